// Functions and their checks: what is right in a line, what is wrong on a card.
#pragma once

#include "record/record.h"
#include "report/html_text.h"

namespace pathmark::report {

// A card tells the statement, what was expected, what came, where, the tolerance, the likely cause,
// where to read, and the command that repeats it.
Markup checkCard(const record::CheckRecord& check);

Markup functionHtml(const record::FunctionRecord& function);

// Cards of what is not ok, and a list of the rest.
Markup checksHtml(const std::vector<record::CheckRecord>& checks);

}  // namespace pathmark::report
