// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <seamwright/core/disjoint_sets.hpp>
#include <seamwright/occ_adapter/repair/joint.hpp>

/// Keeps natural boundaries of surfaces together exactly. Not a public header.
namespace seamwright::occ {

/// Ties the coefficients of two faces that meet along whole sides of their surfaces. Both sides
/// then move as one, and their gap stays as it is, to rounding. The displacements need the same
/// knots and the same denominator along the side. Beside a face that stays, a side may move within
/// the gap tolerance: without this freedom most vertices there could not be repaired.
class NaturalSides {
 public:
  NaturalSides() = default;
  /// Ties joints whose gap need not change. \param gaps_stay by joint.
  NaturalSides(const std::vector<Joint>& joints, const std::vector<bool>& gaps_stay,
               const MovingFaces& movers);

  /// The first coefficient, by face and number, of those tied to this one; this one itself if it is
  /// not tied.
  std::pair<int, int> first(int face, int coefficient) const;
  /// Adds the spans that faces must halve because the faces tied to them halve theirs.
  void spread(std::map<int, std::array<std::set<int>, 2>>& spans, const MovingFaces& movers) const;

 private:
  /// A side of a surface, from the start of the joint to its end.
  struct Side {
    int face = 0;
    int fixed = 0;  ///< the parameter that is constant along the side: 0: u, 1: v
    bool at_last = false, forward = true;
  };

  static const SplineAxis& along(const Side& side, const MovingFaces& movers);
  static std::vector<int> coefficients(const Side& side, const MovingFaces& movers);
  static std::optional<Side> find(const Joint& joint, std::size_t k, const MovingFaces& movers);
  static bool haveSameDenominator(const Side& a, const Side& b, const MovingFaces& movers);
  void tie(const Side& a, const Side& b, const MovingFaces& movers);

  std::map<int, int> offset_;                 ///< by face
  std::vector<std::pair<int, int>> members_;  ///< face and coefficient
  DisjointSets groups_;
  std::vector<std::set<int>> faces_;  ///< by first member of a group
  std::vector<std::pair<Side, Side>> tied_;
};

}  // namespace seamwright::occ
