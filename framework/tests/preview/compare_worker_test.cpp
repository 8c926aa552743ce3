// The thread that compares.
#include "preview/compare/compare_worker.h"

#include "support/background_program.h"
#include "support/test_images.h"
#include "support/test_pictures.h"

#include <gtest/gtest.h>

#include <atomic>

namespace pathmark::test {
namespace {

using namespace preview;

CompareRequest request(std::uint64_t version, View view = View::kPicture) {
  Picture picture = pictureOf(testScene(16, 16), gradientImage(16, 16, 0.1f));
  picture.version = version;
  return {std::make_shared<Picture>(std::move(picture)), {.number = 1}, view};
}

bool hasVersion(const CompareWorker& worker, std::uint64_t version) {
  const auto newest = worker.newest();
  return newest && newest->picture->version == version;
}

TEST(CompareWorker, AnswersTheNewestRequestAndWakes) {
  std::atomic<int> woken = 0;
  CompareWorker worker([&] { ++woken; });
  EXPECT_EQ(worker.newest(), nullptr);
  for (std::uint64_t version = 1; version <= 200; ++version) worker.ask(request(version), false);
  EXPECT_TRUE(waitFor([&] { return hasVersion(worker, 200); }));
  EXPECT_TRUE(waitFor([&] { return woken > 0; }));
}

TEST(CompareWorker, GivesWhatIsToBeShown) {
  CompareWorker worker([] {});
  worker.ask(request(1, View::kNoise), true);
  ASSERT_TRUE(waitFor([&] { return worker.newest() != nullptr; }));
  EXPECT_EQ(worker.newest()->colours.view, View::kNoise);
}

TEST(CompareWorker, EndsWhileItHasWork) {
  for (int k = 0; k < 20; ++k) {
    CompareWorker worker([] {});
    for (std::uint64_t version = 1; version <= 5; ++version) worker.ask(request(version), true);
  }
}

}  // namespace
}  // namespace pathmark::test
