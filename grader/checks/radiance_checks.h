// Questions about the estimators of part 0, whose random numbers come from a seed.
//
//   MeshWords       triangles and plates as the warm-up gets them
//   EvenRoom        a closed room in which everything looks the same
//   judgeRadiance   the mean radiance over evenly spread seeds
//   judgeAll        several questions, one after the other
#pragma once

#include "checks/calls.h"
#include "checks/means.h"
#include "checks/plates.h"
#include "checks/points.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace pathmark::checks {

class MeshWords {
 public:
  void triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                const glm::dvec3& normal, const Colour& colour, const Colour& emission) {
    words_.add(Point(a), Point(b), Point(c), Vector(normal), colour, emission);
  }
  void plate(const Plate& p) {
    const glm::dvec3 opposite = p.corner + p.v1 + p.v2;
    const Colour colour(p.colour), emission(p.emission);
    triangle(p.corner, p.corner + p.v1, opposite, p.normal, colour, emission);
    triangle(p.corner, p.corner + p.v2, opposite, p.normal, colour, emission);
  }
  const Words& words() const { return words_; }

 private:
  Words words_;
};

// A tetrahedron with its normals inwards, whose faces shine and reflect alike: from everywhere in
// it everything looks the same, and every bounce adds the factor a, exactly.
struct EvenRoom {
  static inline const Colour kColour{0.2f, 0.3f, 0.4f}, kEmission{1.0f, 0.5f, 2.0f};

  double size;
  std::array<glm::dvec3, 4> corners;
  MeshWords mesh;

  EvenRoom(Random& random, double size);

  // Of the face opposite to corner number `face`.
  const glm::dvec3& corner(std::size_t face, std::size_t k) const {
    return corners[(face + 1 + k) % 4];
  }
  glm::dvec3 normal(std::size_t face) const;
  Point pointOn(std::size_t face) const;
  Point inside(Random& random) const;
  std::string where() const;
};

// Adds the m-th call of a replicate, with this seed. What is asked should change with the replicate
// only, not within one: then the seeds are spread evenly over one question.
using AddCall = std::function<void(Calls&, std::uint32_t m, uvec2 seed)>;

struct RadianceQuestion {
  CourseworkFunction function;
  const Words& mesh;
  AddCall add;
  std::string where;
  std::uint32_t seedsPerReplicate;
};

struct SuspectedRadiance {
  const char* mistake;
  glm::dvec3 radiance;
};

// Passes where it is right to 0.5 %. The seeds are those whose first two numbers are evenly spread
// points.
Finding judgeRadiance(CheckRun& run, const RadianceQuestion& question, const glm::dvec3& expected,
                      const std::vector<SuspectedRadiance>& suspects);

// Until one fails; a later one sees other numbers.
Finding judgeAll(CheckRun& run, const std::vector<std::function<Finding(CheckRun&)>>& questions);

}  // namespace pathmark::checks
