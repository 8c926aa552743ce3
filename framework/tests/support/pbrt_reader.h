// A strict reader of pbrt-v4 scene files, after its file format's description: directives, bare
// numbers and quoted words, and parameters "type name" with a value or a list in brackets.
//
//   PbrtStatement   a directive with all that belongs to it
//   readPbrt        throws std::runtime_error where the text is none, AttributeBegin has no end, or
//                   a directive stands on the wrong side of WorldBegin
#pragma once

#include <map>
#include <string>
#include <vector>

namespace pathmark::test {

struct PbrtParameter {
  std::string type;
  std::vector<double> numbers;
  std::vector<std::string> texts;  // of strings, and true or false
};

struct PbrtStatement {
  std::string directive;
  std::vector<double> bare;        // numbers without a name
  std::vector<std::string> words;  // quoted, before the parameters
  std::map<std::string, PbrtParameter> parameters;

  const std::vector<double>& numbers(const std::string& name) const {
    return parameters.at(name).numbers;
  }
  const std::vector<std::string>& texts(const std::string& name) const {
    return parameters.at(name).texts;
  }
};

std::vector<PbrtStatement> readPbrt(const std::string& text);

}  // namespace pathmark::test
