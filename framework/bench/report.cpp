#include "bench/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pathmark::bench {

namespace {

constexpr std::size_t kFirstWidth = 20;
constexpr std::size_t kLeastWidth = 9;

std::size_t widthOf(const Table& table, std::size_t column) {
  const Column& c = table.columns[column];
  return std::max({column == 0 ? kFirstWidth : kLeastWidth, c.title.size(), c.width});
}

void printCell(const Table& table, std::size_t column, const std::string& text) {
  if (column == 0) {
    fmt::print("{:<{}}", text, widthOf(table, column));
  } else {
    fmt::print("  {:>{}}", text, widthOf(table, column));
  }
}

std::string textOf(const Cell& cell, int decimals) {
  if (cell.isNumber) return fmt::format("{:.{}f}", cell.number, decimals);
  return cell.text.empty() ? "-" : cell.text;
}

// Three significant digits, and no fewer than all before the point.
std::string shortNumber(double value) {
  const double size = std::abs(value);
  if (size != 0.0 && size < 1e-3) return fmt::format("{:.2e}", value);
  return fmt::format("{:.{}f}", value,
                     size >= 99.95    ? 0
                     : size >= 9.995  ? 1
                     : size >= 0.9995 ? 2
                                      : 3);
}

std::string measured(const Figure& figure) {
  std::string text = shortNumber(figure.value);
  if (figure.error > 0.0) text += fmt::format(" +- {}", shortNumber(figure.error));
  return figure.unit.empty() ? text : text + " " + figure.unit;
}

}  // namespace

void Table::printHead() const {
  if (!title.empty()) fmt::print("\n{}\n", title);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    printCell(*this, c, columns[c].title);
  }
  fmt::print("\n");
  std::fflush(stdout);
}

void Table::add(std::vector<Cell> row) {
  for (std::size_t c = 0; c < row.size(); ++c) {
    printCell(*this, c, textOf(row[c], columns[c].decimals));
  }
  fmt::print("\n");
  std::fflush(stdout);
  rows.push_back(std::move(row));
}

std::string_view Figure::verdict() const {
  if (!target) return "";
  const auto reaches = [this](double bound) {
    return target->moreIsBetter ? value >= bound : value <= bound;
  };
  if (!reaches(target->must)) return "not met";
  return target->aim && reaches(*target->aim) ? "met, and the aim" : "met";
}

void printFigures(const Report& report) {
  fmt::print("\n{:<70}  {:>16}  {:>8}  {:>8}  {}\n", "figure", "measured", "must", "aim",
             "verdict");
  for (const Figure& f : report.figures) {
    const std::string must = f.target ? shortNumber(f.target->must) : "";
    const std::string aim = f.target && f.target->aim ? shortNumber(*f.target->aim) : "";
    fmt::print("{:<70}  {:>16}  {:>8}  {:>8}  {}\n", f.name, measured(f), must, aim, f.verdict());
  }
  for (const Figure& f : report.figures)
    if (!f.note.empty()) fmt::print("{}: {}\n", f.name, f.note);
  fmt::print("\n{}\n", report.machine);
  std::fflush(stdout);
}

}  // namespace pathmark::bench
