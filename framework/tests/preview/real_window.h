// The real window on a virtual display, and hands that use it.
//
//   VirtualDisplay   an X server without a screen
//   RealWindow       pathmark preview on it: keys, mouse, screenshots
#pragma once

#include "film/image.h"
#include "support/background_program.h"
#include "support/test_coursework_files.h"

#include <filesystem>
#include <string>
#include <vector>

namespace pathmark::test {

class VirtualDisplay {
 public:
  explicit VirtualDisplay(int width = 1280, int height = 800, int dotsPerInch = 96);

  void setKeyboard(const std::string& layout);  // "fr"

  const std::string& name() const { return name_; }  // ":7"

 private:
  TemporaryFolder folder_;
  BackgroundProgram server_;
  std::string name_;
};

class RealWindow {
 public:
  // `arguments` stand behind "pathmark preview"; `remembered` is preview.json, as it was left.
  RealWindow(const VirtualDisplay& display, std::vector<std::string> arguments,
             const std::string& remembered = {});

  // In the window's folder, where screenshots go.
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }

  std::string title() const;
  std::string remembered() const { return textOf(folder_ / "pathmark/preview.json"); }
  std::string log() const { return textOf(folder_ / "log"); }
  bool running() { return !program_.ended(); }
  int wait() { return program_.wait(); }

  // Waits until the title has these words; false after minutes without them.
  bool waitForTitle(const std::string& words);
  bool waitForTitleWithout(const std::string& words);

  // By xdotool's names: "space", "shift+F12".
  void press(const std::string& key);
  void moveTo(int x, int y);
  void click(int x, int y, int button = 1);
  void drag(int fromX, int fromY, int toX, int toY, int button = 1);

  // What the window shows, saved by F12.
  Image screenshot();

 private:
  std::string tool(const std::vector<std::string>& arguments) const;

  TemporaryFolder folder_;
  std::string display_;
  BackgroundProgram program_;
  std::string id_;
  int screenshots_ = 0;
};

// The mean of a part of the image, each channel of it.
std::array<double, 3> meanOf(const Image& image, int left, int top, int width, int height);

}  // namespace pathmark::test
