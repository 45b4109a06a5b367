// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bspline/refinement.hpp>
#include <seamwright/core/join/nearest/common_seam.hpp>
#include <seamwright/core/join/nearest/nearest_rows.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::nearest {

namespace {

/// Knots within this share of the range are one. On a seam of 100 mm that is 1e-7 mm, as files
/// round lengths; a span as short would divide roundings of poles by its length.
constexpr double same_knot = 1e-9;
/// Relative. Files give weights with 13 digits and more.
constexpr double same_weight = 1e-10;

/// The parameter of a surface along its edge, as that of the seam.
struct EdgeParameter {
  double first = 0, last = 1;
  bool reversed = false;
  double speed = 1;  ///< derivative of the linear-rational map at share 0

  double share(double knot) const {
    const double t = (reversed ? last - knot : knot - first) / (last - first);
    return speed == 1 ? t : t / (speed * (1 - t) + t);
  }
  double knot(double share) const {
    const double t = speed == 1 ? share : speed * share / (1 - share + speed * share);
    return reversed ? last - t * (last - first) : first + t * (last - first);
  }
  /// By how much roundings of knots change a share.
  double noise() const {
    const double size = std::max(std::abs(first), std::abs(last));
    return 8 * machine_epsilon * (1 + size / (last - first)) * std::max(speed, 1 / speed);
  }
};

int degreeAlong(const JoinSide& side) {
  return along(side.edge) == SurfaceDirection::V ? side.surface.degree_v : side.surface.degree_u;
}

const std::vector<double>& knotsAlong(const JoinSide& side) {
  return along(side.edge) == SurfaceDirection::V ? side.surface.knots_v : side.surface.knots_u;
}

EdgeParameter parameterOf(const JoinSide& side, double speed) {
  return {knotsAlong(side).front(), knotsAlong(side).back(), side.reversed, speed};
}

/// An inner knot of a side.
struct SeamKnot {
  double share = 0;  ///< of the seam
  double value = 0;  ///< in the parameter of its surface
  int multiplicity = 0;
};

/// In the sense of the seam.
std::vector<SeamKnot> seamKnots(const JoinSide& side, const EdgeParameter& parameter) {
  std::vector<SeamKnot> result;
  const std::vector<double>& knots = knotsAlong(side);
  const int degree = degreeAlong(side);
  for (std::size_t i = degree + 1; i + degree + 1 < knots.size(); ++i)
    if (!result.empty() && result.back().value == knots[i])
      ++result.back().multiplicity;
    else
      result.push_back({parameter.share(knots[i]), knots[i], 1});
  if (side.reversed) std::ranges::reverse(result);
  return result;
}

/// What becomes of the inner knots of a surface.
struct KnotPlan {
  std::vector<double> kept, added;  ///< in its parameter, with repetitions
  double largest_change = 0;        ///< of a knot that is kept, as a share
};

/// The knots of both sides, in pairs; null where the other side has none there.
using KnotPair = std::array<const SeamKnot*, 2>;

std::vector<KnotPair> knotPairs(const std::vector<SeamKnot>& a, const std::vector<SeamKnot>& b,
                                double noise) {
  const double near = std::max(same_knot, noise);
  std::vector<KnotPair> pairs;
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    const auto apart = [&](std::size_t k, std::size_t l) {
      return k < a.size() && l < b.size() ? std::abs(a[k].share - b[l].share) : infinite;
    };
    const double here = apart(i, j);
    if (here <= near && here <= apart(i + 1, j) && here <= apart(i, j + 1))
      pairs.push_back({&a[i++], &b[j++]});
    else if (j == b.size() || (i < a.size() && a[i].share < b[j].share))
      pairs.push_back({&a[i++], nullptr});
    else
      pairs.push_back({nullptr, &b[j++]});
  }
  return pairs;
}

/// \param leads its knots stay.
KnotPlan planOf(const std::vector<KnotPair>& pairs, std::size_t which, bool leads,
                const EdgeParameter& parameter, double noise) {
  KnotPlan plan;
  for (const KnotPair& pair : pairs) {
    const SeamKnot *own = pair[which], *other = pair[1 - which];
    const double change = own && other && !leads ? std::abs(own->share - other->share) : 0;
    const bool takes_other = !own || change > noise;
    const double value = takes_other ? parameter.knot(other->share) : own->value;
    if (own && takes_other) plan.largest_change = std::max(plan.largest_change, change);
    const int given = own ? own->multiplicity : 0;
    const int more = other ? std::max(0, other->multiplicity - given) : 0;
    plan.kept.insert(plan.kept.end(), given, value);
    plan.added.insert(plan.added.end(), more, value);
  }
  if (parameter.reversed) {
    std::ranges::reverse(plan.kept);
    std::ranges::reverse(plan.added);
  }
  return plan;
}

/// A number for each pole as a net with one row for each pole along the seam.
Eigen::MatrixXd netOf(const Eigen::VectorXd& values, SurfaceDirection direction,
                      Eigen::Index along_count) {
  const Eigen::Index across = values.size() / along_count;
  if (direction == SurfaceDirection::V)
    return values.reshaped<Eigen::ColMajor>(along_count, across);
  return values.reshaped<Eigen::RowMajor>(along_count, across);
}

Eigen::VectorXd valuesOf(const Eigen::MatrixXd& net, SurfaceDirection direction) {
  if (direction == SurfaceDirection::V) return net.reshaped<Eigen::ColMajor>();
  return net.reshaped<Eigen::RowMajor>();
}

/// Poles of a row that stay: those that depend on such ones alone. Where several poles that stay
/// are neighbours, as many new ones must stay, or what is new does not determine them.
/// \param is_free 1 for each given pole that may move, else 0.
void requireKept(const bspline::PoleShares& shares, const Eigen::VectorXd& is_free, int across,
                 const std::string& name) {
  std::vector<int> run(is_free.size(), 0), missing(is_free.size() + 1, 0);
  for (Eigen::Index j = 0; j < is_free.size(); ++j) {
    run[j] = j > 0 && is_free(j - 1) == 0 ? run[j - 1] : static_cast<int>(j);
    if (is_free(j) == 0) ++missing[run[j]];
  }
  const Eigen::VectorXd depends = shares * is_free;
  for (Eigen::Index i = 0; i < depends.size(); ++i)
    if (depends(i) == 0) --missing[run[bspline::PoleShares::InnerIterator(shares, i).col()]];
  for (Eigen::Index j = 0; j < is_free.size(); ++j)
    if (missing[j] > 0)
      refuse(fmt::format(
          "pole {} along the seam, {} across it, of surface {} cannot stay: the degree or the "
          "knots "
          "of the other side are needed there, and all new poles depend on poles that move",
          j, across, name));
}

/// Weights and fixed poles of the refined surface.
void carryOver(const bspline::PoleShares& shares, int order, const std::string& name,
               JoinSide& side) {
  const SurfaceDirection direction = along(side.edge);
  const Eigen::Index given = shares.cols();
  if (side.weights.size() != 0)
    side.weights = valuesOf(shares * netOf(side.weights, direction, given), direction);
  if (side.fixed.empty()) return;
  Eigen::VectorXd is_free(std::ssize(side.fixed));
  for (Eigen::Index i = 0; i < is_free.size(); ++i) is_free(i) = side.fixed[i] ? 0 : 1;
  const Eigen::MatrixXd net = netOf(is_free, direction, given);
  const bool at_end = side.edge == PatchEdge::U1 || side.edge == PatchEdge::V1;
  for (Eigen::Index row = 0; row <= std::min<Eigen::Index>(order, net.cols() - 1); ++row) {
    const Eigen::Index across = at_end ? net.cols() - 1 - row : row;
    requireKept(shares, net.col(across), static_cast<int>(across), name);
  }
  const Eigen::VectorXd depends = valuesOf(shares * net, direction);
  side.fixed.resize(depends.size());
  for (Eigen::Index i = 0; i < depends.size(); ++i) side.fixed[i] = depends(i) == 0;
}

/// A side on its way to the common degree and knots.
struct Refining {
  JoinSide side;
  std::string name;
  SeamChange change = {};
  std::optional<bspline::PoleShares> shares = {};  ///< of the given poles; nothing: they are these

  void add(const bspline::PoleShares& next) { shares = shares ? next * *shares : next; }

  void raiseTo(int degree) {
    for (; degreeAlong(side) < degree; ++change.raised_degree) {
      add(bspline::elevationShares(degreeAlong(side), knotsAlong(side)));
      side.surface = elevated(side.surface, along(side.edge));
    }
  }

  void refine(const KnotPlan& plan) {
    const int degree = degreeAlong(side);
    std::vector<double> knots = knotsAlong(side);
    std::ranges::copy(plan.kept, knots.begin() + degree + 1);
    (along(side.edge) == SurfaceDirection::V ? side.surface.knots_v : side.surface.knots_u) = knots;
    change.moved_knots = plan.largest_change;
    if (plan.added.empty()) return;
    change.added_knots = plan.added;
    side.surface = withKnots(side.surface, along(side.edge), plan.added);
    add(bspline::insertionShares(degree, knots, knotsAlong(side)));
  }

  CommonSide done(int order) {
    if (shares && side.moves) carryOver(*shares, order, name, side);
    return {side, side.surface, {}, change};
  }
};

/// Over the common parameter: knots through the linear-rational map, and poles times the factors of
/// S1.9.
void reparametrise(CommonSide& common, const EdgeParameter& parameter) {
  JoinSide& side = common.side;
  const SurfaceDirection direction = along(side.edge);
  const int degree = degreeAlong(side);
  std::vector<double> knots;
  for (const double knot : knotsAlong(side)) {
    const double share = parameter.share(knot);
    knots.push_back(side.reversed ? 1 - share : share);
  }
  const double speed = side.reversed ? 1 / parameter.speed : parameter.speed;
  const Eigen::Index count = std::ssize(knots) - degree - 1;
  Eigen::VectorXd factors = Eigen::VectorXd::Ones(count);
  for (Eigen::Index j = 0; j < count; ++j)
    for (int k = 1; k <= degree; ++k) factors(j) *= 1 - knots[j + k] + speed * knots[j + k];
  const Eigen::Index across = side.surface.poles.rows() / count;
  common.factors = valuesOf(factors.replicate(1, across), direction);
  (direction == SurfaceDirection::V ? side.surface.knots_v : side.surface.knots_u) = knots;
  side.surface.poles.array().colwise() *= common.factors.array();
  // Of a polynomial at another speed: without the roundings of its weights it is polynomial again.
  const Eigen::VectorXd weights = side.surface.poles.col(3);
  if (weights.maxCoeff() - weights.minCoeff() > same_weight * weights.maxCoeff()) return;
  side.surface.poles.array().colwise() *= weights(0) / weights.array();
  side.surface.poles.col(3).setConstant(weights(0));
}

/// Whether the same degree and knots, in the order of the seam, are those of both sides.
bool agree(const JoinSide& a, const JoinSide& b, double noise) {
  if (degreeAlong(a) != degreeAlong(b)) return false;
  const EdgeParameter of_a = parameterOf(a, 1), of_b = parameterOf(b, 1);
  std::vector<double> in_b = knotsAlong(b);
  if (a.reversed != b.reversed) std::ranges::reverse(in_b);
  return std::ranges::equal(knotsAlong(a), in_b, [&](double one, double other) {
    return std::abs(of_a.share(one) - of_b.share(other)) <= noise;
  });
}

/// \param speed of b, see EdgeParameter.
CommonSeam overCommonKnots(const JoinSide& a, const JoinSide& b, int order, double speed) {
  const EdgeParameter of_a = parameterOf(a, 1), of_b = parameterOf(b, speed);
  const double noise = of_a.noise() + of_b.noise();
  if (speed == 1 && agree(a, b, noise)) return {{a, a.surface}, {b, b.surface}};
  Refining one{a, "a"}, other{b, "b"};
  const int degree = std::max(degreeAlong(a), degreeAlong(b));
  one.raiseTo(degree);
  other.raiseTo(degree);
  const std::vector<SeamKnot> in_a = seamKnots(one.side, of_a), in_b = seamKnots(other.side, of_b);
  const std::vector<KnotPair> pairs = knotPairs(in_a, in_b, noise);
  const bool b_leads = a.moves && !b.moves;
  one.refine(planOf(pairs, 0, !b_leads, of_a, noise));
  other.refine(planOf(pairs, 1, b_leads, of_b, noise));
  CommonSeam seam{one.done(order), other.done(order)};
  if (speed == 1) return seam;
  reparametrise(seam.b, of_b);
  seam.parameter_of_b = SeamParameter{Eigen::Vector2d(0, speed), Eigen::Vector2d(1, speed)};
  return seam;
}

/// The weights of the poles on the edge, in the sense of the seam.
Eigen::VectorXd seamWeights(const JoinSide& side) {
  const SeamRows rows = seamRows(side, 0);
  Eigen::VectorXd weights(rows.count);
  for (int j = 0; j < rows.count; ++j) weights(j) = side.surface.poles(rows.pole(0, j), 3);
  return weights;
}

/// That of the only linear-rational map after which the end weights of both seams have the
/// same ratio.
double speedByWeights(const JoinSide& a, const JoinSide& b) {
  if (!isRational(a.surface.poles) && !isRational(b.surface.poles)) return 1;
  const auto growth = [](const JoinSide& side) {
    const Eigen::VectorXd weights = seamWeights(side);
    return std::pow(weights(weights.size() - 1) / weights(0), 1.0 / degreeAlong(side));
  };
  const double speed = growth(a) / growth(b);
  return std::isfinite(speed) && std::abs(speed - 1) > same_weight ? speed : 1;
}

bool weightsAgree(const CommonSeam& seam) {
  const Eigen::ArrayXd ratios = seamWeights(seam.b.side).array() / seamWeights(seam.a.side).array();
  return ratios.maxCoeff() - ratios.minCoeff() <= same_weight * ratios.maxCoeff();
}

/// Without what a refinement may refuse.
JoinSide surfaceAlone(JoinSide side) {
  side.weights.resize(0);
  side.fixed.clear();
  return side;
}

}  // namespace

BSplineSurface CommonSide::inOwnParameter(const BSplineSurface& joined) const {
  if (factors.size() == 0) return joined;
  BSplineSurface result = own;
  for (Eigen::Index i = 0; i < factors.size(); ++i)
    if (joined.poles.row(i) != side.surface.poles.row(i))
      result.poles.row(i) = joined.poles.row(i) / factors(i);
  return result;
}

CommonSeam commonSeam(const JoinSide& a, const JoinSide& b, int order) {
  requireSide(a, "a");
  requireSide(b, "b");
  const double speed = speedByWeights(a, b);
  if (speed != 1 && weightsAgree(overCommonKnots(surfaceAlone(a), surfaceAlone(b), order, speed)))
    return overCommonKnots(a, b, order, speed);
  return overCommonKnots(a, b, order, 1);
}

}  // namespace seamwright::nearest
