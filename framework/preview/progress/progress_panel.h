// ProgressPanel: which functions are right, which are wrong and why, and what is next.
#pragma once

#include "preview/frame.h"
#include "preview/progress/function_details.h"
#include "preview/progress/progress_model.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace pathmark::preview {

class ProgressPanel {
 public:
  explicit ProgressPanel(HintSource hints);

  void draw(const Frame& frame);

  // Whether it will show more of this coursework without anything being done.
  static bool busy(const Frame& frame);

  // Called when a function is chosen; may be empty.
  std::function<void(CourseworkFunction)> onChoose;

 private:
  void update(const Frame& frame);
  void choose(CourseworkFunction function);
  void drawHead();
  void drawNext();
  void drawPart(const PartRow& part, const Frame& frame);
  void drawRow(const FunctionRow& row, float scale);
  bool wantsOpen(const PartRow& part, int chosenPart) const;

  FunctionDetails details_;
  std::shared_ptr<const CourseworkState> coursework_;  // that progress_ is made from
  std::shared_ptr<const CheckReport> checks_;
  std::optional<CheckReport> known_;  // of checks_, and of older ones
  std::uint64_t firstOfFolder_ = 0;   // CourseworkState::number; builds before are of another one
  Progress progress_;
  std::string checkImages_;  // the command that comes after the functions
  std::optional<CourseworkFunction> chosen_;
  bool scrollToChosen_ = false;
  std::array<std::optional<bool>, 10> opened_;  // by part: as the user has it, if they said
};

}  // namespace pathmark::preview
