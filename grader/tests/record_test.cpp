// Records come back from their files as they were.
#include "record/record_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace pathmark::record {

namespace {

SubmissionRecord fullRecord() {
  SubmissionRecord r;
  r.name = "alpha";
  r.source = "/submissions/alpha.zip";
  r.contents = "0123";
  r.seed = std::uint64_t{1} << 53;
  r.build = {"abcd", "g++ 12", "-O3", "x86-64", "bubblewrap"};
  r.collecting = {"part9.cpp is not asked for."};
  r.refusedScenes = {"scenes/a.json was refused: it is a link."};
  PartRecord part;
  part.part = 3;
  part.file = "part3_lambertian.cpp";
  part.title = "The Lambertian BRDF";
  part.verdict = Verdict::kForbiddenCall;
  part.message = "warning: \"quoted\" \xff\n";
  part.functions.push_back({"3.1", "lambertianBRDF::brdf", Verdict::kWrong, {}});
  CheckRecord check;
  check.id = "3.1/value";
  check.verdict = Verdict::kWrong;
  check.got = "f = 1";
  check.delta = 0.01;
  check.calls = 12345678901;
  part.functions.back().checks.push_back(check);
  PictureRecord picture;
  picture.scene = "a scene like cornell_box";
  picture.bias = {0.02, 0.018, 0.022};
  picture.meanError[2] = {-0.1, -0.2, 0.0};
  picture.efficiency = Estimate{1.0, 0.9, HUGE_VAL};
  picture.pValues = {1, 2, 3};
  picture.invalid = "16 % of its values are no radiance (45946 NaN)";
  picture.convergence = {{1.0, 4.0}, {0.5, 0.25}, {0.4, 0.2}};
  part.pictures = {picture};
  part.mistakes.push_back({"part3_pi_forgotten",
                           "f = Kd",
                           "a scene",
                           "y.png",
                           "r.png",
                           "m.png",
                           picture.bias,
                           {0.001, 0.0, 0.002}});
  r.parts = {part};
  r.images = {check};
  r.scenes.push_back({"door.json", "a caption", Verdict::kOk, "", "in the corner", "p.png"});
  picture.efficiency.reset();
  r.pictures = {picture};
  SampleRecord samples{"3.3", "lambertianBRDF::reflection", "n", SampleDomain::kHemisphere, {}, {}};
  samples.yours = {{0.5f, 0.25f, -1.0f}};
  samples.histograms = {{"cos(theta)", 0.0, 1.0, {0.5, 0.5}, {0.25, 0.75}}};
  r.samples = {samples};
  r.printed = "hello\n";
  r.outOfTime = true;
  r.seconds = 12.5;
  return r;
}

}  // namespace

TEST(Record, ComesBackFromItsFileByteForByte) {
  const std::string once = toJson(fullRecord());
  const SubmissionRecord again = recordFromJson(once, "record.json");
  EXPECT_EQ(toJson(again), once);
  ASSERT_EQ(again.parts.size(), 1u);
  EXPECT_EQ(again.parts[0].verdict, Verdict::kForbiddenCall);
  EXPECT_EQ(again.seed, std::uint64_t{1} << 53);
  EXPECT_EQ(again.parts[0].pictures[0].efficiency->high, HUGE_VAL);
  EXPECT_FALSE(again.pictures[0].efficiency);
  EXPECT_EQ(again.pictures[0].invalid, "16 % of its values are no radiance (45946 NaN)");
  EXPECT_EQ(again.parts[0].mistakes.at(0).picture, "m.png");
  EXPECT_EQ(again.samples[0].yours[0][2], -1.0f);
  EXPECT_EQ(again.refusedScenes, fullRecord().refusedScenes);
  EXPECT_TRUE(again.outOfTime);
}

TEST(Record, OfWhatWasLeftOutComesBackWithItsReason) {
  SubmissionRecord leftOut;
  leftOut.name = "bob";
  leftOut.leftOut = "It cannot be read.";
  const SubmissionRecord again = recordFromJson(toJson(leftOut), "record.json");
  EXPECT_EQ(again.leftOut, leftOut.leftOut);
  EXPECT_FALSE(again.hasMarks());
  EXPECT_FALSE(again.internalError());
  EXPECT_TRUE(fullRecord().hasMarks());
}

TEST(Record, EveryVerdictHasANameOfItsOwn) {
  for (int v = 0; v <= static_cast<int>(Verdict::kInternalError); ++v) {
    const auto verdict = static_cast<Verdict>(v);
    ASSERT_FALSE(nameOf(verdict).empty());
    EXPECT_EQ(verdictNamed(nameOf(verdict)), verdict);
  }
  EXPECT_FALSE(verdictNamed("fine"));
}

TEST(Record, WhatIsNoneIsASentence) {
  const std::string good = toJson(fullRecord());
  for (const std::string& text :
       {std::string(), std::string("{}"), std::string("[1]"), std::string("{\"format\": 99}"),
        good.substr(0, good.size() / 2), std::string("{\"format\": 2, \"name\": 3}")}) {
    try {
      recordFromJson(text, "record.json");
      ADD_FAILURE() << text;
    } catch (const RecordError& e) {
      EXPECT_NE(std::string(e.what()).find("record.json: this is no record"), std::string::npos)
          << e.what();
    }
  }
  EXPECT_THROW(readRecord("/nowhere/record.json"), RecordError);
}

}  // namespace pathmark::record
