#include "checks/radiance_checks.h"

#include "checks/channels.h"
#include "checks/exact.h"
#include "checks/pcg2d.h"

#include <fmt/format.h>

#include <algorithm>

namespace pathmark::checks {

namespace {

// Seeds whose first two numbers are evenly spread points: the hash is turned back. Each seed by
// itself is uniform among all, so that whatever else is drawn from it is independent.
class Seeds {
 public:
  Seeds(std::uint64_t seed, std::uint32_t perReplicate)
      : points_(seed, perReplicate), random_(seed) {}

  void start(std::uint32_t replicate) { points_.start(replicate); }
  uvec2 seed(std::uint32_t m) {
    points_.point(m);
    const vec2 u = points_.pair();
    return seedOf({word(u.x), word(u.y)});
  }

 private:
  std::uint32_t word(float u) {
    return (static_cast<std::uint32_t>(u * 0x1p24f) << 8) | (random_.bits() >> 24);
  }

  Points points_;
  Random random_;
};

}  // namespace

EvenRoom::EvenRoom(Random& random, double size_) : size(size_) {
  const DoubleFrame frame{glm::dvec3(random.direction())};
  const glm::dvec3 plain[4] = {{1, 1.1, 0.9}, {1.1, -1, -1}, {-1, 1, -1.2}, {-0.9, -1, 1}};
  for (std::size_t k = 0; k < 4; ++k)
    corners[k] = size * (plain[k].x * frame.u + plain[k].y * frame.n + plain[k].z * frame.v);
  for (std::size_t face = 0; face < 4; ++face)
    mesh.triangle(corner(face, 0), corner(face, 1), corner(face, 2), normal(face), kColour,
                  kEmission);
}

glm::dvec3 EvenRoom::normal(std::size_t face) const {
  const glm::dvec3 a = corner(face, 0);
  const glm::dvec3 n = glm::normalize(glm::cross(corner(face, 1) - a, corner(face, 2) - a));
  return glm::dot(n, corners[face] - a) > 0.0 ? n : -n;
}

Point EvenRoom::pointOn(std::size_t face) const {
  return Point(0.5 * corner(face, 0) + 0.3 * corner(face, 1) + 0.2 * corner(face, 2));
}

Point EvenRoom::inside(Random& random) const {
  glm::dvec3 point(0.0);
  double sum = 0.0;
  for (const glm::dvec3& c : corners) {
    const double weight = 0.2 + random.number();
    point += weight * c;
    sum += weight;
  }
  return Point(point / sum);
}

std::string EvenRoom::where() const {
  return fmt::format(
      "a closed tetrahedron with edges of about {:.2g}, all of colour {} and emission {}",
      2.8 * size, text(kColour), text(kEmission));
}

Finding judgeRadiance(CheckRun& run, const RadianceQuestion& question, const glm::dvec3& expected,
                      const std::vector<SuspectedRadiance>& suspects) {
  constexpr std::uint32_t kMostCalls = 1u << 14;  // of one request
  Seeds seeds(run.seed, question.seedsPerReplicate);
  std::vector<Mean> means;
  for (int c = 0; c < 3; ++c) {
    Mean mean;
    mean.what = inChannel("mean radiance", c);
    mean.expected = mean.scale = expected[c];
    mean.delta = 0.005;
    means.push_back(mean);
  }
  std::vector<Suspicion> suspicions;
  for (const SuspectedRadiance& s : suspects)
    suspicions.push_back({s.mistake, {s.radiance.x, s.radiance.y, s.radiance.z}});
  std::uint64_t made = 0;
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    const std::uint32_t perReplicate = question.seedsPerReplicate,
                        most = std::max(kMostCalls / perReplicate, 1u);
    for (std::uint32_t done = 0; done < count; done += most) {
      const std::uint32_t replicates = std::min(most, count - done);
      Calls calls(question.function, question.mesh);
      for (std::uint32_t r = 0; r < replicates; ++r) {
        seeds.start(first + done + r);
        for (std::uint32_t m = 0; m < perReplicate; ++m) question.add(calls, m, seeds.seed(m));
      }
      const Results results = calls.run(run.worker);
      made += results.count();
      for (std::uint32_t r = 0; r < replicates; ++r) {
        glm::dvec3 sum(0.0);
        for (std::uint32_t m = 0; m < perReplicate; ++m)
          sum += glm::dvec3(results.vector(std::size_t{r} * perReplicate + m, 0));
        for (int c = 0; c < 3; ++c)
          values[(std::size_t{done} + r) * 3 + static_cast<std::size_t>(c)] =
              sum[c] / static_cast<double>(perReplicate);
      }
    }
  };
  // The third look is for those that draw more numbers than are spread evenly.
  Finding finding = judgeMeans(run, means, measure, question.where, suspicions, 3);
  finding.calls = made;
  return finding;
}

Finding judgeAll(CheckRun& run, const std::vector<std::function<Finding(CheckRun&)>>& questions) {
  Finding finding;
  std::uint64_t calls = 0;
  for (const auto& judge : questions) {
    CheckRun own{run.worker, run.seed + calls, run.budget};
    finding = judge(own);
    calls += finding.calls;
    if (!finding.passed()) break;
  }
  finding.calls = calls;
  return finding;
}

}  // namespace pathmark::checks
