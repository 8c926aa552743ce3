// Texts that want to be more than text: out of HTML, XML, attributes, scripts, spreadsheets and
// terminals.
#pragma once

#include "record/record.h"
#include "rubric/marks.h"

#include <string>

namespace pathmark::test {

// Markup, quotes, ends of script and CDATA, escape sequences, control characters, bytes that are no
// UTF-8, a direction of writing, braces of format strings. `mark` tells one from another.
std::string hostileText(const std::string& mark);

// Every text of the record and of the marks that is not empty gets a hostile end, of its own; only
// words that stand for something, such as verdicts, stay as they are.
record::SubmissionRecord withHostileTexts(const record::SubmissionRecord& record);
rubric::Marks withHostileTexts(rubric::Marks marks);

}  // namespace pathmark::test
