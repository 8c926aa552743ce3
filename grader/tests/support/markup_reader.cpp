#include "support/markup_reader.h"

#include "report/clean_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace pathmark::test {

namespace {

constexpr std::string_view kNames =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-";

class Reader {
 public:
  Reader(std::string_view text, bool html) : rest_(text), html_(html) {
    if (report::cleanText(text) != text) fail("a character that is not allowed");
  }

  std::vector<MarkupElement> read() {
    take(html_ ? "<!DOCTYPE html>" : "<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
    while (!rest_.empty()) {
      readText();
      if (rest_.starts_with("</"))
        readEnd();
      else if (!rest_.empty())
        readBeginning();
    }
    if (!open_.empty()) fail("an element that is not closed: " + elements_[open_.back()].name);
    if (elements_.empty()) fail("no element");
    return std::move(elements_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw MarkupError(fmt::format("{}, before: {}", what, rest_.substr(0, 80)));
  }

  bool startsWith(std::string_view words) const { return rest_.starts_with(words); }

  void take(std::string_view words) {
    if (!startsWith(words)) fail(fmt::format("{} is missing", words));
    rest_.remove_prefix(words.size());
  }

  std::string takeUntil(std::string_view end) {
    const std::size_t at = rest_.find(end);
    if (at == std::string_view::npos) fail(fmt::format("{} is missing", end));
    std::string taken(rest_.substr(0, at));
    rest_.remove_prefix(at);
    return taken;
  }

  std::string takeName() {
    const std::size_t end = std::min(rest_.find_first_not_of(kNames), rest_.size());
    if (end == 0) fail("no name");
    std::string name(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return name;
  }

  // Every ampersand begins one of the entities that both languages know.
  void expectEntities(const std::string& text) const {
    constexpr std::string_view kEntities[] = {"&amp;",  "&lt;",  "&gt;",
                                              "&quot;", "&#39;", "&#8730;"};
    for (std::size_t at = text.find('&'); at != std::string::npos; at = text.find('&', at + 1)) {
      const std::string_view from = std::string_view(text).substr(at);
      if (std::none_of(std::begin(kEntities), std::end(kEntities),
                       [&](std::string_view entity) { return from.starts_with(entity); }))
        fail("an ampersand that is no entity: " + text.substr(at, 20));
    }
  }

  void readText() {
    const std::size_t end = std::min(rest_.find('<'), rest_.size());
    const std::string text(rest_.substr(0, end));
    rest_.remove_prefix(end);
    expectEntities(text);
    if (text.find("]]>") != std::string::npos) fail("the end of a CDATA section in text");
    if (!open_.empty())
      elements_[open_.back()].text += text;
    else if (text.find_first_not_of(" \n") != std::string::npos)
      fail("text outside of all elements: " + text);
  }

  void readBeginning() {
    take("<");
    if (open_.empty() && !elements_.empty()) fail("a second root");
    MarkupElement element{takeName(), {}, {}};
    while (startsWith(" ")) readAttribute(element);
    const bool empty = startsWith("/>");
    take(empty ? "/>" : ">");
    const std::string name = element.name;
    elements_.push_back(std::move(element));
    const bool isVoid = html_ && (name == "meta" || name == "img");
    if (empty || isVoid) return;
    open_.push_back(elements_.size() - 1);
    if (html_ && (name == "style" || name == "script")) elements_.back().text = takeUntil("</");
  }

  void readAttribute(MarkupElement& element) {
    take(" ");
    const std::string name = takeName();
    take("=\"");
    std::string value = takeUntil("\"");
    take("\"");
    expectEntities(value);
    if (value.find('<') != std::string::npos) fail("< in an attribute");
    if (!element.attributes.emplace(name, std::move(value)).second) fail("an attribute twice");
  }

  void readEnd() {
    take("</");
    const std::string name = takeName();
    take(">");
    if (open_.empty() || elements_[open_.back()].name != name) fail("wrong end: " + name);
    open_.pop_back();
  }

  std::string_view rest_;
  bool html_;
  std::vector<MarkupElement> elements_;
  std::vector<std::size_t> open_;
};

}  // namespace

std::vector<MarkupElement> readXml(std::string_view text) { return Reader(text, false).read(); }
std::vector<MarkupElement> readHtml(std::string_view text) { return Reader(text, true).read(); }

}  // namespace pathmark::test
