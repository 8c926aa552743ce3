// The chapter of all that is asked of the program's speed, and how far it goes.
//
//   FiguresOf            what one command has found
//   writeTargetsChapter  the chapter, as Markdown
#pragma once

#include "bench/report.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace pathmark::bench {

struct FiguresOf {
  std::string command;  // as it can be repeated
  std::vector<Figure> figures;
};

// From a report's JSON: the figures that have a target.
std::vector<Figure> targetedFigures(const nlohmann::ordered_json& report);

struct TargetsFindings {
  std::string command, machine;
  std::vector<FiguresOf> parts;
  nlohmann::ordered_json efficiency = nlohmann::ordered_json::array();  // rows of bench render's
  nlohmann::ordered_json lights = nlohmann::ordered_json::array();      // rows of bench lights'
};

// Throws ImageError.
void writeTargetsChapter(const std::filesystem::path& file, const TargetsFindings& findings);

}  // namespace pathmark::bench
