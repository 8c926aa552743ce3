#include "record/record_json.h"

#include "film/atomic_file.h"
#include "host/display_path.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>

namespace pathmark::record {

namespace {

using Json = nlohmann::ordered_json;

// Each structure names its members once, for reading and for writing.
class Writer {
 public:
  explicit Writer(Json& json) : json_(json) {}

  template <class T>
  void operator()(const char* name, const T& value) {
    json_[name] = toValue(value);
  }

  template <class T>
  static Json toValue(const T& value);

 private:
  Json& json_;
};

class Reader {
 public:
  explicit Reader(const Json& json) : json_(json) {}

  template <class T>
  void operator()(const char* name, T& value) {
    fromValue(json_.at(name), value);
  }

  template <class T>
  static void fromValue(const Json& json, T& value);

 private:
  const Json& json_;
};

template <class Visitor, class T>
void visit(Visitor& v, T& e) requires std::same_as<std::remove_const_t<T>, Estimate> {
  v("value", e.value);
  v("low", e.low);
  v("high", e.high);
}

template <class Visitor, class T>
void visit(Visitor& v, T& c) requires std::same_as<std::remove_const_t<T>, CheckRecord> {
  v("check", c.id);
  v("statement", c.statement);
  v("verdict", c.verdict);
  v("where", c.where);
  v("expected", c.expected);
  v("got", c.got);
  v("tolerance", c.tolerance);
  v("cause", c.cause);
  v("evidence", c.evidence);
  v("remark", c.remark);
  v("read", c.read);
  v("repeat", c.repeat);
  v("delta", c.delta);
  v("shown", c.shown);
  v("calls", c.calls);
  v("seconds", c.seconds);
}

template <class Visitor, class T>
void visit(Visitor& v, T& f) requires std::same_as<std::remove_const_t<T>, FunctionRecord> {
  v("section", f.section);
  v("name", f.name);
  v("verdict", f.verdict);
  v("checks", f.checks);
  v("mistake", f.mistake);
  v("what", f.what);
  v("evidence", f.evidence);
}

template <class Visitor, class T>
void visit(Visitor& v,
           T& c) requires std::same_as<std::remove_const_t<T>, PictureRecord::Convergence> {
  v("raysPerPixel", c.raysPerPixel);
  v("yours", c.yours);
  v("solutions", c.solutions);
}

template <class Visitor, class T>
void visit(Visitor& v, T& p) requires std::same_as<std::remove_const_t<T>, PictureRecord> {
  v("scene", p.scene);
  v("yours", p.yours);
  v("reference", p.reference);
  v("difference", p.difference);
  v("scale", p.scale);
  v("width", p.width);
  v("height", p.height);
  v("raysPerPixel", p.raysPerPixel);
  v("bias", p.bias);
  v("meanError", p.meanError);
  v("efficiency", p.efficiency);
  v("cpuSeconds", p.cpuSeconds);
  v("cpuSecondsOfSolutions", p.cpuSecondsOfSolutions);
  v("pValues", p.pValues);
  v("convergence", p.convergence);
  v("invalid", p.invalid);
  v("failure", p.failure);
}

template <class Visitor, class T>
void visit(Visitor& v, T& m) requires std::same_as<std::remove_const_t<T>, MistakePicture> {
  v("mistake", m.mistake);
  v("what", m.what);
  v("scene", m.scene);
  v("yours", m.yours);
  v("reference", m.reference);
  v("picture", m.picture);
  v("bias", m.bias);
  v("apart", m.apart);
}

template <class Visitor, class T>
void visit(Visitor& v, T& p) requires std::same_as<std::remove_const_t<T>, PartRecord> {
  v("part", p.part);
  v("file", p.file);
  v("title", p.title);
  v("verdict", p.verdict);
  v("message", p.message);
  v("functions", p.functions);
  v("pictures", p.pictures);
  v("mistakes", p.mistakes);
}

template <class Visitor, class T>
void visit(Visitor& v, T& h) requires std::same_as<std::remove_const_t<T>, Histogram> {
  v("axis", h.axis);
  v("low", h.low);
  v("high", h.high);
  v("yours", h.yours);
  v("expected", h.expected);
}

template <class Visitor, class T>
void visit(Visitor& v, T& s) requires std::same_as<std::remove_const_t<T>, SampleRecord> {
  v("section", s.section);
  v("name", s.name);
  v("inputs", s.inputs);
  v("domain", s.domain);
  v("yours", s.yours);
  v("histograms", s.histograms);
}

template <class Visitor, class T>
void visit(Visitor& v, T& s) requires std::same_as<std::remove_const_t<T>, SceneRecord> {
  v("file", s.file);
  v("caption", s.caption);
  v("verdict", s.verdict);
  v("message", s.message);
  v("noise", s.noise);
  v("picture", s.picture);
}

template <class Visitor, class T>
void visit(Visitor& v, T& b) requires std::same_as<std::remove_const_t<T>, BuildRecord> {
  v("program", b.program);
  v("compiler", b.compiler);
  v("flags", b.flags);
  v("instructions", b.instructions);
  v("sandbox", b.sandbox);
}

template <class Visitor, class T>
void visit(Visitor& v, T& r) requires std::same_as<std::remove_const_t<T>, SubmissionRecord> {
  v("name", r.name);
  v("source", r.source);
  v("contents", r.contents);
  v("seed", r.seed);
  v("build", r.build);
  v("collecting", r.collecting);
  v("refusedScenes", r.refusedScenes);
  v("parts", r.parts);
  v("images", r.images);
  v("scenes", r.scenes);
  v("pictures", r.pictures);
  v("samples", r.samples);
  v("printed", r.printed);
  v("leftOut", r.leftOut);
  v("failure", r.failure);
  v("outOfTime", r.outOfTime);
  v("seconds", r.seconds);
}

template <class T>
concept Structure = requires(Writer& w, const T& t) {
  visit(w, t);
};

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

template <class T>
struct IsList : std::false_type {};
template <class T>
struct IsList<std::vector<T>> : std::true_type {};
template <class T, std::size_t N>
struct IsList<std::array<T, N>> : std::true_type {};

template <class T>
Json Writer::toValue(const T& value) {
  if constexpr (std::same_as<T, Verdict> || std::same_as<T, SampleDomain>) {
    return std::string(nameOf(value));
  } else if constexpr (Structure<T>) {
    Json json = Json::object();
    Writer writer(json);
    visit(writer, value);
    return json;
  } else if constexpr (IsOptional<T>::value) {
    return value ? toValue(*value) : Json();
  } else if constexpr (IsList<T>::value) {
    Json json = Json::array();
    for (const auto& element : value) json.push_back(toValue(element));
    return json;
  } else {
    return value;
  }
}

template <class T>
void Reader::fromValue(const Json& json, T& value) {
  if constexpr (std::same_as<T, Verdict>) {
    const auto verdict = verdictNamed(json.get<std::string>());
    if (!verdict) throw RecordError(fmt::format("{} is no verdict", json.dump()));
    value = *verdict;
  } else if constexpr (std::same_as<T, SampleDomain>) {
    const auto domain = domainNamed(json.get<std::string>());
    if (!domain) throw RecordError(fmt::format("{} is no domain", json.dump()));
    value = *domain;
  } else if constexpr (Structure<T>) {
    Reader reader(json);
    visit(reader, value);
  } else if constexpr (IsOptional<T>::value) {
    value.reset();
    if (!json.is_null()) fromValue(json, value.emplace());
  } else if constexpr (IsList<T>::value) {
    if constexpr (requires { value.resize(json.size()); })
      value.resize(json.size());
    else if (json.size() != value.size())
      throw RecordError(fmt::format("a list of {} where {} belong", json.size(), value.size()));
    for (std::size_t k = 0; k < value.size(); ++k) fromValue(json.at(k), value[k]);
  } else if constexpr (std::same_as<T, double>) {
    // JSON has no infinity: it is written as null.
    value = json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
  } else {
    value = json.get<T>();
  }
}

}  // namespace

std::string toJson(const SubmissionRecord& record) {
  Json json{{"format", SubmissionRecord::kFormat}};
  json.update(Writer::toValue(record));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

SubmissionRecord recordFromJson(const std::string& text, const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& why) {
    return RecordError(
        fmt::format("{}: this is no record of a submission: {}. Remove it, and the "
                    "submission is graded again.",
                    displayPath(file), why));
  };
  try {
    const Json json = Json::parse(text);
    if (!json.is_object() || !json.contains("format")) throw refuse("it does not say its format");
    if (json["format"] != SubmissionRecord::kFormat)
      throw refuse(fmt::format("its format is {}, and {} is known", json["format"].dump(),
                               SubmissionRecord::kFormat));
    SubmissionRecord record;
    Reader::fromValue(json, record);
    return record;
  } catch (const Json::exception& e) {
    throw refuse(e.what());
  }
}

void writeRecord(const SubmissionRecord& record, const std::filesystem::path& file) {
  writeFileAtomically(file, toJson(record));
}

SubmissionRecord readRecord(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw RecordError(fmt::format("{} cannot be read.", displayPath(file)));
  return recordFromJson(std::string(std::istreambuf_iterator<char>(in), {}), file);
}

}  // namespace pathmark::record
