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

Markup passedHtml(const std::vector<const CheckRecord*>& passed) {
  if (passed.empty()) return {};
  Markup list;
  for (const CheckRecord* check : passed) {
    list += markup("<li><code>{}</code> {}{}", check->id, withStop(check->statement),
                   sureness(*check));
    if (!check->remark.empty()) list += markup(" <em>Note: {}</em>", withStop(check->remark));
    list += Markup{"</li>\n"};
  }
  return markup("<details><summary>{} {} passed</summary>\n<ul class=\"passed\">\n{}</ul></details>\n",
                passed.size(), passed.size() == 1 ? "check" : "checks", list);
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
  std::vector<const CheckRecord*> passed, others;
  for (const CheckRecord& check : checks)
    (check.verdict == Verdict::kOk ? passed : others).push_back(&check);
  std::stable_sort(others.begin(), others.end(), [](const CheckRecord* a, const CheckRecord* b) {
    return worseThan(a->verdict, b->verdict);
  });
  Markup html;
  for (const CheckRecord* check : others) html += checkCard(*check);
  html += passedHtml(passed);
  return html;
}

// What is not written has nothing to tell but that.
Markup functionHtml(const FunctionRecord& function) {
  const bool unwritten = function.verdict == Verdict::kNotWritten;
  return markup(
      "<article class=\"function {}\">\n<h4>{} <span class=\"section\">{}</span> <code>{}</code>"
      "</h4>\n{}</article>\n",
      kindOf(function.verdict), verdictChip(function.verdict), function.section, function.name,
      unwritten ? Markup{} : checksHtml(function.checks));
}

}  // namespace pathmark::report
