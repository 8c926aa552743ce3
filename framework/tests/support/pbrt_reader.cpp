#include "support/pbrt_reader.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <stdexcept>

namespace pathmark::test {

namespace {

// How many bare numbers and quoted words each directive has.
struct Rule {
  std::size_t numbers, words;
  bool parameters;
  enum Where { kOptions, kWorld, kBoth } where;
};
const std::map<std::string, Rule> kRules{{"Scale", {3, 0, false, Rule::kBoth}},
                                         {"Translate", {3, 0, false, Rule::kBoth}},
                                         {"LookAt", {9, 0, false, Rule::kBoth}},
                                         {"Camera", {0, 1, true, Rule::kOptions}},
                                         {"Film", {0, 1, true, Rule::kOptions}},
                                         {"PixelFilter", {0, 1, true, Rule::kOptions}},
                                         {"Sampler", {0, 1, true, Rule::kOptions}},
                                         {"Integrator", {0, 1, true, Rule::kOptions}},
                                         {"WorldBegin", {0, 0, false, Rule::kBoth}},
                                         {"AttributeBegin", {0, 0, false, Rule::kWorld}},
                                         {"AttributeEnd", {0, 0, false, Rule::kWorld}},
                                         {"MakeNamedMaterial", {0, 1, true, Rule::kWorld}},
                                         {"NamedMaterial", {0, 1, false, Rule::kWorld}},
                                         {"AreaLightSource", {0, 1, true, Rule::kWorld}},
                                         {"ReverseOrientation", {0, 0, false, Rule::kBoth}},
                                         {"Shape", {0, 1, true, Rule::kWorld}}};
const std::set<std::string> kNumberTypes{"float", "integer", "rgb", "point3"};

std::vector<std::string> tokensOf(const std::string& text) {
  std::vector<std::string> tokens;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    std::size_t end = at + 1;
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
    } else if (c == ' ' || c == '\n') {
      ++at;
    } else {
      if (c == '"') {
        end = text.find('"', at + 1) + 1;
        if (end == 0) throw std::runtime_error("a quotation without an end");
      } else if (c != '[' && c != ']') {
        end = std::min(text.find_first_of(" \n[]\"#", at), text.size());
      }
      tokens.push_back(text.substr(at, end - at));
      at = end;
    }
  }
  return tokens;
}

bool isNumber(const std::string& token, double& value) {
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  return error == std::errc{} && end == token.data() + token.size();
}

class Reader {
 public:
  explicit Reader(const std::string& text) : tokens_(tokensOf(text)) {}

  std::vector<PbrtStatement> read() {
    std::vector<PbrtStatement> all;
    while (at_ < tokens_.size()) all.push_back(statement());
    if (!inWorld_) fail("there is no WorldBegin");
    if (depth_ != 0) fail("an AttributeBegin has no end");
    return all;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error(why + ", at token " + std::to_string(at_));
  }
  const std::string& peek() const {
    static const std::string kEnd;
    return at_ < tokens_.size() ? tokens_[at_] : kEnd;
  }
  bool isQuoted() const { return peek().starts_with('"'); }
  std::string unquoted() {
    const std::string& token = tokens_[at_++];
    return token.substr(1, token.size() - 2);
  }

  PbrtStatement statement() {
    PbrtStatement s{tokens_[at_++], {}, {}, {}};
    const auto rule = kRules.find(s.directive);
    if (rule == kRules.end()) fail("no directive: " + s.directive);
    follow(s.directive, rule->second);
    double number = 0.0;
    while (isNumber(peek(), number)) {
      s.bare.push_back(number);
      ++at_;
    }
    while (isQuoted() && s.words.size() < rule->second.words) s.words.push_back(unquoted());
    if (s.bare.size() != rule->second.numbers || s.words.size() != rule->second.words)
      fail("too few or many values of " + s.directive);
    while (isQuoted()) parameter(s);
    if (!s.parameters.empty() && !rule->second.parameters) fail("parameters of " + s.directive);
    return s;
  }

  void follow(const std::string& directive, const Rule& rule) {
    if (rule.where != Rule::kBoth && (rule.where == Rule::kWorld) != inWorld_)
      fail(directive + " on the wrong side of WorldBegin");
    if (directive == "WorldBegin") inWorld_ = true;
    if (directive == "AttributeBegin") ++depth_;
    if (directive == "AttributeEnd" && --depth_ < 0) fail("an AttributeEnd too many");
  }

  void parameter(PbrtStatement& s) {
    const std::string declared = unquoted();
    const std::size_t space = declared.find(' ');
    if (space == std::string::npos) fail("no \"type name\": " + declared);
    PbrtParameter p{declared.substr(0, space), {}, {}};
    const bool list = peek() == "[";
    if (list) ++at_;
    do value(p);
    while (list && peek() != "]");
    if (list) ++at_;
    if (!s.parameters.emplace(declared.substr(space + 1), std::move(p)).second)
      fail("twice: " + declared);
  }

  void value(PbrtParameter& p) {
    double number = 0.0;
    if (kNumberTypes.contains(p.type) && isNumber(peek(), number)) {
      p.numbers.push_back(number);
      ++at_;
    } else if (p.type == "string" && isQuoted()) {
      p.texts.push_back(unquoted());
    } else if (p.type == "bool" && (peek() == "true" || peek() == "false")) {
      p.texts.push_back(tokens_[at_++]);
    } else {
      fail("no value of type " + p.type + ": " + peek());
    }
  }

  std::vector<std::string> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool inWorld_ = false;
};

}  // namespace

std::vector<PbrtStatement> readPbrt(const std::string& text) { return Reader(text).read(); }

}  // namespace pathmark::test
