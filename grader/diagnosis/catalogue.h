// The catalogue: signatures of the known mistakes and of what is right.
//
//   KnownSignature       of one mistake in one function, or of the right function
//   FunctionCatalogue    all of a function
//   Catalogue            of all functions, as the file beside this header holds it
//
// The file has sentences and numbers, and nothing of any coursework. `./pathmark study
// --catalogue` writes it; its stamp says for which variants, solutions and probes.
#pragma once

#include "diagnosis/signature.h"
#include "worker/contract.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pathmark::diagnosis {

struct KnownSignature {
  std::string mistake;  // "part3_angle_uniform"; empty: of what is right
  std::string what;     // in words
  std::vector<double> values, errors;
};

struct FunctionCatalogue {
  CourseworkFunction function = CourseworkFunction::kRayTriangleIntersection;
  std::string features;  // hash of their words: another probe makes others
  KnownSignature right;
  std::vector<KnownSignature> mistakes;  // that can be seen in this function
  std::optional<KnownSignature> stub{};  // of the shipped stub without its marker
};

struct Catalogue {
  std::string stamp;
  std::vector<FunctionCatalogue> functions;

  const FunctionCatalogue* find(CourseworkFunction function) const;
};

std::string hashOf(const Signature& signature);
KnownSignature knownSignature(std::string mistake, std::string what, const Signature& signature);

std::filesystem::path catalogueFile();

// Throws std::runtime_error if the file is damaged or missing.
Catalogue readCatalogue(const std::filesystem::path& file);
void writeCatalogue(const Catalogue& catalogue, const std::filesystem::path& file);

// That of the file, read once. Nothing is in it if the file cannot be read: then nothing is named.
const Catalogue& shippedCatalogue();

}  // namespace pathmark::diagnosis
