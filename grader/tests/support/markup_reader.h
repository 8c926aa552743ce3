// A strict reader of XML and HTML, for tests of reports: stricter than browsers, which mend
// everything.
//
//   readXml     throws MarkupError unless the text is a well-formed document of XML 1.0
//   readHtml    the same for our pages: lower-case tags that are all closed but for void ones,
//               attributes in double quotes, no comments; style and script hold raw text
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark::test {

class MarkupError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct MarkupElement {
  std::string name;
  std::map<std::string, std::string> attributes;  // as written, entities and all
  std::string text;                               // directly inside, as written
};

// In the order in which they begin.
std::vector<MarkupElement> readXml(std::string_view text);
std::vector<MarkupElement> readHtml(std::string_view text);

}  // namespace pathmark::test
