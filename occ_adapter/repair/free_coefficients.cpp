// SPDX-License-Identifier: LGPL-2.1-or-later
#include <utility>

#include <seamwright/occ_adapter/repair/free_coefficients.hpp>

namespace seamwright::occ {

void FreeCoefficients::freeAll(const MovingFaces& movers, const NaturalSides& sides) {
  for (const auto& [face, mover] : movers)
    numbers_[face].assign(static_cast<std::size_t>(mover.displacement.count()), 0);
  number(sides);
}

void FreeCoefficients::free(const std::map<int, std::set<int>>& needed, const std::set<int>& whole,
                            const MovingFaces& movers, const NaturalSides& sides) {
  for (const auto& [face, mover] : movers)
    numbers_[face].assign(static_cast<std::size_t>(mover.displacement.count()),
                          whole.count(face) > 0 ? 0 : -1);
  for (const auto& [face, coefficients] : needed)
    for (const int coefficient : coefficients) numbers_.at(face)[coefficient] = 0;
  number(sides);
}

void FreeCoefficients::number(const NaturalSides& sides) {
  std::map<std::pair<int, int>, int> numbers;  // by first of those that are one
  const auto forEach = [&](const auto& work) {
    for (auto& [face, all] : numbers_)
      for (std::size_t k = 0; k < all.size(); ++k)
        work(sides.first(face, static_cast<int>(k)), all[k]);
  };
  forEach([&](const auto& first, int& own) {
    if (own >= 0) numbers[first] = 0;
  });
  count_ = 0;
  for (auto& [first, number] : numbers) number = count_++;
  forEach([&](const auto& first, int& own) {
    const auto found = numbers.find(first);
    own = found == numbers.end() ? -1 : found->second;
  });
}

}  // namespace seamwright::occ
