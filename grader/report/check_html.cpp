#include "report/check_html.h"

#include "report/page_html.h"
#include "report/record_words.h"

#include <algorithm>

namespace pathmark::report {

namespace {

using record::CheckRecord;
using record::FunctionRecord;
using record::Verdict;

// Numbers and commands keep their columns.
bool isCode(std::string_view field) {
  return field == "where" || field == "expected" || field == "got" || field == "repeat";
}

Markup fieldHtml(const Field& field) {
  const char* tag = isCode(field.name) ? "code" : "span";
  return markup("<div class=\"field {}\"><dt>{}</dt><dd><{}>{}</{}></dd></div>\n",
                field.name.substr(0, field.name.find(' ')), field.name, tag, field.value, tag);
}

std::string withStop(std::string text) {
  if (!text.empty() && std::string_view(".!?").find(text.back()) == std::string_view::npos)
    text += '.';
  return text;
}

std::string sureness(const CheckRecord& check) {
  if (check.shown > 0.0)
    return fmt::format(" An error of {:.2g} % would have been found.", 100.0 * check.shown);
  return check.delta > 0.0 ? std::string() : std::string(" Compared value by value.");
}

Markup listOf(const std::vector<const CheckRecord*>& passed) {
  Markup list;
  for (const CheckRecord* check : passed)
    list += markup("<li><code>{}</code> {}{}</li>\n", check->id, withStop(check->statement),
                   sureness(*check));
  return markup("<ul class=\"passed\">\n{}</ul>", list);
}

std::string countOf(std::size_t passed) {
  return fmt::format("{} {} passed", passed, passed == 1 ? "check" : "checks");
}

// What is correct and could be better is told without asking.
Markup notesOf(const std::vector<const CheckRecord*>& passed) {
  Markup notes;
  for (const CheckRecord* check : passed)
    if (!check->remark.empty())
      notes += markup("<p class=\"hint\">Note: {}</p>\n", withStop(check->remark));
  return notes;
}

struct Sorted {
  std::vector<const CheckRecord*> passed, others;  // others: the worst first
};

Sorted sorted(const std::vector<CheckRecord>& checks) {
  Sorted result;
  for (const CheckRecord& check : checks)
    (check.verdict == Verdict::kOk ? result.passed : result.others).push_back(&check);
  std::stable_sort(
      result.others.begin(), result.others.end(),
      [](const CheckRecord* a, const CheckRecord* b) { return worseThan(a->verdict, b->verdict); });
  return result;
}

Markup nameOfFunction(const FunctionRecord& function) {
  return markup("{} <span class=\"section\">{}</span> <code>{}</code>",
                verdictChip(function.verdict), function.section, function.name);
}

}  // namespace

Markup checkCard(const CheckRecord& check) {
  Markup fields;
  for (const Field& field : fieldsOf(check)) fields += fieldHtml(field);
  return markup(
      "<div class=\"card {}\">\n<p class=\"statement\">{} <code>{}</code> {}</p>\n<dl>\n{}</dl>\n"
      "</div>\n",
      kindOf(check.verdict), verdictChip(check.verdict), check.id, withStop(check.statement),
      fields);
}

Markup checksHtml(const std::vector<CheckRecord>& checks) {
  const auto [passed, others] = sorted(checks);
  Markup html;
  for (const CheckRecord* check : others) html += checkCard(*check);
  html += notesOf(passed);
  if (!passed.empty())
    html += markup("<details><summary>{}</summary>\n{}</details>\n", countOf(passed.size()),
                   listOf(passed));
  return html;
}

Markup functionHtml(const FunctionRecord& function) {
  const auto [passed, others] = sorted(function.checks);
  // What is not written has nothing to tell but that; what is right fits into a line.
  const bool unwritten = function.verdict == Verdict::kNotWritten;
  if (!unwritten && others.empty() && !passed.empty())
    return markup(
        "<article class=\"function good\"><details><summary><h4>{}</h4> <span>{}</span></summary>\n"
        "{}</details>\n{}</article>\n",
        nameOfFunction(function), countOf(passed.size()), listOf(passed), notesOf(passed));
  return markup("<article class=\"function {}\">\n<h4>{}</h4>\n{}</article>\n",
                kindOf(function.verdict), nameOfFunction(function),
                unwritten ? Markup{} : checksHtml(function.checks));
}

}  // namespace pathmark::report
