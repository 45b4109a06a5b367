// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/join/ribbon.hpp>
#include <seamwright/core/umbrella/fill_curvature.hpp>
#include <seamwright/core/umbrella/fill_fairing.hpp>
#include <seamwright/core/umbrella/hole_corner.hpp>
#include <seamwright/core/umbrella/regular.hpp>

namespace seamwright::fill {

namespace {

using Eigen::Index, Eigen::Vector2d, Eigen::Vector3d;
/// A point or vector as an affine function of the unknowns: their coefficients, then the constant's x, y, z.
using Form = Eigen::RowVectorXd;

constexpr int places = 12;  ///< along each edge, besides its ends
/// Of the mean squared third derivative, or what differences make of it, in turn: jumps come down in steps.
constexpr std::array<double, 5> fairness_weights = {100, 10, 1, 1e-1, 1e-2};

/// Differences of poles become derivatives by this factor. Degrees 6 and higher are compared: their weights mean the same.
double derivativeScale(int degree, int order) {
  double scale = 1;
  for (int k = 0; k < order; ++k) scale *= static_cast<double>(degree - k) / (6 - k);
  return scale;
}

double placeOf(int k) {
  return static_cast<double>(k) / places;
}

/// Bernstein polynomials of a degree, their first or second derivatives at t.
Eigen::VectorXd basis(int degree, double t, int derivative) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(degree + 1);
  for (int i = 0; i <= degree; ++i) {
    rows::Field<1> unit = Eigen::VectorXd::Unit(degree + 1, i);
    for (int k = 0; k < derivative; ++k) unit = rows::derivative<1>(unit);
    Eigen::VectorXd b = unit;
    for (Index n = b.size() - 1; n > 0; --n)
      for (Index j = 0; j < n; ++j) b(j) = (1 - t) * b(j) + t * b(j + 1);
    values(i) = b(0);
  }
  return values;
}

/// A patch along one of its edges, as far as curvature asks: x runs into it, s along the edge.
struct Strip {
  Vector3d x, s, xx, xs, ss;
};

Strip stripAt(const Ribbon& ribbon, double t) {
  const auto field = [](const HomogeneousPoles& poles) { return BezierCurve(Poles(poles.leftCols<3>())); };
  const CurveJet edge = field(ribbon.position).jet(t), first = field(ribbon.first).jet(t);
  return {first.p, edge.d1, field(ribbon.second).point(t), first.d1, edge.d2};
}

/// What a jump is measured by: sum of weights times vectors of one or two strips, along the normal.
struct OuterPlace {
  Vector3d normal;
  double wanted = 0;  ///< of xx along the normal
  double scale = 0;   ///< from there to the normal curvature
};

OuterPlace outerPlace(const Strip& strip, const FillSide& side, double t) {
  const CurveJet edge = side.edge.jet(t), cross = BezierCurve(*side.cross).jet(t);
  const Vector3d normal = strip.x.cross(strip.s).normalized();
  const Vector2d c = combination(cross.p, edge.d1, strip.x);
  const Vector3d beyond =
      c(0) * c(0) * BezierCurve(*side.bend).point(t) + 2 * c(0) * c(1) * cross.d1 + c(1) * c(1) * edge.d2;
  const double across = strip.x.cross(strip.s).norm() / strip.s.norm();
  return {normal, normal.dot(beyond), 1 / (across * across)};
}

struct InnerPlace {
  Vector3d normal;
  double alpha = 0, beta = 0;  ///< x of the patch after is alpha x + beta s of the one before
  double scale = 0;
};

InnerPlace innerPlace(const Strip& before, const Strip& after) {
  const Vector3d normal = after.s.cross(after.x).normalized();
  const Vector2d c = combination(before.x, after.s, after.x);
  const double across = after.x.cross(after.s).norm() / after.s.norm();
  return {normal, c(0), c(1), 1 / (across * across)};
}

struct Ribbons {
  Ribbon before, after;
};

Ribbons ribbonsOf(const std::vector<BezierPatch>& patches, const InnerEdge& edge) {
  return {ribbon(patches[edge.before], edge.before_edge, edge.reversed, Across::Into),
          ribbon(patches[edge.after], edge.after_edge, false, Across::Into)};
}

bool isKnown(const FillSide& side) {
  return side.cross && side.bend;
}

/// The least-squares problem of all three coordinates together.
class Problem {
 public:
  Problem(const FillSpace& space, int order) : space_(space), count_(space.coefficients.cols()) {
    forms_.resize(space.coefficients.rows(), count_ + 3);
    forms_ << space.coefficients, space.constants;
    const Eigen::MatrixXd rows = derivativeScale(space.degree, order) * differencesOf(space, forms_, order);
    fair_ = rows.leftCols(count_).transpose() * rows;
  }

  void begin(double fairness) {
    matrix_ = Eigen::MatrixXd::Zero(3 * count_, 3 * count_);
    right_ = Eigen::VectorXd::Zero(3 * count_);
    for (int c = 0; c < 3; ++c) {
      matrix_.block(c * count_, c * count_, count_, count_) = fairness * fair_.leftCols(count_);
      right_.segment(c * count_, count_) = -fairness * fair_.col(count_ + c);
    }
    rows_.clear(), normals_.clear(), values_.clear();
  }

  /// weight (normal . form - wanted) is to be small.
  void add(const Form& form, const Vector3d& normal, double wanted, double weight) {
    rows_.push_back(weight * form.head(count_));
    normals_.push_back(normal);
    values_.push_back(weight * (wanted - form.tail<3>().dot(normal)));
  }

  Poles solve() {
    const Index size = static_cast<Index>(rows_.size());
    Eigen::MatrixXd all(size, count_);
    for (Index i = 0; i < size; ++i) all.row(i) = rows_[i];
    for (int c = 0; c < 3; ++c) {
      Eigen::VectorXd values(size);
      for (Index i = 0; i < size; ++i) values(i) = normals_[i](c) * values_[i];
      right_.segment(c * count_, count_) += all.transpose() * values;
      for (int d = 0; d < 3; ++d) {
        Eigen::VectorXd weights(size);
        for (Index i = 0; i < size; ++i) weights(i) = normals_[i](c) * normals_[i](d);
        matrix_.block(c * count_, d * count_, count_, count_) += all.transpose() * weights.asDiagonal() * all;
      }
    }
    // Unknowns that move no pole, or that all fills leave free, stay near zero.
    matrix_.diagonal().array() += 1e-13 * matrix_.diagonal().maxCoeff();
    const Eigen::VectorXd solution = matrix_.ldlt().solve(right_);
    Poles unknowns(count_, 3);
    for (int c = 0; c < 3; ++c) unknowns.col(c) = solution.segment(c * count_, count_);
    return unknowns;
  }

  /// Derivatives of a patch along an edge: of order 0 to 2 into it, and along.
  Form form(int patch, PatchEdge edge, bool reversed, double t, int across, int along) const {
    const int n = space_.degree;
    const Eigen::VectorXd weights = basis(n, t, along);
    const std::array<std::array<double, 3>, 3> stencils = {
        {{1, 0, 0}, {-1.0 * n, 1.0 * n, 0}, {1.0 * n * (n - 1), -2.0 * n * (n - 1), 1.0 * n * (n - 1)}}};
    Form result = Form::Zero(forms_.cols());
    for (int k = 0; k <= n; ++k)
      for (int r = 0; r <= across; ++r)
        result += weights(k) * stencils.at(across)[r] * forms_.row(poleOf(patch, edge, reversed, r, k));
    return result;
  }

 private:
  Index poleOf(int patch, PatchEdge edge, bool reversed, int r, int k) const {
    const int n = space_.degree, s = reversed ? n - k : k;
    switch (edge) {
      case PatchEdge::U0:
        return space_.row(patch, r, s);
      case PatchEdge::U1:
        return space_.row(patch, n - r, s);
      case PatchEdge::V0:
        return space_.row(patch, s, r);
      default:
        return space_.row(patch, s, n - r);
    }
  }

  const FillSpace& space_;
  Index count_;
  Eigen::MatrixXd forms_, fair_, matrix_;
  Eigen::VectorXd right_;
  std::vector<Form> rows_;
  std::vector<Vector3d> normals_;
  std::vector<double> values_;
};

double sizeOf(const std::vector<FillSide>& sides) {
  double length = 0;
  for (const FillSide& side : sides) length += (side.edge.point(1) - side.edge.point(0)).norm();
  return length / static_cast<double>(sides.size());
}

void addOuter(Problem& problem, const std::vector<BezierPatch>& patches, const OuterEdge& edge,
              const FillSide& side, double weight) {
  const Ribbon along = ribbon(patches[edge.patch], edge.edge, false, Across::Into);
  for (int k = 0; k <= places; ++k) {
    const double s = placeOf(k);
    const OuterPlace place = outerPlace(stripAt(along, s), side, edge.from + s * (edge.to - edge.from));
    problem.add(problem.form(edge.patch, edge.edge, false, s, 2, 0), place.normal, place.wanted,
                weight * place.scale);
  }
}

void addInner(Problem& problem, const std::vector<BezierPatch>& patches, const InnerEdge& edge,
              double weight) {
  const Ribbons ribbons = ribbonsOf(patches, edge);
  for (int k = 0; k <= places; ++k) {
    const double t = placeOf(k);
    const InnerPlace place = innerPlace(stripAt(ribbons.before, t), stripAt(ribbons.after, t));
    const auto before = [&](int across, int along) {
      return problem.form(edge.before, edge.before_edge, edge.reversed, t, across, along);
    };
    const Form jump = problem.form(edge.after, edge.after_edge, false, t, 2, 0) -
                      place.alpha * place.alpha * before(2, 0) - 2 * place.alpha * place.beta * before(1, 1) -
                      place.beta * place.beta * before(0, 2);
    problem.add(jump, place.normal, 0, weight * place.scale);
  }
}

}  // namespace

FillEdges starEdges(int sides) {
  FillEdges edges;
  for (int k = 0; k < sides; ++k) {
    const std::size_t side = static_cast<std::size_t>(k);
    const int next = (k + 1) % sides;
    edges.outer.push_back({k, PatchEdge::V1, side, 0.5, 0});
    edges.outer.push_back({next, PatchEdge::U1, side, 0.5, 1});
    edges.inner.push_back({k, PatchEdge::U0, false, next, PatchEdge::V0});
  }
  return edges;
}

FillEdges ringEdges() {
  constexpr std::array<PatchEdge, 4> middle = {PatchEdge::V0, PatchEdge::U1, PatchEdge::V1, PatchEdge::U0};
  FillEdges edges;
  for (int k = 0; k < 4; ++k) {
    edges.outer.push_back({k, PatchEdge::U1, static_cast<std::size_t>(k), 0, 1});
    edges.inner.push_back({(k + 3) % 4, PatchEdge::V1, false, k, PatchEdge::V0});
    edges.inner.push_back({4, middle.at(k), k >= 2, k, PatchEdge::U0});
  }
  return edges;
}

double curvatureJump_per_mm(const std::vector<BezierPatch>& patches, const FillEdges& edges,
                            const std::vector<FillSide>& sides) {
  constexpr int finer = 3;
  double largest = 0;
  for (const OuterEdge& edge : edges.outer) {
    if (!isKnown(sides[edge.side])) continue;
    const Ribbon along = ribbon(patches[edge.patch], edge.edge, false, Across::Into);
    for (int k = 0; k <= finer * places; ++k) {
      const double s = placeOf(k) / finer;
      const Strip strip = stripAt(along, s);
      const OuterPlace place = outerPlace(strip, sides[edge.side], edge.from + s * (edge.to - edge.from));
      largest = std::max(largest, std::abs(place.normal.dot(strip.xx) - place.wanted) * place.scale);
    }
  }
  for (const InnerEdge& edge : edges.inner) {
    const Ribbons ribbons = ribbonsOf(patches, edge);
    for (int k = 0; k <= finer * places; ++k) {
      const double t = placeOf(k) / finer;
      const Strip before = stripAt(ribbons.before, t), after = stripAt(ribbons.after, t);
      const InnerPlace place = innerPlace(before, after);
      const Vector3d jump = after.xx - place.alpha * place.alpha * before.xx -
                            2 * place.alpha * place.beta * before.xs - place.beta * place.beta * before.ss;
      largest = std::max(largest, std::abs(place.normal.dot(jump)) * place.scale);
    }
  }
  return largest;
}

std::vector<BezierPatch> leastCurvatureJump(
    const FillSpace& space, const std::vector<BezierPatch>& given, const FillEdges& edges,
    const std::vector<FillSide>& sides, int order,
    const std::function<std::vector<BezierPatch>(const Poles& unknowns)>& patchesOf) {
  const double size_mm = sizeOf(sides), weight = size_mm * size_mm;
  Problem problem(space, order);
  std::vector<BezierPatch> best = given, at = given;
  double least = curvatureJump_per_mm(best, edges, sides);
  for (const double fairness : fairness_weights) {
    problem.begin(fairness);
    for (const OuterEdge& edge : edges.outer)
      if (isKnown(sides[edge.side])) addOuter(problem, at, edge, sides[edge.side], weight);
    for (const InnerEdge& edge : edges.inner) addInner(problem, at, edge, weight);
    at = patchesOf(problem.solve());
    if (!std::ranges::all_of(at, [](const BezierPatch& patch) { return provedRegular(patch); })) break;
    const double jump = curvatureJump_per_mm(at, edges, sides);
    if (jump < least) best = at, least = jump;
  }
  return best;
}

}  // namespace seamwright::fill
