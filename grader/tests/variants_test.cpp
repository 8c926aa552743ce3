// The patches of grader/variants: each says what it is, and changes one file of solutions/.
#include "host/build_config.h"
#include "support/test_coursework_files.h"
#include "variants/variant.h"
#include "worker/contract.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

namespace pathmark::test {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

fs::path write(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
  return file;
}

TEST(Variants, StandInTheFolderOfTheirKindUnderTheNameOfTheirPart) {
  for (const Variant& variant : allVariants()) {
    EXPECT_EQ(variant.patch.parent_path().filename(), variant.wrong ? "wrong" : "correct")
        << variant.name;
    EXPECT_TRUE(variant.name.starts_with("part" + std::to_string(variant.part) + "_"))
        << variant.name;
  }
}

// A grader that marks whatever differs from the solutions as wrong must show in every part, and a
// function whose check finds nothing must show too.
TEST(Variants, MissNoFunctionAndNoPart) {
  const std::vector<Variant> all = allVariants();
  for (const FunctionContract& function : contract())
    EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                            [&](const Variant& v) { return v.function == function.name; }))
        << "no mistake of " << function.name;
  for (const PartContract& part : parts())
    EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                            [&](const Variant& v) { return !v.wrong && v.part == part.part; }))
        << "nothing correct but different of part " << part.part;
}

TEST(Variants, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Variant& variant : allVariants())
    EXPECT_TRUE(names.insert(variant.name).second) << variant.name;
}

TEST(Variants, ApplyToTheSolutionsAndChangeTheFileOfTheirPartOnly) {
  const fs::path solutions = fs::path(build::kProjectFolder) / "solutions";
  for (const Variant& variant : allVariants()) {
    SCOPED_TRACE(variant.name);
    const TemporaryFolder folder;
    ASSERT_NO_THROW(applyVariant(variant, folder.path()));
    for (const PartContract& part : parts())
      EXPECT_EQ(textOf(folder / std::string(part.file)) != textOf(solutions / part.file),
                part.part == variant.part)
          << part.file;
    const auto files = std::distance(fs::directory_iterator(folder.path()), {});
    EXPECT_EQ(static_cast<std::size_t>(files), parts().size()) << "only coursework files";
  }
}

TEST(Variants, ReplaceWhatAnEarlierOneHasLeftInTheFolder) {
  const std::vector<Variant> all = allVariants();
  const TemporaryFolder used, fresh;
  applyVariant(all.front(), used.path());
  applyVariant(all.back(), used.path());
  applyVariant(all.back(), fresh.path());
  for (const PartContract& part : parts())
    EXPECT_EQ(textOf(used / std::string(part.file)), textOf(fresh / std::string(part.file)));
}

TEST(Variants, ThatDoNotFitTheSolutionsAreRefusedWithTheirName) {
  const TemporaryFolder folder;
  const Variant variant = readVariant(write(folder / "part6_elsewhere.patch",
                                            "Different: lines that the solutions do not have\n"
                                            "Part: 6\n\n"
                                            "--- a/part6_roulette.cpp\n+++ b/part6_roulette.cpp\n"
                                            "@@ -1 +1 @@\n-no such line\n+another line\n"));
  try {
    applyVariant(variant, folder / "applied");
    FAIL() << "it was applied";
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("part6_elsewhere.patch"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("does not apply"), std::string::npos) << e.what();
  }
}

TEST(VariantHead, IsRead) {
  const TemporaryFolder folder;
  const Variant variant = readVariant(write(folder / "part3_x.patch",
                                            "Mistake: f = Kd: pi is forgotten\nPart: 3\n"
                                            "Function: lambertianBRDF::brdf\n"
                                            "Check: 3.1/value\n\n--- a/x\n"));
  EXPECT_EQ(variant.name, "part3_x");
  EXPECT_TRUE(variant.wrong);
  EXPECT_EQ(variant.what, "f = Kd: pi is forgotten");
  EXPECT_EQ(variant.part, 3);
  EXPECT_EQ(variant.function, "lambertianBRDF::brdf");
  EXPECT_EQ(variant.check, "3.1/value");
  EXPECT_EQ(variant.lessEfficient, "");
}

TEST(VariantHead, SaysWhyItIsLessEfficient) {
  const TemporaryFolder folder;
  const Variant variant = readVariant(write(folder / "part3_x.patch",
                                            "Different: uniform\nPart: 3\n"
                                            "Efficiency: less, because it is uniform\n\n"));
  EXPECT_FALSE(variant.wrong);
  EXPECT_EQ(variant.lessEfficient, "it is uniform");
}

std::string refusalOf(const fs::path& patch) {
  try {
    readMistake(patch);
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return {};
}

TEST(VariantHead, OfAMistakeNamesACheckOfItsFunction) {
  const TemporaryFolder folder;
  const std::string head = "Mistake: a\nPart: 3\nFunction: lambertianBRDF::brdf\n";
  const std::string none = refusalOf(write(folder / "part3_none.patch", head + "\n"));
  EXPECT_NE(none.find("part3_none.patch: the head must name the check"), std::string::npos) << none;
  for (const std::string check : {"3.1/colour", "3.3/samples", "value"}) {
    const std::string text =
        refusalOf(write(folder / "part3_x.patch", head + "Check: " + check + "\n\n"));
    EXPECT_NE(text.find(check + " is no check of lambertianBRDF::brdf; those are 3.1/"),
              std::string::npos)
        << text;
  }
  EXPECT_EQ(readMistake(write(folder / "part3_x.patch", head + "Check: 3.1/value\n\n")).check,
            "3.1/value");
}

TEST(VariantHead, ThatIsNotAsItMustBeIsRefused) {
  const TemporaryFolder folder;
  for (const char* head : {
           "",                                                                       // nothing
           "Part: 3\nFunction: lambertianBRDF::brdf\n\n",                            // neither kind
           "Mistake: a\nDifferent: b\nPart: 3\nFunction: lambertianBRDF::brdf\n\n",  // both
           "Mistake: a\nPart: 3\n\n",                                                // no function
           "Different: a\nPart: 3\nFunction: lambertianBRDF::brdf\n\n",              // a function
           "Mistake: a\nPart: 4\nFunction: lambertianBRDF::brdf\n\n",                // another part
           "Mistake: a\nPart: 3\nFunction: lambertianBRDF::value\n\n",               // no such one
           "Different: a\nPart: 3\nCheck: 3.1/value\n\n",                            // a check
           "Different: a\nPart: 3\nEfficiency: less\n\n",                            // no reason
           "Mistake: a\nPart: 3\nFunction: lambertianBRDF::brdf\n"
           "Efficiency: less, because b\n\n",     // of a mistake
           "Different: a\nPart: 7\n\n",           // no such part
           "Different: a\nPart: 3\nPart: 3\n\n",  // twice
           "Different: a\nPart: 3\nWhy: b\n\n",   // unknown
           "Different: a\nPart: 3",               // no diff
           "--- a/part3_lambertian.cpp\n\n",      // no head
       }) {
    EXPECT_THROW(readVariant(write(folder / "head.patch", head)), std::runtime_error) << head;
  }
  EXPECT_THROW(readVariant(folder / "missing.patch"), std::runtime_error);
}

}  // namespace
}  // namespace pathmark::test
