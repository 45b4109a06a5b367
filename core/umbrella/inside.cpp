// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/umbrella/frame.hpp>
#include <seamwright/core/umbrella/spokes.hpp>
#include <stdexcept>
#include <string>

namespace seamwright {

namespace {

using bernstein::text;
using umbrella::Forms;
using umbrella::FreeVectors;
using umbrella::Net;

void requireSides(const std::vector<BezierCurve>& sides, double gap_mm) {
  const std::size_t n = sides.size();
  if (n < 3 || n > 12) refuse(std::to_string(n) + " sides: 3 to 12 are needed");
  if (!(gap_mm >= 0) || !std::isfinite(gap_mm))
    refuse("gap_mm is " + text(gap_mm) + ": a finite number, 0 or more, is needed");
  for (std::size_t i = 0; i < n; ++i) {
    const std::string side = "side " + std::to_string(i) + " ";
    if (sides[i].isRational()) refuse(side + "is rational: only polynomial ones are built within");
    if (sides[i].degree() < 1) refuse(side + "has degree 0: it is a point");
    const Poles poles = sides[i].poles(), next = sides[(i + 1) % n].poles();
    const double gap = (poles.bottomRows<1>() - next.row(0)).norm();
    const double rounding =
        16 * std::numeric_limits<double>::epsilon() * poles.cwiseAbs().maxCoeff();
    if (gap > gap_mm + rounding)
      refuse(side + "ends " + text(gap) + " mm from the beginning of side " +
             std::to_string((i + 1) % n) + ": at most " + text(gap_mm) + " is allowed");
  }
}

/// The halves of a side in that degree. The first one is reversed, so both begin in the middle.
struct Halves {
  Poles to_begin, to_end;
};

std::vector<Halves> halvesOf(const std::vector<BezierCurve>& sides, int degree) {
  std::vector<Halves> result;
  for (const BezierCurve& side : sides) {
    const auto [first, second] = side.split(0.5);
    result.push_back({rows::elevated<3>(first.reversed().poles(), degree),
                      rows::elevated<3>(second.poles(), degree)});
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    Halves& next = result[(i + 1) % result.size()];
    const Eigen::RowVector3d corner =
        (result[i].to_end.bottomRows<1>() + next.to_begin.bottomRows<1>()) / 2;
    result[i].to_end.bottomRows<1>() = next.to_begin.bottomRows<1>() = corner;
  }
  return result;
}

umbrella::GivenPoles outerPoles(const std::vector<Net>& nets, const std::vector<Halves>& sides) {
  const Eigen::Index count = umbrella::polesOf(nets);
  umbrella::GivenPoles outer{Poles::Zero(count, 3), std::vector<bool>(count, false)};
  const auto set = [&](Eigen::Index row, const Eigen::RowVector3d& pole) {
    outer.poles.row(row) = pole;
    outer.given[row] = true;
  };
  for (std::size_t i = 0; i < nets.size(); ++i)
    for (int k = 0; k <= nets[i].degree; ++k) {
      set(nets[i].at(nets[i].degree, k), sides[i].to_end.row(k));
      set(nets[i].at(k, nets[i].degree), sides[(i + 1) % sides.size()].to_begin.row(k));
    }
  return outer;
}

/// The tangents of a regular closed fan.
Eigen::Matrix3Xd regularTangents(int n) {
  Eigen::Matrix3Xd tangents(3, n);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    tangents.col(i) << std::cos(angle), std::sin(angle), 0;
  }
  return tangents;
}

/// Spokes from a free O, with tangents that are an affine image of the regular ones, to the middles
/// of the sides. An even fan closes if the alternating sum of the third poles is zero.
std::vector<Forms> freeSpokes(const UmbrellaVertex& vertex, const std::vector<Halves>& sides,
                              int degree, FreeVectors& free) {
  const Eigen::RowVectorXd origin = free.next(), x = free.next(), y = free.next();
  const int n = vertex.spokes();
  Eigen::RowVectorXd alternating = Eigen::RowVectorXd::Zero(free.columns());
  std::vector<Forms> spokes;
  for (int i = 0; i < n; ++i) {
    Forms spoke = Forms::Zero(degree + 1, free.columns());
    spoke.row(0) = origin;
    spoke.row(1) = origin + (vertex.tangents(0, i) * x + vertex.tangents(1, i) * y) / degree;
    for (int k = 2; k < degree; ++k) {
      const bool follows = k == 2 && i == n - 1 && n % 2 == 0 && !vertex.isRegular();
      spoke.row(k) = follows ? alternating : free.next();
    }
    alternating += (i % 2 == 0 ? 1 : -1) * spoke.row(2);
    spoke.bottomRows<1>() = free.constants(sides[i].to_end.topRows<1>());
    spokes.push_back(spoke);
  }
  return spokes;
}

}  // namespace

Umbrella umbrellaInside(const std::vector<BezierCurve>& sides,
                        const UmbrellaInsideOptions& options) {
  requireSides(sides, options.gap_mm);
  if (options.spoke_degree < 3)
    refuse("spoke_degree is " + std::to_string(options.spoke_degree) + ": 3 or more is needed");
  int degree = options.spoke_degree;
  for (const BezierCurve& side : sides) degree = std::max(degree, side.degree());
  if (options.degree && (*options.degree < degree || *options.degree > bernstein::kMaxDegree))
    refuse("degree " + std::to_string(*options.degree) +
           " of the members is too low or too high: they need " + std::to_string(degree));
  degree = options.degree.value_or(degree);

  const int n = static_cast<int>(sides.size());
  const UmbrellaVertex regular = umbrellaVertex(regularTangents(n), true);
  const std::vector<SpokeFunctions> functions =
      umbrella::functionsOf(regular, defaultSeconds(regular, Eigen::Matrix3Xd::Zero(3, n)));
  const std::vector<Net> nets =
      umbrella::netsOf(std::vector<MemberKind>(n, MemberKind::Tensor), degree);
  const std::vector<Halves> halves = halvesOf(sides, degree);
  FreeVectors free(umbrella::polesOf(nets));
  const std::vector<Forms> spokes = freeSpokes(regular, halves, options.spoke_degree, free);
  const Forms forms =
      umbrella::framed({regular, functions, nets, spokes, outerPoles(nets, halves)}, free);

  const Eigen::MatrixXd energy = umbrella::energyRows(nets);
  const Eigen::MatrixXd least = linear::LeastSquares(energy * umbrella::linearPart(forms, free))
                                    .solve(energy * -umbrella::constantPart(forms));
  const auto valued = [&](const Forms& of) {
    return Poles(umbrella::constantPart(of) + umbrella::linearPart(of, free) * least);
  };
  Umbrella result;
  for (const Forms& spoke : spokes) result.spokes.emplace_back(valued(spoke));
  result.vertex = umbrellaVertex(umbrella::tangentsOf(result.spokes), true);
  result.members = umbrella::membersOf(nets, valued(forms));
  result.functions = functions;
  result.free_vectors = free.count();
  return result;
}

}  // namespace seamwright
