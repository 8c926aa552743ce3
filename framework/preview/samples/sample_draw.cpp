#include "preview/samples/sample_draw.h"

#include <algorithm>

namespace pathmark::preview {

namespace {

// Of get_random_numbers: so many calls after one another, each with the seed that the one before
// has left, for as many pixels as it takes.
constexpr std::uint32_t kCallsOfSeed = 16;

// In the order of the calls: all of the first pixel, all of the second, ...
std::vector<std::uint32_t> drawRandomNumbers(WorkerProcess& worker, std::uint32_t count,
                                             std::uint32_t seed) {
  constexpr auto kFunction = CourseworkFunction::kGetRandomNumbers;
  const std::size_t words = contractOf(kFunction).outputWords;
  const std::uint32_t pixels = (count + kCallsOfSeed - 1) / kCallsOfSeed;
  CallWords seeds;
  for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) seeds.add(pixel, seed);
  std::vector<std::uint32_t> inputs = seeds.words(), answers(pixels * kCallsOfSeed * words);
  for (std::size_t call = 0; call < kCallsOfSeed; ++call) {
    const std::vector<std::uint32_t> answer = worker.call(kFunction, {}, inputs);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
      const auto from = answer.begin() + static_cast<std::ptrdiff_t>(pixel * words);
      std::copy_n(
          from, words,
          answers.begin() + static_cast<std::ptrdiff_t>((pixel * kCallsOfSeed + call) * words));
      std::copy_n(from + 2, 2, inputs.begin() + static_cast<std::ptrdiff_t>(2 * pixel));
    }
  }
  answers.resize(count * words);
  return answers;
}

}  // namespace

SampleSet drawSamples(WorkerProcess& worker, const SampleSettings& settings) {
  const auto domain = makeSampleDomain(settings);
  if (settings.function == CourseworkFunction::kGetRandomNumbers) {
    const std::vector<CallNumbers> none(settings.count);
    return makeSampleSet(settings, *domain, none,
                         drawRandomNumbers(worker, settings.count, settings.seed));
  }
  const std::vector<CallNumbers> numbers = makeCallNumbers(settings);
  CallWords calls;
  for (std::size_t i = 0; i < numbers.size(); ++i) domain->addCall(calls, i, numbers[i]);
  const std::vector<std::uint32_t> answers =
      worker.call(settings.function, domain->object().words(), calls.words());
  return makeSampleSet(settings, *domain, numbers, answers);
}

}  // namespace pathmark::preview
