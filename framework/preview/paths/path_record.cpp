#include "preview/paths/path_record.h"

#include <cmath>
#include <ranges>

namespace pathmark::preview {

namespace {

vec3 vec(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

// Directions that were computed from the same numbers in another way.
bool sameDirection(const Vector& a, const Vector& b) {
  constexpr float kNear = 1e-4f;
  return dot(a - b, a - b) < kNear * kNear;
}

// Makes one path of its events.
class PathReader {
 public:
  void take(const PathEvent& e) {
    switch (e.kind) {
      case PathEventKind::kPath:
        path_.camera = {vec(e.a), vec(e.b)};
        break;
      case PathEventKind::kRadiance:
        path_.radiance = vec(e.a);
        path_.dropped = e.integer;
        break;
      case PathEventKind::kDirectBegin:
        direct_ = vertexAt(vec(e.a));
        break;
      case PathEventKind::kDirectEnd:
        if (direct_ != nullptr) direct_->direct = vec(e.a);
        direct_ = nullptr;
        break;
      default:
        direct_ != nullptr ? takeOfLight(*direct_, e) : takeOnPath(e);
    }
  }

  TracedPath finish() { return std::move(path_); }

 private:
  PathVertex* last() { return path_.vertices.empty() ? nullptr : &path_.vertices.back(); }

  // The newest vertex there, which is the last but in unusual coursework.
  PathVertex* vertexAt(const Point& p) {
    for (PathVertex& vertex : path_.vertices | std::views::reverse)
      if (vertex.p == p) return &vertex;
    return last();
  }

  // Of light that is sought for the vertex, by directLighting or by the path itself as in part 8.
  static void takeOfLight(PathVertex& vertex, const PathEvent& e) {
    std::vector<ShadowRay>& rays = vertex.shadowRays;
    if (e.kind == PathEventKind::kLightSample) {
      rays.push_back({vec(e.a), vec(e.b), e.x, vec(e.c)});
    } else if (e.kind == PathEventKind::kShadowRay) {
      for (ShadowRay& ray : rays)
        if (ray.to == vec(e.b)) {
          ray.visibility = e.flag != 0      ? Visibility::kVisible
                           : e.integer != 0 ? Visibility::kLeftOut
                                            : Visibility::kBlocked;
          ray.blocker = vec(e.c);
        }
    } else if (e.kind == PathEventKind::kBrdf || e.kind == PathEventKind::kPdf) {
      for (ShadowRay& ray : rays) {
        if (!sameDirection(normalize(ray.to - vertex.p), vec(e.b))) continue;
        if (e.kind == PathEventKind::kBrdf)
          ray.f = vec(e.c);
        else
          ray.brdfPdf = e.x;
      }
    }
  }

  void takeOnPath(const PathEvent& e) {
    PathVertex* vertex = last();
    if (e.kind == PathEventKind::kHit) {
      path_.vertices.push_back({vec(e.d), vec(e.a), vec(e.b), vec(e.c), e.integer});
      path_.escape.reset();
      path_.leftOut = false;
    } else if (e.kind == PathEventKind::kMiss) {
      path_.leftOut = e.flag != 0;
      if (!path_.leftOut) path_.escape = Ray{vec(e.a), vec(e.b)};
    } else if (vertex == nullptr) {
      return;
    } else if (e.kind == PathEventKind::kReflection) {
      vertex->next = Scattering{vec(e.b), e.x, dot(vec(e.b), vertex->n)};
    } else if (e.kind == PathEventKind::kRoulette) {
      vertex->roulette = RouletteCall{vec(e.a), e.integer, e.x, e.flag != 0, e.y};
    } else if (e.kind == PathEventKind::kLightPdf) {
      if (vec(e.b) == vertex->p) vertex->lightPdf = e.x;
    } else if (e.kind == PathEventKind::kBrdf && vertex->next &&
               sameDirection(vertex->next->wi, vec(e.b))) {
      vertex->next->f = vec(e.c);
    } else {
      takeOfLight(*vertex, e);
    }
  }

  TracedPath path_;
  PathVertex* direct_ = nullptr;  // whose direct light is being found
};

}  // namespace

std::vector<TracedPath> readPaths(std::span<const PathEvent> events) {
  std::vector<TracedPath> paths;
  PathReader reader;
  for (const PathEvent& event : events) {
    reader.take(event);
    if (event.kind != PathEventKind::kRadiance) continue;
    paths.push_back(reader.finish());
    paths.back().number = static_cast<int>(paths.size()) - 1;
    reader = {};
  }
  return paths;
}

bool faceEachOther(const PathVertex& vertex, const ShadowRay& ray) {
  const Vector way = ray.to - vertex.p;
  return dot(vertex.n, way) > 0.0f && dot(ray.n, way) < 0.0f;
}

bool isFinite(const vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double luminance(const Colour& c) {
  return 0.2126 * static_cast<double>(c.r) + 0.7152 * static_cast<double>(c.g) +
         0.0722 * static_cast<double>(c.b);
}

}  // namespace pathmark::preview
