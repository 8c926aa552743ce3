// What all pages of reports have in common.
//
//   page            a document that needs nothing from elsewhere
//   verdictChip     a verdict as a sign and a word
//   pngImage        a picture inside of the document
//   term            a row of a list of terms
#pragma once

#include "record/record.h"
#include "report/html_text.h"

#include <string>
#include <string_view>

namespace pathmark::report {

// A script of the project, with the hash that lets it run.
struct Script {
  std::string_view text, sha256;
};

// With a content security policy: nothing is loaded, no script and no style works but those of the
// project, whatever a submission may have smuggled in.
std::string page(std::string_view title, const Markup& body, const Script& script);

// Good, doubtful, nothing, bad or an error: the class of report.css that a verdict has.
std::string_view kindOf(record::Verdict verdict);

Markup verdictChip(record::Verdict verdict);

// Nothing if the bytes are no PNG.
Markup pngImage(std::string_view png, std::string_view alt);

// A row of a list of terms and what they stand for; nothing if there is no text.
Markup term(std::string_view name, std::string_view text);

}  // namespace pathmark::report
