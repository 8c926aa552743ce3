// The app's menus.
#include "host/session.h"
#include "preview/app.h"

#include <fmt/format.h>
#include <imgui.h>

#include <filesystem>
#include <iterator>

namespace pathmark::preview {

void App::drawMenu() {
  if (!ImGui::BeginMenuBar()) return;
  const auto menu = [this](const char* name, void (App::*entries)()) {
    if (!ImGui::BeginMenu(name)) return;
    (this->*entries)();
    ImGui::EndMenu();
  };
  menu("Scene", &App::drawSceneMenu);
  menu("Coursework", &App::drawCourseworkMenu);
  menu("Part", &App::drawPartMenu);
  menu("Sampler", &App::drawSamplerMenu);
  menu("Picture", &App::drawPictureMenu);
  if (ImGui::BeginMenu("Help")) {
    if (ImGui::MenuItem("Shortcuts", "?")) help_ = true;
    ImGui::EndMenu();
  }
  ImGui::EndMenuBar();
}

void App::drawSceneMenu() {
  for (const std::string& name : sceneNames())
    if (ImGui::MenuItem(name.c_str(), nullptr, request_.scene.stem() == name)) chooseScene(name);
}

// The project's own, and the one of the command line.
void App::drawCourseworkMenu() {
  const auto offer = [this](const std::string& with) {
    if (!std::filesystem::is_directory(courseworkFolder(with))) return;
    if (!ImGui::MenuItem(with.c_str(), nullptr, request_.with == with)) return;
    request_.with = with;
    apply();
  };
  offer("student");
  offer("solutions");
  const std::string& own = options_.request.with;
  if (own != "student" && own != "solutions") offer(own);
}

void App::drawPartMenu() {
  for (const PartContract& part : parts()) {
    const std::string text = fmt::format("{}  {}", part.part, part.title);
    if (ImGui::MenuItem(text.c_str(), nullptr, part.part == part_)) choosePart(part.part);
  }
}

void App::drawSamplerMenu() {
  for (std::size_t k = 0; k < std::size(kSamplerNames); ++k) {
    const auto kind = static_cast<SamplerKind>(k);
    const std::string name(kSamplerNames[k]);
    if (!ImGui::MenuItem(name.c_str(), nullptr, request_.sampler == kind)) continue;
    request_.sampler = kind;
    apply();
  }
}

void App::drawPictureMenu() {
  if (ImGui::MenuItem(request_.paused ? "Go on" : "Pause", "Space")) togglePause();
  if (ImGui::MenuItem("Begin anew", "R")) beginAnew();
  if (ImGui::MenuItem("Camera of the scene file", "C", false, pose_ && pose_->moved()))
    useFileCamera();
  ImGui::Separator();
  if (ImGui::MenuItem("Save the window", "F12")) askForWindowShot();
  if (ImGui::MenuItem("Save the picture", "Shift+F12")) saveBoth();
  ImGui::Separator();
  if (ImGui::MenuItem("Close", "Ctrl+Q")) window_.close();
}

}  // namespace pathmark::preview
