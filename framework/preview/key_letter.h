// keyLetter: the letter of a key, as the keyboard's layout has it.
#pragma once

namespace pathmark::preview {

// A capital, or 0 of other keys. `key` is GLFW's, which are by place and called as on an American
// keyboard: those of letters are 'A' to 'Z'. `name` is glfwGetKeyName's and may be null. Layouts
// without Latin letters keep the American ones.
inline char keyLetter(int key, const char* name) {
  if (name != nullptr && name[0] != '\0' && name[1] == '\0') {
    if (name[0] >= 'a' && name[0] <= 'z') return static_cast<char>(name[0] - 'a' + 'A');
    return name[0] >= 'A' && name[0] <= 'Z' ? name[0] : '\0';
  }
  return key >= 'A' && key <= 'Z' ? static_cast<char>(key) : '\0';
}

}  // namespace pathmark::preview
