#include "bench/report.h"

#include <nlohmann/json.hpp>

namespace pathmark::bench {

namespace {

using Json = nlohmann::ordered_json;

Json cellJson(const Cell& cell) {
  if (cell.isNumber) return cell.number;
  return cell.text.empty() ? Json(nullptr) : Json(cell.text);
}

Json rowJson(const Table& table, const std::vector<Cell>& row) {
  Json json = Json::object();
  for (std::size_t c = 0; c < row.size(); ++c) json[table.columns[c].key] = cellJson(row[c]);
  return json;
}

Json figureJson(const Figure& f) {
  Json json{{"name", f.name}, {"value", f.value}};
  if (f.error > 0.0) json["error"] = f.error;
  if (!f.unit.empty()) json["unit"] = f.unit;
  if (f.target) {
    json["must"] = f.target->must;
    json["aim"] = f.target->aim ? Json(*f.target->aim) : Json(nullptr);
    json["moreIsBetter"] = f.target->moreIsBetter;
    json["verdict"] = f.verdict();
  }
  if (!f.note.empty()) json["note"] = f.note;
  return json;
}

}  // namespace

// Numbers that are not finite become null, which is what JSON has for them.
std::string reportJson(const Report& report) {
  Json json{{"command", report.command}, {"machine", report.machine}};
  json["tables"] = Json::object();
  for (const Table& table : report.tables) {
    Json rows = Json::array();
    for (const auto& row : table.rows) rows.push_back(rowJson(table, row));
    json["tables"][table.key] = std::move(rows);
  }
  json["figures"] = Json::object();
  for (const Figure& f : report.figures) json["figures"][f.key] = figureJson(f);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace pathmark::bench
