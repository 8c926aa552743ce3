#include "bench/stress/stress_chapter.h"

#include "film/atomic_file.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string>

namespace pathmark::bench {

namespace {

constexpr const char* kOpening =
    R"(# How far pictures can be trusted

`./pathmark bench stress --peer cycles --handout handouts/stress.md` makes this chapter anew, with the solutions;
`--quick` tries the same in a minute, and is among the tests. Everything runs in float; what is
expected comes from closed forms and quadratures in long double, or from the same scene elsewhere.

* **Similarity**: each scene, multiplied by a power of ten and moved by so many of its own sizes,
  through the reader of scenes, against the scene as it is, with the same random numbers. In %: the
  whole picture's mean, and the block of 8 x 8 pixels that differs most, relative to the block, or to
  a thousandth of the mean block where it is darker. The ranges end before the first scale or
  place tried at which the tolerance is passed. Some difference is always there: rounding sends a few
  paths another way.
* **Lights** and **materials**: relative errors of integrals over what the functions return.
* **Input**: answers that are not finite, negative, no direction, or out of range.
* **Blender**: the same similarity of Cycles for the Cornell box, which it gets where it is.
* **Long runs**: the error of pixels whose value is known, over that of independent rays.

)";

std::string textOf(const Cell& cell, int decimals) {
  if (cell.isNumber) return fmt::format("{:.{}f}", cell.number, decimals);
  return cell.text;
}

void appendTable(const Table& table, std::string& out) {
  fmt::format_to(std::back_inserter(out), "## {}\n\n|", table.title);
  for (const Column& column : table.columns)
    fmt::format_to(std::back_inserter(out), " {} |", column.title);
  out += "\n|---|";
  for (std::size_t c = 1; c < table.columns.size(); ++c) out += "---:|";
  out += "\n";
  for (const auto& row : table.rows) {
    out += "|";
    for (std::size_t c = 0; c < row.size(); ++c)
      fmt::format_to(std::back_inserter(out), " {} |", textOf(row[c], table.columns[c].decimals));
    out += "\n";
  }
  out += "\n";
}

std::string number(double value) {
  return value == 0.0             ? "0"
         : std::abs(value) < 0.01 ? fmt::format("{:.1e}", value)
                                  : fmt::format("{:.3g}", value);
}

void appendFigures(const Report& report, std::string& out) {
  out += "## What must hold\n\n| what | measured | must | aim | |\n|---|---:|---:|---:|---|\n";
  for (const Figure& f : report.figures)
    if (f.target)
      fmt::format_to(std::back_inserter(out), "| {} | {} | {} | {} | {} |\n", f.name,
                     number(f.value), number(f.target->must),
                     f.target->aim ? number(*f.target->aim) : "", f.verdict());
  out += "\n";
}

}  // namespace

void writeStressChapter(const std::filesystem::path& file, const Report& report) {
  std::string out = kOpening;
  appendFigures(report, out);
  for (const Table& table : report.tables) appendTable(table, out);
  out.pop_back();
  writeFileAtomically(file, out);
}

}  // namespace pathmark::bench
