// BackgroundProgram: a program that runs while the test goes on, as in another terminal.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace pathmark::test {

class BackgroundProgram {
 public:
  // What it prints goes into the file `log`.
  BackgroundProgram(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                    const std::filesystem::path& log);
  ~BackgroundProgram();
  BackgroundProgram(const BackgroundProgram&) = delete;
  BackgroundProgram& operator=(const BackgroundProgram&) = delete;

  void signal(int number) const;
  bool ended();

  // Exit code, or 128 + signal.
  int wait();

 private:
  pid_t pid_ = -1;
  int code_ = -1;
};

// Waits for something that will be so; false after minutes in which it was not.
bool waitFor(const std::function<bool()>& condition);

std::string textOf(const std::filesystem::path& file);

}  // namespace pathmark::test
