// ComparePanel: what the picture area shows, and how the picture differs from a reference.
#pragma once

#include "preview/compare/compare_worker.h"
#include "preview/compare/shown.h"
#include "preview/frame.h"

#include <array>
#include <memory>
#include <optional>

namespace pathmark::preview {

class ComparePanel {
 public:
  // The panel's controls, numbers and plot, in the current window.
  void draw(const Frame& frame);

  // The tone curve, for wherever the exposure is.
  void drawDisplay();

  // The pixels for the picture area. Call it once a frame, whether the panel is seen or not: the
  // error curve goes on.
  const Shown& shown(const Frame& frame);

  // What lies over the picture: the slider's line, labels, numbers under the mouse.
  void drawOver(const Frame& frame, const Placement& placement);

  void choose(View view) { view_ = view; }

  // Whether there is more to come about the frame's picture.
  bool busy(const Frame& frame) const;

 private:
  struct Asked {
    std::uint64_t version = 0, series = 0, wish = 0;
    double raysPerPixel = 0.0;
    View view = View::kPicture;
  };

  void ask(const Frame& frame);
  void wishFor(ReferenceSource source);
  void drawReferenceChoice(const Frame& frame);
  void drawFileField(const Frame& frame);
  bool canKeep(const Frame& frame) const;

  View view_ = View::kPicture;
  DisplaySettings display_;
  float slider_ = 0.5f;  // share of the width that is the picture's
  bool byTime_ = true;
  ReferenceWish wish_{.number = 1};
  std::array<char, 1024> path_{};
  std::optional<Asked> asked_;
  bool drawn_ = false;  // since the last shown()
  std::shared_ptr<const CompareResult> result_;
  ShownMaker maker_;
  std::unique_ptr<CompareWorker> worker_;  // made with the first picture; last, it wakes the window
};

}  // namespace pathmark::preview
