// Shown: the pixels of the picture area.
//
//   Shown        what is seen
//   ShownMaker   makes it anew when there is something else to see
#pragma once

#include "preview/compare/compare_session.h"
#include "preview/compare/display.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace pathmark::preview {

struct Shown {
  int width = 0, height = 0;       // 0: there is nothing
  std::vector<std::uint8_t> rgba;  // 4 x width x height, sRGB
  std::uint64_t version = 0;       // another one whenever the pixels are others
};

struct ShownRequest {
  std::shared_ptr<const Picture> picture;       // may be null
  std::shared_ptr<const CompareResult> result;  // may be null, or of an older picture
  std::uint64_t wish = 0;                       // that a result must be of to be shown
  View view = View::kPicture;
  DisplaySettings display;
  double slider = 0.5;  // share of the width that is the picture's
};

class ShownMaker {
 public:
  const Shown& make(const ShownRequest& request);

  // What make() has shown last: the picture where there is nothing to show for the wished view.
  View view() const { return key_.view; }

 private:
  struct Key {
    std::uint64_t picture = 0, reference = 0;
    const CompareResult* colours = nullptr;  // that coloursOf_ keeps alive
    View view = View::kPicture;
    DisplaySettings display{};
    int split = 0;

    bool operator==(const Key&) const = default;
  };

  void composeSlider(const Reference& reference, const ShownRequest& request);

  Shown shown_;
  Key key_;
  std::shared_ptr<const CompareResult> coloursOf_;
  Shown left_, right_;  // of the slider
  Key leftKey_, rightKey_;
};

// The column from which on the reference is seen.
int splitColumn(double slider, int width);

}  // namespace pathmark::preview
