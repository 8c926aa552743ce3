#include "checks/all_checks.h"
#include "host/build_config.h"
#include "rubric/rubric.h"
#include "scene/json_object.h"
#include "scene/json_text.h"
#include "scene/load_scene.h"
#include "scene/read_text.h"
#include "worker/contract.h"

#include <cmath>
#include <span>

namespace pathmark::rubric {

namespace {

constexpr double kMostPoints = 10'000.0;
constexpr double kLargestBias = 100.0, kLargestRatio = 1000.0;

double readBetween(const json& value, const Place& place, double least, double most) {
  const double number = readNumber(value, place);
  if (!(number >= least && number <= most))
    place.refuse(describe(value),
                 fmt::format("this must be a number from {:g} to {:g}", least, most));
  return number;
}

// Above zero.
double readPositive(const json& value, const Place& place, double most) {
  const double number = readBetween(value, place, 0.0, most);
  if (number == 0.0) place.refuse("0", "this must be more than 0");
  return number;
}

double readCredit(const json& value, const Place& place) {
  return readBetween(value, place, 0.0, 1.0);
}

// Numbers by names, of which only these exist.
std::map<std::string, double> readNamed(const json& value, const Place& place,
                                        std::string_view what,
                                        const std::vector<std::string>& allowed) {
  if (!value.is_object())
    place.refuse(describe(value), fmt::format("{} must be an object {{ ... }}", what));
  const std::vector<std::string_view> names(allowed.begin(), allowed.end());
  std::map<std::string, double> result;
  for (const auto& entry : value.items()) {
    const Place inside(place, entry.key());
    if (std::find(names.begin(), names.end(), entry.key()) == names.end())
      inside.refuse(fmt::format("found the key {}, but {} are {}.{}", inQuotes(entry.key()), what,
                                fmt::join(names, ", "), didYouMean(entry.key(), names)));
    result[entry.key()] = readBetween(entry.value(), inside, 0.0, kMostPoints);
  }
  return result;
}

std::vector<std::string> sectionsOf(int part) {
  std::vector<std::string> sections;
  for (const FunctionContract& function : contract())
    if (function.part == part) sections.emplace_back(function.section);
  return sections;
}

std::vector<std::string> checksOf(int part) {
  std::vector<std::string> ids;
  for (const checks::Check& check : checks::checksOfPart(part)) ids.push_back(idOf(check));
  return ids;
}

// A part of functions.
void readFunctions(const json& value, const Place& place, PartRubric& part) {
  const Object object(value, place, "a part");
  object.allowOnly({"points", "efficiency", "functions", "checks"});
  object.optional("efficiency", [&](const json& v, const Place& p) {
    part.efficiency = readBetween(v, p, 0.0, kMostPoints);
    if (part.efficiency > part.points)
      p.refuse(describe(v), fmt::format("these are some of the part's points, of which there are "
                                        "{:g}",
                                        part.points));
  });
  const std::vector<std::string> sections = sectionsOf(part.part);
  object.optional("functions", [&](const json& v, const Place& p) {
    part.weights = readNamed(v, p, "the functions of this part", sections);
    double sum = 0.0;
    for (const std::string& section : sections)
      sum += part.weights.contains(section) ? part.weights.at(section) : 1.0;
    if (sum == 0.0) p.refuse("no function has a weight, but one of them must.");
  });
  object.optional("checks", [&](const json& v, const Place& p) {
    part.checks = readNamed(v, p, "the checks of this part", checksOf(part.part));
  });
}

PartRubric readPart(int number, const json& value, const Place& place) {
  const Object object(value, place, "a part");
  PartRubric part;
  part.part = number;
  object.required("points", [&](const json& v, const Place& p) {
    part.points = readBetween(v, p, 0.0, kMostPoints);
  });
  part.bonus = number > kScenesPart && number < kWholePart;
  if (number < kScenesPart || part.bonus) {
    readFunctions(value, place, part);
  } else {
    object.allowOnly({"points"});
  }
  return part;
}

// Without bonus parts, whose points come on top.
double sumOf(const std::vector<PartRubric>& parts) {
  double sum = 0.0;
  for (const PartRubric& part : parts)
    if (!part.bonus) sum += part.points;
  return sum;
}

std::vector<PartRubric> readParts(const json& value, const Place& place) {
  const Object object(value, place, "the list of parts");
  object.allowOnly({"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "whole"});
  std::vector<PartRubric> parts;
  for (int number = 0; number <= kWholePart; ++number)
    object.optional(
        number == kWholePart ? "whole" : std::to_string(number),
        [&](const json& v, const Place& p) { parts.push_back(readPart(number, v, p)); });
  if (sumOf(parts) == 0.0) place.refuse("no part has any points, but one of them must.");
  return parts;
}

// What a kind of band is called, and how its credits go while its bounds grow.
template <typename Band>
struct BandKind {
  std::string_view key;
  double Band::*bound;
  double largest;
  bool creditsFall;
};

// The bounds must grow, and the credits not turn round.
template <typename Band>
std::vector<Band> readBands(const json& value, const Place& place, const BandKind<Band>& kind) {
  if (!value.is_array() || value.empty())
    place.refuse(describe(value), fmt::format("this must be an array of bands {{ \"{}\", "
                                              "\"credit\" }}",
                                              kind.key));
  std::vector<Band> bands;
  for (const json& entry : value) {
    const Place inside(place, bands.size());
    const Object object(entry, inside, "a band");
    object.allowOnly({kind.key, "credit"});
    const Band* const before = bands.empty() ? nullptr : &bands.back();
    Band band;
    object.required(kind.key, [&](const json& v, const Place& p) {
      band.*kind.bound = readPositive(v, p, kind.largest);
      if (before && !(band.*kind.bound > before->*kind.bound))
        p.refuse(describe(v), "bands stand in the order of their bounds, the smallest first");
    });
    object.required("credit", [&](const json& v, const Place& p) {
      band.credit = readCredit(v, p);
      if (before && kind.creditsFall && band.credit > before->credit)
        p.refuse(describe(v), "a larger bias must not earn more than a smaller one");
      if (before && !kind.creditsFall && band.credit < before->credit)
        p.refuse(describe(v), "a higher efficiency must not earn less than a lower one");
    });
    bands.push_back(band);
  }
  return bands;
}

void readWrong(const json& value, const Place& place, Rubric& rubric) {
  const Object object(value, place, "the credit for what is wrong");
  object.allowOnly({"atMost", "withoutPicture", "bands"});
  object.optional("atMost",
                  [&](const json& v, const Place& p) { rubric.wrongAtMost = readCredit(v, p); });
  object.optional("withoutPicture",
                  [&](const json& v, const Place& p) { rubric.withoutPicture = readCredit(v, p); });
  object.optional("bands", [&](const json& v, const Place& p) {
    rubric.biasBands =
        readBands<BiasBand>(v, p, {"biasAtMost", &BiasBand::biasAtMost, kLargestBias, true});
  });
}

void readEnded(const json& value, const Place& place, Rubric& rubric) {
  const Object object(value, place, "the credit for what ended early");
  object.allowOnly({"crashed", "timeLimit", "memoryLimit", "outputLimit", "forbiddenCall"});
  const auto credit = [&](std::string_view key, double& result) {
    object.optional(key, [&](const json& v, const Place& p) { result = readCredit(v, p); });
  };
  credit("crashed", rubric.crashed);
  credit("timeLimit", rubric.timeLimit);
  credit("memoryLimit", rubric.memoryLimit);
  credit("outputLimit", rubric.outputLimit);
  credit("forbiddenCall", rubric.forbiddenCall);
}

void readEfficiency(const json& value, const Place& place, Rubric& rubric) {
  const Object object(value, place, "the credit for efficiency");
  object.allowOnly({"bands", "reviewAbove"});
  object.optional("bands", [&](const json& v, const Place& p) {
    rubric.efficiencyBands = readBands<EfficiencyBand>(
        v, p, {"ratioAtLeast", &EfficiencyBand::ratioAtLeast, kLargestRatio, false});
  });
  object.optional("reviewAbove", [&](const json& v, const Place& p) {
    rubric.reviewAbove = readPositive(v, p, kLargestRatio);
  });
}

void scaleTo(double total, std::vector<PartRubric>& parts) {
  const double sum = sumOf(parts);
  if (sum == total) return;
  for (PartRubric& part : parts) {
    part.points = part.points * total / sum;
    part.efficiency = part.efficiency * total / sum;
    for (auto& [id, points] : part.checks) points = points * total / sum;
  }
}

Rubric readTop(const json& value, const Place& top) {
  const Object object(value, top, "a rubric");
  object.allowOnly({"$schema", "total", "step", "parts", "wrong", "endedEarly", "efficiency"});
  Rubric rubric;
  object.optional("$schema", [](const json& v, const Place& p) { readWord(v, p); });
  object.required("parts", [&](const json& v, const Place& p) { rubric.parts = readParts(v, p); });
  object.optional("total", [&](const json& v, const Place& p) {
    scaleTo(readPositive(v, p, kMostPoints), rubric.parts);
  });
  object.optional("step", [&](const json& v, const Place& p) {
    rubric.step = readBetween(v, p, 0.0, kMostPoints);
  });
  object.optional("wrong", [&](const json& v, const Place& p) { readWrong(v, p, rubric); });
  object.optional("endedEarly", [&](const json& v, const Place& p) { readEnded(v, p, rubric); });
  object.optional("efficiency",
                  [&](const json& v, const Place& p) { readEfficiency(v, p, rubric); });
  return rubric;
}

}  // namespace

std::filesystem::path defaultRubric() {
  return std::filesystem::path(build::kProjectFolder) / "grader/rubric/rubric.json";
}

Rubric readRubric(const std::filesystem::path& file) {
  try {
    const SceneSource source{file, readText(file, "a rubric is a JSON file")};
    checkSyntax(source);
    const json value = json::parse(source.text.begin(), source.text.end(), nullptr, true, true);
    const Place top(source);
    Rubric rubric = readTop(value, top);
    rubric.file = file;
    return rubric;
  } catch (const SceneError& error) {
    throw RubricError(error.what());
  }
}

}  // namespace pathmark::rubric
