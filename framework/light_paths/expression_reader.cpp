#include "light_paths/expression_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace pathmark {

namespace {

constexpr std::string_view kLetters = "LESD.", kRepeats = "*+?";

bool isOneOf(char c, std::string_view characters) {
  return c != '\0' && characters.find(c) != std::string_view::npos;
}

bool isSpace(char c) { return c == ' ' || c == '\t'; }

// Bytes of other alphabets are not told one by one.
std::string spelled(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x20 && byte < 0x7f ? fmt::format("{}", c) : std::string("this character");
}

}  // namespace

void ExpressionReader::read() {
  if (text_.size() > PathExpression::kLongestText)
    refuse(PathExpression::kLongestText,
           fmt::format("an expression has at most {} characters", PathExpression::kLongestText));
  if (peek() == '\0') refuse(0, "an expression is needed, such as LDE, or L.*E for all light");
  const Part whole = readChoice();
  if (peek() == ')') refuse(at_, "this ) closes no group");
  expression_.first_ = whole.first;
  expression_.last_ = whole.last;
  std::copy_if(text_.begin(), text_.end(), std::back_inserter(expression_.text_),
               [](char c) { return !isSpace(c); });
}

ExpressionReader::Part ExpressionReader::readChoice() {
  Part choice = readSequence();
  while (peek() == '|') {
    ++at_;
    const Part other = readSequence();
    choice.empty = choice.empty || other.empty;
    choice.first |= other.first;
    choice.last |= other.last;
  }
  return choice;
}

ExpressionReader::Part ExpressionReader::readSequence() {
  Part sequence = readRepeated();
  while (peek() != '\0' && !isOneOf(peek(), "|)")) {
    const Part next = readRepeated();
    connect(sequence.last, next.first);
    if (sequence.empty) sequence.first |= next.first;
    sequence.last = next.empty ? sequence.last | next.last : next.last;
    sequence.empty = sequence.empty && next.empty;
  }
  return sequence;
}

ExpressionReader::Part ExpressionReader::readRepeated() {
  Part part = readOne();
  while (isOneOf(peek(), kRepeats)) {
    const char repeat = text_[at_++];
    if (repeat != '?') connect(part.last, part.first);
    if (repeat != '+') part.empty = true;
  }
  return part;
}

ExpressionReader::Part ExpressionReader::readOne() {
  const char c = peek();
  if (isOneOf(c, kLetters)) return readLetter(c);
  if (c == '(') return readGroup();
  if (isOneOf(c, kRepeats))
    refuse(at_, fmt::format("there is nothing before this {} that it could repeat", c));
  if (c == '\0' || c == '|' || c == ')')
    refuse(at_, "something is missing here: a letter, or a group in ( )");
  const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (isOneOf(capital, kLetters))
    refuse(at_, fmt::format("letters are capitals: {} and not {}", capital, c));
  refuse(at_, fmt::format("{} is no part of an expression: it has the letters L, E, S and D, the "
                          "signs . * + ? | and groups in ( )",
                          spelled(c)));
}

ExpressionReader::Part ExpressionReader::readGroup() {
  const std::size_t opened = at_++;
  const Part group = readChoice();
  if (peek() != ')') refuse(opened, "this group is never closed: its ) is missing");
  ++at_;
  return group;
}

ExpressionReader::Part ExpressionReader::readLetter(char symbol) {
  const std::size_t letter = places_.size();
  if (letter == PathExpression::kMostLetters)
    refuse(at_, fmt::format("an expression has at most {} letters", PathExpression::kMostLetters));
  places_.push_back(at_++);
  expression_.symbols_.push_back(symbol);
  const PathExpression::Letters itself = PathExpression::Letters{1} << letter;
  return {false, itself, itself};
}

void ExpressionReader::connect(PathExpression::Letters last, PathExpression::Letters first) {
  for (std::size_t letter = 0; letter < places_.size(); ++letter)
    if ((first >> letter & 1) != 0) expression_.before_[letter] |= last;
}

char ExpressionReader::peek() {
  while (at_ < text_.size() && isSpace(text_[at_])) ++at_;
  return at_ < text_.size() ? text_[at_] : '\0';
}

void ExpressionReader::refuse(std::size_t position, const std::string& what) const {
  throw ExpressionError(position, what);
}

}  // namespace pathmark
