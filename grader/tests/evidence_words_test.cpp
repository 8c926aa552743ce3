// What is measured of each function, as a student reads it in the evidence for a mistake.
#include "checks/scenes.h"
#include "diagnosis/catalogue.h"
#include "diagnosis/probes.h"
#include "host/coursework_builder.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <regex>
#include <utility>

namespace pathmark::diagnosis {
namespace {

// Those of the solutions, each asked as where a mistake is named.
class EvidenceWords : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const CourseworkBuild build = buildCoursework(courseworkFolder("solutions"));
    for (const PartContract& part : parts()) {
      if (part.bonus) continue;
      WorkerProcess::Options options;
      options.program = linkWithStandIns(build, std::array{part.part}).worker;
      options.courseworkFolder = build.folder;
      WorkerProcess worker(std::move(options));
      worker.loadScene(checks::emptyRoom());
      for (const FunctionContract& f : contract())
        if (f.part == part.part)
          seen_[f.function] = probe(worker, f.function, ProbeSeed::kCatalogue);
    }
  }

  static inline std::map<CourseworkFunction, Signature> seen_;
};

TEST_F(EvidenceWords, NameChannelsAndComponentsAndHaveNoIndices) {
  const std::regex index(R"(\[\d|channel \d)");
  for (const auto& [function, signature] : seen_)
    for (const Feature& feature : signature.features())
      EXPECT_FALSE(std::regex_search(feature.what, index)) << feature.what;
}

TEST_F(EvidenceWords, ThatAskAQuestionHaveAnAnswer) {
  std::size_t questions = 0;
  for (const auto& [function, signature] : seen_)
    for (const Feature& feature : signature.features()) {
      EXPECT_EQ(feature.what.starts_with("whether "), feature.isAnswer) << feature.what;
      questions += feature.isAnswer ? 1u : 0u;
    }
  EXPECT_GT(questions, 100u);
}

// Without this a mistake would get no name any more.
TEST_F(EvidenceWords, AreThoseOfTheCatalogue) {
  const Catalogue catalogue = readCatalogue(catalogueFile());
  for (const auto& [function, signature] : seen_) {
    const FunctionCatalogue* known = catalogue.find(function);
    ASSERT_NE(known, nullptr) << contractOf(function).name;
    EXPECT_EQ(known->features, hashOf(signature)) << contractOf(function).name;
  }
}

}  // namespace
}  // namespace pathmark::diagnosis
