#include "preview/samples/sample_set.h"

#include <algorithm>
#include <cmath>

namespace pathmark::preview {

namespace {

bool isFinite(const glm::dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

Sample makeSample(const SampleDomain& domain, const CallNumbers& numbers, const Answer& answer) {
  Sample sample;
  sample.numbers = numbers;
  sample.place = answer.place;
  sample.shown = domain.shown(answer.place);
  sample.claimed = answer.claimed.value_or(0.0);
  if (!isFinite(answer.place) || !std::isfinite(sample.claimed) || sample.claimed < 0.0) {
    sample.kind = SampleKind::kNoNumber;
    return sample;
  }
  sample.expected = domain.density(answer.place);
  if (answer.claimed && sample.claimed == 0.0)
    sample.kind = SampleKind::kNone;
  else if (!(sample.expected > 0.0))
    sample.kind = SampleKind::kAstray;
  return sample;
}

SampleView makeView(const SampleDomain& domain, const SampleSet& set, bool weighted) {
  // Bars and cells that some samples fall into, and no more than can be drawn.
  const std::size_t n = set.samples.size(), bars = std::clamp<std::size_t>(n / 20, 8, 24),
                    about = std::clamp<std::size_t>(n / 8, 4, 256);
  std::vector<WeightedPlace> places;
  std::size_t elsewhere = 0;
  for (const Sample& s : set.samples) {
    if (s.kind == SampleKind::kGood)
      places.push_back({s.place, weighted ? s.expected / s.claimed : 1.0});
    else if (s.kind != SampleKind::kNone)
      ++elsewhere;
  }
  SampleView view;
  for (const Marginal& marginal : domain.marginals())
    view.histograms.push_back(makeHistogram(marginal, places, n, bars, weighted));
  const SampleDomain::Cells cells = domain.cells(about);
  std::vector<Tally> tallies(cells.masses.size());
  for (const WeightedPlace& p : places) tallies[cells.cellOf(p.place)].add(p.weight);
  view.test = testCells(cells.masses, tallies, n, elsewhere, weighted);
  return view;
}

void addTo(std::optional<Range>& range, double x) {
  if (!range) range = Range{x, x};
  range = Range{std::min(range->low, x), std::max(range->high, x)};
}

}  // namespace

std::size_t SampleSet::count(SampleKind kind) const {
  return static_cast<std::size_t>(std::count_if(samples.begin(), samples.end(),
                                                [&](const Sample& s) { return s.kind == kind; }));
}

SampleSet makeSampleSet(const SampleSettings& settings, const SampleDomain& domain,
                        std::span<const CallNumbers> numbers,
                        std::span<const std::uint32_t> answers) {
  SampleSet set;
  set.settings = settings;
  set.astray = domain.astray();
  set.sketch = domain.sketch();
  const std::size_t words = contractOf(settings.function).outputWords;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Answer answer = domain.read(answers.subspan(i * words, words));
    const Sample sample = makeSample(domain, numbers[i], answer);
    set.claims = answer.claimed.has_value();
    if (set.claims && sample.kind == SampleKind::kGood) {
      addTo(set.claimed, sample.claimed);
      addTo(set.claimedOverExpected, sample.claimed / sample.expected);
    }
    set.samples.push_back(sample);
  }
  set.plain = makeView(domain, set, false);
  set.weighted = set.claims ? makeView(domain, set, true) : set.plain;
  return set;
}

}  // namespace pathmark::preview
