#include "preview/window.h"

#include "preview/key_letter.h"

// Before GLFW, which would include the system's own header.
#include <epoxy/gl.h>

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>

namespace pathmark::preview {

namespace {

constexpr const char* kFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr const char* kCodeFont = "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf";
constexpr float kFontSize = 15.0f, kCodeFontSize = 13.0f;

// Latin letters, and the quotation marks and dashes that compilers and handouts use.
constexpr ImWchar kGlyphs[] = {0x20, 0xff, 0x2010, 0x2027, 0};

std::string& lastError() {
  static std::string text;
  return text;
}

std::atomic<bool>& woken() {
  static std::atomic<bool> flag{false};
  return flag;
}

// xvfb-run's exit code is the program's only if its server finds a number that no other has (-a),
// and does not begin anew or end when the last window has gone (-noreset).
std::string noDisplay() {
  const char* display = std::getenv("DISPLAY");
  const char* wayland = std::getenv("WAYLAND_DISPLAY");
  const std::string where = display != nullptr   ? fmt::format("DISPLAY is {}", display)
                            : wayland != nullptr ? "only Wayland, and DISPLAY is not set"
                                                 : "DISPLAY is not set";
  return fmt::format(
      "There is no display to open a window on ({}): run the preview on a desktop, or on a virtual "
      "one with xvfb-run -a -s \"-screen 0 1280x800x24 -noreset\" ./pathmark preview. ({})",
      where, lastError());
}

void onKey(GLFWwindow* window, int key, int code, int action, int modifiers) {
  if (action != GLFW_PRESS) return;
  static_cast<std::vector<KeyPress>*>(glfwGetWindowUserPointer(window))
      ->push_back({.key = key,
                   .letter = keyLetter(key, glfwGetKeyName(key, code)),
                   .shift = (modifiers & GLFW_MOD_SHIFT) != 0,
                   .control = (modifiers & GLFW_MOD_CONTROL) != 0});
}

void onCharacter(GLFWwindow* window, unsigned character) {
  static_cast<std::vector<KeyPress>*>(glfwGetWindowUserPointer(window))
      ->push_back({.character = character});
}

// The first that is added is that of everything; what stands in for a missing file has letters of
// one width.
void addFont(const char* file, float size) {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  if (std::filesystem::exists(file)) {
    fonts.AddFontFromFileTTF(file, size, nullptr, kGlyphs);
    return;
  }
  ImFontConfig config;
  config.SizePixels = 13.0f / kFontSize * size;
  fonts.AddFontDefault(&config);
}

void styleFor(float scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0.0f;
  style.FrameRounding = 3.0f;
  style.GrabRounding = 3.0f;
  style.ScaleAllSizes(scale);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  addFont(kFont, kFontSize * scale);
  addFont(kCodeFont, kCodeFontSize * scale);
}

}  // namespace

ImFont* codeFont() { return ImGui::GetIO().Fonts->Fonts.back(); }

Window::Window(const WindowOptions& options) {
  glfwSetErrorCallback([](int, const char* text) { lastError() = text; });
  if (glfwInit() != GLFW_TRUE) throw DisplayError(noDisplay());
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, options.enlarged ? GLFW_TRUE : GLFW_FALSE);
  window_ =
      glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) {
    const std::string why = lastError();
    glfwTerminate();
    throw DisplayError(fmt::format("This display offers no OpenGL 3.3: {}", why));
  }
  title_ = options.title;
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  float across = 1.0f, down = 1.0f;
  glfwGetWindowContentScale(window_, &across, &down);
  scale_ = options.scale > 0.0 ? static_cast<float>(options.scale) : std::max(across, down);
  glfwSetWindowUserPointer(window_, &keys_);
  glfwSetKeyCallback(window_, onKey);
  glfwSetCharCallback(window_, onCharacter);
  ImGui::CreateContext();
  styleFor(scale_);
  ImGui_ImplGlfw_InitForOpenGL(window_, true);
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

bool Window::open() const { return glfwWindowShouldClose(window_) == GLFW_FALSE; }

void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

int Window::width() const {
  int width = 0, height = 0;
  glfwGetWindowSize(window_, &width, &height);
  return width;
}

int Window::height() const {
  int width = 0, height = 0;
  glfwGetWindowSize(window_, &width, &height);
  return height;
}

void Window::setTitle(const std::string& title) {
  if (title == title_) return;
  title_ = title;
  glfwSetWindowTitle(window_, title.c_str());
}

Window::Event Window::wait(double seconds) {
  if (woken().exchange(false)) return Event::kWoken;
  const double started = glfwGetTime();
  glfwWaitEventsTimeout(seconds);
  if (woken().exchange(false)) return Event::kWoken;
  return glfwGetTime() - started < seconds ? Event::kInput : Event::kNone;
}

void Window::wake() {
  woken() = true;
  glfwPostEmptyEvent();
}

void Window::drawFrame(const std::function<void(const std::vector<KeyPress>&)>& draw,
                       Pixels* seen) {
  glfwPollEvents();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  // What a text field takes for itself; it has no use for function keys.
  if (ImGui::GetIO().WantTextInput)
    std::erase_if(keys_,
                  [](const KeyPress& k) { return k.key < GLFW_KEY_F1 || k.key > GLFW_KEY_F25; });
  draw(keys_);
  keys_.clear();
  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  glViewport(0, 0, width, height);
  glClearColor(0.06f, 0.06f, 0.07f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  // Afterwards it would be anybody's guess what the buffers hold.
  if (seen != nullptr) *seen = backBuffer();
  glfwSwapBuffers(window_);
}

Pixels Window::backBuffer() const {
  Pixels result;
  glfwGetFramebufferSize(window_, &result.width, &result.height);
  const auto rowBytes = static_cast<std::size_t>(result.width) * 4;
  std::vector<std::uint8_t> bottomUp(rowBytes * static_cast<std::size_t>(result.height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadBuffer(GL_BACK);
  glReadPixels(0, 0, result.width, result.height, GL_RGBA, GL_UNSIGNED_BYTE, bottomUp.data());
  result.rgba.resize(bottomUp.size());
  for (std::size_t row = 0; row < static_cast<std::size_t>(result.height); ++row)
    std::copy_n(bottomUp.begin() + static_cast<std::ptrdiff_t>(rowBytes * row), rowBytes,
                result.rgba.end() - static_cast<std::ptrdiff_t>(rowBytes * (row + 1)));
  return result;
}

Texture::Texture() {
  glGenTextures(1, &name_);
  glBindTexture(GL_TEXTURE_2D, name_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

Texture::~Texture() { glDeleteTextures(1, &name_); }

void Texture::upload(int width, int height, std::span<const std::uint8_t> rgba) {
  glBindTexture(GL_TEXTURE_2D, name_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               rgba.data());
}

}  // namespace pathmark::preview
