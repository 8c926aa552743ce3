// The plots of reports.
//
//   histogramPlot      of samples: bars are yours, the line is what is expected
//   pValuePlot         of pixels, flat where there is nothing but noise
//   convergencePlot    error against rays per pixel, both logarithmic
//   distributionPlot   of the marks of a class
//   pointsBar          points out of so many, as a bar for tables
//
// Each is a figure with a caption; nothing if there is nothing to draw.
#pragma once

#include "record/record.h"
#include "report/html_text.h"

#include <cstdint>
#include <span>
#include <vector>

namespace pathmark::report {

Markup histogramPlot(const record::Histogram& histogram);
Markup pValuePlot(std::span<const std::uint32_t> bins);
Markup convergencePlot(const record::PictureRecord::Convergence& convergence);
Markup distributionPlot(std::span<const double> points, double outOf);
Markup pointsBar(double points, double outOf);

}  // namespace pathmark::report
