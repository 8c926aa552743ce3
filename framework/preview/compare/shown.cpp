#include "preview/compare/shown.h"

#include <algorithm>
#include <cmath>

namespace pathmark::preview {

namespace {

bool fits(const Image& image, const Image& picture) {
  return image.width == picture.width && image.height == picture.height;
}

const Reference* referenceOf(const ShownRequest& request) {
  if (!request.result || request.result->wish != request.wish) return nullptr;
  const Reference* reference = request.result->found.reference.get();
  return reference != nullptr && fits(*reference->image, request.picture->image) ? reference
                                                                                 : nullptr;
}

bool hasColours(const ShownRequest& request) {
  const CompareResult* result = request.result.get();
  return result != nullptr && result->wish == request.wish &&
         result->colours.view == request.view &&
         fits(result->picture->image, request.picture->image);
}

View possibleView(const ShownRequest& request) {
  const bool possible = isFalseColour(request.view)    ? hasColours(request)
                        : needsReference(request.view) ? referenceOf(request) != nullptr
                                                       : true;
  return possible ? request.view : View::kPicture;
}

}  // namespace

int splitColumn(double slider, int width) {
  return static_cast<int>(std::lround(std::clamp(slider, 0.0, 1.0) * width));
}

// Each side is kept, so that dragging the slider only copies rows.
void ShownMaker::composeSlider(const Reference& reference, const ShownRequest& request) {
  const Key left{.picture = key_.picture, .display = key_.display};
  const Key right{.reference = key_.reference, .display = key_.display};
  if (left_.rgba.empty() || leftKey_ != left)
    displayImage(request.picture->image, request.display, left_.rgba);
  if (right_.rgba.empty() || rightKey_ != right)
    displayImage(*reference.image, request.display, right_.rgba);
  leftKey_ = left;
  rightKey_ = right;
  const auto rowBytes = 4 * static_cast<std::ptrdiff_t>(shown_.width);
  const auto splitBytes = 4 * static_cast<std::ptrdiff_t>(key_.split);
  shown_.rgba.resize(left_.rgba.size());
  for (std::ptrdiff_t row = 0; row < shown_.height; ++row) {
    const std::ptrdiff_t from = row * rowBytes;
    std::copy_n(left_.rgba.begin() + from, splitBytes, shown_.rgba.begin() + from);
    std::copy_n(right_.rgba.begin() + from + splitBytes, rowBytes - splitBytes,
                shown_.rgba.begin() + from + splitBytes);
  }
}

const Shown& ShownMaker::make(const ShownRequest& request) {
  if (!request.picture) return shown_;
  const Image& image = request.picture->image;
  Key key{.picture = request.picture->version, .view = possibleView(request)};
  const Reference* reference = referenceOf(request);
  if (isFalseColour(key.view)) key.colours = request.result.get();
  if (!isFalseColour(key.view)) key.display = request.display;
  if (key.view == View::kReference || key.view == View::kSlider) key.reference = reference->id;
  if (key.view == View::kSlider) key.split = splitColumn(request.slider, image.width);
  // What does not depend on the picture is not made anew for each.
  if (key.view == View::kReference || isFalseColour(key.view)) key.picture = 0;
  if (shown_.version > 0 && key == key_) return shown_;
  key_ = key;
  coloursOf_ = isFalseColour(key.view) ? request.result : nullptr;
  shown_.width = image.width;
  shown_.height = image.height;
  ++shown_.version;
  if (isFalseColour(key.view))
    shown_.rgba = request.result->colours.rgba;
  else if (key.view == View::kReference)
    displayImage(*reference->image, request.display, shown_.rgba);
  else if (key.view == View::kSlider)
    composeSlider(*reference, request);
  else
    displayImage(image, request.display, shown_.rgba);
  return shown_;
}

}  // namespace pathmark::preview
