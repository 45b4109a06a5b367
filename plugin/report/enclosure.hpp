// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <seamwright/core/seam/survey.hpp>
#include <string>

namespace seamwright::report {

/// A figure as one short word, for people.
///
///   2.01        enclosed to 1 %: three digits, and as many more as tell it from the limit
///   <=1.2e-13   far below the limit, or nothing is known but that it is no larger
///   0.12..0.15  a wider enclosure, or one that holds the limit; rounded outward
///   >=0.3       no upper bound is known: this was seen, there may be more
///   0           exactly zero
///
/// with the signs U+2264 and U+2265 for <= and >=. plain/enclosure.py of the workbench writes the
/// same.
/// \param factor from the figure's unit to the one shown, positive.
/// \param limit what is accepted, in the unit shown; nothing: the figure is not judged.
std::string enclosureText(const Figure& figure, double factor = 1,
                          std::optional<double> limit = {});

/// The enclosure as "0.12..0.15" whatever it is, rounded outward. \pre the figure has an upper
/// bound.
std::string rangeText(const Figure& figure, double factor = 1);

/// Letters that a text takes on a terminal; bytes that continue a UTF-8 letter count nothing.
std::size_t shownWidth(const std::string& text);

}  // namespace seamwright::report
