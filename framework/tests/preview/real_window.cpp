#include "preview/real_window.h"

#include "film/image_formats.h"
#include "host/subprocess.h"

#include <fmt/format.h>

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

namespace pathmark::test {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> previewCommand(const std::string& display, const fs::path& folder,
                                        const std::vector<std::string>& arguments,
                                        const std::string& remembered) {
  if (!remembered.empty()) {
    fs::create_directory(folder / "pathmark");
    std::ofstream(folder / "pathmark/preview.json") << remembered;
  }
  std::vector<std::string> command{"env",
                                   "DISPLAY=" + display,
                                   "LIBGL_ALWAYS_SOFTWARE=1",
                                   "XDG_STATE_HOME=" + folder.string(),
                                   PATHMARK_PROGRAM,
                                   "preview"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

std::string withoutNewline(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

}  // namespace

VirtualDisplay::VirtualDisplay(int width, int height, int dotsPerInch)
    // Without -noreset the server begins anew when its last client has gone, here a tool that
    // looked for the window, and turns away the window that comes at that moment.
    : server_({"Xvfb", "-noreset", "-displayfd", "1", "-screen", "0",
               fmt::format("{}x{}x24", width, height), "-dpi", std::to_string(dotsPerInch),
               "-nolisten", "tcp"},
              folder_.path(), folder_ / "log") {
  const auto number = [&] {
    const std::string text = textOf(folder_ / "log");
    std::size_t end = text.find('\n');
    while (end != std::string::npos) {
      const std::size_t begin = text.rfind('\n', end - 1) + 1;
      const std::string line = text.substr(begin, end - begin);
      if (!line.empty() && line.find_first_not_of("0123456789") == std::string::npos) return line;
      end = text.find('\n', end + 1);
    }
    return std::string();
  };
  EXPECT_TRUE(waitFor([&] { return !number().empty() || server_.ended(); }))
      << textOf(folder_ / "log");
  name_ = fmt::format(":{}", number());
}

void VirtualDisplay::setKeyboard(const std::string& layout) {
  ProcessRequest request;
  request.arguments = {"setxkbmap", "-display", name_, layout};
  const ProcessResult result = runProcess(request);
  EXPECT_EQ(result.exitCode, 0) << result.output;
}

RealWindow::RealWindow(const VirtualDisplay& display, std::vector<std::string> arguments,
                       const std::string& remembered)
    : display_(display.name()),
      program_(previewCommand(display_, folder_.path(), arguments, remembered), folder_.path(),
               folder_ / "log") {
  EXPECT_TRUE(waitFor([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    id_ = withoutNewline(tool({"search", "--name", "^Pathmark"}));
    return !id_.empty() || program_.ended();
  })) << log();
  if (!program_.ended()) tool({"windowfocus", "--sync", id_});
}

std::string RealWindow::tool(const std::vector<std::string>& arguments) const {
  ProcessRequest request;
  request.arguments = {"env", "DISPLAY=" + display_, "xdotool"};
  request.arguments.insert(request.arguments.end(), arguments.begin(), arguments.end());
  return runProcess(request).output;
}

std::string RealWindow::title() const { return withoutNewline(tool({"getwindowname", id_})); }

bool RealWindow::waitForTitle(const std::string& words) {
  const bool came = waitFor([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return title().find(words) != std::string::npos || program_.ended();
  });
  const bool there = came && title().find(words) != std::string::npos;
  if (!there) ADD_FAILURE() << "no \"" << words << "\" in \"" << title() << "\"\n" << log();
  return there;
}

bool RealWindow::waitForTitleWithout(const std::string& words) {
  return waitFor([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return title().find(words) == std::string::npos || program_.ended();
  });
}

void RealWindow::press(const std::string& key) { tool({"key", "--clearmodifiers", key}); }

void RealWindow::moveTo(int x, int y) {
  tool({"mousemove", "--window", id_, std::to_string(x), std::to_string(y)});
}

// With pauses: an interface that is drawn in frames does not see what comes and goes within one.
void RealWindow::click(int x, int y, int button) {
  const std::string which = std::to_string(button);
  tool({"mousemove", "--window", id_, std::to_string(x), std::to_string(y), "sleep", "0.1",
        "mousedown", which, "sleep", "0.1", "mouseup", which, "sleep", "0.1"});
}

void RealWindow::drag(int fromX, int fromY, int toX, int toY, int button) {
  const std::string which = std::to_string(button);
  std::vector<std::string> words{"mousemove",
                                 "--window",
                                 id_,
                                 std::to_string(fromX),
                                 std::to_string(fromY),
                                 "sleep",
                                 "0.1",
                                 "mousedown",
                                 which,
                                 "sleep",
                                 "0.1"};
  constexpr int kSteps = 5;
  for (int k = 1; k <= kSteps; ++k) {
    const int x = fromX + (toX - fromX) * k / kSteps, y = fromY + (toY - fromY) * k / kSteps;
    for (const std::string& word :
         {std::string("mousemove"), std::string("--window"), id_, std::to_string(x),
          std::to_string(y), std::string("sleep"), std::string("0.1")})
      words.push_back(word);
  }
  words.insert(words.end(), {"mouseup", which, "sleep", "0.1"});
  tool(words);
}

Image RealWindow::screenshot() {
  const fs::path shot = file(fmt::format("pathmark_window_{:03}.png", ++screenshots_));
  press("F12");
  EXPECT_TRUE(waitFor([&] { return fs::exists(shot) || program_.ended(); })) << log();
  return decodePng(textOf(shot));
}

std::array<double, 3> meanOf(const Image& image, int left, int top, int width, int height) {
  std::array<double, 3> sum{};
  for (int row = top; row < top + height; ++row)
    for (int column = left; column < left + width; ++column) {
      const auto pixel = image.pixel(column, row);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += pixel[c];
    }
  for (double& s : sum) s /= static_cast<double>(width) * height;
  return sum;
}

}  // namespace pathmark::test
