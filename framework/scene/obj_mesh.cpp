#include "scene/obj_mesh.h"

#include "scene/load_scene.h"
#include "scene/obj_words.h"
#include "scene/polygon.h"
#include "scene/read_text.h"
#include "scene/syntax_sentence.h"
#include "scene/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace pathmark {
namespace {

constexpr std::size_t kMostCorners = 1000;

// Statements of the format that do not change the shape of a mesh.
constexpr std::array<std::string_view, 15> kSkipped{"vt",     "vn",     "vp",  "g",     "o",
                                                    "s",      "mg",     "l",   "p",     "usemtl",
                                                    "mtllib", "usemap", "lod", "bevel", "maplib"};

class ObjReader {
 public:
  explicit ObjReader(const std::filesystem::path& file) : file_(file) {}

  // The next statements of the file, all of them whole.
  void read(std::string_view text) {
    const bool first = line_ == 1;
    if (first) refuseOldLineEnds(text);
    for (std::size_t position = first ? bytesOfMark(text) : 0; position < text.size();) {
      statementLine_ = line_;
      ObjWords words(text, position, line_);
      readStatement(words);
      words.finish();
    }
  }

  Mesh finish() {
    if (mesh_.triangles.empty()) {
      throw SceneError(fmt::format("{}: found no face, but a mesh has lines such as \"f 1 2 3\".",
                                   file_.string()));
    }
    dropUnusedVertices();
    return std::move(mesh_);
  }

 private:
  // Of UTF-8, which some editors put before the first line.
  static std::size_t bytesOfMark(std::string_view text) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    return text.starts_with(kMark) ? kMark.size() : 0;
  }

  // Those of the first Macs, without which all lines would be one.
  void refuseOldLineEnds(std::string_view text) const {
    if (text.find('\n') == text.npos && text.find('\r') < text.size() - 1)
      refuse("lines that end in a carriage return", "those of a mesh end in a line feed");
  }

  [[noreturn]] void refuse(const std::string& found, const std::string& rule) const {
    throw SceneError(
        fmt::format("{}:{}: found {}, but {}.", file_.string(), statementLine_, found, rule));
  }

  void readStatement(ObjWords& words) {
    const std::string_view kind = words.next();
    if (kind.empty()) return;
    if (kind == "v") {
      readVertex(words);
    } else if (kind == "f") {
      readFace(words);
    } else if (std::find(kSkipped.begin(), kSkipped.end(), kind) == kSkipped.end()) {
      refuse(inQuotes(kind),
             "a line of a mesh begins with v, f, or one of vt, vn, g, o, s, usemtl, "
             "mtllib, which are skipped");
    }
  }

  double number(std::string_view word) const {
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    // Too small or too large; the C library tells which.
    if (error == std::errc::result_out_of_range) {
      value = std::strtod(std::string(digits).c_str(), nullptr);
    } else if (error != std::errc{}) {
      refuse(inQuotes(word), "a coordinate is a number");
    }
    if (end != digits.data() + digits.size()) refuse(inQuotes(word), "a coordinate is a number");
    if (!(std::abs(value) <= kLargestCoordinate)) {
      refuse(inQuotes(word), fmt::format("a coordinate must be from {} to {}", -kLargestCoordinate,
                                         kLargestCoordinate));
    }
    return value;
  }

  // x y z, then perhaps a weight, a colour, or both, which are read and not used.
  void readVertex(ObjWords& words) {
    std::array<double, 7> values{};
    std::size_t count = 0;
    for (;; ++count) {
      if (count < values.size() && words.nextDecimal(values[count])) continue;
      const std::string_view word = words.next();
      if (word.empty()) break;
      if (count == values.size()) refuse("more than 7 numbers", "a vertex has three coordinates");
      values[count] = number(word);
    }
    if (count < 3 || count == 5) {
      refuse(fmt::format("{} {}", count, count == 1 ? "number" : "numbers"),
             "a vertex has three coordinates, as in \"v 0.5 1 -2\"");
    }
    mesh_.vertices.emplace_back(values[0], values[1], values[2]);
  }

  // The vertex of "7", "7/1", "7//3" or "7/1/3"; negative numbers count back from the last one.
  std::uint32_t vertexIndex(std::string_view word) const {
    std::int64_t number = 0;
    const char *at = word.data(), *last = word.data() + word.size();
    const auto [end, error] = std::from_chars(at, last, number);
    const bool whole = error == std::errc{} && (end == last || *end == '/');
    if (error != std::errc::result_out_of_range && !whole) {
      refuse(inQuotes(word), "a face is a list of vertex numbers, as in \"f 1 2 3\"");
    }
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    const std::int64_t index = number > 0 ? number - 1 : count + number;
    if (!whole || number == 0 || index < 0 || index >= count) {
      refuse("the vertex " + inQuotes(word),
             fmt::format("{} vertices stand above this line, and they count from 1", count));
    }
    return static_cast<std::uint32_t>(index);
  }

  void readFace(ObjWords& words) {
    corners_.clear();
    const auto count = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (std::uint32_t number = 0;;) {
      if (corners_.size() < kMostCorners && words.nextIndex(count, number)) {
        corners_.push_back(number - 1);
        continue;
      }
      const std::string_view word = words.next();
      if (word.empty()) break;
      if (corners_.size() == kMostCorners) {
        refuse("a face of more vertices", fmt::format("a face may have at most {}", kMostCorners));
      }
      corners_.push_back(vertexIndex(word));
    }
    if (corners_.size() < 3) {
      refuse(fmt::format("a face of {} {}", corners_.size(),
                         corners_.size() == 1 ? "vertex" : "vertices"),
             "a face must have at least 3");
    }
    if (corners_.size() == 3) {
      mesh_.triangles.push_back({corners_[0], corners_[1], corners_[2]});
    } else {
      cutFace();
    }
  }

  // Not every face that programs write is planar: it is cut as it looks along its mean normal.
  void cutFace() {
    std::vector<glm::dvec3> points;
    points.reserve(corners_.size());
    for (const std::uint32_t c : corners_) points.push_back(mesh_.vertices[c]);
    // From the first vertex and in units of the face, so that no product is too large or too small.
    const double size = diameter(points);
    const glm::dvec3 first = points[0];
    for (glm::dvec3& p : points) p = size > 0.0 ? (p - first) / size : glm::dvec3(0.0);
    const glm::dvec3 normal = newellVector(points);
    const bool flat = glm::length(normal) <= kFlatArea;
    const auto cut = flat ? std::nullopt : triangulate(project(points, normal));
    if (cut) {
      for (const TriangleIndices& t : *cut) {
        mesh_.triangles.push_back({corners_[t[0]], corners_[t[1]], corners_[t[2]]});
      }
    } else if (flat || corners_.size() == 4) {
      for (std::size_t i = 2; i < corners_.size(); ++i) {
        mesh_.triangles.push_back({corners_[0], corners_[i - 1], corners_[i]});
      }
    } else {
      refuse(fmt::format("a face of {} vertices that crosses or touches itself", corners_.size()),
             "it must be simple enough to be cut into triangles");
    }
  }

  void dropUnusedVertices() {
    constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> index(mesh_.vertices.size(), kUnused);
    for (const TriangleIndices& t : mesh_.triangles) {
      for (const std::uint32_t v : t) index[v] = 0;
    }
    if (std::find(index.begin(), index.end(), kUnused) == index.end()) return;
    std::uint32_t used = 0;
    for (std::size_t i = 0; i < index.size(); ++i) {
      if (index[i] == kUnused) continue;
      mesh_.vertices[used] = mesh_.vertices[i];
      index[i] = used++;
    }
    mesh_.vertices.resize(used);
    for (TriangleIndices& t : mesh_.triangles) {
      for (std::uint32_t& v : t) v = index[v];
    }
  }

  const std::filesystem::path& file_;
  std::size_t line_ = 1, statementLine_ = 1;
  Mesh mesh_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

Mesh readObj(const SceneSource& source) {
  ObjReader reader(source.file);
  reader.read(source.text);
  return reader.finish();
}

Mesh readObj(const std::filesystem::path& file) {
  ObjReader reader(file);
  readTextInPieces(file, "a mesh is an OBJ file", [&](std::string_view text, bool isLast) {
    const std::size_t end = isLast ? text.size() : endOfStatements(text);
    reader.read(text.substr(0, end));
    return end;
  });
  return reader.finish();
}

}  // namespace pathmark
