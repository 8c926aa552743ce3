// Naming mistakes by their signatures, made up ones.
#include "diagnosis/diagnose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace pathmark::diagnosis {
namespace {

constexpr double kError = 1e-3;
const double kNan = std::numeric_limits<double>::quiet_NaN();

Signature signatureOf(const std::vector<double>& values) {
  Signature signature;
  for (std::size_t k = 0; k < values.size(); ++k)
    signature.add("feature " + std::to_string(k), values[k], kError);
  return signature;
}

KnownSignature known(const std::string& name, const std::vector<double>& values) {
  return knownSignature(name, name + " in words", signatureOf(values));
}

FunctionCatalogue catalogueOf(std::vector<KnownSignature> mistakes) {
  const Signature right = signatureOf({0.5, 0.25, 1.0});
  return {CourseworkFunction::kLambertianPdf, hashOf(right), knownSignature("", "", right),
          std::move(mistakes)};
}

const FunctionCatalogue kTwo =
    catalogueOf({known("small", {0.4, 0.25, 1.0}), known("large", {0.6, 0.25, 0.9})});

TEST(Diagnosis, NamesTheMistakeWhoseFeaturesAllAgree) {
  const Diagnosis d = diagnose(signatureOf({0.6 + kError, 0.25 - kError, 0.9}), kTwo);
  EXPECT_EQ(d.mistake, "large");
  EXPECT_EQ(d.what, "large in words");
  EXPECT_NE(d.evidence.find("feature 0 is 0.601 (right: 0.5; with this mistake: 0.6)"),
            std::string::npos)
      << d.evidence;
  EXPECT_EQ(d.read, "handouts/part3_lambertian.md, 3.2 lambertianBRDF::pdf");
}

TEST(Diagnosis, SpeaksOfOneThingInTheSingular) {
  EXPECT_NE(diagnose(signatureOf({0.4, 0.25, 1.0}), kTwo)
                .evidence.find("Of 3 things that were measured 1 is not right"),
            std::string::npos);
  EXPECT_NE(diagnose(signatureOf({0.6, 0.25, 0.9}), kTwo)
                .evidence.find("Of 3 things that were measured 2 are not right"),
            std::string::npos);
}

TEST(Diagnosis, AnswersQuestionsByYesAndNo) {
  const auto answered = [](bool yes) {
    Signature signature;
    signature.addAnswer("whether it is black", yes);
    return signature;
  };
  const Signature right = answered(false);
  const FunctionCatalogue known{CourseworkFunction::kLambertianPdf,
                                hashOf(right),
                                knownSignature("", "", right),
                                {knownSignature("black", "it is black", answered(true))}};
  EXPECT_TRUE(
      diagnose(answered(true), known)
          .evidence.starts_with("whether it is black: yes (right: no; with this mistake: yes). "))
      << diagnose(answered(true), known).evidence;
}

TEST(Diagnosis, NamesNothingWhereOneFeatureDisagrees) {
  EXPECT_EQ(diagnose(signatureOf({0.6, 0.25, 0.95}), kTwo).mistake, "");
}

TEST(Diagnosis, NamesTheStubWhereNoMistakeAnswersLikeIt) {
  FunctionCatalogue withStub = kTwo;
  withStub.stub = known(kStub, {0.0, 0.0, 0.0});
  EXPECT_EQ(diagnose(signatureOf({0.0, 0.0, 0.0}), withStub).mistake, kStub);
  EXPECT_EQ(diagnose(signatureOf({0.4, 0.25, 1.0}), withStub).mistake, "small");
  withStub.stub = known(kStub, {0.6, 0.25, 0.9});
  EXPECT_EQ(diagnose(signatureOf({0.6, 0.25, 0.9}), withStub).mistake, "large");
  withStub.stub = known(kStub, {0.5, 0.25, 1.0});
  EXPECT_EQ(diagnose(signatureOf({0.5, 0.25, 1.0}), withStub).mistake, "") << "it is right";
}

TEST(Diagnosis, NamesNothingWhereTheFunctionMayBeRight) {
  EXPECT_EQ(diagnose(signatureOf({0.5, 0.25, 1.0}), kTwo).mistake, "");
  const FunctionCatalogue slight = catalogueOf({known("slight", {0.5 + 5 * kError, 0.25, 1.0})});
  EXPECT_EQ(diagnose(signatureOf({0.5 + 5 * kError, 0.25, 1.0}), slight).mistake, "");
}

TEST(Diagnosis, NamesTwoThatLookTheSameTogether) {
  const FunctionCatalogue alike =
      catalogueOf({known("one", {0.4, 0.25, 1.0}), known("other", {0.4, 0.25 + kError, 1.0})});
  EXPECT_EQ(diagnose(signatureOf({0.4, 0.25, 1.0}), alike).what,
            "either one in words, or other in words");
}

TEST(Diagnosis, NamesNothingWhereAThirdLooksTheSameToo) {
  const FunctionCatalogue alike =
      catalogueOf({known("one", {0.4, 0.25, 1.0}), known("other", {0.4, 0.25, 1.0}),
                   known("third", {0.4, 0.25, 1.0})});
  EXPECT_EQ(diagnose(signatureOf({0.4, 0.25, 1.0}), alike).mistake, "");
}

// Neither agrees well enough nor is it excluded.
TEST(Diagnosis, NamesNothingWhereAnotherMistakeIsNotExcludedClearly) {
  const double between = 9.0 * std::sqrt(2.0) * kError;
  const FunctionCatalogue near =
      catalogueOf({known("one", {0.4, 0.25, 1.0}), known("other", {0.4, 0.25 + between, 1.0})});
  EXPECT_EQ(diagnose(signatureOf({0.4, 0.25, 1.0}), near).mistake, "");
}

TEST(Diagnosis, ANumberIsNotLikeNoNumber) {
  const FunctionCatalogue noNumber = catalogueOf({known("no number", {kNan, 0.25, 1.0})});
  EXPECT_EQ(diagnose(signatureOf({0.4, 0.25, 1.0}), noNumber).mistake, "");
  EXPECT_EQ(diagnose(signatureOf({kNan, 0.25, 1.0}), noNumber).mistake, "no number");
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(diagnose(signatureOf({infinity, 0.25, 1.0}), noNumber).mistake, "no number");
}

TEST(Diagnosis, NamesNothingByACatalogueOfOtherFeatures) {
  FunctionCatalogue other = kTwo;
  other.features = "of another probe";
  EXPECT_EQ(diagnose(signatureOf({0.6, 0.25, 0.9}), other).mistake, "");
}

TEST(Diagnosis, CountsAMistakeThatIsLeftOutAsUnknown) {
  EXPECT_TRUE(match(signatureOf({0.6, 0.25, 0.9}), kTwo, {"large"}).mistakes.empty());
  EXPECT_EQ(match(signatureOf({0.6, 0.25, 0.9}), kTwo, {"small"}).mistakes.size(), 1u);
}

TEST(Diagnosis, AMeanOverReplicatesHasItsStandardError) {
  Replicates replicates(4, 2);
  for (std::uint32_t r = 0; r < 4; ++r) {
    replicates.of(r)[0] = r;
    replicates.of(r)[1] = 8.0;
  }
  replicates.divideBy(2.0);
  EXPECT_DOUBLE_EQ(replicates.mean(0), 0.75);
  EXPECT_DOUBLE_EQ(replicates.error(0), std::sqrt(5.0 / 4.0 / 12.0));
  EXPECT_DOUBLE_EQ(replicates.error(1), 0.0);
  Signature signature;
  replicates.addLength(signature, "length", {0, 1});
  EXPECT_DOUBLE_EQ(signature.features()[0].value, std::hypot(0.75, 4.0));
}

TEST(Catalogue, IsReadAsItWasWritten) {
  Catalogue catalogue{"a stamp", {kTwo}};
  catalogue.functions[0].mistakes.push_back(known("no number", {kNan, 0.25, 1.0}));
  catalogue.functions[0].stub = known(kStub, {0.0, 0.25, kNan});
  const auto file = std::filesystem::temp_directory_path() / "pathmark_catalogue_test.json";
  writeCatalogue(catalogue, file);
  const Catalogue read = readCatalogue(file);
  std::filesystem::remove(file);
  EXPECT_EQ(read.stamp, "a stamp");
  ASSERT_EQ(read.functions.size(), 1u);
  const FunctionCatalogue* f = read.find(CourseworkFunction::kLambertianPdf);
  ASSERT_NE(f, nullptr);
  EXPECT_EQ(f->features, kTwo.features);
  ASSERT_EQ(f->mistakes.size(), 3u);
  EXPECT_EQ(f->mistakes[1].mistake, "large");
  EXPECT_EQ(f->mistakes[1].what, "large in words");
  EXPECT_EQ(f->mistakes[1].values, kTwo.mistakes[1].values);
  EXPECT_EQ(f->mistakes[1].errors, kTwo.mistakes[1].errors);
  EXPECT_TRUE(std::isnan(f->mistakes[2].values[0]));
  ASSERT_TRUE(f->stub.has_value());
  EXPECT_EQ(f->stub->mistake, kStub);
  EXPECT_EQ(f->stub->values[0], 0.0);
  EXPECT_TRUE(std::isnan(f->stub->values[2]));
  EXPECT_EQ(read.find(CourseworkFunction::kPhongPdf), nullptr);
}

TEST(Catalogue, ADamagedFileIsRefusedWithASentence) {
  const auto file = std::filesystem::temp_directory_path() / "pathmark_damaged_catalogue.json";
  std::ofstream(file) << R"({"stamp": "x", "functions": [{"function": "noSuchFunction"}]})";
  try {
    readCatalogue(file);
    ADD_FAILURE() << "the file was read";
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("noSuchFunction is no function of the coursework"),
              std::string::npos)
        << e.what();
  }
  std::filesystem::remove(file);
}

TEST(Catalogue, OfThisProjectKnowsMistakesInEveryPartAndEachStub) {
  const Catalogue catalogue = readCatalogue(catalogueFile());
  for (const FunctionContract& f : contract()) {
    const FunctionCatalogue* known = catalogue.find(f.function);
    ASSERT_NE(known, nullptr) << f.name;
    ASSERT_TRUE(known->stub.has_value()) << f.name;
    EXPECT_FALSE(looksLike(*known->stub, known->right)) << f.name;
  }
  std::vector<std::size_t> mistakes(parts().size(), 0);
  for (const FunctionCatalogue& f : catalogue.functions)
    mistakes[placeOfPart(contractOf(f.function).part)] += f.mistakes.size();
  for (const PartContract& part : parts())
    EXPECT_GE(mistakes[placeOfPart(part.part)], 10u) << part.part;
}

}  // namespace
}  // namespace pathmark::diagnosis
