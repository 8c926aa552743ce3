// Attack: loads a library
// Expected: forbidden call openat
#include <pathmark/coursework.h>

#include <dlfcn.h>

namespace pathmark {

namespace {

int attack() {
  return dlopen("libcrypt.so.1", RTLD_NOW) != nullptr;
}

}  // namespace

}  // namespace pathmark
