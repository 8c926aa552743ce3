// Records that are made up, and what is asked of their marks.
//
//   rightRecord          of a submission in which everything is right
//   picture              one that is off by that much
//   function, part       those of a record
//   fail                 has a check of a function fail
//   marksOf, lineOf      those of a part, and the line that begins like this
//   expectReason         what a line says
//   Marking              a right record and the default rubric
#pragma once

#include "rubric/rubric.h"
#include "worker/contract.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace pathmark::rubric {

using record::CheckRecord;
using record::FunctionRecord;
using record::PartRecord;
using record::PictureRecord;
using record::SubmissionRecord;
using record::Verdict;

inline PictureRecord picture(const std::string& scene, const record::Estimate& bias) {
  PictureRecord picture;
  picture.scene = scene;
  picture.bias = bias;
  picture.efficiency = record::Estimate{1.0, 0.9, 1.1};
  return picture;
}

// Of a submission in which everything is right.
inline SubmissionRecord rightRecord() {
  SubmissionRecord record;
  for (const PartContract& contractPart : parts()) {
    PartRecord part;
    part.part = contractPart.part;
    for (const FunctionContract& function : contract())
      if (function.part == part.part)
        part.functions.push_back(
            {std::string(function.section), std::string(function.name), Verdict::kOk, {}});
    part.pictures.push_back(picture("a room", {0.001, 0.0, 0.003}));
    record.parts.push_back(part);
  }
  record.images.push_back({});
  record.pictures.push_back(picture("a room", {0.001, 0.0, 0.003}));
  record.scenes.push_back({});
  record.scenes.back().file = "scenes/my_scene.json";
  return record;
}

inline FunctionRecord& function(SubmissionRecord& record, const std::string& section) {
  for (PartRecord& part : record.parts)
    for (FunctionRecord& f : part.functions)
      if (f.section == section) return f;
  throw std::runtime_error("no function " + section);
}

inline PartRecord& part(SubmissionRecord& record, int number) {
  return record.parts.at(static_cast<std::size_t>(number));
}

inline void fail(FunctionRecord& f, const std::string& check = "valid",
                 Verdict verdict = Verdict::kWrong) {
  f.verdict = verdict;
  CheckRecord failed;
  failed.id = f.section + "/" + check;
  failed.verdict = verdict;
  f.checks.push_back(failed);
}

inline const PartMarks& marksOf(const Marks& marks, int number) {
  for (const PartMarks& p : marks.parts)
    if (p.part == number) return p;
  throw std::runtime_error("no marks of the part");
}

inline const MarkLine& lineOf(const Marks& marks, const std::string& begin) {
  for (const PartMarks& p : marks.parts)
    for (const MarkLine& line : p.lines)
      if (line.what.starts_with(begin)) return line;
  throw std::runtime_error("no line " + begin);
}

inline void expectReason(const Marks& marks, const std::string& line, const std::string& words) {
  EXPECT_NE(lineOf(marks, line).reason.find(words), std::string::npos)
      << lineOf(marks, line).reason;
}

class Marking : public testing::Test {
 protected:
  Marks mark() const { return markSubmission(record_, rubric_); }
  // Part 3 without efficiency: three functions of 4 points.
  void useSimpleRubric() {
    rubric_ = {};
    rubric_.parts = {{3, 12.0, 0.0, {}, {}}};
    rubric_.step = 0.0;
  }

  Rubric rubric_ = readRubric(defaultRubric());
  SubmissionRecord record_ = rightRecord();
};

}  // namespace pathmark::rubric
