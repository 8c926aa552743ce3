// Rubric files: what is refused, and the schema that editors go by.
#include "checks/all_checks.h"
#include "rubric/rubric.h"
#include "support/test_coursework_files.h"
#include "worker/contract.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidjson/document.h>
#include <rapidjson/schema.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace pathmark::rubric {
namespace {

using nlohmann::json;

json parseFile(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return json::parse(stream, nullptr, true, true);
}

rapidjson::Document toRapid(const json& value) {
  rapidjson::Document document;
  document.Parse(value.dump().c_str());
  return document;
}

bool fitsSchema(const json& rubric) {
  static const rapidjson::SchemaDocument schema(
      toRapid(parseFile(defaultRubric().parent_path() / "rubric.schema.json")));
  rapidjson::SchemaValidator validator(schema);
  return toRapid(rubric).Accept(validator);
}

class RubricFile : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "mine.json"; }
  Rubric read(const std::string& text) const {
    std::ofstream(file()) << text;
    return readRubric(file());
  }
  // The sentence, without the folder.
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const RubricError& error) {
      const std::string sentence = error.what();
      const std::string folder = folder_.path().string() + "/";
      return sentence.starts_with(folder) ? sentence.substr(folder.size()) : sentence;
    }
    return "accepted";
  }

  test::TemporaryFolder folder_;
};

TEST_F(RubricFile, TheDefaultHasAHundredPointsAndFitsItsSchema) {
  const Rubric rubric = readRubric(defaultRubric());
  double sum = 0.0;
  for (const PartRubric& part : rubric.parts) sum += part.points;
  EXPECT_EQ(sum, 100.0);
  EXPECT_EQ(rubric.parts.size(), 9u);
  EXPECT_TRUE(fitsSchema(parseFile(defaultRubric())));
}

TEST_F(RubricFile, WhatTheDefaultSaysIsTheDefault) {
  const Rubric said = readRubric(defaultRubric()),
               silent = read(R"({"parts": {"0": {"points": 1}}})");
  EXPECT_EQ(said.step, silent.step);
  EXPECT_EQ(said.wrongAtMost, silent.wrongAtMost);
  EXPECT_EQ(said.withoutPicture, silent.withoutPicture);
  EXPECT_EQ(said.reviewAbove, silent.reviewAbove);
  EXPECT_EQ(said.crashed, silent.crashed);
  ASSERT_EQ(said.biasBands.size(), silent.biasBands.size());
  for (std::size_t i = 0; i < said.biasBands.size(); ++i) {
    EXPECT_EQ(said.biasBands[i].biasAtMost, silent.biasBands[i].biasAtMost);
    EXPECT_EQ(said.biasBands[i].credit, silent.biasBands[i].credit);
  }
  ASSERT_EQ(said.efficiencyBands.size(), silent.efficiencyBands.size());
  for (std::size_t i = 0; i < said.efficiencyBands.size(); ++i) {
    EXPECT_EQ(said.efficiencyBands[i].ratioAtLeast, silent.efficiencyBands[i].ratioAtLeast);
    EXPECT_EQ(said.efficiencyBands[i].credit, silent.efficiencyBands[i].credit);
  }
}

TEST_F(RubricFile, ScalesToItsTotal) {
  const Rubric rubric = read(
      R"({"total": 20, "parts": {"3": {"points": 30, "efficiency": 6, "checks": {"3.3/samples": 3}},
                                 "whole": {"points": 10}}})");
  EXPECT_DOUBLE_EQ(rubric.parts[0].points, 15.0);
  EXPECT_DOUBLE_EQ(rubric.parts[0].efficiency, 3.0);
  EXPECT_DOUBLE_EQ(rubric.parts[0].checks.at("3.3/samples"), 1.5);
  EXPECT_DOUBLE_EQ(rubric.parts[1].points, 5.0);
}

TEST_F(RubricFile, EachMistakeHasItsSentence) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "mine.json: the file is empty, but a rubric is a JSON file."},
      {"{\n\"parts\": {,}}", "mine.json:2:11: "},
      {"[]", "mine.json:1: found an array of 0 entries, but a rubric must be an object { ... }."},
      {"{}", "mine.json:1: the key \"parts\" is missing, but a rubric must have it."},
      {"{\n\"parts\": {}}", "mine.json:2, /parts: no part has any points, but one of them must."},
      {"{\"parts\": {\"10\": {}}}",
       "mine.json:1, /parts/10: found the key \"10\", but the list of "
       "parts has no such key; it has 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, whole."},
      {"{\"parts\": {\"8\": {\"points\": 5}}}",
       "mine.json:1, /parts: no part has any points, but one of them must."},
      {"{\"parts\": {\"whol\": {}}}", "Did you mean \"whole\"?"},
      {"{\"parts\": {\n\"3\": {}}}",
       "mine.json:2, /parts/3: the key \"points\" is missing, but a part must have it."},
      {"{\"parts\": {\"3\": {\"points\":\n-1}}}",
       "mine.json:2, /parts/3/points: found -1, but this must be a number from 0 to 10000."},
      {"{\"parts\": {\"3\": {\"points\": \"ten\"}}}",
       "/parts/3/points: found the text \"ten\", but this must be a number."},
      {"{\"parts\": {\"3\": {\"points\": 2, \"efficiency\": 3}}}",
       "/parts/3/efficiency: found 3, but these are some of the part's points, of which there are "
       "2."},
      {"{\"parts\": {\"3\": {\"points\": 2, \"functions\": {\"4.1\": 1}}}}",
       "/parts/3/functions/4.1: found the key \"4.1\", but the functions of this part are 3.1, "
       "3.2, 3.3."},
      {"{\"parts\": {\"5\": {\"points\": 2, \"functions\": {\"5.1\": 0}}}}",
       "/parts/5/functions: no function has a weight, but one of them must."},
      {"{\"parts\": {\"3\": {\"points\": 2, \"checks\": {\"3.3/sample\": 1}}}}",
       "Did you mean \"3.3/samples\"?"},
      {"{\"parts\": {\"7\": {\"points\": 2, \"efficiency\": 1}}}",
       "/parts/7/efficiency: found the key \"efficiency\", but a part has no such key; it has "
       "points."},
      {"{\"parts\": {\"3\": {\"points\": 2}}, \"total\": 0}",
       "/total: found 0, but this must be more than 0."},
      {"{\"parts\": {\"3\": {\"points\": 2}}, \"wrong\": {\"atMost\": 1.5}}",
       "/wrong/atMost: found 1.5, but this must be a number from 0 to 1."},
      {"{\"parts\": {\"3\": {\"points\": 2}}, \"wrong\": {\"bands\": []}}",
       "/wrong/bands: found an array of 0 entries, but this must be an array of bands { "
       "\"biasAtMost\", \"credit\" }."},
      {"{\"parts\": {\"3\": {\"points\": 2}}, \"wrong\": {\"bands\": [{\"biasAtMost\": 0.1, "
       "\"credit\": 0.5}, {\"biasAtMost\": 0.1, \"credit\": 0.4}]}}",
       "/wrong/bands/1/biasAtMost: found 0.1, but bands stand in the order of their bounds, the "
       "smallest first."},
      {"{\"parts\": {\"3\": {\"points\": 2}}, \"wrong\": {\"bands\": [{\"biasAtMost\": 0.1, "
       "\"credit\": 0.5}, {\"biasAtMost\": 0.2, \"credit\": 0.6}]}}",
       "/wrong/bands/1/credit: found 0.6, but a larger bias must not earn more than a smaller "
       "one."},
      {"{\"parts\": {\"3\": {\"points\": 2}}, \"efficiency\": {\"bands\": [{\"ratioAtLeast\": 0.1, "
       "\"credit\": 0.5}, {\"ratioAtLeast\": 0.2, \"credit\": 0.4}]}}",
       "/efficiency/bands/1/credit: found 0.4, but a higher efficiency must not earn less than a "
       "lower one."},
  };
  for (const auto& [text, sentence] : cases)
    EXPECT_NE(refusal(text).find(sentence), std::string::npos) << refusal(text) << "\n" << sentence;
}

TEST_F(RubricFile, AFileThatIsNotThereIsNamed) {
  EXPECT_THROW(readRubric(folder_ / "gone.json"), RubricError);
}

// Of everything that may stand in a rubric.
const json& fullRubric() {
  static const json rubric = json::parse(R"({
    "$schema": "rubric.schema.json", "total": 50, "step": 0.25,
    "parts": {
      "0": {"points": 10},
      "3": {"points": 12, "efficiency": 2, "functions": {"3.1": 2, "3.3": 0},
            "checks": {"3.3/samples": 0.5}},
      "7": {"points": 4}, "whole": {"points": 4}},
    "wrong": {"atMost": 0.8, "withoutPicture": 0.3,
              "bands": [{"biasAtMost": 0.01, "credit": 1}, {"biasAtMost": 0.1, "credit": 0.5}]},
    "endedEarly": {"crashed": 0, "timeLimit": 0.1, "memoryLimit": 0, "outputLimit": 0,
                   "forbiddenCall": 0},
    "efficiency": {"bands": [{"ratioAtLeast": 0.1, "credit": 0.5}], "reviewAbove": 3}
  })");
  return rubric;
}

class RubricSchemaAndReader : public RubricFile {
 protected:
  // Puts `value` at `pointer`, or takes what is there away if it is null, and asks both.
  void expectBoth(bool accept, const std::string& pointer, const json& value) const {
    json rubric = fullRubric();
    const json::json_pointer place(pointer);
    if (value.is_null()) {
      rubric.at(place.parent_pointer()).erase(place.back());
    } else {
      rubric[place] = value;
    }
    EXPECT_EQ(fitsSchema(rubric), accept) << "schema: " << pointer << " = " << value;
    EXPECT_EQ(refusal(rubric.dump()) == "accepted", accept)
        << "reader: " << pointer << " = " << value << ": " << refusal(rubric.dump());
  }
};

// Pointers to everything in a value.
void collectPointers(const json& value, const std::string& here, std::vector<std::string>& all) {
  if (!here.empty()) all.push_back(here);
  if (value.is_object())
    for (const auto& entry : value.items()) {
      std::string key;
      for (const char c : entry.key()) key += c == '/' ? std::string("~1") : std::string(1, c);
      collectPointers(entry.value(), here + "/" + key, all);
    }
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i)
      collectPointers(value[i], here + "/" + std::to_string(i), all);
}

TEST_F(RubricSchemaAndReader, AgreeOnARubricOfEverything) {
  EXPECT_TRUE(fitsSchema(fullRubric()));
  EXPECT_EQ(refusal(fullRubric().dump()), "accepted");
}

TEST_F(RubricSchemaAndReader, AgreeOnWhatMayBeLeftOut) {
  std::vector<std::string> all;
  collectPointers(fullRubric(), "", all);
  for (const std::string& pointer : all) {
    const bool required = pointer == "/parts" || pointer.ends_with("/points") ||
                          pointer.ends_with("/biasAtMost") || pointer.ends_with("/ratioAtLeast") ||
                          pointer.ends_with("/credit");
    // The only band; a band of two may go.
    const bool last = pointer == "/efficiency/bands/0";
    if (pointer.find("/bands/") != std::string::npos &&
        pointer.find_last_of('/') == pointer.size() - 2) {
      json rubric = fullRubric();
      rubric.at(json::json_pointer(pointer).parent_pointer()).erase(pointer.back() - '0');
      EXPECT_EQ(fitsSchema(rubric), !last) << pointer;
      EXPECT_EQ(refusal(rubric.dump()) == "accepted", !last) << pointer;
    } else {
      expectBoth(!required, pointer, nullptr);
    }
  }
}

TEST_F(RubricSchemaAndReader, AgreeOnUnknownKeys) {
  for (const char* parent : {"", "/parts", "/parts/3", "/parts/7", "/parts/whole", "/wrong",
                             "/wrong/bands/0", "/endedEarly", "/efficiency", "/efficiency/bands/0",
                             "/parts/3/functions", "/parts/3/checks"})
    expectBoth(false, fmt::format("{}/colour", parent), 1);
}

TEST_F(RubricSchemaAndReader, AgreeOnKindsOfValues) {
  std::vector<std::string> all;
  collectPointers(fullRubric(), "", all);
  for (const std::string& pointer : all) {
    const json& there = fullRubric().at(json::json_pointer(pointer));
    for (const json& other :
         {json("word"), json(true), json::array({1, 2}), json::object({{"a", 1}}), json(0.25)})
      if (other.type() != there.type() && !(other.is_number() && there.is_number()))
        expectBoth(false, pointer, other);
  }
}

TEST_F(RubricSchemaAndReader, AgreeOnRanges) {
  const std::vector<std::tuple<const char*, std::vector<json>, std::vector<json>>> cases{
      {"/total", {0, -1, 10001}, {0.5, 10000}},
      {"/step", {-1, 10001}, {0, 1}},
      {"/parts/0/points", {-1, 10001}, {0, 10000, 2.5}},
      {"/parts/3/efficiency", {-1}, {0, 12}},
      {"/parts/3/functions/3.1", {-1, 10001}, {0, 10000}},
      {"/parts/3/checks/3.3~1samples", {-1, 10001}, {0, 3}},
      {"/wrong/atMost", {-0.1, 1.1}, {0, 1}},
      {"/wrong/withoutPicture", {-0.1, 1.1}, {0, 1}},
      {"/wrong/bands", {json::array()}, {}},
      {"/wrong/bands/0/biasAtMost", {0, -1, 101}, {0.001}},
      {"/wrong/bands/1/credit", {-0.1, 1.1}, {0, 1}},
      {"/endedEarly/crashed", {-0.1, 1.1}, {0, 1}},
      {"/efficiency/bands/0/ratioAtLeast", {0, -1, 1001}, {0.001, 1000}},
      {"/efficiency/bands/0/credit", {-0.1, 1.1}, {0, 1}},
      {"/efficiency/reviewAbove", {0, 1001}, {0.5, 1000}},
  };
  for (const auto& [pointer, refused, accepted] : cases) {
    for (const json& value : refused) expectBoth(false, pointer, value);
    for (const json& value : accepted) expectBoth(true, pointer, value);
  }
}

// The schema names functions and checks for editors to complete.
TEST_F(RubricSchemaAndReader, AgreeOnTheChecksOfEachPart) {
  for (const PartContract& part : parts())
    for (const checks::Check& check : checks::checksOfPart(part.part)) {
      const json rubric{
          {"parts",
           {{"7", {{"points", 1}}},
            {std::to_string(part.part), {{"points", 5}, {"checks", {{idOf(check), 1}}}}}}}};
      EXPECT_TRUE(fitsSchema(rubric)) << rubric;
      EXPECT_EQ(refusal(rubric.dump()), "accepted") << rubric;
    }
  const json schema = parseFile(defaultRubric().parent_path() / "rubric.schema.json");
  for (const PartContract& part : parts()) {
    const json& checksOfSchema = schema.at(json::json_pointer(
        fmt::format("/properties/parts/properties/{}/properties/checks/properties", part.part)));
    EXPECT_EQ(checksOfSchema.size(), checks::checksOfPart(part.part).size());
  }
}

TEST_F(RubricSchemaAndReader, AgreeOnTheFunctionsOfEachPart) {
  for (const FunctionContract& function : contract()) {
    for (const PartContract& part : parts()) {
      const json rubric{{"parts",
                         {{"7", {{"points", 1}}},
                          {std::to_string(part.part),
                           {{"points", 5}, {"functions", {{std::string(function.section), 2}}}}}}}};
      EXPECT_EQ(fitsSchema(rubric), part.part == function.part) << rubric;
      EXPECT_EQ(refusal(rubric.dump()) == "accepted", part.part == function.part) << rubric;
    }
  }
}

}  // namespace
}  // namespace pathmark::rubric
