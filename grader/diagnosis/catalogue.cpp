#include "diagnosis/catalogue.h"

#include "host/build_config.h"
#include "host/content_hash.h"
#include "host/display_path.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace pathmark::diagnosis {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// As few digits as a comparison needs.
Json value(double x) {
  return std::isfinite(x) ? Json(std::strtod(fmt::format("{:.7g}", x).c_str(), nullptr)) : Json();
}
Json error(double x) { return Json(std::strtod(fmt::format("{:.2g}", x).c_str(), nullptr)); }
double number(const Json& json) { return json.is_number() ? json.get<double>() : kNan; }

// Of a mistake only what differs from what is right.
Json differences(const KnownSignature& known, const KnownSignature& right) {
  Json all = Json::array();
  for (std::size_t k = 0; k < right.values.size(); ++k) {
    const Json v = value(known.values[k]), e = error(known.errors[k]);
    if (v != value(right.values[k]) || e != error(right.errors[k])) all.push_back({k, v, e});
  }
  return all;
}

Json rightValues(const KnownSignature& right) {
  Json all = Json::array();
  for (std::size_t k = 0; k < right.values.size(); ++k)
    all.push_back({value(right.values[k]), error(right.errors[k])});
  return all;
}

KnownSignature readKnown(const Json& json, const KnownSignature& right) {
  KnownSignature known{json.at("mistake"), json.at("what"), right.values, right.errors};
  for (const Json& difference : json.at("differs")) {
    const std::size_t k = difference.at(0);
    known.values.at(k) = number(difference.at(1));
    known.errors.at(k) = number(difference.at(2));
  }
  return known;
}

Json knownAsJson(const KnownSignature& known, const KnownSignature& right) {
  return {{"mistake", known.mistake}, {"what", known.what}, {"differs", differences(known, right)}};
}

FunctionCatalogue readFunction(const Json& json) {
  FunctionCatalogue result;
  const std::string name = json.at("function");
  bool found = false;
  for (const FunctionContract& f : contract()) {
    if (f.name != name) continue;
    result.function = f.function;
    found = true;
  }
  if (!found) throw std::runtime_error(name + " is no function of the coursework");
  result.features = json.at("features");
  for (const Json& feature : json.at("right")) {
    result.right.values.push_back(number(feature.at(0)));
    result.right.errors.push_back(number(feature.at(1)));
  }
  if (json.contains("stub")) result.stub = readKnown(json.at("stub"), result.right);
  for (const Json& mistake : json.at("mistakes"))
    result.mistakes.push_back(readKnown(mistake, result.right));
  return result;
}

}  // namespace

const FunctionCatalogue* Catalogue::find(CourseworkFunction function) const {
  for (const FunctionCatalogue& f : functions)
    if (f.function == function) return &f;
  return nullptr;
}

std::string hashOf(const Signature& signature) {
  ContentHasher hasher;
  for (const Feature& feature : signature.features()) hasher.add(feature.what + "\n");
  return hasher.digits();
}

KnownSignature knownSignature(std::string mistake, std::string what, const Signature& signature) {
  KnownSignature known{std::move(mistake), std::move(what), {}, {}};
  for (const Feature& feature : signature.features()) {
    known.values.push_back(feature.value);
    known.errors.push_back(feature.error);
  }
  return known;
}

fs::path catalogueFile() {
  return fs::path(build::kProjectFolder) / "grader/diagnosis/catalogue.json";
}

Catalogue readCatalogue(const fs::path& file) {
  std::ifstream in(file);
  try {
    const Json json = Json::parse(in);
    Catalogue catalogue;
    catalogue.stamp = json.at("stamp");
    for (const Json& f : json.at("functions")) catalogue.functions.push_back(readFunction(f));
    return catalogue;
  } catch (const std::exception& e) {
    throw std::runtime_error(
        fmt::format("{} is no catalogue of mistakes: {}; git checkout brings it back.",
                    displayPath(file), e.what()));
  }
}

// One line for each signature, so that a change shows what it changes.
void writeCatalogue(const Catalogue& catalogue, const fs::path& file) {
  std::string text = fmt::format("{{\"stamp\": \"{}\", \"functions\": [", catalogue.stamp);
  const char* between = "\n";
  for (const FunctionCatalogue& f : catalogue.functions) {
    text +=
        fmt::format("{}{{\"function\": \"{}\", \"features\": \"{}\",\n\"right\": {},\n", between,
                    contractOf(f.function).name, f.features, rightValues(f.right).dump());
    if (f.stub) text += fmt::format("\"stub\": {},\n", knownAsJson(*f.stub, f.right).dump());
    text += "\"mistakes\": [";
    const char* betweenMistakes = "\n";
    for (const KnownSignature& known : f.mistakes) {
      text += betweenMistakes + knownAsJson(known, f.right).dump();
      betweenMistakes = ",\n";
    }
    text += "]}";
    between = ",\n";
  }
  text += "]}\n";
  std::ofstream out(file);
  out << text << std::flush;
  if (!out) throw std::runtime_error(displayPath(file) + " cannot be written.");
}

const Catalogue& shippedCatalogue() {
  static const Catalogue catalogue = [] {
    try {
      return readCatalogue(catalogueFile());
    } catch (const std::runtime_error&) {
      return Catalogue{};
    }
  }();
  return catalogue;
}

}  // namespace pathmark::diagnosis
