// Making an image with a worker, step by step.
//
//   ImageRender     a render that can be stopped after any step, and gone on with
//   renderImage     all its steps
//   RenderedImage   what comes of it
//   RenderStatus    how far it is
#pragma once

#include "film/image.h"
#include "host/render_state.h"
#include "host/worker_process.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace pathmark {

struct RenderStatus {
  double fraction = 0.0;        // of the image's rays, [0,1]
  double fractionBefore = 0.0;  // made by earlier runs that this one goes on from
  double seconds = 0.0;
  double secondsBefore = 0.0;
  std::uint64_t raysTraced = 0;
};

struct RenderedImage {
  Image image;
  InvalidPixels invalid;
  std::uint64_t raysTraced = 0;
  double raysPerPixel = 0.0;  // made; fewer than asked for if it was interrupted
  double seconds = 0.0;
  bool complete = true;
};

struct StepSize {
  double seconds = 1.0;  // about: its overhead is nothing then, and little is lost with a step
  double mostPasses = std::numeric_limits<double>::infinity();  // of the whole image, at least 1
};

// Called several times a second; returns whether to go on.
using OnStatus = std::function<bool(const RenderStatus&)>;

class ImageRender {
 public:
  // Goes on from `state`, if it has begun; its film must have the image's size. The worker must
  // outlive this object. Throws std::system_error.
  ImageRender(WorkerProcess& worker, const RenderSettings& settings, RenderState state = {});

  bool finished() const { return pathmark::finished(settings_, state_); }

  // Asks the worker for so much work. Returns false if `onStatus` has ended it
  // before: what there is of it is in image() only, and the next step makes it anew. Throws
  // WorkerError.
  bool step(const OnStatus& onStatus, const StepSize& size = {});

  const RenderState& state() const { return state_; }
  RenderState takeState() { return std::move(state_); }

  // The newest picture, complete or not.
  RenderedImage image() const;

 private:
  // What a step has made of its region before it was ended.
  struct Remainder {
    PixelRegion region;
    std::vector<FilmPixel> film;
    RenderResult made;
    double seconds = 0.0;
  };

  std::span<FilmPixel> rowsOf(const PixelRegion& region);
  void takeRows(const RenderJob& job, const RenderResult& made, bool whole,
                std::span<FilmPixel> to);

  WorkerProcess& worker_;
  RenderSettings settings_;
  RenderState state_;
  double fractionBefore_, secondsBefore_;
  SharedFilm film_;
  double pixelPasses_;  // of the next step
  std::optional<Remainder> remainder_;
};

// Throws WorkerError.
RenderedImage renderImage(WorkerProcess& worker, const RenderSettings& settings,
                          const OnStatus& onStatus);

}  // namespace pathmark
