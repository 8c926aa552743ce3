// Which files of a submission are taken, from folders and from archives.
#include "support/collecting.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>

namespace pathmark::submission {
namespace {

namespace fs = std::filesystem;
using test::ArchiveKind;
using test::MadeArchive;

using Names = std::vector<std::string>;

constexpr const char* kPart3 = "part3_lambertian.cpp";
constexpr const char* kPart4 = "part4_phong.cpp";

TEST_F(Collecting, TakesTheSameFromAFolderAndFromEveryKindOfArchive) {
  write(kPart3, "three");
  write(kPart4, "four");
  write("scenes/my_scene.json", "{}");
  write("scenes/meshes/cup.obj", "v 0 0 0");
  const Collected folder = collectedFolder();
  EXPECT_EQ(names(folder),
            (Names{kPart3, kPart4, "scenes/meshes/cup.obj", "scenes/my_scene.json"}));
  EXPECT_TRUE(folder.failure.empty()) << folder.failure;

  MadeArchive made;
  made.file(kPart3, "three").file(kPart4, "four");
  made.file("scenes/my_scene.json", "{}").file("scenes/meshes/cup.obj", "v 0 0 0");
  for (const ArchiveKind kind : {ArchiveKind::kZip, ArchiveKind::kTar, ArchiveKind::kTarGz,
                                 ArchiveKind::kTarXz, ArchiveKind::kTarZst, ArchiveKind::kTarBz2}) {
    const Collected archive = collected(made, kind);
    EXPECT_EQ(archive.files, folder.files);
    EXPECT_EQ(archive.contents, folder.contents);
    EXPECT_EQ(archive.remarks, folder.remarks);
  }
}

TEST_F(Collecting, HashesNeitherWrapperNorOrderNorTimes) {
  const Collected plain = collected(MadeArchive().file(kPart3, "three").file(kPart4, "four"));
  for (const char* wrapper : {"./", "alice/", "a/b/c/", "alice/student/"}) {
    const Collected wrapped = collected(MadeArchive()
                                            .time(2'000'000)
                                            .file(std::string(wrapper) + kPart4, "four")
                                            .file(std::string(wrapper) + kPart3, "three"));
    EXPECT_EQ(wrapped.files, plain.files) << wrapper;
    EXPECT_EQ(wrapped.contents, plain.contents) << wrapper;
  }
}

TEST_F(Collecting, HashesEveryByteAndName) {
  const std::string one = collected(MadeArchive().file(kPart3, "ab").file(kPart4, "c")).contents;
  EXPECT_NE(collected(MadeArchive().file(kPart3, "a").file(kPart4, "bc")).contents, one);
  EXPECT_NE(collected(MadeArchive().file(kPart3, "ab")).contents, one);
  EXPECT_NE(collected(MadeArchive().file(kPart3, "ab").file("part5_path.cpp", "c")).contents, one);
}

TEST_F(Collecting, IgnoresWhatIsNotTheCourseworksInOneRemark) {
  write(kPart3);
  for (const char* name : {"CMakeLists.txt", "helper.h", ".git/config", "build/part4_phong.cpp",
                           "notes.txt", "scenes/picture.png", "scenes/deeper/other.json"})
    write(name);
  const Collected folder = collectedFolder();
  EXPECT_EQ(names(folder), Names{kPart3});
  expectRemark(folder, "5 other files were ignored: only part*.cpp and scenes/ are taken.");
}

TEST_F(Collecting, SaysWhatIsMissing) {
  expectRemark(collected(MadeArchive().file(kPart3)),
               "part0_warmup.cpp, part1_stratified.cpp, part2_lights.cpp, part4_phong.cpp, "
               "part5_path.cpp, part6_roulette.cpp are missing.");
}

TEST_F(Collecting, RemarksOnNoFileThatTheSelectionDoesNotNeed) {
  const MadeArchive made = MadeArchive()
                               .file(kPart3)
                               .file("Part4_Phong.cpp")
                               .file("a/part5_path.cpp", "1")
                               .file("b/part5_path.cpp", "2")
                               .file("part6.cpp")
                               .file("scenes/-rf.json");
  made.write(ArchiveKind::kTar, folder_ / "work.tar");
  const auto remarks = [&](std::vector<int> only) {
    return collect({"work", folder_ / "work.tar", true}, {}, only).remarks;
  };
  EXPECT_EQ(remarks({3}), Names{});
  EXPECT_EQ(remarks({2}), Names{"part2_lights.cpp is missing."});
  EXPECT_EQ(remarks({8}), Names{"part8_mis.cpp is missing."});
  EXPECT_EQ(remarks({4}), Names{"Part4_Phong.cpp was renamed to part4_phong.cpp."});
  EXPECT_EQ(remarks({5}).size(), 1u);
  EXPECT_EQ(remarks({6}).size(), 3u) << "it is missing, and one of almost that name is ignored";
  EXPECT_EQ(remarks({}).size(), 6u);
}

TEST_F(Collecting, TakesTheSameWhateverIsSelected) {
  write(kPart3, "three");
  write(kPart4, "four");
  const std::vector<int> only{3};
  const Collected some = collect({"submission", folder_ / "submission", false}, {}, only);
  EXPECT_EQ(some.files, collectedFolder().files);
  EXPECT_EQ(some.contents, collectedFolder().contents);
}

TEST_F(Collecting, SaysThatNothingWasTakenOfASelectedPart) {
  MadeArchive().file("readme.txt").write(ArchiveKind::kZip, folder_ / "work.zip");
  const std::vector<int> only{3};
  EXPECT_EQ(collect({"work", folder_ / "work.zip", true}, {}, only).failure,
            "Nothing was taken: neither part3_lambertian.cpp nor another file of the coursework is "
            "in it.");
}

TEST_F(Collecting, KeepsApartWhichRemarksAreAboutRefusedScenes) {
  const Collected one = collected(MadeArchive()
                                      .file(kPart4)
                                      .file("scenes/-rf.json")
                                      .file("scenes/-rf.obj")
                                      .file("scenes/a.json", "1")
                                      .file("scenes/A.json", "2")
                                      .file("../scenes/out.json")
                                      .symbolicLink("scenes/link.json", kPart4)
                                      .symbolicLink("notes.json", kPart4));
  ASSERT_EQ(one.refusedScenes.size(), 4u) << allRemarks(one);
  for (const std::string& remark : one.refusedScenes) {
    EXPECT_NE(remark.find(".json"), std::string::npos) << remark;
    EXPECT_EQ(std::count(one.remarks.begin(), one.remarks.end(), remark), 1) << remark;
  }
  EXPECT_TRUE(collected(MadeArchive().file(kPart4).file("scenes/a.json")).refusedScenes.empty());
}

TEST_F(Collecting, TakesTheFirstScenesByNameAndNamesTheOthers) {
  MadeArchive made;
  made.file(kPart4).file("scenes/z.obj", "v");
  for (int k = 39; k >= 0; --k) made.file(fmt::format("scenes/{:02}.json", k), std::to_string(k));
  const Collected one = collected(made);
  EXPECT_EQ(one.files.size(), 34u);
  EXPECT_TRUE(one.files.contains("scenes/31.json"));
  EXPECT_FALSE(one.files.contains("scenes/32.json"));
  EXPECT_TRUE(one.files.contains("scenes/z.obj"));
  const std::string remark =
      "scenes/32.json, scenes/33.json, scenes/34.json, scenes/35.json, scenes/36.json and 3 more "
      "were left out: of the scenes the first 32 by name are taken.";
  expectRemark(one, remark);
  EXPECT_EQ(one.refusedScenes, Names{remark});
}

// As many folders with coursework in them as a submission may have entries.
TEST_F(Collecting, ManyFoldersWithTheSameFileAreOneRefusal) {
  const Limits limits;
  MadeArchive made;
  for (std::size_t k = 0; k < limits.entries / 2; ++k) {
    made.file(fmt::format("a/{}/b/c/d/e/f/part0_warmup.cpp", k), std::to_string(k % 2));
    made.file(fmt::format("a/{}/b/c/d/e/f/scenes/{}.obj", k, k), "v");
  }
  const Collected one = collected(made);
  EXPECT_TRUE(one.files.contains("scenes/7.obj"));
  EXPECT_FALSE(one.files.contains("part0_warmup.cpp"));
  expectRemark(one,
               "part0_warmup.cpp was refused: it was handed in 5000 times with different "
               "contents (a/0/b/c/d/e/f/part0_warmup.cpp, a/1/");
  expectRemark(one, "part0_warmup.cpp and 4995 more).");
}

TEST_F(Collecting, SaysWhenThereIsNothingToTake) {
  const Collected empty = collected(MadeArchive().file("readme.txt"));
  EXPECT_TRUE(empty.files.empty());
  EXPECT_NE(empty.failure.find("none of the files part0_warmup.cpp"), std::string::npos)
      << empty.failure;
}

TEST_F(Collecting, TakesOnlyStudentOfAWholeProject) {
  MadeArchive made;
  for (const char* folder : {"student", "solutions", "grader/variants", "framework/tests"})
    made.file(std::string("pathmark/") + folder + "/" + kPart3, folder);
  made.file("pathmark/grader/checks/part3_checks.cpp");
  made.file("pathmark/scenes/cornell_box.json").file("pathmark/student/scenes/mine.json", "mine");
  const Collected project = collected(made);
  EXPECT_EQ(names(project), (Names{kPart3, "scenes/mine.json"}));
  EXPECT_EQ(project.files.at(kPart3), "student");
  EXPECT_EQ(project.remarks.size(), 2u) << allRemarks(project);  // what is missing, what is ignored
}

TEST_F(Collecting, TakesNoLabForTheCoursework) {
  const Collected student = collected(MadeArchive()
                                          .file("student/part3_lambertian.cpp", "mine")
                                          .file("student/labs/uniform/part3_lambertian.cpp", "lab")
                                          .file("student/labs/uniform/part4_phong.cpp", "lab"));
  EXPECT_EQ(names(student), Names{kPart3});
  EXPECT_EQ(student.files.at(kPart3), "mine");
  // A folder of that name that belongs to no coursework is one like others.
  EXPECT_EQ(names(collected(MadeArchive().file("labs/week_3/part3_lambertian.cpp"))),
            Names{kPart3});
}

TEST_F(Collecting, RefusesTwoDifferentFilesOfOneName) {
  const Collected two = collected(MadeArchive()
                                      .file(kPart4)
                                      .file("new/part3_lambertian.cpp", "1")
                                      .file("old/part3_lambertian.cpp", "2"));
  EXPECT_EQ(names(two), Names{kPart4});
  expectRemark(two,
               "part3_lambertian.cpp was refused: it was handed in 2 times with different "
               "contents (new/part3_lambertian.cpp, old/part3_lambertian.cpp).");
}

TEST_F(Collecting, TakesTwoEqualFilesOfOneName) {
  const Collected two = collected(
      MadeArchive().file("a/" + std::string(kPart3), "1").file("b/" + std::string(kPart3), "1"));
  EXPECT_EQ(names(two), Names{kPart3});
  expectRemark(two, "part3_lambertian.cpp was handed in 2 times with the same contents.");
}

TEST_F(Collecting, RefusesNamesThatDifferOnlyByCapitals) {
  const Collected two =
      collected(MadeArchive().file(kPart4).file(kPart3, "1").file("Part3_Lambertian.CPP", "2"));
  EXPECT_EQ(names(two), Names{kPart4});
  expectRemark(two, "part3_lambertian.cpp was refused");
  const Collected scenes =
      collected(MadeArchive().file(kPart4).file("scenes/a.json", "1").file("scenes/A.json", "2"));
  EXPECT_EQ(names(scenes), Names{kPart4});
}

TEST_F(Collecting, RenamesAFileWithCapitals) {
  const Collected one = collected(MadeArchive().file("Part3_Lambertian.cpp", "1"));
  EXPECT_EQ(names(one), Names{kPart3});
  expectRemark(one, "Part3_Lambertian.cpp was renamed to part3_lambertian.cpp.");
}

TEST_F(Collecting, NamesAFileThatAlmostHasARightName) {
  const Collected one = collected(MadeArchive().file(kPart4).file("part3_lambertian (1).cpp"));
  EXPECT_EQ(names(one), Names{kPart4});
  expectRemark(one, "part3_lambertian (1).cpp was ignored: this is not the name");
}

TEST_F(Collecting, RefusesSceneNamesThatAreNotPlain) {
  const Collected one = collected(MadeArchive()
                                      .file(kPart4)
                                      .file("scenes/$(reboot).json")
                                      .file("scenes/-rf.json")
                                      .file("scenes/con:.json")
                                      .file("scenes/my scene (2).json"));
  EXPECT_EQ(names(one), (Names{kPart4, "scenes/my scene (2).json"}));
  expectRemark(one, "scenes/-rf.json was refused: names of scenes");
}

TEST_F(Collecting, TakesScenesWithLettersOfAllScriptsInTheirNames) {
  const Collected one = collected(MadeArchive()
                                      .file(kPart4)
                                      .file("scenes/K\u00fcche.json", "{}")
                                      .file("scenes/\u5c71/\u7530.obj")
                                      .file("scenes/a\u202eb.json")
                                      .file("scenes/a\u00a0b.json"));
  EXPECT_EQ(names(one), (Names{kPart4, "scenes/K\u00fcche.json", "scenes/\u5c71/\u7530.obj"}));
  expectRemark(one, "scenes/a\u00a0b.json was refused: names of scenes");
}

TEST_F(Collecting, RefusesWhatIsTooLargeAndTakesWhatJustFits) {
  const Limits limits{.codeBytes = 1000, .sceneBytes = 2000, .meshBytes = 3000};
  const Collected archive = collected(MadeArchive()
                                          .file(kPart3, std::string(1000, 'x'))
                                          .file(kPart4, std::string(1001, 'x'))
                                          .file("scenes/a.json", std::string(2001, 'x'))
                                          .file("scenes/b.json", std::string(2000, 'x'))
                                          .file("scenes/c.obj", std::string(3001, 'x')),
                                      ArchiveKind::kZip, limits);
  EXPECT_EQ(names(archive), (Names{kPart3, "scenes/b.json"}));
  expectRemark(archive, "part4_phong.cpp was refused: it is larger than");
  write(kPart3);
  write(kPart4, std::string(1001, 'x'));
  EXPECT_EQ(names(collectedFolder(limits)), Names{kPart3});
}

TEST_F(Collecting, FollowsNoLinkInAFolder) {
  test::writeBytes(folder_ / "secret/part3_lambertian.cpp", "secret");
  test::writeBytes(folder_ / "secret/scene.json", "secret");
  write(kPart4, "mine");
  fs::create_symlink(folder_ / "secret/part3_lambertian.cpp",
                     folder_ / "submission/part3_lambertian.cpp");
  fs::create_directory_symlink(folder_ / "secret", folder_ / "submission/scenes");
  fs::create_directory_symlink("..", folder_ / "submission/round");
  const Collected folder = collectedFolder();
  EXPECT_EQ(folder.files, (std::map<std::string, std::string>{{kPart4, "mine"}}));
  expectRemark(folder,
               "part3_lambertian.cpp was refused: it is a link, and links are not followed.");
  expectRemark(folder, "scenes was refused: it is a link");
}

TEST_F(Collecting, OpensNeitherPipesNorFoldersUnderAFilesName) {
  write(kPart3, "mine");
  ASSERT_EQ(mkfifo((folder_ / "submission/part4_phong.cpp").c_str(), 0600), 0);
  fs::create_directory(folder_ / "submission/part5_path.cpp");
  const Collected folder = collectedFolder();
  EXPECT_EQ(names(folder), Names{kPart3});
  expectRemark(folder, "part4_phong.cpp was refused: it is a pipe or a device.");
  expectRemark(folder, "part5_path.cpp was refused: it is a folder.");
}

TEST_F(Collecting, RefusesAFolderOfTooManyFiles) {
  write(kPart3);
  for (int i = 0; i < 20; ++i) write("file" + std::to_string(i));
  EXPECT_TRUE(collectedFolder({.entries = 20}).files.empty());
  EXPECT_EQ(names(collectedFolder({.entries = 21})), Names{kPart3});
}

TEST_F(Collecting, SaysThatAFolderIsGone) {
  expectRemark(collectedFolder(), "Nothing was taken: the folder cannot be read");
}

TEST_F(Collecting, WritesOutWhatItTookAndNothingElse) {
  const Collected archive = collected(MadeArchive()
                                          .file(kPart3, std::string("a\0b", 3))
                                          .file("scenes/meshes/cup.obj", "v")
                                          .file("../escaped.txt", "x"));
  const fs::path out = folder_ / "out";
  writeOut(archive, out);
  EXPECT_EQ(test::readBytes(out / kPart3), std::string("a\0b", 3));
  EXPECT_EQ(test::readBytes(out / "scenes/meshes/cup.obj"), "v");
  EXPECT_EQ(std::distance(fs::recursive_directory_iterator(out), {}), 4);
  EXPECT_FALSE(fs::exists(folder_ / "escaped.txt"));
  EXPECT_THROW(writeOut(archive, out), std::runtime_error);  // no longer empty
}

}  // namespace
}  // namespace pathmark::submission
