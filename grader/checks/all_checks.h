// All checks, by part, in the order of the handouts.
#pragma once

#include "checks/check.h"

namespace pathmark::checks {

std::span<const Check> part0Checks();
std::span<const Check> part1Checks();
std::span<const Check> part2Checks();
std::span<const Check> part3Checks();
std::span<const Check> part4Checks();
std::span<const Check> part5Checks();
std::span<const Check> part6Checks();
std::span<const Check> part8Checks();
std::span<const Check> part9Checks();

std::span<const Check> checksOfPart(int part);

// Of the whole coursework: its pictures.
std::span<const Check> imageChecks();

}  // namespace pathmark::checks
