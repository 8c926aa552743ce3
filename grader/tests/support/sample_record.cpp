#include "support/sample_record.h"

#include "film/image_formats.h"
#include "film/signed_picture.h"
#include "worker/contract.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

namespace pathmark::test {

using record::CheckRecord;
using record::FunctionRecord;
using record::Histogram;
using record::PartRecord;
using record::PictureRecord;
using record::SampleDomain;
using record::SampleRecord;
using record::SubmissionRecord;
using record::Verdict;
using rubric::MarkLine;
using rubric::Marks;
using rubric::PartMarks;

namespace {

CheckRecord passed(const std::string& id, const std::string& statement, double delta) {
  CheckRecord check;
  check.id = id;
  check.statement = statement;
  check.delta = delta;
  check.shown = 0.8 * delta;
  check.calls = 262144;
  check.seconds = 0.21;
  return check;
}

CheckRecord failed(const std::string& id, Verdict verdict) {
  CheckRecord check;
  check.id = id;
  check.statement = "the directions follow the density that is returned";
  check.verdict = verdict;
  check.where = "wo = (0.36, 0.48, 0.8), n = (0, 1, 0), 65536 samples";
  check.expected = "mean of cos(theta) = 0.6667";
  check.got = "mean of cos(theta) = 0.5002";
  check.tolerance = "7.1 standard errors of 0.0004";
  check.cause = "the directions are uniform over the hemisphere: cos(theta) = s instead of sqrt(s)";
  check.read = "handouts/part3_lambertian.md, section 3.3";
  check.repeat = fmt::format("./pathmark check {} --seed 4711", id);
  check.delta = 0.01;
  check.seconds = 0.35;
  return check;
}

FunctionRecord functionWith(const FunctionContract& contract, Verdict verdict) {
  const std::string section(contract.section);
  FunctionRecord function{section, std::string(contract.name), verdict, {}};
  if (verdict == Verdict::kNotWritten) return function;
  function.checks.push_back(
      passed(section + "/valid", "directions are of unit length, above the surface", 0.0));
  if (verdict == Verdict::kOk) {
    function.checks.push_back(passed(section + "/samples", "the samples follow the density", 0.01));
    if (section == "3.1") function.checks.back().remark = "twice the noise of the density of 3.3";
    return function;
  }
  function.checks.push_back(failed(section + "/samples", verdict));
  CheckRecord& check = function.checks.back();
  if (verdict == Verdict::kBlocked) {
    check = passed(check.id, check.statement, 0.01);
    check.verdict = verdict;
    check.cause = "3.3 lambertianBRDF::reflection, which is wrong";
  }
  if (verdict == Verdict::kUndecided)
    check.cause = "far more noise than the solutions have, so that 1 % could not be shown";
  if (verdict == Verdict::kCrashed) {
    check.got = "segmentation fault in LitScene::directLighting, part2_lights.cpp, line 63";
    check.expected.clear();
  }
  return function;
}

Verdict verdictOf(const FunctionContract& contract) {
  switch (contract.function) {
    case CourseworkFunction::kSampleHemisphere:
    case CourseworkFunction::kLambertianReflection:
      return Verdict::kWrong;
    case CourseworkFunction::kSphereSample:
      return Verdict::kUndecided;
    case CourseworkFunction::kDirectLighting:
      return Verdict::kCrashed;
    case CourseworkFunction::kTracePath:
      return Verdict::kTimeLimit;
    case CourseworkFunction::kRussianRoulette:
      return Verdict::kNotWritten;
    case CourseworkFunction::kGetRayRadiance:
      return Verdict::kBlocked;
    default:
      return Verdict::kOk;
  }
}

PictureRecord picture(const std::string& scene, const std::string& stem, double bias) {
  PictureRecord p;
  p.scene = scene;
  p.yours = fmt::format("pictures/{}_yours.png", stem);
  p.reference = fmt::format("pictures/{}_reference.png", stem);
  p.difference = fmt::format("pictures/{}_difference.png", stem);
  p.scale = 0.25;
  p.width = p.height = 192;
  p.raysPerPixel = 256;
  p.bias = {bias, 0.93 * bias, 1.08 * bias};
  p.meanError = {{{-bias, -1.1 * bias, -0.9 * bias}, {-0.8 * bias, -bias, -0.6 * bias}, {0, 0, 0}}};
  p.efficiency = {0.46, 0.41, 0.52};
  for (std::uint32_t i = 0; i < 20; ++i) p.pValues.push_back(1700 + (i == 0 ? 5200 : 37 * (i % 4)));
  for (double rays = 1.0; rays <= 1024.0; rays *= 4.0) {
    p.convergence.raysPerPixel.push_back(rays);
    p.convergence.solutions.push_back(0.31 / std::sqrt(rays));
    p.convergence.yours.push_back(std::hypot(0.42 / std::sqrt(rays), bias));
  }
  return p;
}

std::array<float, 3> direction(double y, double phi) {
  const double r = std::sqrt(std::max(0.0, 1.0 - y * y));
  return {static_cast<float>(r * std::cos(phi)), static_cast<float>(y),
          static_cast<float>(r * std::sin(phi))};
}

// Cosines of `yours` in equal bins, against a density that is linear in the cosine.
Histogram histogram(const std::vector<double>& values, double low, bool linear) {
  constexpr std::size_t kBins = 20;
  Histogram h{"cos(theta)", low, 1.0, std::vector<double>(kBins, 0.0), {}};
  for (const double v : values) {
    const auto bin = static_cast<std::size_t>((v - low) / (1.0 - low) * kBins);
    h.yours[std::min(bin, kBins - 1)] += 1.0 / static_cast<double>(values.size());
  }
  for (std::size_t i = 0; i < kBins; ++i) {
    const double middle = (static_cast<double>(i) + 0.5) / kBins;
    h.expected.push_back((linear ? 2.0 * middle : 1.0) / kBins);
  }
  return h;
}

std::vector<SampleRecord> samples() {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  SampleRecord sphere{"0.4", "sample_sphere", "u stratified", SampleDomain::kSphere, {}, {}};
  SampleRecord hemisphere{"3.3",
                          "lambertianBRDF::reflection",
                          "n = (0, 1, 0), s and t stratified",
                          SampleDomain::kHemisphere,
                          {},
                          {}};
  SampleRecord plane{"2.1",
                     "Polygon::TriangularSampling",
                     "the triangle (0,0), (1,0), (0,1)",
                     SampleDomain::kPlane,
                     {},
                     {}};
  std::vector<double> sphereCosines, cosines;
  constexpr int kSide = 22;
  for (int i = 0; i < kSide * kSide; ++i) {
    const double s = (i % kSide + uniform(random)) / kSide,
                 t = (i / kSide + uniform(random)) / kSide;
    const double phi = 2.0 * std::numbers::pi * t;
    sphereCosines.push_back(2.0 * s - 1.0);
    sphere.yours.push_back(direction(2.0 * s - 1.0, phi));
    cosines.push_back(s);
    hemisphere.yours.push_back(direction(i % 40 == 0 ? -0.3 * s : s, phi));
    plane.yours.push_back({static_cast<float>(s), 0.0f, static_cast<float>((1.0 - s) * t)});
  }
  sphere.histograms.push_back(histogram(sphereCosines, -1.0, false));
  hemisphere.histograms.push_back(histogram(cosines, 0.0, true));
  return {sphere, plane, hemisphere};
}

PartRecord partRecord(const PartContract& contract, bool allRight) {
  PartRecord part;
  part.part = contract.part;
  part.file = contract.file;
  part.title = contract.title;
  if (!allRight && part.part == 4) {
    part.verdict = Verdict::kDoesNotCompile;
    part.message =
        "part4_phong.cpp: In member function 'float phongBRDF::pdf(const Vector&, const Vector&, "
        "const Vector&) const':\npart4_phong.cpp:41:23: error: 'pow' was not declared in this "
        "scope; did you mean 'std::pow'?\n   41 |   return Ks * (n + 1) * pow(cosAlpha, n);\n      "
        "|                         ^~~\n";
    return part;
  }
  for (const FunctionContract& f : pathmark::contract()) {
    if (f.part != part.part) continue;
    part.functions.push_back(functionWith(f, allRight ? Verdict::kOk : verdictOf(f)));
    const Verdict verdict = part.functions.back().verdict;
    if (worseThan(verdict, part.verdict)) part.verdict = verdict;
  }
  if (part.part == 2 || part.part == 5)
    part.pictures.push_back(picture("cornell_box", fmt::format("part{}_cornell_box", part.part),
                                    allRight ? 0.0004 : 0.162));
  return part;
}

PartMarks partMarks(const PartRecord& part) {
  PartMarks marks{part.part, fmt::format("Part {}: {}", part.part, part.title), 0.0, 0.0, {}};
  for (const FunctionContract& f : pathmark::contract()) {
    if (f.part != part.part) continue;
    MarkLine line{fmt::format("{} {}", f.section, f.name), 0.0, 3.0, {}};
    Verdict verdict = part.verdict;
    for (const FunctionRecord& function : part.functions)
      if (function.section == f.section) verdict = function.verdict;
    if (verdict == Verdict::kOk || verdict == Verdict::kUndecided)
      line.points = line.outOf;
    else if (verdict == Verdict::kWrong)
      line.points = 1.25, line.reason = "the picture is 2.1 % (1.9 to 2.3 %) off";
    else
      line.reason = nameOf(verdict);
    marks.lines.push_back(line);
  }
  if (part.part == 5)
    marks.lines.push_back(
        {"efficiency", 1.5, 4.0, "0.46 (0.41 to 0.52) of the solutions'; full points from 0.8 on"});
  if (part.part == 0 && part.verdict != Verdict::kOk)
    marks.lines.push_back({"rounding", -0.25, 0.0, "the points of a part are multiples of 0.5"});
  for (const MarkLine& line : marks.lines) marks.points += line.points, marks.outOf += line.outOf;
  return marks;
}

SubmissionRecord recordOf(const std::string& name, bool allRight) {
  SubmissionRecord record;
  record.name = name;
  record.source = fmt::format("submissions/{}.zip", name);
  record.contents = "5c1f0e9a27bd8834c66b1f90d7e2aa10";
  record.seed = 4711;
  record.build = {"9d20b7f31c6e4a58", "g++ 12.2.0", "-O3 -march=native -ffp-contract=off",
                  "x86-64, AVX2", "bubblewrap"};
  for (const PartContract& part : pathmark::parts())
    if (!part.bonus) record.parts.push_back(partRecord(part, allRight));
  record.samples = samples();
  record.pictures.push_back(picture("cornell_box", "whole_cornell_box", allRight ? 0.0003 : 0.08));
  record.seconds = 41.3;
  record.scenes.push_back({"scenes/my_scene.json", "Caustics below a glass of water", Verdict::kOk,
                           "", "most of the noise is in the caustic, at the lower left",
                           "pictures/scene_yours.png"});
  if (allRight) return record;
  record.collecting = {"part4_phong.cpp.bak was left out: it is no file of the coursework.",
                       "scenes/../../.bashrc was refused: its path leads out of the submission."};
  record.images = {passed("images/mean", "the mean of the picture is that of the reference", 0.005),
                   passed("images/tiles", "so are the means of its tiles", 0.02)};
  record.images[1].verdict = Verdict::kBlocked;
  record.images[1].cause = "3.3 lambertianBRDF::reflection, which is wrong";
  record.pictures.push_back({});
  record.pictures.back().scene = "a room that was made for marking";
  record.pictures.back().failure = "part5_path.cpp gave no answer for 10 s.";
  record.scenes.push_back({"scenes/broken.json", "", Verdict::kWrong,
                           "line 7: \"radius\" is -1, but must be greater than 0", "", ""});
  record.printed = "s = 0.25\nreached line 41\n";
  return record;
}

Marks marksOf(const SubmissionRecord& record) {
  Marks marks;
  for (const PartRecord& part : record.parts) marks.parts.push_back(partMarks(part));
  for (const PartMarks& part : marks.parts) marks.points += part.points, marks.outOf += part.outOf;
  return marks;
}

}  // namespace

SubmissionRecord sampleRecord(const std::string& name) { return recordOf(name, false); }

Marks sampleMarks() { return marksOf(recordOf("sample", false)); }

SubmissionRecord leftOutRecord(const std::string& name) {
  SubmissionRecord record;
  record.name = name;
  record.source = fmt::format("submissions/{}.zip", name);
  record.seed = 4711;
  record.leftOut = "Nothing was taken: the archive is damaged.";
  return record;
}

void SampleClass::add(SubmissionRecord record) {
  records.push_back(std::move(record));
  marks.emplace_back();
}

std::vector<report::Graded> SampleClass::graded() const {
  std::vector<report::Graded> list;
  for (std::size_t i = 0; i < records.size(); ++i)
    list.push_back(
        {&records[i], &marks[i], fmt::format("submissions/{}", records[i].name), samplePicture});
  return list;
}

SampleClass sampleClass() {
  SampleClass c;
  c.records = {recordOf("anna_complete", true), recordOf("ben_of_all_sorts", false),
               recordOf("cleo_with_a_name_that_goes_on_and_on_and_on_until_2026", false),
               recordOf("dora_nearly", true), recordOf("emil_unlucky", false)};
  PartRecord& crashed = c.records[3].parts[6];
  crashed.verdict = crashed.functions[0].verdict = Verdict::kCrashed;
  crashed.functions[0].checks.back() = failed("6.1/weight", Verdict::kCrashed);
  c.records[4].failure = "bubblewrap could not be started: no space left on device.";
  for (const SubmissionRecord& record : c.records) c.marks.push_back(marksOf(record));
  c.marks[0].toReview = {"Part 5 has 0.2 times the variance of the solutions; is it allowed to?"};
  return c;
}

std::string samplePicture(const std::string& file) {
  constexpr int kSide = 96;
  std::vector<std::uint8_t> bytes;
  std::vector<float> differences;
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      for (const int c : {i, j, 60}) bytes.push_back(static_cast<std::uint8_t>(40 + 2 * c));
      differences.push_back(static_cast<float>(i - j) / kSide);
    }
  return file.ends_with("difference.png") ? encodeSignedPng(kSide, kSide, differences, 1.0)
                                          : encodePngBytes(kSide, kSide, bytes);
}

}  // namespace pathmark::test
