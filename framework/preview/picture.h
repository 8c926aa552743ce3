// What the window shows of a render, and what it knows of the coursework.
//
//   PreviewScene      the scene in work
//   Picture           the newest picture of it; immutable, shared between threads
//   CourseworkState   what came of the last save
#pragma once

#include "film/image.h"
#include "host/coursework_builder.h"
#include "host/stub_report.h"
#include "preview/part_picture.h"
#include "render/render_job.h"
#include "scene/load_scene.h"

#include <cstdint>
#include <memory>
#include <string>

namespace pathmark::preview {

struct PreviewScene {
  LoadedScene loaded;  // with the part's way to choose points on lights
  std::string hash;    // of the file's scene as a worker gets it, with the file's camera
};

struct Picture {
  std::shared_ptr<const PreviewScene> scene;
  FlatCamera camera;       // that it was made with
  bool fileCamera = true;  // the camera is the scene file's
  PartPicture made{};
  SamplerKind sampler = SamplerKind::kSobol;
  std::string paths;               // light path expression; empty: all light
  PathAutomaton automaton;         // the same for a worker
  std::uint64_t seed = 0;          // of its first replicate
  std::uint32_t raysPerPass = 64;  // of a finished one
  std::string coursework;          // "student", "solutions", or the folder's name

  // Linear radiance. With two replicates or more it has variances; infinite where fewer than two
  // have a ray.
  Image image;
  std::uint32_t replicates = 0;  // that the variances come from
  InvalidPixels invalid;
  double raysPerPixel = 0.0;  // mean over the pixels
  double seconds = 0.0;       // of rendering
  std::uint64_t raysTraced = 0;
  double raysPerSecond = 0.0;  // traced, on average over the time of rendering

  std::uint64_t series = 0;   // the same as long as rays are added to the same picture
  std::uint64_t version = 0;  // different for every picture
};

// Immutable, as Picture is.
struct CourseworkState {
  std::shared_ptr<const CourseworkBuild> build;  // null before the first is done
  std::uint64_t number = 0;                      // of the build: 1, 2, ...
  StubReport stubs;
};

}  // namespace pathmark::preview
