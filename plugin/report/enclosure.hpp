// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <seamwright/core/seam/survey.hpp>
#include <string>

namespace seamwright::report {

/// A figure as one short word, for display.
///
///   2.01        enclosed to 1 %: three digits, and as many more as separate it from the limit
///   <=1.2e-13   far below the limit, or only an upper bound is known
///   0.12..0.15  a wider enclosure, or one that contains the limit; rounded outward
///   >=0.3       no upper bound is known: the largest value seen, the maximum may be larger
///   0           exactly zero
///
/// with the signs U+2264 and U+2265 for <= and >=. plain/enclosure.py of the workbench gives the
/// same text.
/// \param factor from the figure's unit to the displayed unit, positive.
/// \param limit the tolerance in the displayed unit; nothing: the figure is not judged.
std::string enclosureText(const Figure& figure, double factor = 1,
                          std::optional<double> limit = {});

/// Any enclosure as "0.12..0.15", rounded outward. \pre the figure has an upper bound.
std::string rangeText(const Figure& figure, double factor = 1);

/// Number of characters of a UTF-8 text on a terminal; continuation bytes do not count.
std::size_t shownWidth(const std::string& text);

}  // namespace seamwright::report
