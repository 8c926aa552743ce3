#include "support/hostile.h"

#include "record/record_json.h"

#include <nlohmann/json.hpp>

namespace pathmark::test {

namespace {

// Through JSON, so that no text is forgotten.
void makeHostile(nlohmann::json& json, const std::string& path) {
  if (json.is_object())
    for (auto& [key, value] : json.items()) makeHostile(value, path + "_" + key);
  else if (json.is_array())
    for (nlohmann::json& value : json) makeHostile(value, path);
  if (!json.is_string()) return;
  const std::string text = json.get<std::string>();
  // Some mean something by being there, such as the sentence of an internal error.
  const bool hasMeaning = text.empty() || record::verdictNamed(text) || record::domainNamed(text) ||
                          path.ends_with("_format") || path.ends_with("_seed");
  // Only UTF-8 passes through JSON; U+FFFD stands for the bytes that are none.
  if (!hasMeaning)
    json = text +
           nlohmann::json::parse(nlohmann::json(hostileText(path))
                                     .dump(-1, ' ', true, nlohmann::json::error_handler_t::replace))
               .get<std::string>();
}

}  // namespace

std::string hostileText(const std::string& mark) {
  using namespace std::string_literals;
  return mark +
         "</script></style></pre></svg><img src=x onerror=alert(1)><a href='javascript:x'>"s +
         "\" onmouseover=\"alert(2)\" ' & &lt; ]]> <!-- {} {0} \x1b[31m\x1b]0;title\x07\r\n\b\0\x7f"s +
         "\xff\xc0\xaf\xed\xa0\x80 \xe2\x80\xae \xc2\x9b https://example.org/x.js";
}

record::SubmissionRecord withHostileTexts(const record::SubmissionRecord& record) {
  nlohmann::json json = nlohmann::json::parse(record::toJson(record));
  makeHostile(json, "record");
  record::SubmissionRecord hostile = record::recordFromJson(json.dump(), "hostile.json");
  // What JSON cannot hold, where it is most likely to come from.
  hostile.name += hostileText("name");
  hostile.printed += hostileText("printed");
  for (record::PartRecord& part : hostile.parts) part.message += hostileText("message");
  return hostile;
}

rubric::Marks withHostileTexts(rubric::Marks marks) {
  for (rubric::PartMarks& part : marks.parts) {
    part.title += hostileText("title");
    for (rubric::MarkLine& line : part.lines) {
      line.what += hostileText("what");
      line.reason += hostileText("reason");
    }
  }
  marks.toReview.push_back(hostileText("review"));
  return marks;
}

}  // namespace pathmark::test
