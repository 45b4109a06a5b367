// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/occ_adapter/convert/closed_spline.hpp>
#include <seamwright/occ_adapter/repair/displacement.hpp>
#include <seamwright/occ_adapter/repair/hessian.hpp>
#include <seamwright/occ_adapter/repair/prepared_surface.hpp>

namespace seamwright::occ {

namespace {

using SplineSurface = opencascade::handle<Geom_BSplineSurface>;

SplineSurface copied(const SplineSurface& surface) {
  return SplineSurface::DownCast(surface->Copy());
}

/// Distinct knots within the domain, with multiplicities.
struct KnotLine {
  std::vector<double> knots;
  std::vector<int> multiplicities;
};

KnotLine knotLine(const Geom_BSplineSurface& surface, int direction) {
  KnotLine line;
  const int count = direction == 0 ? surface.NbUKnots() : surface.NbVKnots();
  for (int i = 1; i <= count; ++i) {
    line.knots.push_back(direction == 0 ? surface.UKnot(i) : surface.VKnot(i));
    line.multiplicities.push_back(direction == 0 ? surface.UMultiplicity(i)
                                                 : surface.VMultiplicity(i));
  }
  return line;
}

/// Whether second derivatives of the surface may jump at the knot.
bool bendsAt(const Geom_BSplineSurface& surface, int direction, double knot) {
  const KnotLine own = knotLine(surface, direction);
  const auto found = std::ranges::find(own.knots, knot);
  const int degree = direction == 0 ? surface.UDegree() : surface.VDegree();
  return found != own.knots.end() && own.multiplicities[found - own.knots.begin()] >= degree - 1;
}

void insertKnots(Geom_BSplineSurface& surface, int direction, const KnotLine& line) {
  if (line.knots.empty()) return;
  TColStd_Array1OfReal knots(1, static_cast<int>(line.knots.size()));
  TColStd_Array1OfInteger multiplicities(1, knots.Length());
  std::ranges::copy(line.knots, knots.begin());
  std::ranges::copy(line.multiplicities, multiplicities.begin());
  if (direction == 0)
    surface.InsertUKnots(knots, multiplicities, 0, false);
  else
    surface.InsertVKnots(knots, multiplicities, 0, false);
}

/// Whether the denominator varies in u, and in v. For an arc swept along a curve it varies only
/// along the arc.
std::array<bool, 2> denominatorVaries(const Geom_BSplineSurface& surface) {
  std::array<bool, 2> varies = {false, false};
  const auto differ = [](double a, double b) { return std::abs(a - b) > Epsilon(std::abs(a)); };
  for (int i = 1; i <= surface.NbUPoles(); ++i)
    for (int j = 1; j <= surface.NbVPoles(); ++j) {
      if (differ(surface.Weight(i, j), surface.Weight(1, j))) varies[0] = true;
      if (differ(surface.Weight(i, j), surface.Weight(i, 1))) varies[1] = true;
    }
  return varies;
}

/// Whether the denominator varies along a side. \param side poles, as SurfaceBasis counts them.
bool denominatorVaries(const Geom_BSplineSurface& surface, const std::vector<int>& side) {
  // Relative difference of weights that count as equal.
  constexpr double same_share = 1e-6;
  const auto weight = [&surface](int pole) {
    return surface.Weight(pole / surface.NbVPoles() + 1, pole % surface.NbVPoles() + 1);
  };
  return std::ranges::any_of(side, [&](int pole) {
    return !(std::abs(weight(pole) - weight(side.front())) <= same_share * weight(side.front()));
  });
}

/// Whether the surface is rational and its denominator has continuous first derivatives.
bool hasSmoothDenominator(const Geom_BSplineSurface& surface) {
  const std::array<bool, 2> varies = denominatorVaries(surface);
  const auto isSmooth = [&](int direction) {
    const std::vector<int> multiplicities = knotLine(surface, direction).multiplicities;
    const int degree = direction == 0 ? surface.UDegree() : surface.VDegree();
    const bool is_periodic = direction == 0 ? surface.IsUPeriodic() : surface.IsVPeriodic();
    const std::ptrdiff_t ends = is_periodic ? 0 : 1;
    return !varies[direction] ||
           std::all_of(multiplicities.begin() + ends, multiplicities.end() - ends,
                       [degree](int multiplicity) { return multiplicity < degree; });
  };
  return (varies[0] || varies[1]) && isSmooth(0) && isSmooth(1);
}

/// The inner knots of the first line that the second one lacks, with the multiplicities of the
/// first.
KnotLine lacking(const KnotLine& has, const KnotLine& lacks) {
  KnotLine missing;
  for (std::size_t i = 1; i + 1 < has.knots.size(); ++i) {
    const auto found = std::ranges::find(lacks.knots, has.knots[i]);
    if (found != lacks.knots.end() &&
        lacks.multiplicities[found - lacks.knots.begin()] >= has.multiplicities[i])
      continue;
    missing.knots.push_back(has.knots[i]);
    missing.multiplicities.push_back(has.multiplicities[i]);
  }
  return missing;
}

/// The knot nearest to \p at if it is within the distance; otherwise \p at.
double snapped(double at, const std::vector<double>& knots, double within) {
  const auto nearest =
      std::ranges::min_element(knots, {}, [at](double knot) { return std::abs(knot - at); });
  return std::abs(*nearest - at) <= within ? *nearest : at;
}

/// Equally spaced knots over the range. A knot of the surface is taken if it is near, so that fewer
/// knots are inserted into X at the end.
std::vector<double> coarseKnots(const KnotLine& own, double from, double to, int spans) {
  // A knot moves by at most 0.35 of the spacing, so neighbours stay 1 - 2 * 0.35 = 0.3 of it apart.
  constexpr double moved_share = 0.35, least_share = 0.3;
  const double first = own.knots.front(), last = own.knots.back();
  from = std::clamp(from, first, last);
  to = std::clamp(to, first, last);
  const double spacing = (to - from) / spans;
  std::vector<double> knots = {first};
  for (int k = 0; k <= spans; ++k) {
    const double at = snapped(from + k * spacing, own.knots, moved_share * spacing);
    if (at > knots.back() + least_share * spacing && at < last - least_share * spacing)
      knots.push_back(at);
  }
  knots.push_back(last);
  return knots;
}

/// The number of continuous derivatives that the knots of a periodic surface guarantee where it
/// closes.
int smoothnessAtClosing(const Geom_BSplineSurface& surface, int direction) {
  return direction == 0 ? surface.UDegree() - surface.UMultiplicity(1)
                        : surface.VDegree() - surface.VMultiplicity(1);
}

TColStd_Array1OfReal arrayOf(const std::vector<double>& values) {
  TColStd_Array1OfReal array(1, static_cast<int>(values.size()));
  std::ranges::copy(values, array.begin());
  return array;
}

/// Nodes in (0, 1) and weights whose sum is 1.
struct GaussRule {
  std::vector<double> nodes, weights;
};

GaussRule gaussRule(int points) {
  const auto around = [](const std::vector<double>& half, const std::vector<double>& weights) {
    GaussRule rule;
    for (std::size_t k = 0; k < half.size(); ++k)
      for (const double side : {-1.0, 1.0}) {
        if (half[k] == 0 && side > 0) continue;
        rule.nodes.push_back(0.5 + 0.5 * side * half[k]);
        rule.weights.push_back(0.5 * weights[k]);
      }
    return rule;
  };
  if (points <= 3) return around({0, std::sqrt(0.6)}, {8.0 / 9, 5.0 / 9});
  const double root = 2.0 / 7 * std::sqrt(1.2);
  return around({std::sqrt(3.0 / 7 - root), std::sqrt(3.0 / 7 + root)},
                {(18 + std::sqrt(30.0)) / 36, (18 - std::sqrt(30.0)) / 36});
}

std::vector<int> sortedOnce(std::vector<int> numbers) {
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

}  // namespace

Displacement::Displacement(const SplineSurface& given, const std::array<double, 4>& face_range,
                           int spans, double near_mm, bool bends_at_closing,
                           const std::optional<std::array<int, 2>>& degrees)
    : Displacement(prepared(given, near_mm), given->IsUPeriodic() || given->IsVPeriodic(),
                   face_range, spans, near_mm, bends_at_closing, degrees) {}

Displacement::Displacement(const PreparedSurface& given, bool given_periodic,
                           const std::array<double, 4>& face_range, int spans, double near_mm,
                           bool bends_at_closing,
                           const std::optional<std::array<int, 2>>& of_denominator)
    : given_(given.surface),
      collapse_mm_(given.collapse_mm),
      range_(face_range),
      near_mm_(near_mm),
      given_periodic_(given_periodic),
      degrees_(of_denominator.value_or(std::array<int, 2>{given_->UDegree(), given_->VDegree()})),
      given_basis_(*given_),
      basis_(*given_),
      given_poles_(polesOf(*given_)) {
  // With simple knots degree 3 gives two continuous derivatives.
  constexpr int least_degree = 3;
  // A choice: higher degrees couple more coefficients, which fills the matrix, and spans adapt
  // better.
  constexpr int most_degree = 5;
  const int u = std::clamp(degrees_[0], least_degree, most_degree),
            v = std::clamp(degrees_[1], least_degree, most_degree);
  const std::array<int, 2> degrees = {u, v};
  const std::array<bool, 2> periodic = {static_cast<bool>(given_->IsUPeriodic()),
                                        static_cast<bool>(given_->IsVPeriodic())};
  std::array<std::vector<double>, 2> knots;
  std::array<TColStd_Array1OfInteger, 2> multiplicities;
  std::array<int, 2> poles_count{};
  for (const int k : {0, 1}) {
    const KnotLine own = knotLine(*given_, k);
    knots[k] = periodic[k] ? coarseKnots(own, own.knots.front(), own.knots.back(),
                                         std::max(spans, degrees[k] + 1))
                           : coarseKnots(own, range_[2 * k], range_[2 * k + 1], spans);
    const int count = static_cast<int>(knots[k].size());
    multiplicities[k].Resize(1, count, false);
    multiplicities[k].Init(1);
    const int ends = !periodic[k]       ? degrees[k] + 1
                     : bends_at_closing ? std::max(1, degrees[k] - smoothnessAtClosing(*given_, k))
                                        : 1;
    multiplicities[k](1) = multiplicities[k](count) = ends;
    poles_count[k] = periodic[k] ? count - 2 + ends : count + degrees[k] - 1;
  }
  shape_ = new Geom_BSplineSurface(TColgp_Array2OfPnt(1, poles_count[0], 1, poles_count[1]),
                                   arrayOf(knots[0]), arrayOf(knots[1]), multiplicities[0],
                                   multiplicities[1], u, v, periodic[0], periodic[1]);
  const Eigen::RowVector3d centre = given_poles_.colwise().mean();
  size_mm_ = 2 * (given_poles_.rowwise() - centre).rowwise().norm().maxCoeff();
  basis_ = SurfaceBasis(*shape_);
  has_denominator_ =
      hasSmoothDenominator(*given_) &&
      std::ranges::none_of(collapsedSides(given_basis_, given_poles_, near_mm_),
                           [this](const auto& side) { return denominatorVaries(*given_, side); });
  number();
  coefficients_ = PointRows::Zero(count_, 3);
}

/// Numbers the coefficients. A side that is one point has one coefficient.
void Displacement::number() {
  const int columns = basis_.v().poles, rows = basis_.u().poles;
  number_.assign(static_cast<std::size_t>(rows) * columns, -1);
  count_ = 0;
  const int given_columns = given_basis_.v().poles;
  for (const std::vector<int>& side : collapsedSides(given_basis_, given_poles_, near_mm_)) {
    const bool along_v = side.size() < 2 || side[1] - side[0] == 1;
    const bool is_first =
        along_v ? side.front() / given_columns == 0 : side.front() % given_columns == 0;
    for (int k = 0; k < (along_v ? columns : rows); ++k) {
      const int pole = along_v ? basis_.pole(is_first ? 0 : rows - 1, k)
                               : basis_.pole(k, is_first ? 0 : columns - 1);
      number_[pole] = count_;
    }
    ++count_;
  }
  for (int& number : number_)
    if (number < 0) number = count_++;
}

PoleShares Displacement::shares(const Eigen::Vector2d& uv, const Eigen::Vector2d& into) const {
  PoleShares shares = basis_.at(uv, into, 2);
  if (has_denominator_) divide(shares, given_basis_.denominator(uv, into));
  for (int& pole : shares.poles) pole = number_[pole];
  return shares;
}

double Displacement::denominator(const Eigen::Vector2d& uv) const {
  return has_denominator_ ? given_basis_.denominator(uv, Eigen::Vector2d::Zero())[0] : 1;
}

std::vector<int> Displacement::coefficientsNear(const Eigen::Vector2d& uv) const {
  std::vector<int> near;
  const std::vector<int> near_u = basis_.u().polesNear(uv[0]), near_v = basis_.v().polesNear(uv[1]);
  for (const int i : near_u)
    for (const int j : near_v) near.push_back(number_[basis_.pole(i, j)]);
  return near;
}

std::vector<int> Displacement::coefficientsOfSide(int fixed, bool at_last) const {
  const int rows = basis_.u().poles, columns = basis_.v().poles;
  std::vector<int> side;
  for (int k = 0; k < (fixed == 0 ? columns : rows); ++k)
    side.push_back(number_[fixed == 0 ? basis_.pole(at_last ? rows - 1 : 0, k)
                                      : basis_.pole(k, at_last ? columns - 1 : 0)]);
  return side;
}

SurfaceJet Displacement::given(const Eigen::Vector2d& uv, const Eigen::Vector2d& into) const {
  return jetOf(given_basis_.at(uv, into, 2), given_poles_);
}

SurfaceJet Displacement::moved(SurfaceJet given, const PoleShares& shares) const {
  const SurfaceJet by = jetOf(shares, coefficients_);
  given.p += by.p;
  given.u += by.u;
  given.v += by.v;
  given.uu += by.uu;
  given.uv += by.uv;
  given.vv += by.vv;
  return given;
}

SplineSurface Displacement::displacementSurface() const {
  const SplineSurface surface = copied(shape_);
  for (int i = 0; i < basis_.u().poles; ++i)
    for (int j = 0; j < basis_.v().poles; ++j) {
      const auto d = coefficients_.row(number_[basis_.pole(i, j)]);
      surface->SetPole(i + 1, j + 1, gp_Pnt(d[0], d[1], d[2]));
    }
  return surface;
}

bool Displacement::halve(const std::array<std::set<int>, 2>& spans) {
  const SplineSurface refined = displacementSurface();
  bool any = false;
  for (const int direction : {0, 1}) {
    const SplineAxis& axis = direction == 0 ? basis_.u() : basis_.v();
    const std::vector<double> own = knotLine(*given_, direction).knots;
    std::map<double, int> inserted;  // by knot: its multiplicity
    for (const int span : spans[direction]) {
      const double length = axis.length(span);
      // A knot of the surface in the middle half of the span is taken, as in coarseKnots().
      inserted.emplace(snapped(axis.middle(span), own, 0.25 * length), 1);
      for (const double knot : {axis.knots[span], axis.knots[span + 1]})
        if (knot > axis.first && knot < axis.last && bendsAt(*given_, direction, knot))
          inserted[knot] = axis.degree - 1;
    }
    any = any || !inserted.empty();
    KnotLine line;
    for (const auto& [knot, multiplicity] : inserted) {
      line.knots.push_back(knot);
      line.multiplicities.push_back(multiplicity);
    }
    insertKnots(*refined, direction, line);
  }
  if (!any) return false;
  const PointRows poles = polesOf(*refined);
  shape_ = refined;
  basis_ = SurfaceBasis(*shape_);
  number();
  coefficients_ = PointRows::Zero(count_, 3);
  for (Eigen::Index pole = 0; pole < poles.rows(); ++pole)
    coefficients_.row(number_[pole]) = poles.row(pole);
  return true;
}

EnergyBlock Displacement::bendingOfSpan(int span_u, int span_v, double least_metric) const {
  // Weight of the energy beyond the parameters that the face shows, see bending().
  constexpr double share_outside = 0.03;
  const SplineAxis &u = basis_.u(), &v = basis_.v();
  const GaussRule rule_u = gaussRule(u.degree), rule_v = gaussRule(v.degree);
  const auto isWithin = [this](const SplineAxis& axis, double t, int k) {
    return axis.periodic || (t >= range_[k] && t <= range_[k + 1]);
  };
  EnergyBlock block;
  std::vector<Eigen::Index> column;  // by index among the span's poles
  Eigen::MatrixXd rows;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < rule_u.nodes.size(); ++i)
    for (std::size_t j = 0; j < rule_v.nodes.size(); ++j, row += 3) {
      const Eigen::Vector2d uv(u.knots[span_u] + rule_u.nodes[i] * u.length(span_u),
                               v.knots[span_v] + rule_v.nodes[j] * v.length(span_v));
      const PoleShares of_point = shares(uv, Eigen::Vector2d::Zero());
      if (column.empty()) {
        block.coefficients = sortedOnce(of_point.poles);
        for (const int pole : of_point.poles)
          column.push_back(std::ranges::lower_bound(block.coefficients, pole) -
                           block.coefficients.begin());
        rows = Eigen::MatrixXd::Zero(3 * std::ssize(rule_u.nodes) * std::ssize(rule_v.nodes),
                                     std::ssize(block.coefficients));
      }
      const SurfaceJet jet = given(uv, Eigen::Vector2d::Zero());
      const bool is_within = isWithin(u, uv[0], 0) && isWithin(v, uv[1], 2);
      const double area = std::max(jet.u.cross(jet.v).norm(), least_metric) * rule_u.weights[i] *
                          rule_v.weights[j] * u.length(span_u) * v.length(span_v) *
                          (is_within ? 1 : share_outside);
      const Eigen::MatrixXd hessian = hessianShares(of_point, jet, least_metric);
      for (std::size_t k = 0; k < column.size(); ++k)
        rows.block<3, 1>(row, column[k]) +=
            std::sqrt(area) * hessian.col(static_cast<Eigen::Index>(k));
    }
  block.matrix = rows.transpose() * rows;
  return block;
}

std::vector<EnergyBlock> Displacement::bending() const {
  // Keeps the metric regular at degenerate points, relative to its mean size.
  constexpr double share_of_metric = 1e-12;
  const SplineAxis &u = basis_.u(), &v = basis_.v();
  const double least_metric =
      share_of_metric * std::pow(size_mm_ / std::max(u.last - u.first, v.last - v.first), 2);
  std::vector<EnergyBlock> blocks;
  for (const int span_u : u.spans())
    for (const int span_v : v.spans())
      blocks.push_back(bendingOfSpan(span_u, span_v, least_metric));
  return blocks;
}

namespace {

/// Values of the polynomial basis functions of an axis, one row for each parameter.
Eigen::MatrixXd collocation(const SplineAxis& axis, const std::vector<double>& parameters) {
  Eigen::MatrixXd values =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(parameters.size()), axis.poles);
  for (std::size_t row = 0; row < parameters.size(); ++row) {
    double t = parameters[row];
    const int span = axis.span(t, 0);
    const Eigen::MatrixXd functions =
        bspline::basisDerivatives(axis.degree, axis.knots, span, t, 0);
    for (int k = 0; k <= axis.degree; ++k)
      values(static_cast<Eigen::Index>(row), axis.pole(span - axis.degree + k)) += functions(0, k);
  }
  return values;
}

/// Parameters for a fit: degree + 2 Chebyshev nodes in each span, one more than determine a
/// polynomial.
std::vector<double> fitParameters(const SplineAxis& axis) {
  std::vector<double> parameters;
  const int inside = axis.degree + 2;
  for (const int span : axis.spans())
    for (int k = 0; k < inside; ++k)
      parameters.push_back(axis.knots[span] +
                           (0.5 - 0.5 * std::cos((k + 0.5) * std::numbers::pi / inside)) *
                               axis.length(span));
  if (!axis.periodic) {
    parameters.front() = axis.first;
    parameters.back() = axis.last;
  }
  return parameters;
}

/// Replaces the moves of a side that is one point by their mean.
void joinSides(const SurfaceBasis& basis, const PointRows& given, double near_mm,
               PointRows& moves) {
  for (const std::vector<int>& side : collapsedSides(basis, given, near_mm)) {
    const Eigen::RowVector3d mean = moves(side, Eigen::indexing::all).colwise().mean();
    for (const int pole : side) moves.row(pole) = mean;
  }
}

}  // namespace

/// X in the knots of both, and the moves of its poles. W D, with W the denominator of X, is a
/// spline in these knots. If D has no denominator its degree is the sum of the degrees of W and D.
/// A least squares fit finds it exactly, to rounding.
std::pair<SplineSurface, PointRows> Displacement::refined() const {
  const SplineSurface x = copied(given_), d = copied(shape_);
  const std::array<bool, 2> varies = denominatorVaries(*x);
  const auto degree = [&](int direction, int of_x, int of_d) {
    return std::max(of_x,
                    varies[direction] && !has_denominator_ ? degrees_[direction] + of_d : of_d);
  };
  x->IncreaseDegree(degree(0, x->UDegree(), d->UDegree()), degree(1, x->VDegree(), d->VDegree()));
  // Raising the degree raises the multiplicities of D's knots too, so that D keeps its smoothness.
  d->IncreaseDegree(x->UDegree(), x->VDegree());
  for (const int direction : {0, 1})
    insertKnots(*x, direction, lacking(knotLine(*d, direction), knotLine(*x, direction)));
  const SurfaceBasis basis(*x);
  const std::vector<double> parameters_u = fitParameters(basis.u()),
                            parameters_v = fitParameters(basis.v());
  const Eigen::MatrixXd x_u = collocation(basis.u(), parameters_u),
                        x_v = collocation(basis.v(), parameters_v);
  const Eigen::MatrixXd d_u = collocation(basis_.u(), parameters_u),
                        d_v = collocation(basis_.v(), parameters_v);
  const Eigen::HouseholderQR<Eigen::MatrixXd> fit_u(x_u), fit_v(x_v);
  const int rows = basis.u().poles, columns = basis.v().poles;
  Eigen::MatrixXd weights = Eigen::MatrixXd::Ones(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) weights(i, j) = x->Weight(i + 1, j + 1);
  Eigen::MatrixXd factor = x_u * weights * x_v.transpose();
  // The weight is taken from the given surface: the first pole of a periodic surface changes with
  // degree and knots.
  if (has_denominator_) factor.setConstant(given_->Weight(1, 1));
  PointRows moves(static_cast<Eigen::Index>(rows) * columns, 3);
  for (int k = 0; k < 3; ++k) {
    Eigen::MatrixXd own(basis_.u().poles, basis_.v().poles);
    for (int i = 0; i < own.rows(); ++i)
      for (int j = 0; j < own.cols(); ++j) own(i, j) = coefficients_(number_[basis_.pole(i, j)], k);
    const Eigen::MatrixXd values = factor.cwiseProduct(d_u * own * d_v.transpose());
    const Eigen::MatrixXd half = fit_u.solve(values);
    const Eigen::MatrixXd fitted = fit_v.solve(half.transpose()).transpose();
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) moves(basis.pole(i, j), k) = fitted(i, j) / weights(i, j);
  }
  joinSides(basis, polesOf(*x), near_mm_, moves);
  return {x, moves};
}

/// The poles of the part over the face bound the moves of its points. A periodic surface is not
/// cut.
/// \param moves the moves as a surface.
double Displacement::largestOf(SplineSurface moves) const {
  std::array<double, 4> part{};
  moves->Bounds(part[0], part[1], part[2], part[3]);
  const std::array<bool, 2> periodic = {static_cast<bool>(moves->IsUPeriodic()),
                                        static_cast<bool>(moves->IsVPeriodic())};
  for (const int k : {0, 1}) {
    const double from = std::max(part[2 * k], range_[2 * k]),
                 to = std::min(part[2 * k + 1], range_[2 * k + 1]);
    if (!periodic[k] && from < to) std::tie(part[2 * k], part[2 * k + 1]) = std::pair(from, to);
  }
  if (!periodic[0] && !periodic[1]) moves->Segment(part[0], part[1], part[2], part[3]);
  return polesOf(*moves).rowwise().norm().maxCoeff() + collapse_mm_;
}

Displacement::Moved Displacement::moved() const {
  const auto [x, moves] = refined();
  const SplineSurface of_moves = copied(x);
  setPoles(*of_moves, moves);
  setPoles(*x, polesOf(*x) + moves);
  if ((x->IsUPeriodic() || x->IsVPeriodic()) && !given_periodic_) makeClamped(*x);
  return {x, largestOf(of_moves)};
}

}  // namespace seamwright::occ
