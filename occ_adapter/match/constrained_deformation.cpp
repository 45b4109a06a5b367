// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/match/constrained_deformation.hpp>
#include <seamwright/occ_adapter/match/least_moves.hpp>
#include <seamwright/occ_adapter/match/match_reasons.hpp>
#include <seamwright/occ_adapter/match/side_basis.hpp>

namespace seamwright::occ {

namespace {

/// What the reference shows at a parameter of the side.
struct Target {
  double t = 0;
  Blend blend;
  Eigen::Vector3d point;
  std::optional<Eigen::Vector3d> normal;
  Eigen::Matrix3d curvature = Eigen::Matrix3d::Zero();
};

std::vector<Target> targetsOf(const EdgeRows& rows, const SideBasis& basis,
                              const Reference& reference) {
  std::vector<Target> targets;
  // More points in a span than a polynomial of its degree has coefficients: no row can meet them
  // all and swing between them.
  for (const double t : parametersInSpans(rows.knotsAlong(), std::max(4, rows.degreeAlong() + 1))) {
    const SidePoint point = reference.at(t);
    Target target{t, basis.at(t), point.jet.p, unitNormal(point.jet, point.noise), {}};
    target.curvature.setZero();
    if (target.normal) target.curvature = curvatureTensor(point.jet, *target.normal);
    targets.push_back(std::move(target));
  }
  return targets;
}

std::vector<int> columnsOf(const Target& target) {
  std::vector<int> columns(target.blend.share[0].cols());
  std::iota(columns.begin(), columns.end(), target.blend.first);
  return columns;
}

/// Moves the rows one after the other.
class RowDeformation {
 public:
  RowDeformation(EdgeRows& rows, const Reference& reference, const DeformationOptions& options)
      : rows_(rows), options_(options), basis_(rows), targets_(targetsOf(rows, basis_, reference)) {
    for (const int column : {0, rows.columns() - 1})
      collapsed_.push_back(isCollapsed(rows, column));
  }

  void run() {
    movePoints();
    for (int row = 1; row <= options_.order; ++row) moveRow(row);
  }

 private:
  int end(int which) const { return which == 0 ? 0 : rows_.columns() - 1; }

  void apply(int row, const LeastMoves& system) {
    // Rows that meet the points alike differ by the null space of the conditions; the damping takes
    // the one that moves least. It is squared, so conditions are met to 1e-10 of a move.
    constexpr double damping = 1e-5;
    const PointRows moves = system.solve(damping);
    for (int j = 0; j < rows_.columns(); ++j)
      rows_.setPole(row, j, rows_.pole(row, j) + moves.row(j).transpose());
    if (row == 0) first_row_ = moves;
  }

  void movePoints() {
    LeastMoves system(rows_.columns());
    for (const int which : {0, 1}) {
      const Eigen::Vector3d there = which == 0 ? targets_.front().point : targets_.back().point;
      Eigen::Vector3d move = there - rows_.pole(0, end(which));
      if (options_.hold_sides) move.setZero();
      system.fix(end(which), move);
    }
    for (const Target& target : targets_) {
      const Eigen::Vector3d missing = target.point - derivative(rows_, target.blend, 0);
      system.addPoint(columnsOf(target), target.blend.share[0].row(0), missing);
    }
    apply(0, system);
    for (const int which : {0, 1})
      if (collapsed_[which])
        for (int row = options_.order + 1; row < rows_.rows(); ++row)
          rows_.setPole(row, end(which), rows_.pole(0, end(which)));
  }

  void moveRow(int row) {
    LeastMoves system(rows_.columns());
    for (const int which : {0, 1}) {
      if (collapsed_[which]) system.fix(end(which), first_row_.row(end(which)).transpose());
      if (options_.hold_sides) system.fix(end(which), Eigen::Vector3d::Zero());
    }
    const double scale = 1 / basis_.leading(row);
    for (const Target& target : targets_) {
      if (!target.normal) continue;
      double value = -target.normal->dot(derivative(rows_, target.blend, row));
      if (row == 2) {
        const Eigen::Vector3d across = derivative(rows_, target.blend, 1);
        value += across.dot(target.curvature * across);
      }
      system.add(columnsOf(target), scale * target.blend.share[row].row(row), *target.normal,
                 Eigen::VectorXd::Constant(1, scale * value));
    }
    apply(row, system);
  }

  EdgeRows& rows_;
  const DeformationOptions& options_;
  SideBasis basis_;
  std::vector<Target> targets_;
  std::vector<bool> collapsed_;
  PointRows first_row_;
};

opencascade::handle<Geom_BSplineSurface> copyOf(const Geom_BSplineSurface& surface) {
  return opencascade::handle<Geom_BSplineSurface>::DownCast(surface.Copy());
}

/// Parameters of points where rows 0..order act.
std::vector<Eigen::Vector2d> gridOverRows(const EdgeRows& rows, int order, int across_points) {
  // A choice: more than two for each pole of a cubic span. The proof measures what lies between
  // them.
  constexpr int per_span = 9;
  const std::vector<double> knots = knotsFromSide(rows);
  const double reach = std::min(1.0, knots[order + rows.degreeAcross() + 1] / knots.back());
  std::vector<Eigen::Vector2d> parameters;
  for (const double t : parametersInSpans(rows.knotsAlong(), per_span))
    for (int k = 0; k < across_points; ++k)
      parameters.push_back(rows.parameters(t, reach * k / (across_points - 1)));
  return parameters;
}

using Height = std::function<double(const Eigen::Vector2d&)>;

/// The height of the local maximum above a point: steps to higher neighbours, halved where none is.
double heightAbove(Eigen::Vector2d at, const Eigen::AlignedBox2d& box, const Height& height) {
  // Steps begin with a sixteenth of the box and end with 2^-12 of it. Maxima are flat: what is
  // missed is of the order of the square.
  constexpr int halvings = 8;
  Eigen::Vector2d step = box.sizes() / 16;
  double highest = height(at);
  for (int halved = 0; halved < halvings;) {
    const double before = highest;
    for (const Eigen::Vector2d& direction : {Eigen::Vector2d(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      const Eigen::Vector2d next =
          (at + direction.cwiseProduct(step)).cwiseMax(box.min()).cwiseMin(box.max());
      if (const double value = height(next); value > highest) {
        highest = value;
        at = next;
      }
    }
    if (highest > before) continue;
    step /= 2;
    ++halved;
  }
  return highest;
}

/// The largest height over the box of a grid. Weights that change make peaks between its points, by
/// less than a quarter of what the points show; so the points near the largest are climbed from.
double largestOver(const std::vector<Eigen::Vector2d>& grid, const Height& height) {
  // 1 / 1.25: beside a lower point no peak is higher than the largest point.
  constexpr double near = 0.8;
  std::vector<double> heights;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& at : grid) {
    heights.push_back(height(at));
    box.extend(at);
  }
  double largest = *std::ranges::max_element(heights);
  const double least = near * largest;
  for (std::size_t i = 0; i < grid.size(); ++i)
    if (heights[i] >= least) largest = std::max(largest, heightAbove(grid[i], box, height));
  return largest;
}

}  // namespace

double ratioOf(const PairMeasure& pair, int order, const ContinuityTolerance& tolerance) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto over = [](double value, double limit) { return value == 0 ? 0 : value / limit; };
  double ratio = pair.gap_mm ? over(*pair.gap_mm, tolerance.gap_mm) : infinite;
  if (order > 0 && pair.angle_rad)
    ratio = std::max(ratio, over(*pair.angle_rad, tolerance.angle_rad));
  if (order > 0 && pair.fold) ratio = infinite;
  if (order > 1 && pair.curvature)
    ratio = std::max(ratio, over(relativeDifference(*pair.curvature, tolerance.flat_radius_mm),
                                 tolerance.curvature_rel));
  return ratio;
}

bool isCollapsed(const EdgeRows& rows, int column) {
  double size = 0, spread = 0;
  for (int row = 0; row < rows.rows(); ++row) {
    size = std::max(size, rows.pole(row, column).cwiseAbs().maxCoeff());
    spread = std::max(spread, (rows.pole(row, column) - rows.pole(0, column)).norm());
  }
  // Poles that a file or a knot insertion rounds: some tens of operations on a coordinate.
  return spread <= 64 * std::numeric_limits<double>::epsilon() * size;
}

double largestMove_mm(const EdgeRows& before, const EdgeRows& after, int order) {
  double largest = 0;
  bool same_weights = true;
  for (int row = 0; row < before.rows(); ++row)
    for (int column = 0; column < before.columns(); ++column) {
      largest = std::max(largest, (after.pole(row, column) - before.pole(row, column)).norm());
      same_weights = same_weights && before.weight(row, column) == after.weight(row, column);
    }
  if (same_weights) return largest;
  // A choice: peaks between points exceed them by less than largestOver() allows for.
  constexpr int across_points = 17;
  const auto distance = [&](const Eigen::Vector2d& at) {
    return before.surface()->Value(at[0], at[1]).Distance(after.surface()->Value(at[0], at[1]));
  };
  return std::max(largest, largestOver(gridOverRows(before, order, across_points), distance));
}

MovedSurface deformed(const EdgeRows& rows, const Reference& reference,
                      const DeformationOptions& options) {
  MovedSurface moved{rows.surface(), copyOf(*rows.surface()), 0};
  EdgeRows changed(moved.after, rows.edge(), rows.reversed());
  RowDeformation(changed, reference, options).run();
  moved.largest_move_mm = largestMove_mm(rows, changed, options.order);
  return moved;
}

std::vector<double> sampledRatios(const EdgeRows& rows, const Reference& reference,
                                  const DeformationOptions& options) {
  // As in gridOverRows().
  constexpr int per_span = 9;
  const std::vector<double> t = parametersInSpans(rows.knotsAlong(), per_span);
  std::vector<double> ratios;
  for (std::size_t first = 0; first + 1 < t.size(); first += per_span) {
    double worst = 0;
    for (std::size_t k = first; k <= first + per_span; ++k)
      worst = std::max(worst, ratioOf(measurePair(reference.at(t[k]), sidePoint(rows, t[k])),
                                      options.order, options.tolerance));
    ratios.push_back(worst);
  }
  return ratios;
}

MatchReason whySidesMove(const EdgeRows& rows, const Reference& reference,
                         const DeformationOptions& options) {
  const SideBasis basis(rows);
  for (const double t : {0.0, 1.0}) {
    const SidePoint there = reference.at(t);
    const Blend blend = basis.at(t);
    const double gap_mm = (there.jet.p - derivative(rows, blend, 0)).norm();
    if (gap_mm > options.tolerance.gap_mm) return match_why::sideEndsAway(gap_mm);
    const std::optional<Eigen::Vector3d> normal = unitNormal(there.jet, there.noise);
    const Eigen::Vector3d across = derivative(rows, blend, 1);
    if (!normal || across.norm() == 0) continue;
    const double angle_rad =
        std::asin(std::min(1.0, std::abs(normal->dot(across)) / across.norm()));
    if (angle_rad > options.tolerance.angle_rad)
      return match_why::sideEndsTilted(angle_rad * degrees_per_radian);
    if (options.order < 2) continue;
    const Eigen::Matrix3d tensor = curvatureTensor(there.jet, *normal);
    const double own = normal->dot(derivative(rows, blend, 2)) / across.squaredNorm();
    const double wanted = across.dot(tensor * across) / across.squaredNorm();
    const double largest =
        std::max({tensor.norm(), std::abs(own), 1 / options.tolerance.flat_radius_mm});
    if (std::abs(own - wanted) > options.tolerance.curvature_rel * largest)
      return match_why::sideEndsCurved(own, wanted);
  }
  return {};
}

bool isTurnedOver(const EdgeRows& before, const EdgeRows& after, int order) {
  // A choice: across the few rows that move, the normal changes little between five points.
  constexpr int across_points = 5;
  for (const Eigen::Vector2d& at : gridOverRows(before, order, across_points)) {
    gp_Pnt point;
    std::array<gp_Vec, 2> u, v;
    before.surface()->D1(at[0], at[1], point, u[0], v[0]);
    after.surface()->D1(at[0], at[1], point, u[1], v[1]);
    if (u[0].Crossed(v[0]).Dot(u[1].Crossed(v[1])) < 0) return true;
  }
  return false;
}

}  // namespace seamwright::occ
