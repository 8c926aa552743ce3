// App: the window's contents: the picture on the left, panels on the right, and what the keys do.
#pragma once

#include "film/image.h"
#include "preview/app_options.h"
#include "preview/camera_pose.h"
#include "preview/engine.h"
#include "preview/frame.h"
#include "preview/paths_field.h"
#include "preview/picture_area.h"
#include "preview/remembered.h"
#include "preview/window.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

struct ImFont;
struct ImVec4;

namespace pathmark::preview {

class App {
 public:
  App(Window& window, AppOptions options);
  ~App();

  // Until the window is closed, or the script is done. Returns an exit code.
  int run();

  // For the next time.
  Remembered remembered() const;

 private:
  class Panels;

  void showFrame(Pixels* seen = nullptr);
  void draw(const std::vector<KeyPress>& pressed);
  void drawMenu();
  void drawSceneMenu();
  void drawCourseworkMenu();
  void drawPartMenu();
  void drawSamplerMenu();
  void drawPictureMenu();
  void drawBanners();
  void drawBanner(const char* title, const std::string& text, const char* remedy,
                  const ImVec4& colour, ImFont* font = nullptr);
  std::string unwrittenSentence() const;
  void drawPicture(float width);
  void drawPanels();
  void drawStatus();
  void drawHelp();
  void drawToast();
  void drawView();
  void key(const KeyPress& press);
  void takeNews();
  Frame makeFrame() const;
  void apply();  // sends the request to the engine
  void choosePart(int part);
  void chooseScene(const std::string& name);
  void askForWindowShot();
  void saveWindow(const std::filesystem::path& file);
  void savePicture(const std::filesystem::path& file);
  void saveBoth();
  void togglePause();
  void beginAnew();
  void useFileCamera();
  void say(std::string text);
  void cannotWrite(const ImageError& error);
  bool scriptDone();
  std::string title() const;
  double exposure() const;

  Window& window_;
  AppOptions options_;
  EngineRequest request_;
  std::function<void()> wake_;
  std::shared_ptr<const EngineState> state_;
  std::optional<CameraPose> pose_;
  std::uint64_t poseOf_ = 0;     // EngineState::sceneNumber
  std::string poseIn_;           // the scene's name
  double cameraMovedAt_ = -1e9;  // seconds, of ImGui's clock
  int part_ = 5;
  Tab tab_ = Tab::kProgress;    // that is seen
  std::optional<Tab> openTab_;  // to be opened in this frame
  double stops_ = 0.0;
  std::uint64_t noiseOf_ = 0;    // the picture's version of which it is
  std::optional<double> noise_;  // relative mean squared, as the picture's own variances tell
  bool help_ = false;
  std::string toast_;
  double toastUntil_ = 0.0;
  std::optional<std::filesystem::path> windowShot_;  // to be taken after this frame
  int screenshots_ = 0;
  int framesDue_ = 3;
  int exitCode_ = 0;
  PictureArea area_;
  PathsField pathsField_;
  std::unique_ptr<Panels> panels_;
  std::unique_ptr<Engine> engine_;  // last: it wakes the window
};

// "STEM_001", with the first number of which there is no file with any of these endings yet.
std::string unusedStem(const std::string& stem, std::initializer_list<const char*> endings);

}  // namespace pathmark::preview
