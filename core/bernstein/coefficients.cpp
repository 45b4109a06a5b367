// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>

namespace seamwright::bernstein {

std::string text(double value) {
  return fmt::format("{:.17g}", value);
}

}  // namespace seamwright::bernstein
