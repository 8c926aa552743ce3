// Disks that are full, and other reasons why a file cannot be written: a sentence, and nothing left
// behind.
#include "film/atomic_file.h"
#include "support/run_command.h"
#include "support/test_coursework_files.h"
#include "support/test_images.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>

#include <unistd.h>

namespace pathmark::test {
namespace {

bool contains(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

class FullDisk : public ::testing::Test {
 protected:
  // Runs a shell script in a mount namespace of its own, in which ./disk is a disk of 64 kB. As a
  // user, that needs a user namespace too.
  ProcessResult runBesideASmallDisk(const std::string& script) {
    std::filesystem::create_directory(folder_ / "disk");
    std::vector<std::string> command{"unshare", geteuid() == 0 ? "-m" : "-Urm", "sh", "-c"};
    command.push_back("mount -t tmpfs -o size=64k none disk || exit 99\n" + script);
    return run(command, folder_.path());
  }
  bool canMount() {
    try {
      return runBesideASmallDisk("exit 0").exitCode == 0;
    } catch (const std::system_error&) {
      return false;
    }
  }

  TemporaryFolder folder_;
};

TEST_F(FullDisk, RenderIsASentenceAndLeavesNothingBehind) {
  if (!canMount()) GTEST_SKIP() << "Mount namespaces are not allowed here: nothing was mounted.";
  const TestCoursework coursework;
  const std::string render = std::string(PATHMARK_PROGRAM) + " render furnace --with '" +
                             coursework.folder().string() + "' --rays-per-pixel 1 --output ";
  std::puts("A tmpfs of 64 kB was mounted, and pathmark render wrote into it.");
  const auto expectNoFile = [&](const std::string& options, const std::string& reason) {
    // What can be saved of the work is saved in the folder of temporary files.
    const ProcessResult result =
        runBesideASmallDisk("mkdir -p kept\nTMPDIR=$PWD/kept " + render + options +
                            "\necho code $?\nls -A disk\necho end of list");
    EXPECT_TRUE(contains(result.output, " cannot be written: " + reason)) << result.output;
    EXPECT_TRUE(contains(result.output, "code 3\nend of list")) << result.output;
  };
  for (const char* name : {"a.pfm", "a.exr", "a.hdr"})
    expectNoFile(fmt::format("disk/{} --size 512x512", name), "it takes at least ");
  // How well noise can be compressed is not known before.
  expectNoFile("disk/a.exr --size 160x160", "No space left on device.");
  const ProcessResult kept = runBesideASmallDisk("echo old > disk/a.pfm\n" + render +
                                                 "disk/a.pfm --size 512x512\ncat disk/a.pfm");
  EXPECT_TRUE(contains(kept.output, "\nold\n")) << kept.output;
  const ProcessResult fits =
      runBesideASmallDisk(render + "disk/a.pfm --size 32x32\necho code $?\nls -A disk");
  EXPECT_TRUE(contains(fits.output, "code 0\na.pfm\n")) << fits.output;
}

TEST_F(FullDisk, CompareIsASentenceAndLeavesNothingBehind) {
  if (!canMount()) GTEST_SKIP() << "Mount namespaces are not allowed here: nothing was mounted.";
  writeImage(folder_ / "a.pfm", gradientImage(200, 200), 1.0);
  const ProcessResult result = runBesideASmallDisk(
      std::string(PATHMARK_PROGRAM) +
      " compare a.pfm a.pfm --difference disk/d.pfm\necho code $?\nls -A disk\necho end of list");
  EXPECT_TRUE(contains(result.output, "disk/d.pfm cannot be written: No space left on device."))
      << result.output;
  EXPECT_TRUE(contains(result.output, "code 2\nend of list")) << result.output;
}

TEST_F(FullDisk, AReadOnlyDiskIsASentence) {
  if (!canMount()) GTEST_SKIP() << "Mount namespaces are not allowed here: nothing was mounted.";
  writeImage(folder_ / "a.pfm", gradientImage(4, 4), 1.0);
  const ProcessResult result = runBesideASmallDisk("mount -t tmpfs -o ro none disk || exit 99\n" +
                                                   std::string(PATHMARK_PROGRAM) +
                                                   " compare a.pfm a.pfm --difference disk/d.pfm");
  EXPECT_TRUE(contains(result.output, "disk/d.pfm cannot be written: Read-only file system."))
      << result.output;
}

// Needs no rights: a limit on the size of files fails a write in the middle as a full disk does.
TEST_F(FullDisk, ALimitOnTheSizeOfFilesIsASentence) {
  writeImage(folder_ / "a.pfm", gradientImage(200, 200), 1.0);
  const ProcessResult result =
      run({"sh", "-c",
           "ulimit -f 8\n" + std::string(PATHMARK_PROGRAM) +
               " compare a.pfm a.pfm --difference d.pfm\necho code $?\nls -A"},
          folder_.path());
  EXPECT_TRUE(contains(result.output, "d.pfm cannot be written: File too large.")) << result.output;
  EXPECT_TRUE(contains(result.output, "code 2\na.pfm\n")) << result.output;
}

TEST(AtomicFile, LongNamesAreWrittenAsFarAsNamesMayGo) {
  TemporaryFolder folder;
  const std::string longest(255, 'n');
  writeFileAtomically(folder / longest, "content");
  EXPECT_EQ(readText(folder / longest), "content");
  const std::string sentence =
      sentenceOf([&] { writeFileAtomically(folder / (longest + "n"), "content"); });
  EXPECT_TRUE(contains(sentence, "cannot be written: File name too long.")) << sentence;
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

// Root may write anywhere; without its rights it is a user like any other.
class OrdinaryUser {
 public:
  OrdinaryUser() {
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0) {
      EXPECT_EQ(seteuid(kNobody), 0);
    }
  }
  ~OrdinaryUser() { EXPECT_EQ(seteuid(getuid()), 0); }
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;
};

TEST(AtomicFile, FoldersThatAreMissingOrReadOnlyAreSentences) {
  TemporaryFolder folder;
  EXPECT_TRUE(contains(sentenceOf([&] { writeFileAtomically(folder / "no/a", "x"); }),
                       "no/a cannot be written: No such file or directory."));
  writeText(folder / "file", "x");
  EXPECT_TRUE(contains(sentenceOf([&] { writeFileAtomically(folder / "file/a", "x"); }),
                       "file/a cannot be written: Not a directory."));
  std::filesystem::create_directory(folder / "shut");
  std::filesystem::permissions(folder / "shut", std::filesystem::perms(0555));
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  const OrdinaryUser user;
  EXPECT_TRUE(contains(sentenceOf([&] { writeFileAtomically(folder / "shut/a", "x"); }),
                       "shut/a cannot be written: Permission denied."));
}

}  // namespace
}  // namespace pathmark::test
