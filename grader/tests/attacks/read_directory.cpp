// Attack: lists the machine's folders
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <dirent.h>
#include <cstdio>
static void attack() {
  DIR* folder = opendir("@OUTSIDE@");
  while (folder != nullptr)
    if (const dirent* entry = readdir(folder))
      std::puts(entry->d_name);
    else
      break;
}
