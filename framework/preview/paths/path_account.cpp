#include "preview/paths/path_account.h"

#include "preview/paths/path_remarks.h"

#include <algorithm>
#include <cmath>

namespace pathmark::preview {

namespace {

// Sums and products of floats, done in another order. A cosine of unit vectors has an absolute
// error, which is much of a small one.
double toleranceFor(double cosine) {
  constexpr double kRounding = 1e-4, kOfCosine = 1e-6;
  return kRounding + kOfCosine / std::max(std::abs(cosine), 1e-6);
}

// Numbers that near to 0 may have been flushed to it.
constexpr double kNothing = 1e-30;

bool near(const Colour& a, const Colour& b, double tolerance, const Colour& scale = Colour(0.0f)) {
  for (int c = 0; c < 3; ++c) {
    const double x = a[c], y = b[c];
    const double size =
        std::max({std::abs(x), std::abs(y), std::abs(static_cast<double>(scale[c]))});
    if (!std::isfinite(size) || !(std::abs(x - y) <= tolerance * size + kNothing)) return false;
  }
  return true;
}

// Le f G V / pdf, per unit area; 0 where the light cannot be seen.
Colour contributionOf(const ShadowRay& ray, const PathVertex& vertex) {
  const Vector way = ray.to - vertex.p;
  const float distance2 = dot(way, way);
  if (ray.pdf == 0.0f || ray.visibility == Visibility::kBlocked ||
      ray.visibility == Visibility::kLeftOut || !ray.f || !faceEachOther(vertex, ray))
    return Colour(0.0f);
  const Vector wi = way / std::sqrt(distance2);
  const float cosX = dot(vertex.n, wi), cosY = -dot(ray.n, wi);
  return ray.emission * *ray.f * (cosX * cosY / (distance2 * ray.pdf));
}

// Light comes from there, and how much of it is reflected has not been asked.
bool unknown(const ShadowRay& ray) { return ray.visibility == Visibility::kVisible && !ray.f; }

double smallestCosine(const PathVertex& vertex) {
  double smallest = 1.0;
  for (const ShadowRay& ray : vertex.shadowRays) {
    const Vector wi = normalize(ray.to - vertex.p);
    for (const float cosine : {dot(vertex.n, wi), -dot(ray.n, wi)})
      if (cosine > 0.0f) smallest = std::min(smallest, static_cast<double>(cosine));
  }
  return smallest;
}

// The weight of a sample that was drawn with density a, where the other technique has density b. No
// square of a float is too large for a double.
double powerHeuristic(double a, double b) {
  if (a == b) return a == 0.0 ? 0.0 : 0.5;
  return std::isinf(a) ? 1.0 : a * a / (a * a + b * b);
}

// Of a density per unit area at a point with normal n, as seen from `from`; 0 from behind.
double perSolidAngle(float perArea, const Point& from, const Point& to, const Vector& n) {
  const glm::dvec3 back = glm::dvec3(from) - glm::dvec3(to);
  const double distance = glm::length(back), cosine = glm::dot(glm::dvec3(n), back) / distance;
  return cosine > 0.0 ? static_cast<double>(perArea) * distance * distance / cosine : 0.0;
}

class Accountant {
 public:
  Accountant(const TracedPath& path, const AccountRules& rules) : path_(path), rules_(rules) {}

  PathAccount make() {
    Colour throughput(1.0f);
    bool own = true;  // the camera's is 1, whatever the coursework says
    for (std::size_t k = 0; k < path_.vertices.size(); ++k) {
      account_.vertices.push_back(rules_.mis ? contributeMis(k, throughput, own)
                                             : contribute(k, throughput, own));
      account_.explained += account_.vertices[k].emission + account_.vertices[k].direct;
      throughput = step(k, throughput, own);
    }
    compareSum();
    return std::move(account_);
  }

 private:
  VertexAccount contribute(std::size_t k, const Colour& throughput, bool own) {
    const PathVertex& vertex = path_.vertices[k];
    VertexAccount account;
    account.throughput = throughput;
    account.own = own;
    if (rules_.warmUp || (k == 0 && vertex.seenFromFront()))
      account.emission = throughput * vertex.emission;
    if (vertex.direct) account.direct = throughput * *vertex.direct;
    Colour sum(0.0f);
    for (const ShadowRay& ray : vertex.shadowRays) {
      account.shadowRays.push_back(contributionOf(ray, vertex));
      sum += account.shadowRays.back();
    }
    // One of many lights has been chosen with a probability that nobody but the coursework knows.
    const bool all = !vertex.shadowRays.empty() && vertex.shadowRays.size() == rules_.lights &&
                     std::none_of(vertex.shadowRays.begin(), vertex.shadowRays.end(),
                                  [](const ShadowRay& ray) { return unknown(ray); });
    if (vertex.direct && all && !near(*vertex.direct, sum, toleranceFor(smallestCosine(vertex)))) {
      account.directFits = false;
      account_.remarks.push_back(directRemark(k, *vertex.direct, sum));
    }
    return account;
  }

  VertexAccount contributeMis(std::size_t k, const Colour& throughput, bool own) {
    const PathVertex& vertex = path_.vertices[k];
    VertexAccount account;
    account.throughput = throughput;
    account.own = own;
    if (vertex.seenFromFront() && vertex.emission != Colour(0.0f)) {
      account.emissionWeight = emissionWeight(k);
      if (account.emissionWeight)
        account.emission =
            throughput * vertex.emission * static_cast<float>(*account.emissionWeight);
      else
        account_.known = false;
    }
    Colour sum(0.0f);
    bool all = !vertex.direct;
    for (const ShadowRay& ray : vertex.shadowRays) {
      account.shadowRays.push_back(contributionOf(ray, vertex));
      account.weights.push_back(lightWeight(ray, k));
      const Colour& unweighted = account.shadowRays.back();
      const std::optional<double>& weight = account.weights.back();
      if (weight)
        sum += unweighted * static_cast<float>(*weight);
      else
        all = all && unweighted == Colour(0.0f);
      all = all && !unknown(ray);
    }
    if (!all)
      account_.known = false;
    else if (!vertex.shadowRays.empty())
      account.found = sum;
    if (account.found) account.direct = throughput * sum;
    return account;
  }

  // One of many lights has been chosen with a probability that nobody but the coursework knows.
  bool samplesAllLights(const PathVertex& vertex) const {
    return !vertex.shadowRays.empty() && vertex.shadowRays.size() == rules_.lights;
  }

  std::optional<double> lightWeight(const ShadowRay& ray, std::size_t k) {
    const PathVertex& vertex = path_.vertices[k];
    if (!ray.brdfPdf) {
      if (ray.visibility == Visibility::kVisible && ray.f)
        account_.remarks.push_back(weightRemark(k, "the BRDF's pdf() towards the light sample"));
      return std::nullopt;
    }
    if (!samplesAllLights(vertex)) return std::nullopt;
    return powerHeuristic(perSolidAngle(ray.pdf, vertex.p, ray.to, ray.n),
                          static_cast<double>(*ray.brdfPdf));
  }

  // The camera samples no lights.
  std::optional<double> emissionWeight(std::size_t k) {
    if (k == 0) return 1.0;
    const PathVertex &vertex = path_.vertices[k], &before = path_.vertices[k - 1];
    if (!vertex.lightPdf) {
      account_.remarks.push_back(weightRemark(k, "Light::pdf() for what this vertex emits"));
      return std::nullopt;
    }
    if (!samplesAllLights(before) || !before.next) return std::nullopt;
    return powerHeuristic(static_cast<double>(before.next->pdf),
                          perSolidAngle(*vertex.lightPdf, before.p, vertex.p, vertex.n));
  }

  // The throughput at the next vertex.
  Colour step(std::size_t k, const Colour& throughput, bool& own) {
    const PathVertex& vertex = path_.vertices[k];
    Colour expected = throughput;
    const bool known = vertex.next && vertex.next->f && vertex.next->pdf != 0.0f;
    if (known) expected *= *vertex.next->f * (vertex.next->cosine / vertex.next->pdf);
    own = vertex.roulette.has_value();
    if (!own) return expected;
    const RouletteCall& roulette = *vertex.roulette;
    if (known && !near(roulette.throughput, expected, toleranceFor(vertex.next->cosine))) {
      account_.vertices[k].stepFits = false;
      const float weight =
          k > 0 && path_.vertices[k - 1].roulette ? path_.vertices[k - 1].roulette->weight : 1.0f;
      account_.remarks.push_back(
          stepRemark(k, {throughput, roulette.throughput, expected, *vertex.next, weight}));
    }
    return roulette.survives ? roulette.throughput * roulette.weight : roulette.throughput;
  }

  void compareSum() {
    if (path_.dropped > 0) {
      account_.remarks.push_back(tooLongRemark(path_.dropped));
      return;
    }
    if (!account_.known) return;
    Colour size(0.0f);
    for (const VertexAccount& v : account_.vertices) size += v.emission + v.direct;
    // Weights may come from a density that was computed in another way, of a narrow lobe.
    constexpr double kRounding = 1e-4, kOfWeights = 1e-2;
    account_.fits =
        near(path_.radiance, account_.explained, rules_.mis ? kOfWeights : kRounding, size);
    if (!account_.fits) account_.remarks.push_back(sumRemark(path_, account_));
  }

  const TracedPath& path_;
  const AccountRules& rules_;
  PathAccount account_;
};

}  // namespace

PathAccount accountFor(const TracedPath& path, const AccountRules& rules) {
  return Accountant(path, rules).make();
}

}  // namespace pathmark::preview
