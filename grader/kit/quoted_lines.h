// QuotedLines: does a file have three lines of code that follow one another in a hidden file?
//
// Also where they are short, so that Passages would not call them a quotation.
#pragma once

#include "kit/quotation.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace pathmark::kit {

class QuotedLines {
 public:
  // What may be quoted; to be said before anything is hidden.
  void allow(std::string_view text);
  void hide(const std::string& file, std::string_view text);

  // All quotations of a text, one for each run of lines.
  std::vector<Quotation> find(std::string_view text) const;

 private:
  struct Place {
    std::size_t file = 0;
    int line = 0;
  };

  std::vector<std::string> files_;
  std::unordered_set<std::string> allowed_;
  std::unordered_map<std::string, Place> places_;  // of three lines' letters
};

}  // namespace pathmark::kit
