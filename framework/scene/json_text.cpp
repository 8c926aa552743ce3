#include "scene/json_text.h"

#include "scene/load_scene.h"
#include "scene/place.h"
#include "scene/syntax_sentence.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace pathmark {
namespace {

using nlohmann::json;

// A scene nests six deep; the limit keeps hostile files from costing memory.
constexpr std::size_t kDeepestNesting = 16;

// Reads a text and counts what was read: the JSON library does not tell where it is.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, std::size_t* count) : at_(at), count_(count) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    ++at_;
    ++*count_;
    return *this;
  }
  CountingIterator operator++(int) {
    const CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  std::size_t* count_;
};

// An array or object that is open, and where in it the walk is.
struct Level {
  bool isArray;
  std::size_t index = 0;
  std::string key{};
  std::set<std::string> keys{};
};

// Every value of a text, one after the other. A deriving class is told where each begins.
class Walk : public nlohmann::json_sax<json> {
 public:
  // Returns whether the walk reached the end.
  bool over(std::string_view text) {
    return json::sax_parse(CountingIterator(text.data(), &read_),
                           CountingIterator(text.data() + text.size(), &read_), this,
                           json::input_format_t::json, true, true);
  }

  bool null() override { return passValue(); }
  bool boolean(bool) override { return passValue(); }
  bool number_integer(number_integer_t) override { return passValue(); }
  bool number_unsigned(number_unsigned_t) override { return passValue(); }
  bool number_float(number_float_t, const string_t&) override { return passValue(); }
  bool string(string_t&) override { return passValue(); }
  bool binary(binary_t&) override { return passValue(); }
  bool start_object(std::size_t) override { return open(false); }
  bool start_array(std::size_t) override { return open(true); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    levels_.back().key = name;
    return atKey(levels_.back());
  }

 protected:
  // Whether to go on.
  virtual bool atValue() { return true; }
  virtual bool atBracket() { return true; }
  virtual bool atKey(Level&) { return true; }

  const std::vector<Level>& levels() const { return levels_; }

  // Behind the last character of the value or bracket that was read; behind a number the library
  // has looked one character further.
  std::size_t read() const { return read_; }

 private:
  bool advance() {
    if (!levels_.empty()) ++levels_.back().index;
    return true;
  }
  bool passValue() { return atValue() && advance(); }
  bool open(bool isArray) {
    if (!atValue() || !atBracket()) return false;
    levels_.push_back({isArray});
    return true;
  }
  bool close() {
    levels_.pop_back();
    return advance();
  }

  std::vector<Level> levels_;
  std::size_t read_ = 0;
};

class SyntaxCheck final : public Walk {
 public:
  explicit SyntaxCheck(const SceneSource& source) : source_(source), top_(source) {}

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    throw SceneError(fmt::format("{}:{}", source_.file.string(),
                                 syntaxSentence(source_.text, position, error.what())));
  }

 private:
  bool atBracket() override {
    if (levels().size() == kDeepestNesting) {
      refuseHere(top_, 0,
                 fmt::format("found brackets nested more than {} deep, but a scene needs only six.",
                             kDeepestNesting));
    }
    return true;
  }

  bool atKey(Level& level) override {
    if (!level.keys.insert(level.key).second) {
      refuseHere(top_, 0,
                 fmt::format("the key {} stands twice in one object.", inQuotes(level.key)));
    }
    return true;
  }

  [[noreturn]] void refuseHere(const Place& place, std::size_t level,
                               const std::string& sentence) const {
    if (level == levels().size()) place.refuse(sentence);
    const Level& l = levels()[level];
    refuseHere(l.isArray ? Place(place, l.index) : Place(place, l.key), level + 1, sentence);
  }

  const SceneSource& source_;
  Place top_;
};

std::vector<std::string> tokensOf(std::string_view pointer) {
  std::vector<std::string> tokens;
  for (std::size_t i = 0; i < pointer.size(); ++i) {
    if (pointer[i] == '/') {
      tokens.emplace_back();
    } else if (pointer[i] == '~' && i + 1 < pointer.size()) {
      tokens.back() += pointer[++i] == '1' ? '/' : '~';
    } else {
      tokens.back() += pointer[i];
    }
  }
  return tokens;
}

class LineFinder final : public Walk {
 public:
  explicit LineFinder(std::string_view pointer) : tokens_(tokensOf(pointer)) {}

  // Behind the value, or a character further; 0 until it is found.
  std::size_t end() const { return end_; }

  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  bool atValue() override {
    if (levels().size() != tokens_.size()) return true;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const Level& l = levels()[i];
      if (tokens_[i] != (l.isArray ? std::to_string(l.index) : l.key)) return true;
    }
    end_ = read();
    return false;
  }

  std::vector<std::string> tokens_;
  std::size_t end_ = 0;
};

}  // namespace

void checkSyntax(const SceneSource& source) { SyntaxCheck(source).over(source.text); }

std::size_t lineOf(std::string_view text, std::string_view pointer) {
  LineFinder finder(pointer);
  finder.over(text);
  if (finder.end() == 0) return 0;
  const std::string_view before = text.substr(0, finder.end() - 1);
  return 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
}

}  // namespace pathmark
