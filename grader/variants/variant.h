// Variants of the solutions, for testing the grader: what it must find, and what it must accept.
//
//   Variant        one patch of grader/variants/wrong or grader/variants/correct
//   readVariant    what the head of a patch says
//   readMistake    the same, of a mistake that names the check that must find it
//   allVariants    all of them
//   applyVariant   the solutions with a variant's change
//   applyVariants  the solutions with the changes of several
//   addVariant     one more change, to files that may have been changed before
//
// A patch is a unified diff of one file of solutions/, after a head and an empty line:
//
//   Mistake: the cosine is part of the BRDF's value
//   Part: 3
//   Function: lambertianBRDF::brdf
//   Check: 3.1/value
//
// "Different:" stands for "Mistake:" where the change is correct; there is no function and no check
// to name then. One that is noisier than the solutions by its nature says so:
//
//   Efficiency: less, because directions that carry little are as likely as others
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace pathmark {

struct Variant {
  std::string name;             // of the patch, such as part3_cosine_in_brdf
  bool wrong = false;           // the grader must find it; else the grader must accept it
  std::string what;             // the mistake, or what is different
  int part = 0;                 // whose file is changed
  std::string function;         // whose check must find the mistake, as in the contract
  std::string check;            // that must find it, such as 3.1/value; may be empty
  std::string lessEfficient;    // why it is so on purpose; empty: as efficient as the solutions
  std::filesystem::path patch;  // the file
};

// Throws std::runtime_error with a sentence if the head is not as it must be.
Variant readVariant(const std::filesystem::path& patch);
Variant readMistake(const std::filesystem::path& patch);

// The wrong ones first, each kind in the order of the names. Each wrong one names its check.
std::vector<Variant> allVariants();

// Copies the coursework files of solutions/ into `folder`, which is made if it is not there, and
// applies the patch. Throws std::runtime_error if its lines are not found exactly as they are, or
// std::system_error if the program `patch` cannot be run.
void applyVariant(const Variant& variant, const std::filesystem::path& folder);
void applyVariants(std::span<const Variant> variants, const std::filesystem::path& folder);

// Applies the patch to what is in `folder`, and throws as applyVariant does.
void addVariant(const Variant& variant, const std::filesystem::path& folder);

}  // namespace pathmark
