// FunctionDetails: what the checks say of the function that was chosen, its hints, and the commands
// that repeat them.
#pragma once

#include "preview/progress/progress_model.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace pathmark::preview {

using HintSource = std::function<std::vector<std::string>(CourseworkFunction)>;

class FunctionDetails {
 public:
  explicit FunctionDetails(HintSource hints);

  // In the current window, below a row of the panel.
  void draw(const FunctionRow& row, float scale);

  void giveHint(CourseworkFunction function);

 private:
  struct Given {
    std::vector<std::string> hints;
    std::size_t shown = 0;
  };

  void drawButtons(const FunctionRow& row);
  void drawHints(CourseworkFunction function) const;

  HintSource source_;
  std::map<CourseworkFunction, Given> given_;
};

}  // namespace pathmark::preview
