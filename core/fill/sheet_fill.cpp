// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <seamwright/core/fill/graph_knots.hpp>
#include <seamwright/core/fill/regular.hpp>
#include <seamwright/core/fill/sheet_fill.hpp>
#include <seamwright/core/linear/gauss_rule.hpp>
#include <seamwright/core/linear/symmetric_band.hpp>
#include <stdexcept>

namespace seamwright {

namespace sheet {

using Eigen::Index, Eigen::Vector2d, Eigen::Vector3d;
using fill::GraphKnots;

constexpr int sheet_degree = fill::graph_degree;
constexpr int local = sheet_degree + 1;

/// Knots are added until the sides are met to this share of what is accepted, so that the sum of
/// all errors is within it.
constexpr double met_enough = 0.5;

/// Misses of this angle have the largest weight that leaves digits for the fairness.
constexpr double least_rad = 1e-7;

/// From one weight to the next, the misses that it belongs to.
constexpr double finer = 0.1;

/// As near to the ends of sides as samples are taken, because a surface may have no tangent plane
/// there.
constexpr double nearest_share = 1e-5;

/// A sum of values or derivatives of the poles around a cell.
struct SheetRow {
  std::array<Index, 2> first{};  ///< of the poles, in u and in v
  Eigen::Matrix<double, local, local> factors;
};

/// The integrals of the products of the derivatives of all functions of one direction.
Eigen::MatrixXd integrals(const GraphKnots& knots, int order) {
  static const GaussRule rule = gaussRule(local);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(knots.poles(), knots.poles());
  for (int span = 0; span < knots.spans(); ++span)
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double t = knots.begin(span) + rule.nodes[i] * knots.width(span);
      const Eigen::VectorXd row = knots.basis(span, t, order).row(order).transpose();
      const Index first = knots.firstPole(span);
      result.block(first, first, local, local) +=
          rule.weights[i] * knots.width(span) * row * row.transpose();
    }
  return result;
}

/// The squared jumps of the second derivative at the knots where it may jump, as if it changed over
/// a quarter of the range.
Eigen::MatrixXd jumps(const GraphKnots& knots) {
  const double range = knots.flat().back() - knots.flat().front();
  constexpr double share = 0.25;  // a choice: it keeps jumps local
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(knots.poles(), knots.poles());
  for (const double bend : knots.bends()) {
    const int after = knots.spanAt(bend);
    Eigen::VectorXd jump = Eigen::VectorXd::Zero(knots.poles());
    jump.segment(knots.firstPole(after), local) += knots.basis(after, bend, 2).row(2).transpose();
    jump.segment(knots.firstPole(after - 1), local) -=
        knots.basis(after - 1, bend, 2).row(2).transpose();
    result += jump * jump.transpose() / (share * range);
  }
  return result;
}

/// A condition: the component of a sum of poles along a direction has a value.
struct SheetCondition {
  SheetRow row;
  Vector3d direction;
  double value = 0, weight = 1;
};

/// A spline sheet over a rectangle, and its equations.
class Sheet {
 public:
  Sheet(GraphKnots u, GraphKnots v) : u_(std::move(u)), v_(std::move(v)) {}

  const GraphKnots& u() const { return u_; }
  const GraphKnots& v() const { return v_; }
  int poles() const { return u_.poles() * v_.poles(); }

  SheetRow row(const Vector2d& at, int order_u, int order_v) const {
    const int a = u_.spanAt(at.x()), b = v_.spanAt(at.y());
    return {{u_.firstPole(a), v_.firstPole(b)},
            u_.basis(a, at.x(), order_u).row(order_u).transpose() *
                v_.basis(b, at.y(), order_v).row(order_v)};
  }

  void clear() {
    matrix_ = linear::SymmetricBand(3 * poles(), 3 * sheet_degree * (v_.poles() + 1) + 2);
    right_ = Eigen::VectorXd::Zero(3 * poles());
  }

  /// The integral of the squared third derivatives, and the jumps.
  void addVariation() {
    for (int order = 0; order <= 3; ++order)
      addProduct(integrals(u_, order), integrals(v_, 3 - order), order % 3 == 0 ? 1 : 3);
    addProduct(jumps(u_), integrals(v_, 0), 1);
    addProduct(integrals(u_, 0), jumps(v_), 1);
  }

  void add(const SheetCondition& one) {
    const auto entries = entriesOf(one);
    for (std::size_t k = 0; k < entries.size(); ++k)
      for (std::size_t m = 0; m <= k; ++m)
        matrix_(entries[k].first, entries[m].first) +=
            one.weight * entries[k].second * entries[m].second;
    addRight(one, one.value);
  }
  void addRight(const SheetCondition& one, double value) {
    for (const auto& [unknown, factor] : entriesOf(one))
      right_(unknown) += one.weight * factor * value;
  }
  Vector3d valueOf(const SheetRow& row) const {
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < local; ++i)
      for (int j = 0; j < local; ++j)
        sum += row.factors(i, j) * poles_.segment<3>(3 * poleAt(row, i, j));
    return sum;
  }

  bool factorise() {
    factors_ = linear::BandCholesky(std::move(matrix_));
    return factors_.positive();
  }
  /// \pre factorise() returned true.
  bool solve() {
    const Eigen::VectorXd found = factors_.solve(right_);
    if (!found.allFinite()) return false;
    poles_ = found;
    return true;
  }

  BSplineSurface surface(const Vector3d& centre, double unit_mm) const {
    const auto knots = [&](const GraphKnots& one) {
      std::vector<double> result = one.flat();
      for (double& knot : result) knot *= unit_mm;
      return result;
    };
    BSplineSurface result{.degree_u = sheet_degree,
                          .degree_v = sheet_degree,
                          .knots_u = knots(u_),
                          .knots_v = knots(v_),
                          .poles = HomogeneousPoles(poles(), 4)};
    for (int k = 0; k < poles(); ++k)
      result.poles.row(k) << (centre + unit_mm * poles_.segment<3>(3 * k)).transpose(), 1;
    return result;
  }

 private:
  Index poleAt(const SheetRow& row, int i, int j) const {
    return (row.first[0] + i) * v_.poles() + row.first[1] + j;
  }

  /// The factors that do not vanish, by increasing unknown.
  std::vector<std::pair<Index, double>> entriesOf(const SheetCondition& one) const {
    std::vector<std::pair<Index, double>> entries;
    for (int i = 0; i < local; ++i)
      for (int j = 0; j < local; ++j)
        for (int c = 0; c < 3; ++c)
          if (const double factor = one.row.factors(i, j) * one.direction(c); factor != 0)
            entries.emplace_back(3 * poleAt(one.row, i, j) + c, factor);
    return entries;
  }

  void addProduct(const Eigen::MatrixXd& in_u, const Eigen::MatrixXd& in_v, double weight) {
    const int count_v = v_.poles();
    for (int i = 0; i < u_.poles(); ++i)
      for (int k = std::max(0, i - sheet_degree); k <= i; ++k)
        for (int j = 0; j < count_v; ++j)
          for (int m = std::max(0, j - sheet_degree); m <= std::min(count_v - 1, j + sheet_degree);
               ++m) {
            const Index row = Index{i} * count_v + j, column = Index{k} * count_v + m;
            if (column > row) continue;
            for (int c = 0; c < 3; ++c)
              matrix_(3 * row + c, 3 * column + c) += weight * in_u(i, k) * in_v(j, m);
          }
  }

  GraphKnots u_, v_;
  linear::SymmetricBand matrix_;
  linear::BandCholesky factors_{linear::SymmetricBand()};
  Eigen::VectorXd right_, poles_;
};

double angleBetweenNormals(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The proof for each polynomial piece.
bool isRegular(const BSplineSurface& surface) {
  const BSplineSurface pieces =
      withRaisedKnots(withRaisedKnots(surface, SurfaceDirection::U, sheet_degree),
                      SurfaceDirection::V, sheet_degree);
  for (int i = 0; i + local <= pieces.countU(); i += sheet_degree)
    for (int j = 0; j + local <= pieces.countV(); j += sheet_degree) {
      BSplineSurface piece{.degree_u = sheet_degree,
                           .degree_v = sheet_degree,
                           .knots_u = std::vector<double>(2 * local, 1),
                           .knots_v = std::vector<double>(2 * local, 1),
                           .poles = HomogeneousPoles(local * local, 4)};
      std::fill_n(piece.knots_u.begin(), local, 0);
      std::fill_n(piece.knots_v.begin(), local, 0);
      for (int k = 0; k < local; ++k)
        piece.poles.middleRows(Index{k} * local, local) =
            pieces.poles.middleRows(Index{i + k} * pieces.countV() + j, local);
      if (!provedRegular(bezierPatch(piece))) return false;
    }
  return true;
}

/// Where a side is missed. What is to be small is one of the largest: an angle, or a gap as an
/// angle over a short way.
struct SheetMiss {
  Vector2d at;
  std::size_t side = 0;
  double gap = 0, angle_rad = 0, largest_rad = 0;
};

double worstOf(const std::vector<SheetMiss>& misses) {
  return std::ranges::max_element(misses, {}, &SheetMiss::largest_rad)->largest_rad;
}

/// The four sides, in units of half the diagonal of their box.
class SheetBorder {
 public:
  explicit SheetBorder(const std::array<SheetFillSide, 4>& sides) : sides_(sides) { takeScale(); }

 protected:
  /// \throws std::invalid_argument for a side without length.
  void takeScale() {
    constexpr int count = 32;
    Eigen::AlignedBox3d box;
    Eigen::Vector4d lengths_mm = Eigen::Vector4d::Zero();
    for (std::size_t side = 0; side < 4; ++side)
      for (int k = 0; k < count; ++k) {
        const SheetSample sample = sampleOf(side, (k + 0.5) / count);
        box.extend(sample.point);
        lengths_mm(static_cast<Index>(side)) += sample.derivative.norm() / count;
      }
    if (!(lengths_mm.minCoeff() > 0))
      throw std::invalid_argument("a side of a sheet has no length");
    centre_ = box.center();
    unit_mm_ = 0.5 * box.diagonal().norm();
    range_ = 0.5 * (lengths_mm.head<2>() + lengths_mm.tail<2>()) / unit_mm_;
  }

  SheetSample sampleOf(std::size_t side, double share) const {
    const SheetSample sample = sides_[side].at(share);
    if (!sample.point.allFinite() || !sample.derivative.allFinite() || !sample.normal.allFinite() ||
        !sample.bend.allFinite())
      throw std::invalid_argument("a sample of a side of a sheet is not finite");
    return sample;
  }

  static int directionOf(std::size_t side) { return side % 2 == 0 ? 0 : 1; }
  static bool isBackward(std::size_t side) { return side >= 2; }

  Vector2d placeOf(std::size_t side, double share) const {
    const double along = isBackward(side) ? 1 - share : share;
    switch (side) {
      case 0:
        return {along * range_.x(), 0};
      case 1:
        return {range_.x(), along * range_.y()};
      case 2:
        return {along * range_.x(), range_.y()};
      default:
        return {0, along * range_.y()};
    }
  }

  /// Shares of a side that bound three pieces in each span.
  std::vector<double> sharesAlong(std::size_t side, const GraphKnots& knots) const {
    constexpr int pieces = 3;
    std::vector<double> shares;
    for (int span = 0; span < knots.spans(); ++span)
      for (int k = 0; k < pieces; ++k)
        shares.push_back((knots.begin(span) + k * knots.width(span) / pieces) /
                         range_(directionOf(side)));
    shares.push_back(1);
    if (isBackward(side)) {
      std::ranges::reverse(shares);
      for (double& share : shares) share = 1 - share;
    }
    shares.front() = nearest_share, shares.back() = 1 - nearest_share;
    return shares;
  }

  /// How much the side and its normal turn on a short piece, per unit.
  using Turn = Eigen::Matrix<double, 6, 1>;
  Turn turnOf(std::size_t side, double from, double to) const {
    const SheetSample a = sampleOf(side, from), b = sampleOf(side, to);
    Turn turn;
    turn << b.derivative.normalized() - a.derivative.normalized(), b.normal - a.normal;
    return turn / ((b.point - a.point).norm() / unit_mm_);
  }

  /// Whether the turning jumps at a share of a side.
  bool hasKink(std::size_t side, double joint) const {
    constexpr double step = 1e-3;         // of the side
    constexpr double least_kink = 0.02;   // of the turning
    constexpr double least_turn = 0.005;  // over the side
    if (joint < 4 * step || joint > 1 - 4 * step) return false;
    const Turn before = turnOf(side, joint - 2 * step, joint - step),
               after = turnOf(side, joint + step, joint + 2 * step);
    const Turn farther = turnOf(side, joint + 2 * step, joint + 4 * step) -
                         turnOf(side, joint - 4 * step, joint - 2 * step);
    // Of a smooth turning, the difference doubles with the distance.
    const double kink = (2 * (after - before) - farther).norm();
    return kink > std::max(least_kink * std::max(before.norm(), after.norm()),
                           least_turn / range_(directionOf(side)));
  }

  /// Knots of a direction at which the second derivatives have to jump.
  std::vector<double> bendsOf(int direction) const {
    constexpr double near = 1e-4;  // of the range: joints of opposite sides are one
    std::vector<double> bends;
    for (std::size_t side = static_cast<std::size_t>(direction); side < 4; side += 2)
      for (const double joint : sides_[side].joints) {
        const double at = range_(direction) * (isBackward(side) ? 1 - joint : joint);
        const bool is_new = std::ranges::none_of(
            bends, [&](double other) { return std::abs(other - at) < near * range_(direction); });
        if (is_new && hasKink(side, joint)) bends.push_back(at);
      }
    return bends;
  }

  std::array<SheetFillSide, 4> sides_;
  Vector3d centre_;
  double unit_mm_ = 1;
  Vector2d range_;  ///< of the parameters, in units
};

/// Adds the conditions to the equations of a sheet and solves these.
/// \returns false if the equations determine no sheet.
bool solveWith(const std::vector<SheetCondition>& conditions, Sheet& sheet) {
  for (const SheetCondition& one : conditions) sheet.add(one);
  if (!sheet.factorise() || !sheet.solve()) return false;
  // Each step adds what is missed to the right side, which makes the penalty exact in the limit
  // (the method of multipliers).
  constexpr int steps = 12;
  for (int step = 0; step < steps; ++step) {
    for (const SheetCondition& one : conditions)
      sheet.addRight(one, one.value - one.direction.dot(sheet.valueOf(one.row)));
    if (!sheet.solve()) return false;
  }
  return true;
}

}  // namespace sheet

using namespace sheet;

class SheetSequence::Filling : private sheet::SheetBorder {
 public:
  Filling(const std::array<SheetFillSide, 4>& sides, const SheetFillOptions& options)
      : SheetBorder(sides), options_(options) {
    constexpr int least_spans = 4;
    const double span = range_.minCoeff() / least_spans;
    const auto knots = [&](int direction) {
      const int spans = std::clamp(static_cast<int>(std::lround(range_(direction) / span)),
                                   least_spans, 4 * least_spans);
      return GraphKnots(0, range_(direction), spans, bendsOf(direction));
    };
    sheet_.emplace(knots(0), knots(1));
  }

  std::optional<SheetFill> next(const Progress& progress) {
    while (!ended_) {
      checkProgress(progress, shareAfter(round_));
      const std::optional<SheetFill> made = step();
      if (!made || !isMet(*made)) continue;
      any_met_ = true;
      return made;
    }
    if (any_met_) return std::nullopt;
    if (!nearest_) throw std::invalid_argument("the sides of the sheet do not determine it");
    any_met_ = true;
    return nearest_;
  }

 private:
  /// The sheet with the present knots; adds knots for the next. Nothing if the equations determine
  /// none.
  std::optional<SheetFill> step() {
    // A step counts as one that helps if the largest miss falls by a tenth.
    constexpr double helps = 0.9;
    constexpr int most_rounds = 16, patience = 4;
    if (!solve()) {
      ended_ = true;
      return std::nullopt;
    }
    const std::vector<SheetMiss> misses = missesOf();
    const double worst = worstOf(misses);
    idle_ = worst < helps * least_ ? 0 : idle_ + 1;
    least_ = std::min(least_, worst);
    SheetFill made = result(misses);
    if (!nearest_ || shareOf(made) < shareOf(*nearest_)) nearest_ = made;
    refine(misses, worst, idle_ > 0);
    level_ = std::max(least_rad, finer * level_);
    ended_ = ++round_ == most_rounds || idle_ == patience || sheet_->poles() > options_.most_poles;
    return made;
  }

  /// Of what is accepted.
  double shareOf(const SheetFill& made) const {
    const double gap = made.gap_mm / options_.gap_mm;
    return options_.angle_rad > 0 ? std::max(gap, made.angle_rad / options_.angle_rad) : gap;
  }
  bool isMet(const SheetFill& made) const { return made.regular && shareOf(made) <= met_enough; }

  const GraphKnots& knotsAlong(std::size_t side) const {
    return directionOf(side) == 0 ? sheet_->u() : sheet_->v();
  }

  /// The sheet with the present knots. \returns false if the equations determine none.
  bool solve() {
    // Weights grow while that lowers the misses by half. Those far above what the knots can meet
    // would leave no digits for the fairness, and the sheet would turn back.
    constexpr double helps = 0.5, least_share = 2e-3;
    constexpr double least_at_once_rad = 5e-7;
    double worst = HUGE_VAL;
    for (double level = level_;; level *= finer) {
      if (!solveOnce(level)) return std::isfinite(worst);
      before_ = sheet_->surface(Vector3d::Zero(), 1);
      const double now = worstOf(missesOf());
      if (!(now < helps * worst)) break;
      worst = now;
      level_ = level;
      if (level * finer < std::max(least_at_once_rad, least_share * worst)) break;
    }
    return true;
  }

  /// What is asked for at a sample of a side.
  void addConditions(std::size_t side, double share, double length, double level,
                     std::vector<SheetCondition>& conditions) {
    const SheetSample sample = sampleOf(side, share);
    const Vector2d at = placeOf(side, share);
    const Vector3d point = (sample.point - centre_) / unit_mm_;
    const auto weight = [&](double accepted) { return length * std::pow(accepted, -2); };
    const double gap = level * way_;
    for (int c = 0; c < 3; ++c)
      conditions.push_back({sheet_->row(at, 0, 0), Vector3d::Unit(c), point(c), weight(gap)});
    if (!(options_.angle_rad > 0)) return;
    const bool by_v = directionOf(side) == 0;  // the derivative across the side
    const SheetRow across = by_v ? sheet_->row(at, 0, 1) : sheet_->row(at, 1, 0);
    // The derivative of the sheet before across the side. Where it nearly vanished the condition
    // must not become infinite.
    constexpr double least_speed = 1e-2;
    double speed = 1;
    if (before_) {
      const SurfaceJet jet = seamwright::jet(*before_, at.x(), at.y());
      const Vector3d before = by_v ? jet.v : jet.u;
      // Into the hole: of parameters that grow for sides 0 and 3.
      const double sense = side == 0 || side == 3 ? 1 : -1;
      const Vector3d inward = sense * sample.normal.cross(sample.derivative).normalized();
      const double inward_speed = inward.dot(before);
      if (inward_speed < least_speed)  // the sheet turned back
        sheet_->add({across, inward, 1, length * options_.bend_weight});
      else
        addBend(sample, at, by_v, before, length);
      speed = std::max(least_speed, std::abs(inward_speed));
    }
    const double accepted = speed * level;
    conditions.push_back({across, sample.normal, 0, weight(accepted)});
  }

  /// Asks for the curvature of the surface beyond across the side, with less weight where it is
  /// large, as beside a pole.
  void addBend(const SheetSample& sample, const Vector2d& at, bool by_v, const Vector3d& across,
               double length) {
    const double bend = unit_mm_ * across.dot(sample.bend * across);
    const double wide = range_(by_v ? 1 : 0), turn = wide * bend;
    sheet_->add({by_v ? sheet_->row(at, 0, 2) : sheet_->row(at, 2, 0), sample.normal, bend,
                 length * options_.bend_weight / wide / (1 + turn * turn)});
  }

  /// \returns false if the equations determine no sheet.
  bool solveOnce(double level) {
    sheet_->clear();
    sheet_->addVariation();
    std::vector<SheetCondition> conditions;
    for (std::size_t side = 0; side < 4; ++side) {
      const std::vector<double> shares = sharesAlong(side, knotsAlong(side));
      for (std::size_t k = 0; k + 1 < shares.size(); ++k)
        addConditions(side, 0.5 * (shares[k] + shares[k + 1]),
                      (shares[k + 1] - shares[k]) * range_(directionOf(side)), level, conditions);
    }
    return solveWith(conditions, *sheet_);
  }

  std::vector<SheetMiss> missesOf() const {
    std::vector<SheetMiss> misses;
    for (std::size_t side = 0; side < 4; ++side)
      for (const double share : sharesAlong(side, knotsAlong(side))) {
        const SheetSample sample = sampleOf(side, share);
        const Vector2d at = placeOf(side, share);
        const Vector3d u = sheet_->valueOf(sheet_->row(at, 1, 0)),
                       v = sheet_->valueOf(sheet_->row(at, 0, 1));
        SheetMiss miss{.at = at, .side = side};
        miss.gap =
            (sheet_->valueOf(sheet_->row(at, 0, 0)) - (sample.point - centre_) / unit_mm_).norm();
        miss.angle_rad = angleBetweenNormals(sample.normal, u.cross(v));
        miss.largest_rad = miss.gap / way_;
        if (options_.angle_rad > 0) miss.largest_rad = std::max(miss.largest_rad, miss.angle_rad);
        misses.push_back(miss);
      }
    return misses;
  }

  SheetFill result(const std::vector<SheetMiss>& misses) const {
    SheetFill fill{.surface = sheet_->surface(centre_, unit_mm_)};
    for (const SheetMiss& miss : misses) {
      fill.gap_mm = std::max(fill.gap_mm, miss.gap * unit_mm_);
      fill.angle_rad = std::max(fill.angle_rad, miss.angle_rad);
    }
    fill.regular = isRegular(fill.surface);
    return fill;
  }

  /// Halves the spans where a side is missed. Spans across the side are halved only if that did not
  /// help.
  void refine(const std::vector<SheetMiss>& misses, double worst, bool both) {
    constexpr double poor = 0.3;  // of the largest miss
    std::vector<bool> in_u(static_cast<std::size_t>(sheet_->u().spans())),
        in_v(static_cast<std::size_t>(sheet_->v().spans()));
    for (const SheetMiss& miss : misses) {
      if (miss.largest_rad < poor * worst) continue;
      if (both || directionOf(miss.side) == 0)
        in_u[static_cast<std::size_t>(sheet_->u().spanAt(miss.at.x()))] = true;
      if (both || directionOf(miss.side) == 1)
        in_v[static_cast<std::size_t>(sheet_->v().spanAt(miss.at.y()))] = true;
    }
    GraphKnots u = sheet_->u(), v = sheet_->v();
    u.halve(in_u);
    v.halve(in_v);
    sheet_.emplace(std::move(u), std::move(v));
  }

  SheetFillOptions options_;
  double way_ = 0.5 * std::min(1.0, range_.minCoeff());  ///< over which a gap is an angle, in units
  std::optional<Sheet> sheet_;
  std::optional<BSplineSurface> before_;  ///< the sheet of the step before, in units
  double level_ = 1e-3;                   ///< of misses that have the weight 1, as an angle
  std::optional<SheetFill> nearest_;
  double least_ = HUGE_VAL;  ///< the largest miss of the sheet whose largest miss is smallest
  int round_ = 0, idle_ = 0;
  bool any_met_ = false, ended_ = false;
};

SheetSequence::SheetSequence(const std::array<SheetFillSide, 4>& sides,
                             const SheetFillOptions& options) {
  if (!(options.gap_mm > 0) || !(options.angle_rad >= 0) || options.most_poles < 1 ||
      !(options.bend_weight >= 0))
    throw std::invalid_argument(
        "a sheet needs a gap above 0, an angle, a weight and a number of poles that are not "
        "negative");
  filling_ = std::make_unique<Filling>(sides, options);
}

SheetSequence::~SheetSequence() = default;
SheetSequence::SheetSequence(SheetSequence&&) noexcept = default;
SheetSequence& SheetSequence::operator=(SheetSequence&&) noexcept = default;

std::optional<SheetFill> SheetSequence::next(const Progress& progress) {
  return filling_->next(progress);
}

SheetFill sheetFill(const std::array<SheetFillSide, 4>& sides, const SheetFillOptions& options,
                    const Progress& progress) {
  return *SheetSequence(sides, options).next(progress);
}

}  // namespace seamwright
