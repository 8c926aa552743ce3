// The folder that a class is graded into: no record of it is lost, whatever happens meanwhile.
#include "grading/class_folder.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

namespace pathmark::grading {
namespace {

namespace fs = std::filesystem;

class ClassFolderTest : public testing::Test {
 protected:
  static Judged judged(const std::string& name, const std::string& printed = {}) {
    Judged judged;
    judged.record.name = name;
    judged.record.source = "/nowhere/" + name;
    judged.record.seed = kSeed;
    judged.record.printed = printed;
    return judged;
  }

  fs::path place() const { return folder_ / "grades"; }

  static constexpr std::uint64_t kSeed = 3;
  const RunAsked asked_{kSeed, {6}, false};
  test::TemporaryFolder folder_;
};

TEST_F(ClassFolderTest, LeavesAloneWhatIsUnderWayWhateverItsName) {
  const ClassFolder folder(place(), asked_);
  std::vector<fs::path> others;
  for (const char* name : {"ada.new", "ada.made", "ada.replaced", "ada_"})
    others.push_back(folder.scratch(name));
  folder.put(judged("ada"));
  folder.put(judged("ada"));
  for (const fs::path& other : others) EXPECT_TRUE(fs::exists(other)) << other;
}

TEST_F(ClassFolderTest, ReplacesAllOfARecord) {
  const ClassFolder folder(place(), asked_);
  Judged first = judged("ada", "first");
  first.files["pictures/old.png"] = "bytes";
  folder.put(first);
  EXPECT_EQ(folder.picture("ada", "pictures/old.png"), "bytes");
  folder.put(judged("ada", "second"));
  EXPECT_EQ(folder.find("ada")->printed, "second");
  EXPECT_EQ(folder.picture("ada", "pictures/old.png"), "");
}

// As after a run that was killed between putting the old one aside and the new one in its place.
TEST_F(ClassFolderTest, PutsBackARecordWhoseSuccessorDidNotAppear) {
  { ClassFolder(place(), asked_).put(judged("ada", "first")); }
  const fs::path aside = place() / ".work/.replaced";
  fs::create_directories(aside);
  fs::rename(place() / "submissions/ada", aside / "ada");
  const ClassFolder folder(place(), asked_);
  ASSERT_TRUE(folder.find("ada"));
  EXPECT_EQ(folder.find("ada")->printed, "first");
  EXPECT_FALSE(fs::exists(place() / ".work"));
}

TEST_F(ClassFolderTest, PutsBackNoRecordWhoseSuccessorIsThere) {
  { ClassFolder(place(), asked_).put(judged("ada", "first")); }
  const fs::path aside = place() / ".work/.replaced";
  fs::create_directories(aside);
  fs::rename(place() / "submissions/ada", aside / "ada");
  fs::create_directories(place() / "submissions");
  fs::copy(aside / "ada", place() / "submissions/ada", fs::copy_options::recursive);
  fs::create_directories(aside / "ada/pictures/old");
  const ClassFolder folder(place(), asked_);
  EXPECT_FALSE(fs::exists(place() / "submissions/ada/pictures/old"));
}

}  // namespace
}  // namespace pathmark::grading
