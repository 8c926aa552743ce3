// PathsField: where the light path expression of the picture is typed.
#pragma once

#include "light_paths/expression.h"
#include "scene/flat_scene.h"

#include <array>
#include <optional>
#include <string>

namespace pathmark::preview {

class PathsField {
 public:
  // As if it had been typed.
  void show(const std::string& text);

  // Returns whether there is another expression now. `scene` may be null, before the first.
  bool draw(const FlatScene* scene, bool warmUp);

  // What was typed last without a mistake; nothing: all light.
  const std::optional<PathExpression>& expression() const { return expression_; }

 private:
  bool read();
  void explain(const FlatScene& scene) const;

  std::array<char, PathExpression::kLongestText + 1> text_{};
  std::optional<PathExpression> expression_;
  std::string error_;  // a sentence; the expression is then an older one
};

}  // namespace pathmark::preview
