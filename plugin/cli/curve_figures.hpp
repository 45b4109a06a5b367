// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <seamwright/plugin/report/curve_json.hpp>

namespace seamwright::cli {

/// \param figures of a chain or of clothoids.
template <class Figures>
report::CurveFigures figuresFrom(const Figures& figures) {
  report::CurveFigures result{.length_mm = figures.length_mm,
                              .extrema = figures.extrema,
                              .inflections = figures.inflections};
  if (std::isfinite(figures.energy_per_mm)) result.energy_per_mm = figures.energy_per_mm;
  return result;
}

}  // namespace seamwright::cli
