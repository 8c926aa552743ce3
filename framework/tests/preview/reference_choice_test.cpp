// Which reference there is, and what is said where there is none.
#include "preview/compare/reference_choice.h"

#include "film/image_file.h"
#include "host/session.h"
#include "support/test_coursework_files.h"
#include "support/test_images.h"
#include "support/test_pictures.h"

#include <gtest/gtest.h>

namespace pathmark::test {
namespace {

using namespace preview;

constexpr int kWidth = 8, kHeight = 6;

void expectNone(const FoundReference& found, const std::string& words) {
  EXPECT_EQ(found.reference, nullptr);
  EXPECT_NE(found.why.find(words), std::string::npos) << found.why;
  EXPECT_EQ(found.why.back(), '.') << found.why;
}

// The tests' own folder of references; one at a time.
std::filesystem::path shippedFolder;

std::filesystem::path shippedFile(const std::string& scene) {
  return shippedFolder / (scene + ".exr");
}

class ReferenceChoice : public ::testing::Test {
 protected:
  ReferenceChoice() { shippedFolder = folder_.path(); }

  void ship(const std::string& hash, int width = kWidth, int height = kHeight) {
    writeImage(shippedFile("test"), gradientImage(width, height, 0.01f), 1.0,
               {.sceneHash = hash, .replicates = 16});
  }

  Picture picture(int width = kWidth, int height = kHeight) {
    return pictureOf(scene_, gradientImage(width, height, 0.1f));
  }

  FoundReference find(const Picture& p) {
    return finder_.find(wish_, std::make_shared<Picture>(p));
  }

  FoundReference find(const std::filesystem::path& file) {
    wish_ = {.source = ReferenceSource::kFile,
             .file = file,
             .loads = wish_.loads + 1,
             .number = wish_.number + 1};
    return find(picture());
  }

  FoundReference keep(const Picture& p) {
    wish_ = {.source = ReferenceSource::kKept,
             .kept = std::make_shared<Picture>(p),
             .number = wish_.number + 1};
    return find(picture());
  }

  TemporaryFolder folder_;
  std::shared_ptr<const PreviewScene> scene_ = testScene(kWidth, kHeight);
  ReferenceWish wish_{.number = 1};
  ReferenceFinder finder_{shippedFile};
};

TEST_F(ReferenceChoice, TheShippedReferenceOfTheSceneIsFoundAndReadOnce) {
  ship(scene_->hash);
  const FoundReference found = find(picture());
  ASSERT_NE(found.reference, nullptr) << found.why;
  EXPECT_EQ(found.reference->replicates, 16u);
  EXPECT_EQ(found.reference->image->rgb, gradientImage(kWidth, kHeight).rgb);
  std::filesystem::remove(shippedFile("test"));
  EXPECT_EQ(find(picture()).reference, found.reference);
}

TEST_F(ReferenceChoice, SaysOfNearMirrorsThatTracePathHardlyFindsTheirLight) {
  ship(scene_->hash);
  EXPECT_EQ(find(picture()).note, "");
  PreviewScene smooth = *scene_;
  smooth.loaded.flat.materials.push_back({.kind = FlatMaterialKind::kPhong, .exponent = 30000.0f});
  Picture mirrored = picture();
  mirrored.scene = std::make_shared<const PreviewScene>(smooth);
  EXPECT_NE(find(mirrored).note.find("exponent 30000 are nearly mirrors"), std::string::npos);
  mirrored.made.estimator = Estimator::kMis;
  EXPECT_EQ(find(mirrored).note, "");
}

TEST_F(ReferenceChoice, AMissingReferenceIsASentence) {
  expectNone(find(picture()), "There is no reference for test");
}

TEST_F(ReferenceChoice, AnUnreadableReferenceIsASentence) {
  writeText(shippedFile("test"), "no picture");
  expectNone(find(picture()), "The reference cannot be used");
}

TEST_F(ReferenceChoice, AReferenceOfAnotherVersionOfTheSceneIsASentence) {
  ship("another hash");
  expectNone(find(picture()), "another version of the scene");
}

TEST_F(ReferenceChoice, AReferenceOfAnotherSizeIsASentence) {
  ship(scene_->hash, kWidth, kHeight + 1);
  expectNone(find(picture()), "has 8x7 pixels, and this picture 8x6");
}

TEST_F(ReferenceChoice, AMovedCameraIsASentenceThatSaysHowToPutItBack) {
  ship(scene_->hash);
  Picture moved = picture();
  moved.fileCamera = false;
  expectNone(find(moved), "press C");
}

TEST_F(ReferenceChoice, TheWarmUpIsASentence) {
  ship(scene_->hash);
  Picture warmUp = picture();
  warmUp.made.estimator = Estimator::kWarmUp;
  expectNone(find(warmUp), "warm-up");
}

TEST_F(ReferenceChoice, IsForThePicturesOwnLightPathsOnly) {
  ship(scene_->hash);
  Picture caustics = picture();
  caustics.paths = "LS+DE";
  expectNone(find(caustics), "The reference has all light");
  keep(caustics);
  EXPECT_NE(find(caustics).reference, nullptr);
  expectNone(find(picture()), "has the light paths LS+DE, and this one all light");
  writeImage(folder_ / "a.exr", gradientImage(kWidth, kHeight, 0.01f), 1.0,
             {.replicates = 16, .paths = "LE"});
  const FoundReference file = find(folder_ / "a.exr");
  ASSERT_NE(file.reference, nullptr);
  EXPECT_NE(file.note.find("It has the light paths LE, and this picture all light."),
            std::string::npos)
      << file.note;
}

TEST_F(ReferenceChoice, AKeptPictureIsAReferenceForItsCameraOnly) {
  Picture kept = picture();
  kept.fileCamera = false;
  kept.series = 7;
  const FoundReference found = keep(kept);
  ASSERT_NE(found.reference, nullptr) << found.why;
  EXPECT_EQ(found.reference->series, 7u);
  EXPECT_EQ(found.reference->replicates, kept.replicates);
  Picture moved = picture();
  moved.camera.eye = {1.0f, 0.0f, 0.0f};
  expectNone(find(moved), "another camera");
  ++wish_.number;  // chosen again
  EXPECT_EQ(find(picture()).reference, found.reference);
}

TEST_F(ReferenceChoice, AKeptPictureOfAnotherSceneIsASentence) {
  expectNone(keep(pictureOf(testScene(kWidth, kHeight, "other"), gradientImage(kWidth, kHeight))),
             "of other (8x6), and this one of test");
}

TEST_F(ReferenceChoice, AKeptPictureWithoutKnownNoiseIsASentence) {
  Picture early = picture();
  early.replicates = 0;
  early.image.variance.clear();
  expectNone(keep(early), "too early");
  wish_.kept = nullptr;
  expectNone(find(picture()), "No picture has been kept");
}

TEST_F(ReferenceChoice, AFileIsAReferenceIfItHasThePicturesSize) {
  writeImage(folder_ / "a.pfm", gradientImage(kWidth, kHeight), 1.0);
  const FoundReference found = find(folder_ / "a.pfm");
  ASSERT_NE(found.reference, nullptr) << found.why;
  EXPECT_EQ(found.reference->replicates, 0u);
  EXPECT_NE(found.note.find("counts as exact"), std::string::npos) << found.note;
  expectNone(find(picture(5, 5)), "only images of the same size");
  writeImage(folder_ / "a.exr", gradientImage(kWidth, kHeight, 0.1f), 1.0, {.sceneHash = "other"});
  EXPECT_NE(find(folder_ / "a.exr").note.find("another scene"), std::string::npos);
}

TEST_F(ReferenceChoice, AFileThatCannotBeUsedIsASentence) {
  expectNone(find(std::filesystem::path()), "Type the name");
  expectNone(find(folder_ / "none.exr"), "there is no such file");
  expectNone(find(folder_.path()), "");
  expectNone(find(folder_ / "a.txt"), "a.txt");
  writeImage(folder_ / "a.png", gradientImage(kWidth, kHeight), 1.0);
  expectNone(find(folder_ / "a.png"), "no radiance");
  writeText(folder_ / "broken.exr", "no picture");
  expectNone(find(folder_ / "broken.exr"), "broken.exr");
}

TEST_F(ReferenceChoice, AFileIsReadAgainWhenItIsAskedForAgain) {
  expectNone(find(folder_ / "a.pfm"), "there is no such file");
  writeImage(folder_ / "a.pfm", gradientImage(kWidth, kHeight), 1.0);
  const auto first = find(folder_ / "a.pfm").reference;
  ASSERT_NE(first, nullptr);
  ++wish_.number;
  EXPECT_EQ(find(picture()).reference, first);
  EXPECT_NE(find(folder_ / "a.pfm").reference->id, first->id);
}

// The one that is shipped, of a scene as the window has it.
TEST(ShippedReference, FitsItsScene) {
  const auto scene = std::make_shared<PreviewScene>();
  scene->loaded = loadScene(shippedSceneFile("cornell_box"));
  scene->hash = sceneHash(scene->loaded);
  const FlatCamera& camera = scene->loaded.flat.camera;
  ReferenceFinder finder;
  const Image image =
      gradientImage(static_cast<int>(camera.width), static_cast<int>(camera.height), 1.0f);
  const FoundReference found =
      finder.find({.number = 1}, std::make_shared<Picture>(pictureOf(scene, image)));
  ASSERT_NE(found.reference, nullptr) << found.why;
  EXPECT_GE(found.reference->replicates, 8u);
}

}  // namespace
}  // namespace pathmark::test
