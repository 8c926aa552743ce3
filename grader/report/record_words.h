// Words for what is in a record; they are the same in every report.
//
//   whyNoMarks       "was not graded: ..."
//   endOfPath        "bob.zip" of "/home/me/class/bob.zip"
//   submissionName   of the folder or archive that was handed in
//   verdictOfPart    of parts 0 to 7, or of the whole as submitted
//   partName         "part 3", "whole"
//   isFault          whether a verdict says that something is wrong with the coursework
//   isMarked         whether a part counts
//   whatIsWrong      "part 4 does not compile", and the like
//   worstOf          the check that tells most about a function
//   fieldsOf         what to tell of a check, in order
//   functionOf       the function that a line of the marks is about
//   pointsText       "12.5"
//   lineText         "2.5 / 4"
#pragma once

#include "record/record.h"
#include "report/field.h"
#include "rubric/marks.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pathmark::report {

inline constexpr int kScenesPart = 7, kWhole = 10;

// What to say after its name, or after those of several; empty if it has marks.
std::string whyNoMarks(const record::SubmissionRecord& record, bool several = false);

// Nothing of the machine that a path is of.
std::string endOfPath(const std::string& path);

// "Müller, Anna", "Alex Kim.tar.gz"; after its folder's name where the submission has its name from
// there, as learning platforms make a folder for each archive. Empty if it is not known.
std::string submissionName(const record::SubmissionRecord& record);

// The worst of the whole, the best of the scenes: one good scene is enough, and without any the
// part is not written. Nothing if the record does not say.
std::optional<record::Verdict> verdictOfPart(const record::SubmissionRecord& record, int part);

std::string partName(int part);

// Wrong, not compiling, stopped; neither unwritten nor blocked nor an error of the grader.
bool isFault(record::Verdict verdict);

bool isMarked(const rubric::Marks& marks, int part);

// "part 4 does not compile", "parts 2 and 3 wrong", "part 5 missing", of which there is no file,
// "part 6 without a picture", which was stopped or crashed, though the checks found nothing wrong;
// what is only blocked, and what does not count, is left out. After an internal error, or where
// nothing was graded, nothing else is known.
std::vector<std::string> whatIsWrong(const record::SubmissionRecord& record,
                                     const rubric::Marks& marks);

// Null if there are none.
const record::CheckRecord* worstOf(const std::vector<record::CheckRecord>& checks);

// Those that are known: "where", "expected", "got", "tolerance", "likely", "note", "read",
// "repeat".
std::vector<Field> fieldsOf(const record::CheckRecord& check);

// The same as lines of text, the statement first.
std::string textOf(const record::CheckRecord& check);

// By the section at its beginning: "3.3 lambertianBRDF::reflection". Null if there is none.
const record::FunctionRecord* functionOf(const record::SubmissionRecord& record,
                                         const rubric::MarkLine& line);

// At most two places behind the point, and none that are 0.
std::string pointsText(double points);

// Only the points, with their sign, of a line that is out of nothing, such as rounding.
std::string lineText(const rubric::MarkLine& line);

}  // namespace pathmark::report
