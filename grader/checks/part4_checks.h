// What is asked of the modified Phong BRDF, by its functions.
//
//   4.1 brdf         part4_value_checks.cpp
//   4.2 pdf          part4_density_checks.cpp
//   4.3 reflection   part4_sampling_checks.cpp
#pragma once

#include "checks/phong_oracle.h"

#include <array>

namespace pathmark::checks::phong {

// From plain ones to extreme ones.
inline constexpr std::array kExponents{1.0f, 10.0f, 3.7f, 0.5f, 0.0f, 100.0f, 1e4f, 1e6f};

inline const Colour kKd(0.25f, 0.4f, 0.1f), kKs(0.6f, 0.3f, 0.2f), kBlack(0.0f);

// Why a density of wi, or wi itself, is no number; empty where nothing tells.
std::string causeOfNoNumber(const PhongLobes& lobes, const Vector& wi);

Finding valueIsTheFormula(CheckRun& run);

Finding densityIsADensity(CheckRun& run);
Finding densityIsThatOfReflection(CheckRun& run);

Finding directionsAreValid(CheckRun& run);
Finding bothLobesAreDrawn(CheckRun& run);
Finding densityIsOfTheMixture(CheckRun& run);
Finding samplesFollowTheirDensity(CheckRun& run);

}  // namespace pathmark::checks::phong
