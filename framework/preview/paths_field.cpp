#include "preview/paths_field.h"

#include "light_paths/error_text.h"
#include "light_paths/explain.h"
#include "light_paths/language.h"
#include "preview/panel_text.h"

#include <fmt/format.h>
#include <imgui.h>

#include <utility>

namespace pathmark::preview {

namespace {

const ImVec4 kWrong{1.0f, 0.67f, 0.31f, 1.0f};

struct Example {
  const char *text, *what;
};

constexpr Example kExamples[] = {
    {"", "all light"},
    {"LE", "lamps, seen directly"},
    {"L.E", "direct light"},
    {"L..+E", "what takes two reflections or more"},
    {"LD+E", "diffuse reflections only"},
    {"LS+E", "specular reflections only"},
    {"LS+DE", "caustics: specular, and then diffuse"},
    {"L.*SE", "all that a specular surface shows"},
};

}  // namespace

void PathsField::show(const std::string& text) {
  text_.fill('\0');
  text.copy(text_.data(), text_.size() - 1);
  read();
}

// Returns whether there is another expression now.
bool PathsField::read() {
  const std::string text(text_.data());
  const std::string before = expression_ ? expression_->text() : std::string();
  error_.clear();
  if (text.find_first_not_of(' ') == std::string::npos) {
    expression_.reset();
    return !before.empty();
  }
  try {
    PathExpression expression(text);
    automatonFor(expression);
    expression_ = std::move(expression);
  } catch (const ExpressionError& e) {
    error_ = sentenceOf(text, e);
  }
  return error_.empty() && expression_->text() != before;
}

bool PathsField::draw(const FlatScene* scene, bool warmUp) {
  ImGui::TextUnformatted("Light paths");
  bool changed = false;
  ImGui::SetNextItemWidth(0.6f * ImGui::GetContentRegionAvail().x);
  if (ImGui::InputTextWithHint("##paths", "all light", text_.data(), text_.size()))
    changed = read();
  ImGui::SameLine();
  if (ImGui::BeginCombo("##examples", "examples", ImGuiComboFlags_NoArrowButton)) {
    for (const Example& example : kExamples)
      if (ImGui::Selectable(fmt::format("{:<8}{}", example.text, example.what).c_str())) {
        const std::string before = expression_ ? expression_->text() : std::string();
        show(example.text);
        changed = before != example.text;
      }
    ImGui::EndCombo();
  }
  if (!error_.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, kWrong);
    drawWrapped(error_);
    ImGui::PopStyleColor();
  } else if (warmUp && expression_) {
    drawDim("The warm-up finds its light by itself, and shows all of it.");
  } else if (expression_ && scene != nullptr) {
    explain(*scene);
  }
  drawDim(
      "L the light, D diffuse, S specular, . either, E the eye; * any number, + one or more, ? one "
      "or none, | or, ( ) groups.");
  return changed;
}

void PathsField::explain(const FlatScene& scene) const {
  for (const PlanLine& line : explainLightPaths(*expression_, viewOf(scene)))
    drawDim(fmt::format("{}: {}{}", line.what, line.decision,
                        line.why.empty() ? "" : fmt::format(" ({})", line.why)));
}

}  // namespace pathmark::preview
