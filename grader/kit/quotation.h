// What of a text can be quoted, and where a quotation was found.
//
//   Line          the letters of a line, without what can be changed and still be a quotation
//   linesOf       those of a text, or of any bytes, that are not the same in every file
//   afterPatch    what the lines of a patch become;  beforePatch  what they were
//   Quotation     where a text has what a hidden one has
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pathmark::kit {

struct Line {
  int number = 0;  // from 1
  std::string letters;
};

enum class Comments { kKept, kDropped };

// Leaves out white space, the marks of comments and quotations at the front of lines, those of
// strings, and lines such as those that include or that only close a brace.
std::vector<Line> linesOf(std::string_view text, Comments comments);

// Lines keep their numbers.
std::string afterPatch(std::string_view patch);
std::string beforePatch(std::string_view patch);

struct Quotation {
  int line = 0;  // of the text that was searched
  std::string hiddenFile;
  int hiddenLine = 0;
};

}  // namespace pathmark::kit
