// pathmark bench error and export, run as programs with the solutions.
#include "host/build_config.h"
#include "support/background_program.h"
#include "support/bench_json.h"
#include "support/markup_reader.h"
#include "support/run_command.h"

#include <algorithm>
#include <csignal>
#include <set>
#include <sstream>
#include <thread>

namespace pathmark::test {
namespace {

using nlohmann::json;

class BenchErrorCommand : public BenchCommand {
 protected:
  // Small, and the same in all tests, so that one reference serves all.
  std::vector<std::string> words(std::vector<std::string> more) {
    std::vector<std::string> all{"error", "cornell_box",      "--size",
                                 "16x16", "--reference-rays", "512"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  std::string text(const std::string& name) {
    std::ifstream in(folder_ / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  static long lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }
};

TEST_F(BenchErrorCommand, MeasuresEveryEstimatorSamplerAndNumberOfRays) {
  const json report =
      benchJson(words({"--estimators", "solutions,uniform", "--samplers", "sobol,pcg", "--rays",
                       "1,4", "--replicates", "3", "--csv", "runs.csv"}));
  ASSERT_TRUE(report.is_object());
  EXPECT_EQ(report.at("complete"), true);
  const json& scene = report.at("scenes").at(0);
  EXPECT_GT(scene.at("reference").at("relativeMse").get<double>(), 0.0);
  ASSERT_EQ(scene.at("curves").size(), 4u);
  for (const json& curve : scene.at("curves")) {
    ASSERT_EQ(curve.at("points").size(), 2u);
    EXPECT_LT(curve.at("slope").at("value").get<double>(), 0.0);
    for (const json& point : curve.at("points")) {
      EXPECT_EQ(point.at("replicates"), 3);
      const json& efficiency = point.at("efficiency");
      EXPECT_LT(efficiency.at("low").get<double>(), efficiency.at("value").get<double>());
      EXPECT_GT(point.at("cpuSeconds").at("value").get<double>(), 0.0);
    }
    // Four times the rays: less than half of the error.
    EXPECT_GT(curve.at("points").at(0).at("relativeMse").at("value").get<double>(),
              2.0 * curve.at("points").at(1).at("relativeMse").at("value").get<double>());
  }
  EXPECT_EQ(report.at("runs").size(), 2u * 2u * 2u * 3u);
  EXPECT_EQ(lines(text("runs.csv")), 1 + 2 * 2 * 2 * 3);
}

TEST_F(BenchErrorCommand, WhatIsKeptIsNotMadeAgain) {
  const std::vector<std::string> first = words(
      {"--estimators", "solutions", "--rays", "1,2", "--replicates", "2", "--csv", "runs.csv"});
  EXPECT_EQ(bench(first).exitCode, 0);
  const std::string before = text("runs.csv");
  EXPECT_EQ(bench(first).exitCode, 0);
  EXPECT_EQ(text("runs.csv"), before) << "times too: nothing was measured";
  EXPECT_EQ(bench(words({"--estimators", "solutions", "--rays", "1,2,4", "--replicates", "3",
                         "--csv", "runs.csv"}))
                .exitCode,
            0);
  const std::string after = text("runs.csv");
  EXPECT_EQ(lines(after), 1 + 9);
  std::istringstream old(before);
  for (std::string line; std::getline(old, line);)
    EXPECT_NE(after.find(line), std::string::npos) << line;
}

TEST_F(BenchErrorCommand, WhatIsKeptOfAnotherSeedIsMadeAgain) {
  const auto valuesWith = [&](const std::string& seed) {
    const json report = benchJson(words({"--estimators", "solutions", "--rays", "1", "--replicates",
                                         "1", "--csv", "runs.csv", "--seed", seed}));
    EXPECT_EQ(report.at("runs").size(), 1u);
    return report.at("runs").at(0).at("relativeMse").get<double>();
  };
  const double first = valuesWith("0"), other = valuesWith("100");
  EXPECT_NE(first, other);
}

TEST_F(BenchErrorCommand, OnlyWhatWasComparedWithTheSameReferenceIsSummedUp) {
  const std::vector<std::string> kept{"--rays", "1", "--replicates", "2", "--csv", "runs.csv"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), kept.begin(), kept.end());
    return more;
  };
  ASSERT_EQ(run({PATHMARK_PROGRAM, "render", "cornell_box", "--with", "solutions", "--size",
                 "16x16", "--rays-per-pixel", "16", "--output", "peer.exr"},
                folder_.path())
                .exitCode,
            0);
  const auto namesIn = [](const json& report) {
    std::set<std::string> names;
    for (const json& curve : report.at("scenes").at(0).at("curves"))
      names.insert(curve.at("estimator").get<std::string>());
    return names;
  };
  using Names = std::set<std::string>;
  EXPECT_EQ(namesIn(benchJson(
                words(with({"--estimators", "solutions", "--peer", "Other=peer.exr,0.5,16"})))),
            (Names{"solutions", "Other"}));
  EXPECT_EQ(namesIn(benchJson(words(with({"--estimators", "cosine"})))),
            (Names{"solutions", "Other", "cosine"}));
  EXPECT_EQ(namesIn(benchJson(with({"error", "cornell_box", "--size", "8x8", "--reference-rays",
                                    "512", "--estimators", "uniform"}))),
            (Names{"uniform"}));
}

TEST_F(BenchErrorCommand, ImagesOfAPeerTakeThePlaceOfAllThatWereGivenBefore) {
  for (const char* file : {"one.exr", "two.exr"})
    ASSERT_EQ(run({PATHMARK_PROGRAM, "render", "cornell_box", "--with", "solutions", "--size",
                   "16x16", "--rays-per-pixel", "16", "--output", file},
                  folder_.path())
                  .exitCode,
              0);
  const auto rowsWith = [&](const std::string& list) {
    std::ofstream(folder_ / "peers.json") << list;
    const json report = benchJson(words({"--estimators", "solutions", "--rays", "1", "--replicates",
                                         "1", "--csv", "runs.csv", "--peer", "peers.json"}));
    return report.at("runs").size();
  };
  const std::string one = R"({"name": "M", "image": "one.exr", "seconds": 1, "raysPerPixel": 16})";
  const std::string two = R"({"name": "M", "image": "two.exr", "seconds": 1, "raysPerPixel": 16})";
  EXPECT_EQ(rowsWith("[" + one + "," + two + "]"), 3u);
  EXPECT_EQ(rowsWith("[" + one + "]"), 2u);
}

TEST_F(BenchErrorCommand, ANameThatItsFileCannotHoldIsRefusedFirst) {
  std::filesystem::copy_file(std::string(PATHMARK_ROOT) + "/scenes/empty_furnace.json",
                             folder_ / "one,two.json");
  const ProcessResult result =
      bench({"error", "one,two.json", "--estimators", "solutions", "--csv", "runs.csv"});
  EXPECT_EQ(result.exitCode, 2) << result.output;
  EXPECT_NE(result.output.find("has no commas"), std::string::npos) << result.output;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "runs.csv"));
}

TEST_F(BenchErrorCommand, PagesAndPlotsAreWellFormedAndNeedNothingFromElsewhere) {
  ASSERT_EQ(bench(words({"--estimators", "solutions,hemispherical", "--rays", "1,4", "--replicates",
                         "2", "--html", "error.html", "--svg", "error.svg"}))
                .exitCode,
            0);
  const std::string html = text("error.html");
  const std::vector<MarkupElement> page = readHtml(html);
  int charts = 0, rows = 0;
  for (const MarkupElement& e : page) {
    charts += e.name == "svg" && e.attributes.contains("role") ? 1 : 0;
    rows += e.name == "tr" ? 1 : 0;
    for (const auto& [name, value] : e.attributes)
      EXPECT_TRUE(name != "src" && name != "href" && !name.starts_with("on")) << name;
  }
  EXPECT_EQ(charts, 1);
  EXPECT_EQ(rows, 1 + 4);
  EXPECT_EQ(html.find("http"), html.find("http-equiv"));
  const std::vector<MarkupElement> svg =
      readXml("<?xml version=\"1.0\" encoding=\"UTF-8\"?>" + text("error.svg"));
  EXPECT_EQ(svg.front().name, "svg");
  EXPECT_EQ(std::count_if(svg.begin(), svg.end(),
                          [](const MarkupElement& e) { return e.name == "polyline"; }),
            2);
  EXPECT_EQ(text("error.svg").find("nan"), std::string::npos);
}

TEST_F(BenchErrorCommand, AnotherRenderersImageIsAPoint) {
  ASSERT_EQ(run({PATHMARK_PROGRAM, "render", "cornell_box", "--with", "solutions", "--size",
                 "16x16", "--rays-per-pixel", "16", "--output", "peer.exr"},
                folder_.path())
                .exitCode,
            0);
  const json report = benchJson(words({"--estimators", "solutions", "--rays", "4", "--replicates",
                                       "2", "--peer", "Other=peer.exr,0.5,16"}));
  const json& curves = report.at("scenes").at(0).at("curves");
  ASSERT_EQ(curves.size(), 2u);
  const json& peer = curves.at(0).at("estimator") == "Other" ? curves.at(0) : curves.at(1);
  EXPECT_EQ(peer.at("points").at(0).at("cpuSeconds").at("value"), 0.5);
  EXPECT_EQ(peer.at("points").at(0).at("raysPerPixel"), 16);
  EXPECT_GT(peer.at("points").at(0).at("relativeMse").at("value").get<double>(), 0.0);
  EXPECT_TRUE(peer.at("points").at(0).at("efficiency").at("low").is_null()) << "of one image";
}

TEST_F(BenchErrorCommand, InterruptedItShowsWhatThereIs) {
  EXPECT_EQ(
      bench(words({"--estimators", "solutions", "--rays", "1", "--replicates", "1"})).exitCode, 0)
      << "so that the reference is there";
  BackgroundProgram program({PATHMARK_PROGRAM, "bench", "error", "cornell_box", "--size", "16x16",
                             "--reference-rays", "512", "--estimators", "solutions", "--rays", "64",
                             "--replicates", "10000", "--csv", "runs.csv", "--json", "runs.json"},
                            folder_.path(), folder_ / "log.txt");
  for (int k = 0; k < 6000 && lines(text("runs.csv")) < 3; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  program.signal(SIGINT);
  EXPECT_EQ(program.wait(), 130);
  EXPECT_NE(text("log.txt").find("goes on from here"), std::string::npos) << text("log.txt");
  const json report = json::parse(text("runs.json"), nullptr, false);
  EXPECT_EQ(report.at("complete"), false);
  EXPECT_GE(report.at("runs").size(), 2u);
}

TEST_F(BenchErrorCommand, AListTakesOneWordSoThatAScenePutBehindItIsAScene) {
  EXPECT_EQ(
      bench({"error", "--size", "16x16", "--reference-rays", "512", "--rays", "1", "--replicates",
             "1", "--samplers", "pcg,sobol", "--estimators", "solutions", "cornell_box"})
          .exitCode,
      0);
}

TEST_F(BenchErrorCommand, TheTimeIsKept) {
  const ProcessResult result =
      bench(words({"--estimators", "solutions", "--rays", "64", "--replicates", "10000",
                   "--seconds", "1", "--json", "bench.json"}));
  EXPECT_EQ(result.exitCode, 0) << result.output;
  std::ifstream file(folder_ / "bench.json");
  EXPECT_LT(json::parse(file).at("runs").size(), 10000u);
}

TEST_F(BenchErrorCommand, StubsAreNotMeasured) {
  const ProcessResult result =
      bench(words({"--with", PATHMARK_ROOT "/student", "--estimators", "uniform", "--rays", "1"}));
  EXPECT_EQ(result.exitCode, 1) << result.output;
  EXPECT_NE(result.output.find("not written yet"), std::string::npos) << result.output;
}

TEST_F(BenchErrorCommand, CostHasItsTablesAndPlotsAndMemoryIsFlat) {
  const json report =
      benchJson({"cost", "cornell_box", "--quick", "--html", "cost.html", "--svg", "cost.svg"});
  ASSERT_TRUE(report.is_object());
  for (const char* key : {"rays", "pixels"}) {
    const json& rows = report.at("tables").at(key);
    ASSERT_EQ(rows.size(), 3u) << key;
    EXPECT_EQ(rows.at(2).at("amount"), key == std::string("rays") ? "16" : "16384");
    const double cameraRays = key == std::string("rays") ? 256.0 * 256.0 * 16.0 : 16384.0 * 4.0;
    EXPECT_NEAR(rows.at(2).at("microseconds").get<double>() * cameraRays,
                1e6 * rows.at(2).at("cpuSeconds").get<double>(), 1.0)
        << key;
  }
  for (const char* key : {"raysExponent", "pixelsExponent"})
    EXPECT_TRUE(report.at("figures").contains(key)) << key;
  // Had each of the 15 rays more left as much as one float, it would be 3.9 MB; the kernel gives
  // pages in batches, and two runs may differ by one or two megabytes. A sanitizer keeps what is
  // freed for a while.
  if (!build::kSanitized) {
    EXPECT_LT(report.at("figures").at("memoryGrowth").at("value").get<double>(), 3.9);
  }
  EXPECT_NO_THROW(readHtml(text("cost.html")));
  EXPECT_NO_THROW(readXml("<?xml version=\"1.0\" encoding=\"UTF-8\"?>" + text("cost.svg")));
}

// Our strict reader of XML knows no comments.
std::string withoutComments(std::string xml) {
  for (std::size_t at = 0; (at = xml.find("<!--", at)) != std::string::npos;) {
    const std::size_t end = xml.find("-->", at);
    EXPECT_EQ(xml.substr(at + 4, end - at - 4).find("--"), std::string::npos);
    xml.erase(at, end + 3 - at);
  }
  return xml;
}

class ExportCommand : public BenchErrorCommand {
 protected:
  ProcessResult exported(std::vector<std::string> words) {
    words.insert(words.begin(), {PATHMARK_PROGRAM, "export"});
    return run(words, folder_.path());
  }
  static std::string valueOf(const std::vector<MarkupElement>& all, const std::string& name) {
    for (const MarkupElement& e : all)
      if (e.attributes.contains("name") && e.attributes.at("name") == name)
        return e.attributes.at("value");
    return "";
  }
};

TEST_F(ExportCommand, MitsubasSceneIsWellFormedAndComplete) {
  expectSays(exported({"cornell_spheres", "--format", "mitsuba", "--rays-per-pixel", "144",
                       "--max-bounces", "5"}),
             0, "Wrote cornell_spheres.xml");
  const std::vector<MarkupElement> xml = readXml(withoutComments(text("cornell_spheres.xml")));
  EXPECT_EQ(xml.front().name, "scene");
  EXPECT_EQ(valueOf(xml, "max_depth"), "6") << "5 scattering events";
  EXPECT_EQ(valueOf(xml, "sample_count"), "144");
  EXPECT_EQ(valueOf(xml, "width"), "256");
  EXPECT_EQ(valueOf(xml, "fov_axis"), "y");
  std::set<std::string> materials;
  int spheres = 0, lights = 0;
  for (const MarkupElement& e : xml) {
    if (e.name == "bsdf" && e.attributes.contains("id")) materials.insert(e.attributes.at("id"));
    if (e.name == "ref") {
      EXPECT_TRUE(materials.contains(e.attributes.at("id")));
    }
    spheres += e.name == "shape" && e.attributes.at("type") == "sphere" ? 1 : 0;
    lights += e.name == "emitter" ? 1 : 0;
    if (e.name == "string" && e.attributes.at("name") == "filename") {
      EXPECT_TRUE(std::filesystem::exists(folder_ / e.attributes.at("value")));
    }
  }
  EXPECT_EQ(spheres, 3);
  EXPECT_EQ(lights, 1);
}

TEST_F(ExportCommand, SaysWhatHasNoCounterpart) {
  const ProcessResult result = exported({"cornell_phong", "--format", "pbrt"});
  expectSays(result, 0, "no modified Phong");
  EXPECT_NE(text("cornell_phong.pbrt").find("# Note: pbrt has no modified Phong"),
            std::string::npos);
  expectSays(exported({"cornell_phong", "--format", "mitsuba"}), 0, "no modified Phong");
}

TEST_F(ExportCommand, WrongCommandLinesAreSentences) {
  expectSays(exported({"cornell_box", "--format", "blend"}), 2, "it is pbrt or mitsuba");
  expectSays(exported({"cornell_box"}), 2, "--format is required");
  expectSays(exported({"cornel_box", "--format", "pbrt"}), 2, "cornell_box");
  expectSays(exported({"cornell_box", "--format", "pbrt", "--output", "no/such/box.pbrt"}), 2,
             "there is no folder no/such");
  expectSays(exported({"cornell_box", "--format", "pbrt", "--output", "box.xml"}), 2,
             "ends in .pbrt");
}

}  // namespace
}  // namespace pathmark::test
