// A C++ file cut into its definitions, without a compiler.
//
//   Definition      one definition or declaration at namespace level
//   definitionsOf   all of a file, in their order
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark {

struct Definition {
  std::string text;  // its words and signs with one space between them; no comments
  // As it is written before its first parenthesis, brace or equals sign: "lambertianBRDF::brdf",
  // "kMostBounces". Empty where it is neither a function nor a constant.
  std::string name;
};

// Nothing if brackets do not match. Namespaces are looked into; a line with # is a definition
// without a name.
std::optional<std::vector<Definition>> definitionsOf(std::string_view source);

// Whether `word` is one of the identifiers in the definition.
bool mentions(const Definition& definition, std::string_view word);

}  // namespace pathmark
