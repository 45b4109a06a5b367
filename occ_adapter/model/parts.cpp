// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <stdexcept>

#include <seamwright/occ_adapter/model/parts.hpp>

namespace seamwright::occ {

void requirePart(std::string_view singular, std::string_view plural, int number, int count) {
  if (number >= 1 && number <= count) return;
  throw std::invalid_argument(
      count > 0 ? fmt::format("{} {}: the model has {} 1 to {}", singular, number, plural, count)
                : fmt::format("{} {}: the model has no {}", singular, number, plural));
}

}  // namespace seamwright::occ
