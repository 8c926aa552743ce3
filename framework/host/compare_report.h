// What pathmark compare says about two images.
//
//   CompareReport      what was compared, and how it came out
//   verdictSentence    the first line
//   compareNotes       sentences on what limits the comparison
//   furthestTiles      the tiles to list
//   compareTable, compareJson   everything, for people and for programs
#pragma once

#include "film/compare.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace pathmark {

// A file that was written, and the number that is shown in full colour; 0 if it has no colours.
struct ComparePicture {
  std::filesystem::path file;
  std::string what;
  double fullColour = 0.0;
};

struct CompareReport {
  std::array<std::filesystem::path, 2> names;  // A, B
  std::array<ImageFile, 2> files;
  CompareSettings settings;
  Comparison comparison;
  std::vector<ComparePicture> pictures{};
};

constexpr std::array<const char*, 3> kChannelNames{"R", "G", "B"};

std::string verdictSentence(const CompareReport& report);

std::vector<std::string> compareNotes(const CompareReport& report);

// Of each tile the channel that is furthest apart: by p-value where there are variances, else by
// relative difference. At most ten, the furthest first, and none of equal means.
std::vector<RegionResult> furthestTiles(const Comparison& comparison);

std::string compareTable(const CompareReport& report);
std::string compareJson(const CompareReport& report);

}  // namespace pathmark
