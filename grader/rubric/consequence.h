// What mistakes do to pictures, and what that is worth.
//
//   Consequence, worstPicture   the bias of the worst of several pictures
//   isRight                     whether a picture is what it should be
//   Economy, worstEfficiency    the efficiency of the least efficient one
//   percent, interval           numbers in sentences
#pragma once

#include "rubric/rubric.h"

#include <optional>
#include <span>
#include <string>

namespace pathmark::rubric {

struct Consequence {
  double credit = 0.0;  // by the bands alone
  std::string words;    // "the picture of cornell_box is 2.1 % (1.9 % to 2.3 %) off"
};

// In favour of the student by the lower end of each bias's interval. A picture some of whose values
// are no radiance earns what its bias does, but not more than a mistake that no picture shows.
// Nothing without pictures.
std::optional<Consequence> worstPicture(std::span<const record::PictureRecord> pictures,
                                        const Rubric& rubric);

// In the band of full credit, and all its values are radiance.
bool isRight(const record::PictureRecord& picture, const Rubric& rubric);

struct Economy {
  double credit = 0.0;
  std::string words;  // "in cornell_box 1 / (variance x rays) is 0.5 (0.4 to 0.6) of the ..."
};

// Each picture counts by the highest band that its interval reaches. Nothing if it was measured in
// none of them.
std::optional<Economy> worstEfficiency(std::span<const record::PictureRecord> pictures,
                                       const Rubric& rubric);

std::string percent(double share);  // "2.1 %", "37 %"
std::string interval(const record::Estimate& shares);

}  // namespace pathmark::rubric
