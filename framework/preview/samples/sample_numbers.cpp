#include "preview/samples/sample_numbers.h"

#include "sampling/pixel_sampler.h"

#include <algorithm>

namespace pathmark::preview {

namespace {

std::vector<CallNumbers> numbersOfFilm(const SampleSettings& settings) {
  const auto strata = static_cast<std::uint32_t>(settings.strata * settings.strata);
  const std::uint32_t passes = std::max(settings.count / strata, 1u);
  const auto sampler = makePixelSampler(settings.points, settings.seed, strata);
  std::vector<CallNumbers> numbers;
  for (std::uint32_t pass = 0; pass < passes; ++pass) {
    sampler->startPixel(0, 0, std::uint64_t{pass} * strata);
    for (std::uint32_t ray = 0; ray < strata; ++ray) {
      sampler->startRay(static_cast<int>(ray));
      const vec2 st = sampler->next2D();
      numbers.push_back({st.x, st.y, 0.0f});
    }
  }
  return numbers;
}

}  // namespace

std::vector<CallNumbers> makeCallNumbers(const SampleSettings& settings) {
  if (settings.function == CourseworkFunction::kStratifiedRandomRay) return numbersOfFilm(settings);
  const auto sampler = makePixelSampler(settings.points, settings.seed, settings.count);
  sampler->startPixel(0, 0, 0);
  std::vector<CallNumbers> numbers;
  for (std::uint32_t ray = 0; ray < settings.count; ++ray) {
    sampler->startRay(static_cast<int>(ray));
    sampler->next2D();  // the place on the film, which is spread over passes and not within one
    const vec2 st = sampler->next2D();
    numbers.push_back({st.x, st.y, sampler->next1D()});
  }
  return numbers;
}

}  // namespace pathmark::preview
