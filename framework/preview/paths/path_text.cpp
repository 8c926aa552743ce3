#include "preview/paths/path_text.h"

#include "preview/paths/path_remarks.h"

#include <fmt/format.h>

namespace pathmark::preview {

namespace {

std::string vectorText(const glm::dvec3& v) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z);
}

// Undoes the scene's normalisation.
glm::dvec3 inFile(const Point& p, const LoadedScene& scene) {
  const Normalisation& n = scene.normalisation;
  return glm::dvec3(p) / n.scale + glm::dvec3(n.shift[0], n.shift[1], n.shift[2]);
}

std::string visibilityText(const PathVertex& vertex, const ShadowRay& ray,
                           const LoadedScene& scene) {
  switch (ray.visibility) {
    case Visibility::kBlocked:
      return fmt::format("blocked at {}", vectorText(inFile(ray.blocker, scene)));
    case Visibility::kVisible:
      return "visible";
    case Visibility::kLeftOut:
      return "left out by the light path expression";
    case Visibility::kNotAsked:
      break;
  }
  return faceEachOther(vertex, ray) ? "visible() not called" : "behind one of the two surfaces";
}

std::string weightText(const std::optional<double>& weight) {
  return weight ? fmt::format(", weight {}", shortNumber(*weight)) : std::string();
}

void describeShadowRay(const PathVertex& vertex, const VertexAccount& account, std::size_t i,
                       const LoadedScene& scene, std::vector<std::string>& lines) {
  const ShadowRay& ray = vertex.shadowRays[i];
  const Colour& contribution = account.shadowRays[i];
  const double scale = scene.normalisation.scale;
  lines.push_back(fmt::format("  light at {}: {}", vectorText(inFile(ray.to, scene)),
                              visibilityText(vertex, ray, scene)));
  std::string numbers =
      fmt::format("  pdf {} per area", shortNumber(static_cast<double>(ray.pdf) * scale * scale));
  if (ray.f) numbers += fmt::format(", f {}", shortColour(*ray.f));
  if (ray.brdfPdf)
    numbers += fmt::format(", BRDF's pdf {}", shortNumber(static_cast<double>(*ray.brdfPdf)));
  lines.push_back(numbers);
  if (contribution != Colour(0.0f))
    lines.push_back(
        fmt::format("  Le f G V / pdf = {}{}", shortColour(contribution),
                    i < account.weights.size() ? weightText(account.weights[i]) : std::string()));
}

void describeDirection(const Scattering& next, std::vector<std::string>& lines) {
  if (next.pdf == 0.0f) {
    lines.emplace_back("no direction: reflection() returned pdf 0");
    return;
  }
  lines.push_back(fmt::format("goes on to {}", vectorText(glm::dvec3(next.wi))));
  lines.push_back(fmt::format("  pdf {}, cos {}{}", shortNumber(static_cast<double>(next.pdf)),
                              shortNumber(static_cast<double>(next.cosine)),
                              next.f ? ", f " + shortColour(*next.f) : std::string()));
  if (next.f)
    lines.push_back(
        fmt::format("  f cos / pdf = {}", shortColour(*next.f * (next.cosine / next.pdf))));
}

std::string rouletteText(const RouletteCall& roulette) {
  return fmt::format(
      "roulette: throughput {}, depth {}, u {}: {}", shortColour(roulette.throughput),
      roulette.depth, shortNumber(static_cast<double>(roulette.u)),
      roulette.survives
          ? fmt::format("survives, weight {}", shortNumber(static_cast<double>(roulette.weight)))
          : "ends");
}

}  // namespace

std::string surfaceName(const PathVertex& vertex, const LoadedScene& scene) {
  if (vertex.emission != Colour(0.0f)) return "light";
  const auto index = static_cast<std::size_t>(vertex.material);
  if (vertex.material < 0 || index >= scene.flat.materials.size()) return "diffuse";
  const bool phong = scene.flat.materials[index].kind == FlatMaterialKind::kPhong;
  return fmt::format("{} {}", phong ? "Phong" : "Lambert", index);
}

std::string endOf(const TracedPath& path) {
  if (path.dropped > 0) return "too long";
  if (path.escape) return "leaves scene";
  if (path.leftOut) return "other paths";
  if (path.vertices.empty()) return "at once";
  const PathVertex& last = path.vertices.back();
  if (last.roulette && !last.roulette->survives) return "roulette";
  if (last.next && last.next->pdf == 0.0f) return "no direction";
  return "last bounce";
}

std::vector<std::string> describeVertex(const TracedPath& path, const PathAccount& account,
                                        std::size_t k, const LoadedScene& scene) {
  const PathVertex& vertex = path.vertices[k];
  const VertexAccount& v = account.vertices[k];
  std::vector<std::string> lines;
  lines.push_back(fmt::format("Vertex {}: {}, seen from the {}", k + 1, surfaceName(vertex, scene),
                              vertex.seenFromFront() ? "front" : "back"));
  lines.push_back(fmt::format("at {}, normal {}", vectorText(inFile(vertex.p, scene)),
                              vectorText(glm::dvec3(vertex.n))));
  lines.push_back(fmt::format("throughput {}{}", shortColour(v.throughput),
                              v.own ? "" : " (f cos / pdf multiplied up)"));
  if (vertex.emission != Colour(0.0f))
    lines.push_back(fmt::format("emits {}, which adds {}{}", shortColour(vertex.emission),
                                shortColour(v.emission), weightText(v.emissionWeight)));
  if (vertex.direct)
    lines.push_back(fmt::format("directLighting returned {}, which adds {}",
                                shortColour(*vertex.direct), shortColour(v.direct)));
  for (std::size_t i = 0; i < vertex.shadowRays.size(); ++i)
    describeShadowRay(vertex, v, i, scene, lines);
  if (vertex.next) describeDirection(*vertex.next, lines);
  if (vertex.roulette) lines.push_back(rouletteText(*vertex.roulette));
  return lines;
}

}  // namespace pathmark::preview
