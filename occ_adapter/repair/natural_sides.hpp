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

/// What keeps natural sides of surfaces together exactly; not a public header.
namespace seamwright::occ {

/// Where two faces meet along whole sides of their surfaces both sides are displaced as one: what
/// they have of a gap stays as it is, to rounding. For that their displacements need the same knots
/// and the same denominator along the side. Beside a face that stays a side has the freedom of the
/// gap tolerance: without it most vertices there could not be repaired.
class NaturalSides {
 public:
  NaturalSides() = default;
  /// Of joints whose gap need not change. \param gaps_stay by joint.
  NaturalSides(const std::vector<Joint>& joints, const std::vector<bool>& gaps_stay,
               const MovingFaces& movers);

  /// The first of the coefficients, by face and number, that are one with this; itself where it
  /// stands alone.
  std::pair<int, int> first(int face, int coefficient) const;
  /// Adds spans that faces have to halve for the sake of spans that others halve.
  void spread(std::map<int, std::array<std::set<int>, 2>>& spans, const MovingFaces& movers) const;

 private:
  /// A side of a surface, from the start of the joint to its end.
  struct Side {
    int face = 0;
    int fixed = 0;  ///< the parameter that is the same all along: 0: u, 1: v
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
