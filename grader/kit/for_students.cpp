#include "kit/for_students.h"

#include <algorithm>

namespace pathmark::kit {

namespace {

constexpr std::string_view kParagraph = "Instructors", kRemark = "(instructors: ";

// Behind the parenthesis that closes the one at the front; 0 if the paragraph has none.
std::size_t endOfParenthesis(std::string_view text) {
  const std::size_t end = std::min(text.find("\n\n"), text.size());
  int open = 0;
  for (std::size_t k = 0; k < end; ++k) {
    if (text[k] == '(') ++open;
    if (text[k] == ')' && --open == 0) return k + 1;
  }
  return 0;
}

std::string withoutRemarks(std::string_view text) {
  std::string kept;
  while (true) {
    const std::size_t at = text.find(kRemark);
    kept += text.substr(0, at);
    if (at == std::string_view::npos) return kept;
    text.remove_prefix(at);
    const std::size_t end = endOfParenthesis(text);
    // What is not closed is no remark.
    if (end == 0) {
      kept += kRemark;
      text.remove_prefix(kRemark.size());
      continue;
    }
    kept.erase(kept.find_last_not_of(" \n") + 1);
    text.remove_prefix(end);
  }
}

// With the empty lines behind it.
std::string_view takeParagraph(std::string_view& text) {
  std::size_t end = text.find("\n\n");
  end = end == std::string_view::npos ? text.size() : text.find_first_not_of('\n', end);
  const std::string_view paragraph = text.substr(0, end);
  text.remove_prefix(paragraph.size());
  return paragraph;
}

}  // namespace

std::string forStudents(std::string_view markdown) {
  std::string kept;
  while (!markdown.empty()) {
    const std::string_view paragraph = takeParagraph(markdown);
    if (!paragraph.starts_with(kParagraph)) kept += paragraph;
  }
  return withoutRemarks(kept);
}

}  // namespace pathmark::kit
