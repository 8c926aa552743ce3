// SamplePanel: looks at a sampling function: its samples in their domain, their histograms beside
// the expected density, what the checks say.
#pragma once

#include "preview/frame.h"
#include "preview/samples/metronome.h"
#include "preview/samples/playback.h"
#include "preview/samples/sample_engine.h"
#include "preview/samples/sample_scene.h"

#include <memory>
#include <optional>

namespace pathmark::preview {

class SamplePanel {
 public:
  // Inside the current window.
  void draw(const Frame& frame);

  // Shows this function, if it can be shown.
  void choose(CourseworkFunction function);

  // Whether there will be other samples or another verdict without anything being done.
  bool busy(const Frame& frame) const;

 private:
  bool awaitsSamples(const Frame& frame) const;
  void followPart(int part);
  std::shared_ptr<const SampleAnswer> ask(const Frame& frame);
  void showVerdict(const Frame& frame) const;
  float showScene(const SampleAnswer& answer, const Frame& frame);
  void chooseLook(const SampleAnswer& answer);
  void showNumbers(const SampleAnswer& answer, float scale);
  void keepTime(const Frame& frame);

  SampleSettings settings_;
  int part_ = -1;
  Colouring colouring_ = Colouring::kOrder;
  bool weighted_ = false;
  Playback playback_;
  SampleScene scene_;
  float below_ = 0.0f;                    // height of what was drawn below the scene last time
  double waitingSince_ = -1.0;            // for an answer; negative: not
  std::unique_ptr<SampleEngine> engine_;  // from the first frame on
  std::optional<Metronome> metronome_;    // while something moves by itself
};

}  // namespace pathmark::preview
