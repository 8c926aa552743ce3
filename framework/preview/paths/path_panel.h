// PathPanel: the paths of one pixel, drawn in the scene and told in numbers.
//
// The pixel is one of the picture that was seen when it was picked. Its paths stay in the scene
// while the camera moves; they are recorded again when the code has changed, and gone with the
// scene.
#pragma once

#include "preview/frame.h"
#include "preview/paths/path_engine.h"
#include "preview/paths/path_overlay.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pathmark::preview {

class PathPanel {
 public:
  // A pixel of the picture of the last frame.
  void pick(int column, int row);

  void draw(const Frame& frame);
  void drawOver(const Frame& frame, const Placement& placement);

  // Whether there will be other paths without anything being done.
  bool busy() const { return picked_ || engine_.working(); }

 private:
  void follow(const Frame& frame);
  void followPicture(const Frame& frame);
  void followPick(const Picture& seen, const Frame& frame);
  void takeAnswer();
  void sortPaths();
  void drawHead();
  void drawControls(const Frame& frame);
  void drawChosen(const Frame& frame);
  void forget();
  bool cameraIsThatOf(const Picture& picture) const;

  PathEngine engine_;
  std::shared_ptr<const Picture> picture_;             // of the last frame
  std::shared_ptr<const CourseworkState> coursework_;  // the newest that there is a worker of
  std::optional<std::array<int, 2>> picked_{};         // and not yet asked for
  std::optional<PathRequest> request_{};               // the newest
  std::shared_ptr<const PathAnswer> answer_;           // that is shown
  std::vector<int> order_;                             // of its paths
  int rays_ = 64;
  bool brightestFirst_ = true;
  PathSelection selection_;
  int vertexInTable_ = -1;  // that the mouse points at in the table
  std::string note_;        // about a pixel that cannot be picked
};

}  // namespace pathmark::preview
