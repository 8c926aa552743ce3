// What the app does when a key is pressed.
#include "preview/app.h"

#include <GLFW/glfw3.h>

namespace pathmark::preview {

namespace {

constexpr double kStopsPerKey = 0.5;

}  // namespace

// By their characters where keyboards differ.
void App::key(const KeyPress& press) {
  switch (press.character) {
    case U'?':
      help_ = !help_;
      return;
    case U'+':
      stops_ += kStopsPerKey;
      return;
    case U'-':
      stops_ -= kStopsPerKey;
      return;
    default:
      break;
  }
  // With Shift they are other characters, such as + on some keyboards.
  const bool digit = press.key >= GLFW_KEY_0 && press.key <= GLFW_KEY_9;
  if (digit && press.shift) return;
  if (press.key >= GLFW_KEY_1 && press.key < GLFW_KEY_1 + kTabs) {
    openTab_ = static_cast<Tab>(press.key - GLFW_KEY_1);
    return;
  }
  switch (press.letter) {
    case 'F':
      area_.fit();
      return;
    case 'Q':
      if (press.control) window_.close();
      return;
    case 'R':
      beginAnew();
      return;
    case 'C':
      useFileCamera();
      return;
    default:
      break;
  }
  switch (press.key) {
    case GLFW_KEY_F1:
      help_ = !help_;
      break;
    case GLFW_KEY_ESCAPE:
      help_ = false;
      break;
    case GLFW_KEY_0:
      stops_ = 0.0;
      break;
    case GLFW_KEY_F12:
      if (press.shift)
        saveBoth();
      else
        askForWindowShot();
      break;
    case GLFW_KEY_SPACE:
      togglePause();
      break;
    default:
      break;
  }
}

}  // namespace pathmark::preview
