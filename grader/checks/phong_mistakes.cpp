#include "checks/phong_mistakes.h"

namespace pathmark::checks {

namespace {

constexpr double kPiD = std::numbers::pi;

glm::dvec3 around(const glm::dvec3& axis, double cosine, double turn) {
  return DoubleFrame(axis).direction(cosine, 2.0 * kPiD * turn);
}

// What one draw is made of; a mistake changes a part of it.
struct Recipe {
  glm::dvec3 axis;  // of the specular lobe
  double power;     // cos(alpha) = t^power
  double share;     // of the diffuse lobe
  bool mirroredUp = false;
  bool uniformAngle = false;
};

glm::dvec3 drawBy(const Recipe& recipe, const PhongLobes& lobes, const DirectionDraw& p) {
  const bool diffuse = double{p.u} < recipe.share;
  const double turn = p.st.x, t = p.st.y;
  const double cosine = std::pow(t, diffuse ? 0.5 : recipe.power);
  glm::dvec3 wi = around(diffuse ? lobes.n : recipe.axis, cosine, turn);
  if (recipe.uniformAngle && !diffuse) wi = around(recipe.axis, std::cos(0.5 * kPiD * t), turn);
  const double height = glm::dot(wi, lobes.n);
  return recipe.mirroredUp && height < 0.0 ? wi - 2.0 * height * lobes.n : wi;
}

}  // namespace

std::vector<PhongMistake> phongMistakes(const MixtureCase& c) {
  const PhongLobes lobes(c.wo, c.n, c.material.exponent);
  const double m = lobes.m, share = c.material.diffuseShare();
  const Recipe right{lobes.mirror, 1.0 / (m + 1.0), share};
  std::vector<PhongMistake> mistakes;
  const auto add = [&](std::string text, auto change) {
    Recipe recipe = right;
    change(recipe);
    mistakes.push_back(
        {std::move(text), [=](const DirectionDraw& p) { return drawBy(recipe, lobes, p); }});
  };
  add("the specular lobe is drawn around wo instead of its mirror direction",
      [&](Recipe& r) { r.axis = lobes.wo; });
  add("the specular lobe is drawn around n instead of the mirror direction of wo",
      [&](Recipe& r) { r.axis = lobes.n; });
  add("the mirror direction has the wrong sign: the specular lobe points into the surface",
      [&](Recipe& r) { r.axis = -lobes.mirror; });
  add("directions below the surface are mirrored upwards: return them as they are",
      [](Recipe& r) { r.mirroredUp = true; });
  add("the lobes are swapped: the diffuse one is drawn with the probability of the specular one",
      [&](Recipe& r) { r.share = 1.0 - share; });
  add("each lobe is drawn with the probability 1/2, and the density is that of another mixture",
      [](Recipe& r) { r.share = 0.5; });
  add("the angle alpha is proportional to t instead of cos(alpha) = t^(1/(m + 1))",
      [](Recipe& r) { r.uniformAngle = true; });
  add("cos(alpha) = t^(1/(m + 2)) instead of t^(1/(m + 1))",
      [&](Recipe& r) { r.power = 1.0 / (m + 2.0); });
  // Integers are asked for first, where these two show already. At 0.5, t^m is what an exponent of
  // 1 gives.
  const bool isInteger = m == std::floor(m);
  if (isInteger && m > 0.0) {
    add("cos(alpha) = t^(1/m) instead of t^(1/(m + 1))", [&](Recipe& r) { r.power = 1.0 / m; });
    add("cos(alpha) = t^m instead of t^(1/(m + 1))", [&](Recipe& r) { r.power = m; });
  }
  if (!isInteger)
    add("the exponent is rounded down to an integer",
        [&](Recipe& r) { r.power = 1.0 / (std::floor(m) + 1.0); });
  if (m < 1.0) add("an exponent below 1 is taken for 1", [](Recipe& r) { r.power = 0.5; });
  return mistakes;
}

std::string numberUsedTwice(CheckRun& run, const MixtureCase& c) {
  Random random(run.seed);
  constexpr std::size_t kDraws = 64;
  std::vector<DirectionDraw> points;
  for (std::size_t k = 0; k < kDraws; ++k) {
    const DirectionDraw p{{random.uniform(), random.uniform()}, random.uniform()};
    points.push_back(p);
    points.push_back({{random.uniform(), p.st.y}, p.u});
    points.push_back({{p.st.x, random.uniform()}, p.u});
    points.push_back({p.st, random.uniform()});
  }
  // At the exponent 1 a specular lobe around n is the diffuse one, whichever u chooses.
  MixtureCase sharper = c;
  sharper.material.exponent += 9.0f;
  const std::vector<DrawnDirection> drawn = drawPhong(run, sharper, points);
  const auto unused = [&](std::size_t number) {
    for (std::size_t k = 0; k < drawn.size(); k += 4)
      if (drawn[k].wi != drawn[k + number].wi) return false;
    return true;
  };
  if (unused(1))
    return "s changes nothing: if u chooses the lobe and the azimuth too, each lobe gets only a "
           "wedge of it";
  if (unused(2)) return "t changes nothing: the angle to the axis of the lobe needs a number";
  const bool bothLobes = c.material.kd != Colour(0.0f) && c.material.ks != Colour(0.0f);
  if (bothLobes && unused(3)) return "u changes nothing: it is there to choose the lobe";
  return {};
}

}  // namespace pathmark::checks
