// What a benchmark found, for a person and for a program.
//
//   Table      rows of measurements, printed one by one as they come
//   Figure     one measured number, with what it must be and is to be
//   Report     all of a run, with the machine it ran on; reportJson turns it into JSON
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pathmark::bench {

// A number, a text, or nothing where there is nothing to measure.
struct Cell {
  Cell() = default;
  Cell(double value) : number(value), isNumber(true) {}
  Cell(std::string words) : text(std::move(words)) {}

  double number = 0.0;
  bool isNumber = false;
  std::string text{};
};

struct Column {
  std::string key;        // in JSON
  std::string title;      // on the terminal
  int decimals = 1;       // of numbers, on the terminal
  std::size_t width = 0;  // at least so wide there
};

struct Table {
  std::string key;  // in JSON
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;

  void printHead() const;
  void add(std::vector<Cell> row);  // prints it too
};

struct Target {
  double must;
  std::optional<double> aim{};
  bool moreIsBetter = true;
};

struct Figure {
  std::string key;   // in JSON
  std::string name;  // on the terminal
  double value = 0.0;
  double error = 0.0;  // standard error; 0: not known
  std::string unit{};  // "" for ratios and counts
  std::optional<Target> target{};
  std::string note{};

  // "met", "met, and the aim", "not met"; empty without a target.
  std::string_view verdict() const;
};

struct Report {
  std::string command;
  std::string machine;
  std::vector<Table> tables;
  std::vector<Figure> figures;
};

// With a line for the machine below.
void printFigures(const Report& report);

std::string reportJson(const Report& report);

}  // namespace pathmark::bench
