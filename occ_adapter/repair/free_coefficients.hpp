// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <set>
#include <vector>

#include <seamwright/occ_adapter/repair/natural_sides.hpp>

/// Which coefficients of displacements are unknowns. Not a public header.
namespace seamwright::occ {

/// The unknowns of a problem, numbered from 0. Tied coefficients (see NaturalSides) have one number
/// and are free if one of them is.
class FreeCoefficients {
 public:
  /// All coefficients are free.
  void freeAll(const MovingFaces& movers, const NaturalSides& sides);
  /// \param needed by face: the coefficients that are free. \param whole faces of which all are.
  void free(const std::map<int, std::set<int>>& needed, const std::set<int>& whole,
            const MovingFaces& movers, const NaturalSides& sides);

  int count() const { return count_; }
  /// By coefficient of the face: its number, -1 if it stays.
  const std::vector<int>& of(int face) const { return numbers_.at(face); }

 private:
  /// Numbers the coefficients that are not marked with a negative number.
  void number(const NaturalSides& sides);

  std::map<int, std::vector<int>> numbers_;  ///< by face and coefficient
  int count_ = 0;
};

}  // namespace seamwright::occ
