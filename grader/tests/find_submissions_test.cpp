// What words of the command line mean, and what submissions are called.
#include "support/collecting.h"

#include "submission/names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include <linux/capability.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace pathmark::submission {
namespace {

namespace fs = std::filesystem;
using test::ArchiveKind;
using test::MadeArchive;

using Names = std::vector<std::string>;

class Finding : public testing::Test {
 protected:
  void write(const std::string& name) { test::writeBytes(folder_ / name, "x"); }
  void archive(const std::string& name, ArchiveKind kind = ArchiveKind::kZip) {
    fs::create_directories((folder_ / name).parent_path());
    MadeArchive().file("part3_lambertian.cpp").write(kind, folder_ / name);
  }
  // `earlier` leads from places in the folder to names.
  FoundSubmissions find(const std::vector<std::string>& words,
                        const std::map<std::string, std::string>& earlier = {}) {
    std::vector<fs::path> paths;
    for (const std::string& word : words) paths.push_back(folder_ / word);
    EarlierNames names;
    for (const auto& [place, name] : earlier) names[fs::weakly_canonical(folder_ / place)] = name;
    return findSubmissions(paths, names);
  }
  Names namesOf(const std::vector<std::string>& words) {
    Names all;
    for (const Submission& one : find(words).submissions) all.push_back(one.name);
    return all;
  }

  test::TemporaryFolder folder_;
};

TEST_F(Finding, AFolderWithAnExpectedFileIsOneSubmission) {
  write("direct/part3_lambertian.cpp");
  write("project/student/part3_lambertian.cpp");
  write("project/framework/readme.txt");
  write("project/grader/readme.txt");
  write("wrapped/a/b/part3_lambertian.cpp");
  write("wrapped/readme.txt");
  EXPECT_EQ(namesOf({"direct", "project", "wrapped"}), (Names{"direct", "project", "wrapped"}));
}

TEST_F(Finding, AnArchiveIsOneSubmission) {
  archive("alice.zip");
  archive("bob.tar.gz", ArchiveKind::kTarGz);
  archive("carol", ArchiveKind::kZip);  // known by its first bytes
  const FoundSubmissions found = find({"alice.zip", "bob.tar.gz", "carol"});
  ASSERT_EQ(found.submissions.size(), 3u);
  EXPECT_EQ(found.submissions[0].name, "alice");
  EXPECT_EQ(found.submissions[1].name, "bob");
  EXPECT_EQ(found.submissions[2].name, "carol");
  for (const Submission& one : found.submissions) {
    EXPECT_TRUE(one.isArchive);
    EXPECT_EQ(collect(one).files.size(), 1u);
  }
}

TEST_F(Finding, AFolderOfSubmissionsIsAClass) {
  write("class/task 10/part0_warmup.cpp");
  write("class/task 9/deeper/part0_warmup.cpp");
  archive("class/task 2.zip");
  archive("class/moodle_7_file/handed in.zip");
  write("class/notes.txt");
  write("class/empty/readme.txt");
  write("class/.hidden/part0_warmup.cpp");
  const FoundSubmissions found = find({"class"});
  Names all;
  for (const Submission& one : found.submissions) all.push_back(one.name);
  EXPECT_EQ(all, (Names{"moodle_7_file", "task_2", "task_9", "task_10"}));
  EXPECT_EQ(found.remarks.size(), 2u);
}

TEST_F(Finding, AFolderThatIsNamedAloneAndWrapsOneIsAClassOfOne) {
  write("class/alice/part0_warmup.cpp");
  write("bob/part0_warmup.cpp");
  EXPECT_EQ(namesOf({"class"}), Names{"alice"});
  EXPECT_EQ(namesOf({"bob"}), Names{"bob"});
}

TEST_F(Finding, AFolderBesideAnArchiveIsAClass) {
  write("class/alice/part0_warmup.cpp");
  archive("class/bob.zip");
  EXPECT_EQ(namesOf({"class"}), (Names{"alice", "bob"}));
}

TEST_F(Finding, WhatIsNoSubmissionIsNamedAndStopsNothing) {
  write("notes.txt");
  write("empty/readme.txt");
  archive("two/work.zip");
  archive("two/work again.zip");
  write("good/part0_warmup.cpp");
  fs::create_directories(folder_ / "nothing");
  fs::create_directories(folder_ / "class");
  fs::rename(folder_ / "two", folder_ / "class/two");
  fs::create_directory_symlink(folder_ / "good", folder_ / "class/link");
  const FoundSubmissions found = find({"notes.txt", "gone", "nothing", "empty", "class", "good"});
  ASSERT_EQ(found.submissions.size(), 1u);
  EXPECT_EQ(found.submissions[0].name, "good");
  std::string all;
  for (const std::string& remark : found.remarks) all += remark + "\n";
  for (const char* words :
       {"notes.txt\" was left out: a submission is", "nothing\" was left out: the folder is empty",
        "empty\" was left out: there is no submission in it",
        "two\" was left out: there are 2 archives in it",
        "link\" was left out: links within a class are not followed"})
    EXPECT_NE(all.find(words), std::string::npos) << words << "\n" << all;
}

TEST_F(Finding, WhatIsLeftOutKeepsItsNameAndHasAReason) {
  write("class/alice/part0_warmup.cpp");
  write("class/Bob (1).rar");
  archive("class/carol/work.zip");
  archive("class/carol/work again.zip");
  write("class/dora/part3_mine.cpp");
  fs::create_directory_symlink(folder_ / "class/alice", folder_ / "class/emil");
  const FoundSubmissions found = find({"class"});
  ASSERT_EQ(found.submissions.size(), 1u);
  Names names;
  for (const LeftOut& one : found.leftOut) {
    names.push_back(one.name);
    EXPECT_FALSE(std::islower(static_cast<unsigned char>(one.reason.front()))) << one.reason;
    EXPECT_TRUE(one.reason.ends_with(".")) << one.reason;
  }
  EXPECT_EQ(names, (Names{"Bob_1_", "carol", "dora", "emil"}));
  EXPECT_EQ(found.remarks.size(), found.leftOut.size());
}

TEST_F(Finding, AFolderWithoutASubmissionIsLeftOutForWhatIsWrongWithIt) {
  write("class/ada/part0_warmup.cpp");
  fs::create_directories(folder_ / "class/empty");
  write("class/hidden/.DS_Store");
  fs::create_directories(folder_ / "class/wrapped/deeper");
  write("class/packed/work.7z");
  write("class/rar/readme.txt");
  write("class/rar/WORK.RAR");
  write("class/renamed/part1_stratified-1.cpp");
  write("class/numberless/work/parts.cpp");
  write("class/other/readme.txt");
  write("class/loose.rar");
  write("class/part3.cpp");
  std::map<std::string, std::string> reasons;
  for (const LeftOut& one : find({"class"}).leftOut) reasons[one.name] = one.reason;
  const std::string general = "A submission is a folder with part*.cpp, a zip or a tar.";
  const std::map<std::string, std::string> expected{
      {"empty", "The folder is empty."},
      {"hidden", "The folder is empty."},
      {"wrapped", "The folder is empty."},
      {"packed", ".7z is not read: a zip or a tar is."},
      {"rar", ".rar is not read: a zip or a tar is."},
      {"loose", ".rar is not read: a zip or a tar is."},
      {"renamed",
       "\"part1_stratified-1.cpp\" is not the name of a file of the coursework, such as "
       "part1_stratified.cpp."},
      {"numberless",
       "\"parts.cpp\" is not the name of a file of the coursework, such as part0_warmup.cpp."},
      {"other", general},
      {"part3", general}};
  EXPECT_EQ(reasons, expected);
}

TEST_F(Finding, AFolderThatIsNamedAloneSaysTheSame) {
  write("renamed/part3.cpp");
  write("packed/work.7z");
  const FoundSubmissions found = find({"renamed", "packed"});
  ASSERT_EQ(found.leftOut.size(), 2u);
  EXPECT_EQ(found.leftOut[0].reason, ".7z is not read: a zip or a tar is.");
  EXPECT_NE(found.leftOut[1].reason.find("such as part3_lambertian.cpp"), std::string::npos)
      << found.leftOut[1].reason;
}

TEST_F(Finding, ADocumentBesideSubmissionsIsNobodys) {
  write("class/alice/part0_warmup.cpp");
  write("class/grades.CSV");
  write("class/submission_metadata.yml");
  write("class/course.yaml");
  write("class/Thumbs.db");
  write("class/bob.cpp");
  const FoundSubmissions found = find({"class"});
  ASSERT_EQ(found.submissions.size(), 1u);
  ASSERT_EQ(found.leftOut.size(), 1u);
  EXPECT_EQ(found.leftOut[0].name, "bob") << "who may have handed it in";
  EXPECT_EQ(std::count_if(found.remarks.begin(), found.remarks.end(),
                          [](const std::string& remark) {
                            return remark.ends_with(" was taken for nobody's: it is a document.");
                          }),
            4);
}

TEST_F(Finding, AFolderOfNothingButFilesIsLeftOutAsOne) {
  write("good/part0_warmup.cpp");
  write("bob/part3.cpp");
  write("bob/readme.txt");
  const FoundSubmissions found = find({"good", "bob"});
  ASSERT_EQ(found.leftOut.size(), 1u);
  EXPECT_EQ(found.leftOut[0].name, "bob");
  EXPECT_EQ(found.leftOut[0].source, fs::canonical(folder_ / "bob"));
}

// Root may read everything, but for its privileges. Another user may not be able to reach the
// folder.
class WithoutPrivileges {
 public:
  WithoutPrivileges() {
    EXPECT_EQ(syscall(SYS_capget, &header_, before_.data()), 0);
    Capabilities none = before_;
    for (__user_cap_data_struct& word : none) word.effective = 0;
    EXPECT_EQ(syscall(SYS_capset, &header_, none.data()), 0);
  }
  ~WithoutPrivileges() { EXPECT_EQ(syscall(SYS_capset, &header_, before_.data()), 0); }
  WithoutPrivileges(const WithoutPrivileges&) = delete;
  WithoutPrivileges& operator=(const WithoutPrivileges&) = delete;

 private:
  using Capabilities = std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3>;

  __user_cap_header_struct header_{_LINUX_CAPABILITY_VERSION_3, 0};
  Capabilities before_{};
};

TEST_F(Finding, AFolderThatCannotBeReadIsLeftOut) {
  write("class/alice/part0_warmup.cpp");
  write("class/bob/part0_warmup.cpp");
  fs::permissions(folder_ / "class/bob", fs::perms::none);
  FoundSubmissions found;
  {
    const WithoutPrivileges here;
    found = find({"class"});
  }
  fs::permissions(folder_ / "class/bob", fs::perms::owner_all);
  ASSERT_EQ(found.leftOut.size(), 1u);
  EXPECT_EQ(found.leftOut[0].name, "bob");
  EXPECT_NE(found.leftOut[0].reason.find("cannot be read"), std::string::npos);
}

TEST_F(Finding, WhatIsLeftOutTakesNoNameFromASubmission) {
  archive("class/bob.zip");
  write("class/bob.7z");
  write("class/bob.rar");
  const FoundSubmissions found = find({"class"});
  ASSERT_EQ(found.submissions.size(), 1u);
  EXPECT_EQ(found.submissions[0].name, "bob");
  ASSERT_EQ(found.leftOut.size(), 2u);
  EXPECT_EQ(found.leftOut[0].name, "bob-2");
  EXPECT_EQ(found.leftOut[1].name, "bob-3");
}

TEST_F(Finding, AFileThatIsNotThereIsNobodys) {
  write("good/part0_warmup.cpp");
  const FoundSubmissions found = find({"good", "godo", "goood"});
  EXPECT_TRUE(found.leftOut.empty());
  EXPECT_EQ(found.missing, (Names{folder_ / "godo", folder_ / "goood"}));
}

TEST_F(Finding, AClassWithinAClassIsLeftOutWithTheNumberOfItsSubmissions) {
  write("class/ada/part0_warmup.cpp");
  write("class/section B/Bo/part0_warmup.cpp");
  archive("class/section B/Cy/handed in.zip");
  write("class/section C/Di/part0_warmup.cpp");
  archive("class/section C/Eve.zip");
  const FoundSubmissions found = find({"class"});
  ASSERT_EQ(found.submissions.size(), 1u);
  EXPECT_EQ(found.submissions[0].name, "ada");
  ASSERT_EQ(found.leftOut.size(), 2u);
  for (const LeftOut& one : found.leftOut)
    EXPECT_EQ(one.reason,
              "It holds 2 submissions: name it by itself on the command line, or the one that "
              "counts.");
  EXPECT_EQ(namesOf({"class/section B"}), (Names{"Bo", "Cy"}));
}

TEST_F(Finding, WhoeverHasAnEarlierNameKeepsIt) {
  archive("class/Alex Kim.zip");
  write("class/Alex Kim/part0_warmup.cpp");
  const FoundSubmissions found = find({"class"}, {{"class/Alex Kim.zip", "Alex_Kim"}});
  ASSERT_EQ(found.submissions.size(), 2u);
  EXPECT_EQ(found.submissions[0].name, "Alex_Kim");
  EXPECT_TRUE(found.submissions[0].isArchive);
  EXPECT_EQ(found.submissions[1].name, "Alex_Kim-2");
  ASSERT_EQ(found.remarks.size(), 1u);
  EXPECT_NE(found.remarks[0].find("another submission has been graded as Alex_Kim"),
            std::string::npos)
      << found.remarks[0];
  // Alone, too.
  const FoundSubmissions second = find({"class/Alex Kim"}, {{"class/Alex Kim", "Alex_Kim-2"}});
  ASSERT_EQ(second.submissions.size(), 1u);
  EXPECT_EQ(second.submissions[0].name, "Alex_Kim-2");
  EXPECT_TRUE(second.remarks.empty());
}

TEST_F(Finding, NobodyGetsTheEarlierNameOfOneElsewhere) {
  write("group1/ada/part0_warmup.cpp");
  write("group2/Ada/part0_warmup.cpp");
  write("group2/ben/part0_warmup.cpp");
  fs::create_directories(folder_ / "group3/ada");
  write("group3/cy/part0_warmup.cpp");
  const std::map<std::string, std::string> earlier{{"group1/ada", "ada"}};
  const FoundSubmissions second = find({"group2"}, earlier);
  ASSERT_EQ(second.submissions.size(), 2u);
  EXPECT_EQ(second.submissions[0].name, "Ada-2");
  const FoundSubmissions third = find({"group3"}, earlier);
  ASSERT_EQ(third.leftOut.size(), 1u);
  EXPECT_EQ(third.leftOut[0].name, "ada-2");
}

TEST_F(Finding, WhatIsLeftOutKeepsTheNameThatItWasGradedUnder) {
  fs::create_directories(folder_ / "class/ada");
  write("class/ben/part0_warmup.cpp");
  const FoundSubmissions found = find({"class"}, {{"class/ada", "ada"}});
  ASSERT_EQ(found.leftOut.size(), 1u);
  EXPECT_EQ(found.leftOut[0].name, "ada");
}

TEST_F(Finding, TheSamePlaceCountsOnce) {
  write("a/part0_warmup.cpp");
  EXPECT_EQ(namesOf({"a", "a/../a", "a"}), Names{"a"});
}

TEST_F(Finding, NamesAreUniqueAndSafe) {
  write("1/work/part0_warmup.cpp");
  write("2/work/part0_warmup.cpp");
  archive("3/Work.zip");
  write("4/work-2/part0_warmup.cpp");
  write("5/\xc3\x9c\xc3\xa9 <b>/part0_warmup.cpp");
  const Names all =
      namesOf({"1/work", "2/work", "3/Work.zip", "4/work-2", "5/\xc3\x9c\xc3\xa9 <b>"});
  Names lower;
  for (const std::string& name : all) lower.push_back(lowerCase(name));
  std::sort(lower.begin(), lower.end());
  EXPECT_EQ(lower, (Names{"work", "work-2", "work-2-2", "work-3", "\u00dc\u00e9_b_"}));
}

TEST(SubmissionNames, AreSafeInFoldersTablesAndTerminals) {
  EXPECT_EQ(safeName("Ada Lovelace (1)"), "Ada_Lovelace_1_");
  EXPECT_EQ(safeName("Ada_-x"), "Ada_-x");
  for (const char* empty : {"", ".", "..", "---", "\xff\xff", "/"})
    EXPECT_EQ(safeName(empty), "submission") << empty;
  EXPECT_EQ(safeName("../../etc"), "_.._etc");
  EXPECT_EQ(safeName("-rf"), "rf");
  EXPECT_EQ(safeName(std::string(500, 'a')).size(), kLongestName);
  UniqueNames names;
  EXPECT_EQ(names.unique(std::string(80, 'a')).size(), kLongestName);
  EXPECT_EQ(names.unique(std::string(80, 'a')), std::string(78, 'a') + "-2");
}

TEST_F(Finding, NamesDoNotDependOnWhoElseIsThere) {
  const std::string mueller = "M\u00fcller", moeller = "M\u00f6ller";
  for (const std::string& name : {mueller, moeller}) write("class/" + name + "/part0_warmup.cpp");
  EXPECT_EQ(namesOf({"class"}), (Names{moeller, mueller}));
  EXPECT_EQ(namesOf({"class/" + mueller}), Names{mueller});
}

TEST(SubmissionNames, KeepLettersOfAllScripts) {
  for (const char* name : {"Zo\u00eb", "\u5c71\u7530\u592a\u90ce", "\u039b\u03ac\u03bc\u03b4\u03b1",
                           "\U0001d538", "Mu\u0308ller"})
    EXPECT_EQ(safeName(name), name);
  // No UTF-8: a byte alone, an overlong slash, a surrogate, one beyond U+10FFFF, one cut off.
  for (const char* bytes : {"\xfc", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82"})
    EXPECT_EQ(safeName(std::string("a") + bytes), "a_");
  // Controls, spaces, and what turns the direction of writing round.
  for (const char* unseen : {"\u0085", "\u00a0", "\u2028", "\u202e", "\u200b", "\ufeff"})
    EXPECT_EQ(safeName(std::string("a") + unseen + "b"), "a_b");
}

TEST(SubmissionNames, AreCutBetweenCharacters) {
  std::string letters;
  for (int i = 0; i < 40; ++i) letters += "\u5c71";  // of three bytes each
  EXPECT_EQ(safeName(letters), letters.substr(0, 78));
  UniqueNames names;
  EXPECT_EQ(names.unique(safeName(letters)), letters.substr(0, 78));
  EXPECT_EQ(names.unique(safeName(letters)), letters.substr(0, 78) + "-2");
}

TEST(SubmissionNames, AreInNaturalOrder) {
  Names all{"b", "task10", "a", "task9", "Task2", "task 1", "task010", "task"};
  std::sort(all.begin(), all.end(), naturalLess);
  EXPECT_EQ(all, (Names{"a", "b", "task", "task 1", "Task2", "task9", "task010", "task10"}));
}

}  // namespace
}  // namespace pathmark::submission
