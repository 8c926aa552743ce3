// The window on the screen: GLFW, OpenGL 3.3 core, Dear ImGui.
//
//   Window        opens it, draws frames into it
//   codeFont      with letters of one width
//   Texture       pixels that an interface can show
//   DisplayError  a sentence: why there is no window
//
// For the thread that runs main only, except wake().
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

struct GLFWwindow;
struct ImFont;

namespace pathmark::preview {

class DisplayError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct WindowOptions {
  int width = 1280, height = 800;  // in the screen's coordinates
  bool enlarged = true;            // by the screen's own scale
  std::string title;
  double scale = 0.0;  // of the interface; 0: the screen's own
};

// A key that was pressed since the last frame, by GLFW's names. Characters have no key.
struct KeyPress {
  int key = 0;
  char letter = 0;  // of the key, if it has one: see key_letter.h
  bool shift = false, control = false;
  char32_t character = 0;
};

struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // row by row from the top
};

// Of the open window.
ImFont* codeFont();

class Window {
 public:
  // Throws DisplayError.
  explicit Window(const WindowOptions& options);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  bool open() const;  // false once the user has closed it
  void close();

  float scale() const { return scale_; }
  int width() const;
  int height() const;
  void setTitle(const std::string& title);

  // Until wake() is called, the user does something, or so many seconds are over.
  enum class Event { kWoken, kInput, kNone };
  Event wait(double seconds);

  // Any thread.
  static void wake();

  // A frame: `draw` makes the interface. It is given the keys that no text field has taken.
  // With `seen`, keeps what the frame shows.
  void drawFrame(const std::function<void(const std::vector<KeyPress>&)>& draw,
                 Pixels* seen = nullptr);

 private:
  Pixels backBuffer() const;

  GLFWwindow* window_ = nullptr;
  float scale_ = 1.0f;
  std::string title_;
  std::vector<KeyPress> keys_;
};

class Texture {
 public:
  Texture();  // of a window that is open
  ~Texture();
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  // Four values a pixel, sRGB as it is to be seen.
  void upload(int width, int height, std::span<const std::uint8_t> rgba);

  void* id() const { return reinterpret_cast<void*>(static_cast<std::uintptr_t>(name_)); }

 private:
  unsigned name_ = 0;
};

}  // namespace pathmark::preview
