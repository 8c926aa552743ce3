// What a sandbox puts where its programs find it, and the users that it gives them.
#include "sandbox/staging.h"
#include "host/build_config.h"
#include "sandbox/landlock.h"
#include "sandbox/landlock_tier.h"
#include "sandbox/sandbox.h"
#include "support/test_coursework_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <grp.h>
#include <sched.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace pathmark::test {
namespace {

// What is said where this function fails, in a process that has become another user; empty where
// the process could not.
std::string sentenceAsNobody(const std::function<void()>& function) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (setgroups(0, nullptr) != 0 || setresgid(kNobody, kNobody, kNobody) != 0 ||
        setresuid(kNobody, kNobody, kNobody) != 0)
      _exit(1);
    std::string sentence = "nothing failed";
    try {
      function();
    } catch (const std::exception& e) {
      sentence = e.what();
    }
    _exit(write(ends[1], sentence.data(), sentence.size()) < 0 ? 1 : 0);
  }
  close(ends[1]);
  std::string sentence;
  std::array<char, 512> chunk{};
  for (ssize_t n = 0; (n = read(ends[0], chunk.data(), chunk.size())) > 0;)
    sentence.append(chunk.data(), static_cast<std::size_t>(n));
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return sentence;
}

TEST(OpenSandbox, ABuildFolderThatCannotBeWrittenIsNoLackOfASandbox) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can become a user who may not write there";
  std::filesystem::create_directories(std::filesystem::path(build::kBuildFolder) / "workers");
  for (const bool unsafe : {false, true}) {
    const std::string sentence = sentenceAsNobody([&] { sandbox::openStrongest(unsafe); });
    if (sentence.empty()) GTEST_SKIP() << "this process cannot become another user";
    EXPECT_NE(sentence.find("workers cannot be written by this user (Permission denied), and must"),
              std::string::npos)
        << sentence;
    EXPECT_EQ(sentence.find("--unsafe"), std::string::npos) << sentence;
  }
}

TEST(Staging, RemovesWhatKilledProcessesHaveLeftAndNothingElse) {
  const std::filesystem::path forsaken =
      std::filesystem::temp_directory_path() / "pathmark-sandbox.forsaken";
  std::filesystem::create_directories(forsaken / "files");
  const std::ofstream lock(forsaken / "lock");
  sandbox::Staging first;
  EXPECT_FALSE(std::filesystem::exists(forsaken));
  const std::filesystem::path inUse = first.makeScratchFolder();
  const sandbox::Staging second;
  EXPECT_TRUE(std::filesystem::exists(inUse));
}

TEST(Staging, CompiledCourseworkIsNotCopiedAnewBecauseItIsUsed) {
  const std::filesystem::path folder =
      std::filesystem::path(build::kBuildFolder) / "workers/objects";
  const std::filesystem::path object = folder / fmt::format("test-{}.o", getpid());
  std::filesystem::create_directories(folder);
  std::ofstream(object) << "object";
  sandbox::Staging staging;
  const std::filesystem::path copy = staging.visible(object);
  if (copy == object) GTEST_SKIP() << "only root makes copies";
  std::ofstream(copy) << "linked";
  std::filesystem::last_write_time(
      object, std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_EQ(staging.visible(object), copy);
  std::string contents;
  std::ifstream(copy) >> contents;
  EXPECT_EQ(contents, "linked");
  std::filesystem::remove(object);
}

TEST(Staging, ProgramsShareAUserWhereThereAreNoNumbersForThem) {
  EXPECT_TRUE(sandbox::isShared(std::nullopt));
  EXPECT_TRUE(sandbox::isShared(65534));
  EXPECT_FALSE(sandbox::isShared(0x70000001));
  EXPECT_GT(sandbox::processesOfUser(getuid()), 0u);
}

// What the function returns in a process that is root of a container, which has few users; empty
// where there can be none.
std::string inContainer(const std::function<std::string()>& function) {
  std::array<int, 2> down{}, up{};
  if (pipe(down.data()) != 0 || pipe(up.data()) != 0) return {};
  const pid_t child = fork();
  char word = 'x';
  if (child == 0) {
    if (unshare(CLONE_NEWUSER) != 0 || write(up[1], &word, 1) != 1 || read(down[0], &word, 1) != 1)
      _exit(1);
    std::string result;
    try {
      result = function();
    } catch (const std::exception& e) {
      result = e.what();
    }
    _exit(write(up[1], result.data(), result.size()) < 0 ? 1 : 0);
  }
  close(up[1]);
  std::string result;
  if (read(up[0], &word, 1) == 1) {
    for (const char* map : {"uid_map", "gid_map"})
      std::ofstream(fmt::format("/proc/{}/{}", child, map)) << "0 0 65536\n";
    std::array<char, 512> chunk{};
    if (write(down[1], &word, 1) == 1)
      for (ssize_t n = 0; (n = read(up[0], chunk.data(), chunk.size())) > 0;)
        result.append(chunk.data(), static_cast<std::size_t>(n));
  }
  for (const int end : {down[0], down[1], up[0]}) close(end);
  waitpid(child, nullptr, 0);
  return result;
}

TEST(Landlock, ProgramsThatShareAUserMayHaveManyProcessesTogether) {
  if (geteuid() != 0) GTEST_SKIP() << "only root gives programs other users";
  const auto processesAllowed = [] {
    sandbox::LandlockTier tier({});
    Confinement::Step step;
    step.request.arguments = {"/bin/sh", "-c", "ulimit -p"};
    return tier.run(step).output;
  };
  if (sandbox::landlockVersion() == 0) GTEST_SKIP() << "the kernel has no Landlock";
  EXPECT_LT(std::atoi(processesAllowed().c_str()), 1000);
  const std::string allowed = inContainer(processesAllowed);
  if (allowed.empty()) GTEST_SKIP() << "this machine makes no containers";
  EXPECT_GT(std::atoi(allowed.c_str()), 4000) << allowed;
}

// A process between fork and exec holds the descriptors of files that other threads write.
TEST(Staging, WhatItCopiesCanBeExecutedWhileOtherThreadsMakeProcesses) {
  const TemporaryFolder folder;
  std::filesystem::copy_file("/bin/true", folder / "program");
  std::filesystem::resize_file(folder / "program", std::size_t{32} << 20);
  sandbox::Staging staging;
  if (staging.visible(folder / "program") == folder / "program")
    GTEST_SKIP() << "only copies, which root makes, are written here";
  std::atomic<bool> done{false};
  std::thread others([&] {
    while (!done) {
      const pid_t child = fork();
      if (child == 0) {
        usleep(20000);
        _exit(0);
      }
      waitpid(child, nullptr, 0);
    }
  });
  for (int k = 0; k < 10; ++k) {
    std::filesystem::last_write_time(folder / "program",
                                     std::filesystem::file_time_type(std::chrono::seconds(k)));
    std::string copy = staging.visible(folder / "program").string();
    char* const arguments[] = {copy.data(), nullptr};
    pid_t program = 0;
    const int error = posix_spawn(&program, copy.c_str(), nullptr, nullptr, arguments, nullptr);
    EXPECT_EQ(error, 0) << std::strerror(error);
    if (error == 0) waitpid(program, nullptr, 0);
  }
  done = true;
  others.join();
}

TEST(Staging, IsNotRemovedByAnotherThatBeginsAtTheSameTime) {
  constexpr int kThreads = 8, kEach = 100;
  std::atomic<int> failed{0};
  std::vector<std::thread> threads;
  threads.reserve(kThreads);
  for (int k = 0; k < kThreads; ++k)
    threads.emplace_back([&] {
      for (int i = 0; i < kEach; ++i) try {
          sandbox::Staging staging;
          staging.makeScratchFolder();
        } catch (const std::exception&) {
          ++failed;
        }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(failed, 0);
}

}  // namespace
}  // namespace pathmark::test
