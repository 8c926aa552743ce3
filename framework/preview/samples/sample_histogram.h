// Samples beside what is expected of them.
//
//   Tally        samples of a bar or of a cell: their number, or the sum of their weights
//   Histogram    of one coordinate
//   CellTest     chi-square over a partition
#pragma once

#include "preview/samples/sample_domain.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace pathmark::preview {

struct Tally {
  double sum = 0.0, sumOfSquares = 0.0;

  void add(double weight) {
    sum += weight;
    sumOfSquares += weight * weight;
  }
};

struct WeightedPlace {
  glm::dvec3 place;
  double weight = 1.0;
};

struct Bar {
  double share = 0.0;     // of all samples
  double expected = 0.0;  // this share
  double sigma = 0.0;     // its standard deviation, if samples are independent
};

struct Histogram {
  std::string name;
  double low = 0.0, high = 1.0;
  std::vector<Bar> bars;      // of equal widths
  std::vector<double> curve;  // expected density at places spread evenly, as a share of a bar
};

// `samples` is the number of all of them; weights 1 unless `weighted`.
Histogram makeHistogram(const Marginal& marginal, std::span<const WeightedPlace> places,
                        std::size_t samples, std::size_t bars, bool weighted);

struct CellTest {
  bool possible = false;  // enough samples to say anything
  double pValue = 1.0;    // of independent samples; they are as uneven as this or more
  std::size_t cells = 0;  // that were told apart
};

// Pearson's test of a partition with these masses; small cells are put together. Samples that are
// in no cell are `elsewhere`, where nothing is expected. With weights (expected density over
// claimed), each cell's variance is estimated from the samples in it.
//
// To be looked at, not to mark with: its tails are those of chi-square only roughly.
CellTest testCells(std::span<const double> masses, std::span<const Tally> cells,
                   std::size_t samples, std::size_t elsewhere, bool weighted);

}  // namespace pathmark::preview
