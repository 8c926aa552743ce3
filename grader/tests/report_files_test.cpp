// Reports for other programs: Gradescope's results.json and JUnit XML.

#include "report/gradescope.h"
#include "report/junit.h"
#include "support/hostile.h"
#include "support/markup_reader.h"
#include "support/sample_record.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace pathmark {

namespace {

using nlohmann::json;
using report::gradescopeJson;
using report::junitXml;
using test::MarkupElement;

const json* testNamed(const json& results, const std::string& end) {
  for (const json& t : results["tests"])
    if (t["name"].get<std::string>().ends_with(end)) return &t;
  return nullptr;
}

TEST(Gradescope, PointsAddUp) {
  const json results = json::parse(gradescopeJson(test::sampleRecord("ben"), test::sampleMarks()));
  double score = 0.0, outOf = 0.0;
  for (const json& t : results["tests"]) {
    score += t["score"].get<double>();
    outOf += t["max_score"].get<double>();
    EXPECT_EQ(t["status"] == "failed", t["score"] < t["max_score"] && t["max_score"] > 0.0)
        << t.dump();
  }
  EXPECT_DOUBLE_EQ(score, results["score"].get<double>());
  EXPECT_DOUBLE_EQ(score, test::sampleMarks().points);
  EXPECT_DOUBLE_EQ(outOf, test::sampleMarks().outOf);
}

TEST(Gradescope, HasNoDigitsThatRoundingLeft) {
  rubric::Marks marks = test::sampleMarks();
  marks.parts[0].lines.push_back({"rounding", -0.20000000000000018, 0.0, "to halves"});
  EXPECT_NE(gradescopeJson(test::sampleRecord("ben"), marks).find("\"score\": -0.2,"),
            std::string::npos);
}

TEST(Gradescope, HasOnlyWordsThatItKnows) {
  const json results = json::parse(gradescopeJson(test::sampleRecord("ben"), test::sampleMarks()));
  const std::set<std::string> top{"score",      "execution_time",    "output", "output_format",
                                  "visibility", "stdout_visibility", "tests",  "extra_data"};
  const std::set<std::string> words{"name",   "number", "score",         "max_score",
                                    "status", "output", "output_format", "visibility"};
  for (const auto& [key, value] : results.items()) EXPECT_TRUE(top.contains(key)) << key;
  for (const json& t : results["tests"])
    for (const auto& [key, value] : t.items()) EXPECT_TRUE(words.contains(key)) << key;
}

TEST(Gradescope, SaysWhatWasFoundWithTheFunctionAndThePart) {
  const json results = json::parse(gradescopeJson(test::sampleRecord("ben"), test::sampleMarks()));
  const json* function = testNamed(results, "3.3 lambertianBRDF::reflection");
  ASSERT_NE(function, nullptr);
  const std::string output = (*function)["output"];
  for (const char* words : {"2.1 %", "got: mean of cos(theta) = 0.5002", "likely cause:",
                            "read: handouts/part3_lambertian.md", "repeat: ./pathmark check"})
    EXPECT_NE(output.find(words), std::string::npos) << output;
  const json* unbuilt = testNamed(results, "4.2 phongBRDF::pdf");
  ASSERT_NE(unbuilt, nullptr);
  EXPECT_NE((*unbuilt)["output"].get<std::string>().find("'pow' was not declared"),
            std::string::npos);
}

TEST(Gradescope, KeepsToItselfWhatOnlyTheTeacherShouldSee) {
  rubric::Marks marks = test::sampleMarks();
  marks.toReview = {"suspicious"};
  EXPECT_EQ(gradescopeJson(test::sampleRecord("ben"), marks).find("suspicious"), std::string::npos);
}

TEST(Gradescope, HasNoScoreOfWhatWasLeftOut) {
  const json results = json::parse(gradescopeJson(test::leftOutRecord("fay"), rubric::Marks()));
  EXPECT_FALSE(results.contains("score"));
  EXPECT_EQ(results["extra_data"]["complete"], false);
  EXPECT_NE(results["output"].get<std::string>().find("the archive is damaged"), std::string::npos);
}

TEST(Gradescope, SurvivesHostileTexts) {
  const json results = json::parse(gradescopeJson(test::withHostileTexts(test::sampleRecord("ben")),
                                                  test::withHostileTexts(test::sampleMarks())));
  for (const json& t : results["tests"])
    for (const char* field : {"name", "output"})
      EXPECT_EQ(t[field].get<std::string>().find('\x1b'), std::string::npos);
}

std::size_t numberOf(const std::vector<MarkupElement>& elements, const std::string& name) {
  return static_cast<std::size_t>(std::count_if(
      elements.begin(), elements.end(), [&](const MarkupElement& e) { return e.name == name; }));
}

const MarkupElement* caseNamed(const std::vector<MarkupElement>& elements,
                               const std::string& name) {
  for (const MarkupElement& e : elements)
    if (e.name == "testcase" && e.attributes.at("name") == name) return &e;
  return nullptr;
}

TEST(MarkupReader, RefusesWhatIsNotWellFormed) {
  const std::string begin = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  EXPECT_NO_THROW(test::readXml(begin + "<a b=\"&lt;\">c<d/>&amp;</a>\n"));
  for (const char* text : {"", "<a>", "<a></b>", "<a/><b/>", "<a b=c/>", "<a b=\"<\"/>",
                           "<a b=\"1\" b=\"2\"/>", "<a>&</a>", "<a>&nbsp;</a>", "<a>]]></a>",
                           "<a><!-- --></a>", "<a>\x1b</a>", "<a>\xff</a>", "x<a/>"})
    EXPECT_THROW(test::readXml(begin + text), test::MarkupError) << text;
}

TEST(JUnit, IsWellFormedAndCountsItsCases) {
  const auto elements = test::readXml(junitXml(test::sampleRecord("ben")));
  ASSERT_EQ(elements[0].name, "testsuites");
  const auto& counts = elements[0].attributes;
  EXPECT_EQ(counts.at("tests"), std::to_string(numberOf(elements, "testcase")));
  EXPECT_EQ(counts.at("failures"), std::to_string(numberOf(elements, "failure")));
  EXPECT_EQ(counts.at("errors"), std::to_string(numberOf(elements, "error")));
  EXPECT_EQ(counts.at("skipped"), std::to_string(numberOf(elements, "skipped")));
  EXPECT_EQ(numberOf(elements, "failure"), 3u);
  EXPECT_EQ(numberOf(elements, "error"), 3u);
}

TEST(JUnit, NamesChecksByTheirIdsAndPartsThatDoNotCompileByTheirFiles) {
  const auto elements = test::readXml(junitXml(test::sampleRecord("ben")));
  EXPECT_NE(caseNamed(elements, "3.3/samples"), nullptr);
  EXPECT_NE(caseNamed(elements, "part4_phong.cpp"), nullptr);
  const auto failure = std::find_if(elements.begin(), elements.end(),
                                    [](const MarkupElement& e) { return e.name == "failure"; });
  EXPECT_EQ(failure->attributes.at("type"), "wrong");
  EXPECT_NE(failure->attributes.at("message").find("uniform over the hemisphere"),
            std::string::npos);
  EXPECT_NE(failure->text.find("0.5002"), std::string::npos);
}

TEST(JUnit, HasAnErrorForWhatWasLeftOut) {
  const auto elements = test::readXml(junitXml(test::leftOutRecord("fay")));
  const auto error = std::find_if(elements.begin(), elements.end(),
                                  [](const MarkupElement& e) { return e.name == "error"; });
  ASSERT_NE(error, elements.end());
  EXPECT_EQ(error->attributes.at("type"), "not graded");
  EXPECT_NE(error->attributes.at("message").find("the archive is damaged"), std::string::npos);
}

TEST(JUnit, OfAClassHasTheCasesOfAllSubmissions) {
  const test::SampleClass c = test::sampleClass();
  std::size_t cases = 0;
  for (const record::SubmissionRecord& record : c.records)
    cases += numberOf(test::readXml(junitXml(record)), "testcase");
  EXPECT_EQ(numberOf(test::readXml(junitXml(c.graded())), "testcase"), cases);
}

TEST(JUnit, SurvivesHostileTexts) {
  const auto elements = test::readXml(junitXml(test::withHostileTexts(test::sampleRecord("ben"))));
  const std::set<std::string> ours{"testsuites", "testsuite", "testcase",  "failure",
                                   "error",      "skipped",   "system-out"};
  for (const MarkupElement& e : elements) EXPECT_TRUE(ours.contains(e.name)) << e.name;
}

}  // namespace

}  // namespace pathmark
