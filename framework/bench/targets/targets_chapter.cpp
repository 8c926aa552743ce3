#include "bench/targets/targets_chapter.h"

#include "bench/error_words.h"
#include "film/atomic_file.h"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <utility>

namespace pathmark::bench {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kOpening =
    R"(# How fast it is

`{}` makes this chapter anew.

Every speed is a ratio of two things that were measured in turns in one run, where there is
something to measure it against; the others hold for the machine below. *Must* is what is asked of
the program, *aim* what it is to become.

{}

)";

constexpr const char* kEfficiency =
    R"(## Error and time of whole renders

Efficiency is 1 / (relative mean squared error x CPU seconds), of processes of one thread from their
start to their end.

)";

constexpr const char* kLights =
    R"(## In other ways

The same with multiple importance sampling ([part 8](part8_mis.md)), with points on lights by the
solid angle ([part 9](part9_solid_angle.md)), and with several paths for each camera ray, which share
the surface that it meets first, and the direct light there or not
([splitting](labs.md#7-splitting)), and with paths that neighbouring pixels share
([re-using paths](labs.md#8-re-using-paths)): `bench lights`.

)";

struct ColumnOf {
  const char* key;
  const char* title;
  int decimals;
};

std::string textOf(const Json& value, int decimals) {
  if (value.is_number()) return fmt::format("{:.{}f}", value.get<double>(), decimals);
  return value.is_string() ? value.get<std::string>() : std::string();
}

template <std::size_t N>
void appendRows(const Json& rows, const std::array<ColumnOf, N>& columns, std::string& out) {
  out += "|";
  for (const ColumnOf& c : columns) out += fmt::format(" {} |", c.title);
  out += "\n|---|---|";
  for (std::size_t c = 2; c < columns.size(); ++c) out += "---:|";
  out += "\n";
  for (const Json& row : rows) {
    out += "|";
    for (const ColumnOf& c : columns)
      out += fmt::format(" {} |", textOf(row.value(c.key, Json()), c.decimals));
    out += "\n";
  }
  out += "\n";
}

void appendFigures(const FiguresOf& part, std::string& out) {
  fmt::format_to(std::back_inserter(out),
                 "`{}`\n\n| what | measured | must | aim | |\n|---|---:|---:|---:|---|\n",
                 part.command);
  for (const Figure& f : part.figures) {
    const std::string unit = f.unit.empty() ? "" : " " + f.unit;
    const std::string error = f.error > 0.0 ? " ± " + threeDigits(f.error) : "";
    fmt::format_to(std::back_inserter(out), "| {} | {}{}{} | {} | {} | {} |\n", f.name,
                   threeDigits(f.value), error, unit, threeDigits(f.target->must),
                   f.target->aim ? threeDigits(*f.target->aim) : "", f.verdict());
  }
  out += "\n";
  for (const Figure& f : part.figures)
    if (!f.note.empty()) fmt::format_to(std::back_inserter(out), "- {}: {}\n", f.name, f.note);
  if (!out.ends_with("\n\n")) out += "\n";
}

}  // namespace

std::vector<Figure> targetedFigures(const Json& report) {
  std::vector<Figure> figures;
  for (const auto& [key, json] : report.at("figures").items()) {
    if (!json.contains("must") || !json.at("value").is_number()) continue;
    Target target{.must = json.at("must"), .moreIsBetter = json.at("moreIsBetter")};
    if (json.at("aim").is_number()) target.aim = json.at("aim").get<double>();
    figures.push_back({.key = key,
                       .name = json.at("name"),
                       .value = json.at("value"),
                       .error = json.value("error", 0.0),
                       .unit = json.value("unit", ""),
                       .target = target,
                       .note = json.value("note", "")});
  }
  return figures;
}

void writeTargetsChapter(const std::filesystem::path& file, const TargetsFindings& findings) {
  std::string out = fmt::format(kOpening, findings.command, findings.machine);
  out += "## What is asked\n\n";
  for (const FiguresOf& part : findings.parts)
    if (!part.figures.empty()) appendFigures(part, out);
  out += kEfficiency;
  appendRows(findings.efficiency,
             std::array<ColumnOf, 7>{{{"scene", "scene", 0},
                                      {"renderer", "renderer", 0},
                                      {"raysPerPixel", "rays/px", 0},
                                      {"relMse", "relMSE x 1e4", 3},
                                      {"cpuSeconds", "CPU s", 2},
                                      {"efficiency", "efficiency", 0},
                                      {"meanOff", "mean off, %", 3}}},
             out);
  out += kLights;
  appendRows(findings.lights,
             std::array<ColumnOf, 6>{{{"scene", "scene", 0},
                                      {"way", "way", 0},
                                      {"relMse", "relMSE x 1e4", 3},
                                      {"cpuSeconds", "CPU s", 2},
                                      {"efficiencyRatio", "efficiency / tracePath's", 2},
                                      {"efficiencyRatioError", "±", 2}}},
             out);
  out.pop_back();
  writeFileAtomically(file, out);
}

}  // namespace pathmark::bench
