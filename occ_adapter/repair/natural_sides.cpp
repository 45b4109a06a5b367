// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <seamwright/occ_adapter/repair/natural_sides.hpp>

namespace seamwright::occ {

namespace {

/// Share of the parameter range within which two parameters are equal.
constexpr double same_parameter = 1e-9;

/// The position of a knot along the axis, in 0..1, in the direction of the side.
double share(const SplineAxis& axis, bool forward, double t) {
  const double from_first = (t - axis.first) / (axis.last - axis.first);
  return forward ? from_first : 1 - from_first;
}

bool haveSameKnots(const SplineAxis& a, bool a_forward, const SplineAxis& b, bool b_forward) {
  if (a.periodic || b.periodic || a.degree != b.degree || a.poles != b.poles) return false;
  const std::size_t count = a.knots.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double of_a = share(a, a_forward, a.knots[a_forward ? i : count - 1 - i]),
                 of_b = share(b, b_forward, b.knots[b_forward ? i : count - 1 - i]);
    if (!(std::abs(of_a - of_b) <= same_parameter)) return false;
  }
  return true;
}

}  // namespace

const SplineAxis& NaturalSides::along(const Side& side, const MovingFaces& movers) {
  const SurfaceBasis& basis = movers.at(side.face).displacement.basis();
  return side.fixed == 0 ? basis.v() : basis.u();
}

std::vector<int> NaturalSides::coefficients(const Side& side, const MovingFaces& movers) {
  std::vector<int> list =
      movers.at(side.face).displacement.coefficientsOfSide(side.fixed, side.at_last);
  if (!side.forward) std::ranges::reverse(list);
  return list;
}

std::optional<NaturalSides::Side> NaturalSides::find(const Joint& joint, std::size_t k,
                                                     const MovingFaces& movers) {
  // Number of intervals whose ends are compared with the side.
  constexpr int looks = 4;
  Side side;
  side.face = joint.sides[k].face;
  const auto mover = movers.find(side.face);
  if (mover == movers.end()) return {};
  const SurfaceBasis& basis = mover->second.displacement.basis();
  const Pcurve& path = joint.paths[k];
  for (const int fixed : {0, 1}) {
    const SplineAxis &across = fixed == 0 ? basis.u() : basis.v(),
                     &along = fixed == 0 ? basis.v() : basis.u();
    if (across.periodic || along.periodic) continue;
    side.fixed = fixed;
    bool is_side = true;
    for (int look = 0; look <= looks && is_side; ++look) {
      const double s = static_cast<double>(look) / looks;
      const gp_Pnt2d uv = path.curve->Value(path.first + s * (path.last - path.first));
      const double at_across = share(across, true, fixed == 0 ? uv.X() : uv.Y()),
                   at_along = share(along, true, fixed == 0 ? uv.Y() : uv.X());
      if (look == 0) {
        side.at_last = at_across > 0.5;
        side.forward = at_along < 0.5;
      }
      is_side = std::abs(at_across - (side.at_last ? 1 : 0)) <= same_parameter &&
                std::abs(at_along - (side.forward ? s : 1 - s)) <= same_parameter;
    }
    if (is_side) return side;
  }
  return {};
}

NaturalSides::NaturalSides(const std::vector<Joint>& joints, const std::vector<bool>& gaps_stay,
                           const MovingFaces& movers) {
  for (const auto& [face, mover] : movers) {
    offset_[face] = static_cast<int>(members_.size());
    for (int k = 0; k < mover.displacement.count(); ++k) members_.emplace_back(face, k);
  }
  groups_ = DisjointSets(static_cast<int>(members_.size()));
  for (const auto& [face, coefficient] : members_) faces_.push_back({face});
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j];
    if (joint.sides.size() < 2 || !joint.map.s.empty() || !gaps_stay[j]) continue;
    const auto a = find(joint, 0, movers), b = find(joint, 1, movers);
    if (a && b) tie(*a, *b, movers);
  }
}

bool NaturalSides::haveSameDenominator(const Side& a, const Side& b, const MovingFaces& movers) {
  const auto denominator = [&movers](const Side& side, double s) {
    const Displacement& displacement = movers.at(side.face).displacement;
    const SplineAxis &own = along(side, movers),
                     &other = side.fixed == 0 ? displacement.basis().u() : displacement.basis().v();
    const double t = own.first + (side.forward ? s : 1 - s) * (own.last - own.first),
                 at = side.at_last ? other.last : other.first;
    return displacement.denominator(side.fixed == 0 ? Eigen::Vector2d(at, t)
                                                    : Eigen::Vector2d(t, at));
  };
  const int looks = 2 * along(a, movers).poles;
  for (int look = 0; look <= looks; ++look) {
    const double s = static_cast<double>(look) / looks, of_a = denominator(a, s);
    if (!(std::abs(of_a - denominator(b, s)) <= same_parameter * of_a)) return false;
  }
  return true;
}

void NaturalSides::tie(const Side& a, const Side& b, const MovingFaces& movers) {
  if (a.face == b.face) return;
  tied_.emplace_back(a, b);
  if (!haveSameKnots(along(a, movers), a.forward, along(b, movers), b.forward) ||
      !haveSameDenominator(a, b, movers))
    return;
  const std::vector<int> of_a = coefficients(a, movers), of_b = coefficients(b, movers);
  const PointRows &at_a = movers.at(a.face).displacement.coefficients(),
                  &at_b = movers.at(b.face).displacement.coefficients();
  const double near_mm = same_parameter * movers.at(a.face).displacement.size_mm();
  for (std::size_t k = 0; k < of_a.size(); ++k)
    if (!((at_a.row(of_a[k]) - at_b.row(of_b[k])).norm() <= near_mm)) return;
  for (std::size_t k = 0; k < of_a.size(); ++k) {
    const int first = groups_.of(offset_.at(a.face) + of_a[k]),
              second = groups_.of(offset_.at(b.face) + of_b[k]);
    if (first == second) continue;
    // Never ties two coefficients of one face: that would collapse the face there.
    const bool share_a_face = std::ranges::any_of(
        faces_[second], [&](int face) { return faces_[first].count(face) > 0; });
    if (share_a_face) continue;
    faces_[std::min(first, second)].insert(faces_[std::max(first, second)].begin(),
                                           faces_[std::max(first, second)].end());
    groups_.unite(first, second);
  }
}

std::pair<int, int> NaturalSides::first(int face, int coefficient) const {
  return members_[groups_.of(offset_.at(face) + coefficient)];
}

void NaturalSides::spread(std::map<int, std::array<std::set<int>, 2>>& spans,
                          const MovingFaces& movers) const {
  const auto add = [&](const Side& from, const Side& to) {
    const auto halved = spans.find(from.face);
    if (halved == spans.end()) return false;
    const SplineAxis &axis = along(from, movers), &other = along(to, movers);
    bool any = false;
    for (const int span : halved->second[1 - from.fixed]) {
      const double at = share(axis, from.forward, axis.middle(span));
      double t = other.first + (to.forward ? at : 1 - at) * (other.last - other.first);
      any = spans[to.face][1 - to.fixed].insert(other.span(t, 0)).second || any;
    }
    return any;
  };
  for (bool any = true; any;) {
    any = false;
    for (const auto& [a, b] : tied_) {
      any = add(a, b) || any;
      any = add(b, a) || any;
    }
  }
}

}  // namespace seamwright::occ
