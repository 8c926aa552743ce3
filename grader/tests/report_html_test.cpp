// report.html of submissions and classes: complete, in need of nothing, and safe.

#include "report/class_html.h"
#include "report/picture_html.h"
#include "report/record_words.h"
#include "report/submission_html.h"
#include "report/svg_samples.h"
#include "support/hostile.h"
#include "support/markup_reader.h"
#include "support/sample_record.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace pathmark {

namespace {

using report::classHtml;
using report::submissionHtml;
using test::MarkupElement;
using test::readHtml;

// Everything that a page is made of. Event handlers, styles and frames are not in it.
const std::set<std::string> kTags{
    "html",    "head",    "meta",     "title",  "style",      "body",  "main", "header", "section",
    "nav",     "article", "h1",       "h2",     "h3",         "h4",    "p",    "a",      "strong",
    "small",   "em",      "code",     "pre",    "span",       "ul",    "ol",   "li",     "dl",
    "div",     "dt",      "dd",       "table",  "thead",      "tbody", "tr",   "th",     "td",
    "caption", "details", "summary",  "figure", "figcaption", "img",   "svg",  "rect",   "line",
    "path",    "circle",  "polyline", "text",   "script"};
const std::set<std::string> kAttributes{"lang",        "charset",     "http-equiv",
                                        "content",     "name",        "class",
                                        "id",          "href",        "src",
                                        "alt",         "scope",       "tabindex",
                                        "role",        "title",       "viewBox",
                                        "x",           "y",           "x1",
                                        "x2",          "y1",          "y2",
                                        "cx",          "cy",          "r",
                                        "d",           "width",       "height",
                                        "points",      "fill",        "transform",
                                        "aria-label",  "aria-hidden", "preserveAspectRatio",
                                        "text-anchor", "data-value"};

void expectSafe(const std::string& html) {
  const std::vector<MarkupElement> elements = readHtml(html);
  std::size_t scripts = 0;
  for (const MarkupElement& e : elements) {
    EXPECT_TRUE(kTags.contains(e.name)) << e.name;
    scripts += e.name == "script" ? 1u : 0u;
    for (const auto& [name, value] : e.attributes) {
      EXPECT_TRUE(kAttributes.contains(name)) << e.name << " " << name;
      if (name == "src") {
        EXPECT_TRUE(value.starts_with("data:image/png;base64,")) << value;
      }
      if (name == "href") {
        EXPECT_TRUE(value.starts_with("#part-") || value.starts_with("./submissions/")) << value;
      }
    }
    if (e.name == "style") {
      EXPECT_EQ(e.text.find("url("), std::string::npos);
      EXPECT_EQ(e.text.find("@import"), std::string::npos);
    }
  }
  EXPECT_EQ(scripts, 1u);
}

std::string policyOf(const std::string& html) {
  for (const MarkupElement& e : readHtml(html))
    if (e.attributes.contains("http-equiv")) return e.attributes.at("content");
  return {};
}

std::string scriptOf(const std::string& html) {
  for (const MarkupElement& e : readHtml(html))
    if (e.name == "script") return e.text;
  return {};
}

std::size_t numberOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

std::string sampleHtml() {
  return submissionHtml(test::sampleRecord("ben"), test::sampleMarks(), test::samplePicture);
}

TEST(SubmissionHtml, TellsEverythingThatIsKnown) {
  const std::string html = sampleHtml();
  for (const char* words : {"ben",
                            "Part 3: The Lambertian BRDF",
                            "lambertianBRDF::reflection",
                            "mean of cos(theta) = 0.6667",
                            "mean of cos(theta) = 0.5002",
                            "7.1 standard errors of 0.0004",
                            "the directions are uniform over the hemisphere",
                            "handouts/part3_lambertian.md, section 3.3",
                            "./pathmark check 3.3/samples --seed 4711",
                            "was not declared in this scope",
                            "\u22120.25</td>",
                            "segmentation fault",
                            "16 % (15 to 17 %)",
                            "0.46 (0.41 to 0.52)",
                            "reached line 41",
                            ".bashrc was refused",
                            "Caustics below a glass",
                            "bubblewrap",
                            "g++ 12.2.0",
                            "9d20b7f31c6e4a58",
                            "./pathmark grade ben.zip --seed 4711",
                            "<code>./pathmark check --seed 4711</code>",
                            "functions that were looked at are right",
                            "; 1 file does not compile.",
                            "13 below the horizon"})
    EXPECT_NE(html.find(words), std::string::npos) << words;
  // Three pictures of parts 2 and 5 and of the whole, and one of the scene.
  EXPECT_EQ(numberOf(html, "<img "), 10u);
  EXPECT_EQ(numberOf(html, "aria-label=\"Error against rays per pixel\""), 3u);
  EXPECT_EQ(numberOf(html, "aria-label=\"Histogram of the p-values of pixels\""), 3u);
}

TEST(SubmissionHtml, NeedsNothingFromElsewhere) {
  const std::string html = sampleHtml();
  expectSafe(html);
  EXPECT_EQ(html.find("http://"), std::string::npos);
  EXPECT_EQ(html.find("https://"), std::string::npos);
}

TEST(SubmissionHtml, AllowsNoScriptsAndStylesButItsOwn) {
  const std::string policy = policyOf(sampleHtml());
  EXPECT_TRUE(policy.starts_with("default-src 'none'; img-src data:; ")) << policy;
  EXPECT_EQ(policy.find("unsafe"), std::string::npos) << policy;
  EXPECT_EQ(numberOf(policy, "'sha256-"), 3u) << policy;
}

TEST(SubmissionHtml, IsSafeWithHostileTexts) {
  const std::string html =
      submissionHtml(test::withHostileTexts(test::sampleRecord("ben")),
                     test::withHostileTexts(test::sampleMarks()), test::samplePicture);
  expectSafe(html);
  EXPECT_EQ(scriptOf(html), scriptOf(sampleHtml()));
  EXPECT_EQ(policyOf(html), policyOf(sampleHtml()));
  // They are shown, and not lost.
  for (const char* mark :
       {"record_parts_functions_checks_got", "record_printed", "what", "reason",
        "record_samples_inputs", "record_scenes_caption", "record_pictures_failure",
        "record_parts_pictures_scene", "record_build_compiler"})
    EXPECT_NE(html.find(std::string(mark) + "&lt;/script&gt;"), std::string::npos) << mark;
}

TEST(SubmissionHtml, IsForStudentsAndKeepsToItselfWhatOnlyTheTeacherShouldSee) {
  rubric::Marks marks = test::sampleMarks();
  marks.toReview = {"suspicious"};
  const std::string html = submissionHtml(test::sampleRecord("ben"), marks, test::samplePicture);
  EXPECT_EQ(html.find("suspicious"), std::string::npos);
}

TEST(SubmissionHtml, SaysSoWhereAFileIsMissingOrNoPicture) {
  for (const std::string bytes : {"", "<svg onload=alert(1)>"}) {
    const std::string html = submissionHtml(test::sampleRecord("ben"), test::sampleMarks(),
                                            [&](const std::string&) { return bytes; });
    expectSafe(html);
    EXPECT_EQ(numberOf(html, "<img "), 0u);
    EXPECT_EQ(numberOf(html, "The file is missing."), 9u);
  }
}

// Of part 5, whose picture in the sample record is 16 % off.
std::string htmlWithMistake(double bias, double apart, const std::string& invalid = {}) {
  record::SubmissionRecord record = test::sampleRecord("ben");
  record.parts.at(5).pictures.at(0).invalid = invalid;
  record.parts.at(5).mistakes.push_back({"part5_cosine_missing",
                                         "the cosine is missing in the throughput",
                                         "cornell_box",
                                         "pictures/part5_cornell_box_yours.png",
                                         "pictures/part5_cornell_box_reference.png",
                                         "pictures/part5_mistake_1.png",
                                         {bias, 0.95 * bias, 1.05 * bias},
                                         {apart, 0.0, 1.5 * apart}});
  return submissionHtml(record, test::sampleMarks(), test::samplePicture);
}

TEST(SubmissionHtml, ShowsWhatANamedMistakeDoesToTheSameScene) {
  const std::string html = htmlWithMistake(0.162, 0.004);
  expectSafe(html);
  EXPECT_NE(html.find("What the mistake looks like"), std::string::npos);
  EXPECT_NE(html.find("the cosine is missing in the throughput"), std::string::npos);
  EXPECT_NE(html.find("Your picture looks like the one that this mistake alone makes: it is off by "
                      "16 %, and differs from that one by 0.4 %."),
            std::string::npos);
  EXPECT_EQ(numberOf(html, "<img "), 13u) << "three more than without";
}

TEST(SubmissionHtml, SaysWhereAPictureIsUnlikeTheMistakes) {
  const std::string html = htmlWithMistake(0.162, 0.12);
  EXPECT_EQ(html.find("Your picture looks like"), std::string::npos);
  EXPECT_NE(html.find("Yours differs from that too, by 12 %"), std::string::npos);
}

TEST(SubmissionHtml, ShowsNoPicturesOfAMistakeThatCannotBeSeen) {
  const std::string html = htmlWithMistake(0.004, 0.001);
  EXPECT_NE(html.find("It hardly shows in the picture"), std::string::npos);
  EXPECT_EQ(numberOf(html, "<img "), 10u);
}

TEST(SubmissionHtml, ShowsAPictureWithInvalidValuesAndTheirShare) {
  const std::string words = "16 % of its values are no radiance (45946 NaN)";
  const std::string html = htmlWithMistake(0.004, 0.001, words);
  expectSafe(html);
  EXPECT_EQ(html.find("It hardly shows in the picture"), std::string::npos);
  EXPECT_NE(html.find("It shows in your picture: " + words + "."), std::string::npos);
  EXPECT_NE(html.find(words + ". These are left out"), std::string::npos);
  EXPECT_EQ(numberOf(html, "<img "), 13u) << "the mistake's pictures too";
}

TEST(SubmissionHtml, TellsTheWholeCommandThatGivesTheSameMarks) {
  record::SubmissionRecord record = test::sampleRecord("ben");
  rubric::Marks marks = test::sampleMarks();
  marks.rubric = "/home/teacher/my rubric.json";
  const auto has = [&](const std::string& command) {
    return submissionHtml(record, marks, test::samplePicture)
               .find("<code>./pathmark grade ben.zip " + command + "</code>") != std::string::npos;
  };
  EXPECT_TRUE(has("--seed 4711 --rubric &#39;my rubric.json&#39;"));
  record.parts = {record.parts.at(3)};
  record.pictures.clear();
  marks.rubric.clear();
  EXPECT_TRUE(has("--only part3 --seed 4711"));
  EXPECT_NE(submissionHtml(record, marks, test::samplePicture)
                .find("<code>./pathmark check part3 --seed 4711</code>"),
            std::string::npos);
}

TEST(SubmissionHtml, NamesNoFolderOfTheMachineThatItWasGradedOn) {
  record::SubmissionRecord record = test::sampleRecord("ben");
  rubric::Marks marks = test::sampleMarks();
  marks.rubric = "/home/teacher/secret/rubric.json";
  for (const char* source : {"/home/teacher/class/ben.zip", "/home/teacher/class/ben/"}) {
    record.source = source;
    const std::string html = submissionHtml(record, marks, test::samplePicture);
    EXPECT_EQ(html.find("teacher"), std::string::npos);
    EXPECT_NE(html.find("./pathmark grade ben"), std::string::npos);
  }
}

TEST(SubmissionHtml, HasNoExponentsInPercentages) {
  const auto text = [](double value) { return report::percentText({value, 0.96 * value, value}); };
  EXPECT_EQ(text(1.0), "100 % (96 to 100 %)");
  EXPECT_EQ(text(0.1234), "12 % (12 to 12 %)");
  EXPECT_EQ(text(0.0996), "10 % (9.6 to 10 %)");
  EXPECT_EQ(text(0.0212), "2.1 % (2 to 2.1 %)");
  EXPECT_EQ(text(23.456), "2346 % (2252 to 2346 %)");
  record::SubmissionRecord record = test::sampleRecord("ben");
  record.parts.at(5).pictures.at(0).meanError[0] = {-1.04, -1.1, -1.0};
  EXPECT_NE(submissionHtml(record, test::sampleMarks(), test::samplePicture)
                .find("red \u2212104 %, green"),
            std::string::npos);
}

TEST(SubmissionHtml, HasAVerdictOnScenesThatAreMissing) {
  record::SubmissionRecord record = test::sampleRecord("ben");
  record.scenes.clear();
  EXPECT_EQ(report::verdictOfPart(record, report::kScenesPart), record::Verdict::kNotWritten);
  // Of one part alone nobody looks for scenes.
  record.pictures.clear();
  EXPECT_EQ(report::verdictOfPart(record, report::kScenesPart), std::nullopt);
}

TEST(SubmissionHtml, SaysThatAnInternalErrorIsNoFaultOfTheSubmission) {
  record::SubmissionRecord record;
  record.name = "emil";
  record.failure = "no space left on device";
  const std::string html = submissionHtml(record, {}, test::samplePicture);
  expectSafe(html);
  EXPECT_NE(html.find("no fault of this submission: no space left on device"), std::string::npos);
}

TEST(SubmissionHtml, IsSafeWithNumbersThatAreNone) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  record::SubmissionRecord record = test::sampleRecord("ben");
  for (record::PartRecord& part : record.parts)
    for (record::PictureRecord& p : part.pictures) {
      p.bias = {kNan, -kInfinity, kInfinity};
      p.convergence.yours = {kNan, kInfinity, -1.0, 0.0, 1e-300};
    }
  for (record::SampleRecord& s : record.samples) {
    s.yours.push_back({NAN, 0.0f, 1.0f});
    s.yours.push_back({0.0f, -1.0f, 0.0f});
    s.yours.push_back({INFINITY, 3e38f, 0.0f});
    for (record::Histogram& h : s.histograms) h.yours.assign(20, kNan), h.high = kInfinity;
  }
  const std::string html = submissionHtml(record, test::sampleMarks(), test::samplePicture);
  expectSafe(html);
  for (const MarkupElement& e : readHtml(html))
    for (const char* name : {"d", "points", "x", "y", "width", "height", "cx", "cy"})
      if (e.attributes.contains(name)) {
        EXPECT_EQ(e.attributes.at(name).find("n"), std::string::npos) << e.attributes.at(name);
      }
}

TEST(SamplePlot, IsEqualAreaProjection) {
  // Latitude 30 degrees halves the upper half: radius sqrt(1/2) of the disc.
  record::SampleRecord samples{"0.4",
                               "sample_sphere",
                               "",
                               record::SampleDomain::kSphere,
                               {{0.8660254f, 0.5f, 0.0f}, {0.0f, 1.0f, 0.0f}},
                               {}};
  const std::string svg = report::samplePlot(samples).html;
  EXPECT_NE(svg.find("M70.7 0.0h0M0.0 0.0h0"), std::string::npos) << svg;
}

TEST(ClassHtml, ShowsEverySubmissionWithALinkToItsReport) {
  test::SampleClass c = test::sampleClass();
  c.records[1].name = "ben & co #1?";
  const std::string html = classHtml(c.graded());
  expectSafe(html);
  EXPECT_NE(html.find("href=\"./submissions/ben%20%26%20co%20%231%3F/report.html\""),
            std::string::npos);
  for (const record::SubmissionRecord& record : c.records)
    EXPECT_NE(html.find("report.html\""), std::string::npos) << record.name;
  EXPECT_EQ(html.find("https://"), std::string::npos);
}

TEST(ClassHtml, ShowsTheScenesOfAllBesideOneAnother) {
  test::SampleClass c = test::sampleClass();
  const std::string html = classHtml(c.graded());
  const std::size_t section = html.find("<h2>Scenes of their own</h2>");
  ASSERT_NE(section, std::string::npos);
  EXPECT_NE(html.find("Caustics below a glass of water", section), std::string::npos);
  EXPECT_NE(html.find("<img", section), std::string::npos);
  for (record::SubmissionRecord& record : c.records)
    for (record::SceneRecord& scene : record.scenes) scene.picture.clear();
  EXPECT_EQ(classHtml(c.graded()).find("Scenes of their own"), std::string::npos);
}

TEST(ClassHtml, PutsFirstWhatAPersonShouldLookAt) {
  const test::SampleClass c = test::sampleClass();
  const std::string html = classHtml(c.graded());
  for (const char* words : {"could not be graded: bubblewrap", "0.2 times the variance"}) {
    EXPECT_NE(html.find(words), std::string::npos) << words;
    EXPECT_LT(html.find(words), html.find("<h2>Submissions</h2>"));
  }
}

TEST(ClassHtml, PutsFirstWhoHasTheSameFiles) {
  test::SampleClass c = test::sampleClass();
  for (record::SubmissionRecord& record : c.records) record.contents = record.name;
  c.records[0].contents = c.records[3].contents;
  const std::string html = classHtml(c.graded());
  for (const char* line : {"anna_complete</a> The same files as in dora_nearly.</li>",
                           "dora_nearly</a> The same files as in anna_complete.</li>"}) {
    EXPECT_NE(html.find(line), std::string::npos) << line;
    EXPECT_LT(html.find(line), html.find("<h2>Submissions</h2>"));
  }
  EXPECT_EQ(numberOf(html, "The same files"), 2u);
}

TEST(ClassHtml, SpeaksOfSeveralWithoutMarksInThePlural) {
  test::SampleClass c = test::sampleClass();
  c.add(test::leftOutRecord("fay"));
  EXPECT_NE(classHtml(c.graded()).find("fay</a> was not graded: Nothing"), std::string::npos);
  c.add(test::leftOutRecord("gil"));
  EXPECT_NE(classHtml(c.graded()).find("gil</a> were not graded: Nothing"), std::string::npos);
  for (const char* name : {"hal", "ida", "jon", "kim"}) c.add(test::leftOutRecord(name));
  EXPECT_NE(classHtml(c.graded()).find("6 submissions were not graded: Nothing"),
            std::string::npos);
}

TEST(ClassHtml, SaysWhyAPictureOfWhatIsRightIsMissing) {
  test::SampleClass c = test::sampleClass();
  c.records[0].parts.at(5).pictures.at(0).failure = "It printed more than 1024 KiB.";
  const std::string html = classHtml(c.graded());
  EXPECT_NE(html.find("Part 5: there is no picture of cornell_box: It printed more than 1024 KiB."),
            std::string::npos);
  EXPECT_NE(html.find("<li>part 5 without a picture</li>"), std::string::npos);
}

TEST(ClassHtml, SaysWhatWasHandedInWhereItIsNotTheName) {
  test::SampleClass c = test::sampleClass();
  c.records[0].name = "M\u00fcller_Anna";
  c.records[0].source = "/class/M\u00fcller, Anna";
  c.records[1].name = "alex";
  c.records[1].source = "/class/alex";
  const std::string html = classHtml(c.graded());
  EXPECT_NE(html.find("M\u00fcller_Anna<small>M\u00fcller, Anna</small>"), std::string::npos);
  EXPECT_EQ(html.find("<small>alex</small>"), std::string::npos);
}

TEST(ClassHtml, HasARowWithoutMarksForWhatWasLeftOut) {
  test::SampleClass c = test::sampleClass();
  const std::string before = classHtml(c.graded());
  c.add(test::leftOutRecord("fay"));
  const std::string html = classHtml(c.graded());
  expectSafe(html);
  const std::size_t row = html.find("<th scope=\"row\" data-value=\"fay\">");
  ASSERT_NE(row, std::string::npos);
  const std::string cells = html.substr(row, html.find("</tr>", row) - row);
  EXPECT_EQ(cells.find("data-value=\"0"), std::string::npos) << cells;
  EXPECT_NE(cells.find("not graded: Nothing was taken: the archive is damaged."), std::string::npos)
      << cells;
  const std::size_t first = html.find("was not graded: Nothing was taken");
  EXPECT_LT(first, html.find("<h2>Submissions</h2>"));
  // What the others earned on average stays.
  const auto mean = [](const std::string& page) {
    const std::size_t at = page.find("Mean ");
    return page.substr(at, page.find(" points.", at) - at);
  };
  EXPECT_EQ(mean(html), mean(before));
  EXPECT_NE(html.find("2 have no marks."), std::string::npos);
}

TEST(SubmissionHtml, OfWhatWasLeftOutSaysWhyThereAreNoMarks) {
  const std::string html =
      submissionHtml(test::leftOutRecord("fay"), rubric::Marks(), test::samplePicture);
  expectSafe(html);
  EXPECT_NE(html.find("There are no marks, which are not 0: Nothing was taken"), std::string::npos);
  EXPECT_EQ(html.find("points</p>"), std::string::npos);
}

TEST(ClassHtml, CountsTheFunctionsOfAPartThatDoesNotCompile) {
  const test::SampleClass c = test::sampleClass();
  const std::string html = classHtml(c.graded());
  const std::size_t row = html.find("<code>phongBRDF::pdf</code>");
  ASSERT_NE(row, std::string::npos);
  EXPECT_NE(html.substr(row, 1500).find("does not compile"), std::string::npos);
}

TEST(ClassHtml, IsSafeWithHostileTexts) {
  test::SampleClass c = test::sampleClass();
  for (record::SubmissionRecord& record : c.records) record = test::withHostileTexts(record);
  for (rubric::Marks& marks : c.marks) marks = test::withHostileTexts(marks);
  expectSafe(classHtml(c.graded()));
}

TEST(ClassHtml, OfNobodyIsAPageToo) { expectSafe(classHtml({})); }

}  // namespace

}  // namespace pathmark
