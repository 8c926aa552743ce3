// Where a student finds what a function is about.
//
//   handoutOf   "handouts/part3_lambertian.md"
//   placeOf     "3.1 lambertianBRDF::brdf in student/part3_lambertian.cpp; the chapter is ..."
#pragma once

#include "worker/contract.h"

#include <filesystem>
#include <string>

namespace pathmark {

std::string handoutOf(const PartContract& part);

// `folder` is that of the coursework.
std::string placeOf(const FunctionContract& function, const std::filesystem::path& folder);

}  // namespace pathmark
