#include "variants/definitions.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace pathmark {

namespace {

bool isWordPart(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// One line for each #, and words, numbers, literals and single signs for the rest.
std::vector<std::string> tokensOf(std::string_view source) {
  std::vector<std::string> tokens;
  for (std::size_t i = 0; i < source.size();) {
    const char c = source[i];
    std::size_t end = i + 1;
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      i = end;
      continue;
    }
    if (source.substr(i, 2) == "//") {
      i = std::min(source.find('\n', i), source.size());
      continue;
    }
    if (source.substr(i, 2) == "/*") {
      i = std::min(source.find("*/", i + 2), source.size() - 2) + 2;
      continue;
    }
    if (c == '#') {
      end = std::min(source.find('\n', i), source.size());
      while (end < source.size() && source[end - 1] == '\\')
        end = std::min(source.find('\n', end + 1), source.size());
    } else if (c == '"' || c == '\'') {
      while (end < source.size() && source[end] != c) end += source[end] == '\\' ? 2 : 1;
      end = std::min(end + 1, source.size());
    } else if (isWordPart(c)) {
      // A digit separator belongs to its number.
      const bool number = std::isdigit(static_cast<unsigned char>(c)) != 0;
      while (end < source.size() && (isWordPart(source[end]) || (number && source[end] == '\'')))
        ++end;
    } else if (source.substr(i, 2) == "::") {
      end = i + 2;
    }
    tokens.emplace_back(source.substr(i, end - i));
    i = end;
  }
  return tokens;
}

bool isWord(const std::string& token) { return isWordPart(token.front()); }

// What has no name of its own that other definitions would have to mention.
bool isNameless(const std::vector<std::string>& tokens) {
  constexpr std::array kinds{"struct", "class",   "enum",     "union",        "template",
                             "using",  "typedef", "operator", "static_assert"};
  return std::any_of(tokens.begin(), tokens.end(), [&](const std::string& token) {
    return token.front() == '#' || std::find(kinds.begin(), kinds.end(), token) != kinds.end();
  });
}

std::string nameIn(const std::vector<std::string>& tokens) {
  const auto end = std::find_if(tokens.begin(), tokens.end(), [](const std::string& t) {
    return t == "(" || t == "{" || t == "=" || t == "[" || t == ";";
  });
  if (end == tokens.begin() || end == tokens.end()) return {};
  if (isNameless({tokens.begin(), end})) return {};
  auto begin = end - 1;
  if (!isWord(*begin)) return {};
  while (begin - tokens.begin() >= 2 && *(begin - 1) == "::" && isWord(*(begin - 2))) begin -= 2;
  std::string name;
  for (auto t = begin; t != end; ++t) name += *t;
  return name;
}

// Gathers the tokens of one definition after the other.
class Cutter {
 public:
  // Returns whether brackets match so far.
  bool take(const std::string& token) {
    if (token.front() == '#') return add({token}), true;
    if (depth_ == 0 && token == "}") {
      --namespaces_;
      return definition_.empty() && namespaces_ >= 0;
    }
    definition_.push_back(token);
    if (token == "{" || token == "(") {
      if (token == "{" && depth_ == 0 && opensNamespace()) {
        ++namespaces_;
        definition_.clear();
        return true;
      }
      ++depth_;
    }
    if (token == "}" || token == ")") --depth_;
    if (depth_ < 0) return false;
    // A semicolon after a body is a definition of nothing.
    if (depth_ == 0 && (token == ";" || token == "}")) finish();
    return true;
  }

  bool closed() const { return depth_ == 0 && namespaces_ == 0 && definition_.empty(); }
  std::vector<Definition> definitions;

 private:
  bool opensNamespace() const {
    return definition_.front() == "namespace" ||
           (definition_.front() == "inline" && definition_.size() > 1 &&
            definition_[1] == "namespace");
  }

  void finish() {
    if (definition_.size() > 1 || definition_.front() != ";") add(definition_);
    definition_.clear();
  }

  void add(const std::vector<std::string>& tokens) {
    Definition made;
    for (const std::string& token : tokens) made.text += (made.text.empty() ? "" : " ") + token;
    made.name = nameIn(tokens);
    definitions.push_back(std::move(made));
  }

  std::vector<std::string> definition_;
  int depth_ = 0, namespaces_ = 0;
};

}  // namespace

std::optional<std::vector<Definition>> definitionsOf(std::string_view source) {
  Cutter cutter;
  for (const std::string& token : tokensOf(source))
    if (!cutter.take(token)) return std::nullopt;
  if (!cutter.closed()) return std::nullopt;
  return std::move(cutter.definitions);
}

bool mentions(const Definition& definition, std::string_view word) {
  const std::string& text = definition.text;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const bool begins = at == 0 || !isWordPart(text[at - 1]);
    const std::size_t end = at + word.size();
    if (begins && (end == text.size() || !isWordPart(text[end]))) return true;
  }
  return false;
}

}  // namespace pathmark
