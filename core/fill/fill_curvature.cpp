// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <seamwright/core/fill/fill_curvature.hpp>
#include <seamwright/core/fill/fill_fairing.hpp>
#include <seamwright/core/fill/fill_forms.hpp>
#include <seamwright/core/fill/hole_corner.hpp>
#include <seamwright/core/fill/regular.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/join/ribbon.hpp>

namespace seamwright::fill {

namespace {

using Eigen::Index, Eigen::Vector2d, Eigen::Vector3d;
/// A point or vector as an affine function of the unknowns: their coefficients, then the constant's
/// x, y, z.
using Form = Eigen::RowVectorXd;

/// Jumps are measured at this number of parameters per parameter at which they are minimised.
constexpr int finer = 3;
constexpr Index last_sample = 3 * 12;  ///< index of the last parameter along each edge
/// Weights of the mean squared third derivative (from differences), used in turn. The decreasing
/// weights lower the jumps in steps.
constexpr std::array<double, 5> fairness_weights = {100, 10, 1, 1e-1, 1e-2};

/// Factor that converts differences of poles into derivatives, relative to degree 6. So the weights
/// have the same meaning in all degrees from 6 on.
double derivativeScale(int degree, int order) {
  double scale = 1;
  for (int k = 0; k < order; ++k) scale *= static_cast<double>(degree - k) / (6 - k);
  return scale;
}

/// The sampled parameters of an edge from one parameter to another.
Eigen::VectorXd sampledParameters(double from, double to) {
  Eigen::VectorXd all(last_sample + 1);
  for (Index k = 0; k <= last_sample; ++k)
    all(k) = from + static_cast<double>(k) / static_cast<double>(last_sample) * (to - from);
  return all;
}

/// Bernstein polynomials of a degree, or their derivatives: one row for each t.
Eigen::MatrixXd basisAt(const Eigen::VectorXd& t, Index degree, int order) {
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(t.size(), degree + 1);
  if (order > degree) return basis;
  Forms differences = Forms::Identity(degree + 1, degree + 1);
  for (int k = 0; k < order; ++k) differences = derivative(differences);
  basis.col(0).setOnes();
  for (Index n = 1; n <= degree - order; ++n)
    for (Index i = n; i >= 0; --i) {
      basis.col(i).array() *= 1 - t.array();
      if (i > 0) basis.col(i) += t.cwiseProduct(basis.col(i - 1));
    }
  return basis.leftCols(degree - order + 1) * differences;
}

Poles valuesAt(const Eigen::VectorXd& t, const Poles& polynomial, int order) {
  return basisAt(t, polynomial.rows() - 1, order) * polynomial;
}

Vector3d at(const Poles& vectors, Index sample) {
  return vectors.row(sample);
}

/// The derivatives of a patch along one edge that curvature needs, at all sampled parameters: x
/// runs into the patch, s along the edge.
struct Strip {
  Poles x, s, xx, xs, ss;
};

/// The surface on the other side of an edge of the fill, at the sampled parameters.
struct Beyond {
  Poles edge1, edge2, cross, cross1, bend;
};

/// The jump across an edge at a sampled parameter, along the normal: xx of the patch (or of the
/// patch after the edge) minus alpha^2 xx + 2 alpha beta xs + beta^2 ss of the patch before it,
/// minus the wanted value. The scale converts it into a normal curvature.
struct Jump {
  Index sample = 0;
  Vector3d normal = Vector3d::Zero();
  double alpha = 0, beta = 0, wanted = 0, scale = 0;
  double value_per_mm = 0;
};

double curvatureScale(const Vector3d& x, const Vector3d& s) {
  const double across = x.cross(s).norm() / s.norm();
  return 1 / (across * across);
}

Jump outerJump(const Strip& strip, const Beyond& beyond, Index sample) {
  const Vector3d x = at(strip.x, sample), s = at(strip.s, sample);
  Jump jump{sample, x.cross(s).normalized()};
  const Vector2d c = combination(at(beyond.cross, sample), at(beyond.edge1, sample), x);
  jump.wanted = jump.normal.dot(c(0) * c(0) * at(beyond.bend, sample) +
                                2 * c(0) * c(1) * at(beyond.cross1, sample) +
                                c(1) * c(1) * at(beyond.edge2, sample));
  jump.scale = curvatureScale(x, s);
  jump.value_per_mm = jump.scale * (jump.normal.dot(at(strip.xx, sample)) - jump.wanted);
  return jump;
}

Jump innerJump(const Strip& before, const Strip& after, Index sample) {
  const Vector3d x = at(after.x, sample), s = at(after.s, sample);
  Jump jump{sample, s.cross(x).normalized()};
  const Vector2d c = combination(at(before.x, sample), s, x);
  jump.alpha = c(0), jump.beta = c(1);
  jump.scale = curvatureScale(x, s);
  jump.value_per_mm =
      jump.scale * jump.normal.dot(at(after.xx, sample) - c(0) * c(0) * at(before.xx, sample) -
                                   2 * c(0) * c(1) * at(before.xs, sample) -
                                   c(1) * c(1) * at(before.ss, sample));
  return jump;
}

bool isKnown(const FillSide& side) {
  return side.cross && side.bend;
}

/// The jumps along the edges of a fill.
struct Jumps {
  std::vector<std::vector<Jump>> outer,
      inner;  ///< of each edge; empty if the other side is unknown
  double largest_per_mm = 0;
  double squares = 0;  ///< their sum
};

/// The sampled parameters at which jumps are measured.
class EdgeSamples {
 public:
  EdgeSamples(int degree, const FillEdges& edges, const std::vector<FillSide>& sides)
      : edges_(edges) {
    const Eigen::VectorXd even = sampledParameters(0, 1);
    for (int order = 0; order < 3; ++order) basis_[order] = basisAt(even, degree, order);
    for (const OuterEdge& edge : edges.outer) {
      const FillSide& side = sides[edge.side];
      beyond_.emplace_back();
      if (!isKnown(side)) continue;
      const Eigen::VectorXd t = sampledParameters(edge.from, edge.to);
      const Poles poles = side.edge.poles();
      beyond_.back() = {valuesAt(t, poles, 1), valuesAt(t, poles, 2), valuesAt(t, *side.cross, 0),
                        valuesAt(t, *side.cross, 1), valuesAt(t, *side.bend, 0)};
    }
  }

  const FillEdges& edges() const { return edges_; }
  /// The Bernstein polynomials of the patches' degree, or their derivatives.
  const Eigen::MatrixXd& basis(int order) const { return basis_.at(order); }

  Jumps jumps(const std::vector<BezierPatch>& patches) const {
    Jumps jumps;
    const auto add = [&](std::vector<std::vector<Jump>>& edges, const auto& jumpAt) {
      for (Index k = 0; k <= last_sample; ++k) {
        edges.back().push_back(jumpAt(k));
        const double jump = std::abs(edges.back().back().value_per_mm);
        jumps.largest_per_mm = std::max(jumps.largest_per_mm, jump);
        jumps.squares += jump * jump;
      }
    };
    for (std::size_t e = 0; e < edges_.outer.size(); ++e) {
      jumps.outer.emplace_back();
      if (beyond_[e].cross.rows() == 0) continue;
      const Strip strip = stripOf(patches[edges_.outer[e].patch], edges_.outer[e].edge, false);
      add(jumps.outer, [&](Index k) { return outerJump(strip, beyond_[e], k); });
    }
    for (const InnerEdge& edge : edges_.inner) {
      jumps.inner.emplace_back();
      const Strip before = stripOf(patches[edge.before], edge.before_edge, edge.reversed),
                  after = stripOf(patches[edge.after], edge.after_edge, false);
      add(jumps.inner, [&](Index k) { return innerJump(before, after, k); });
    }
    return jumps;
  }

 private:
  Strip stripOf(const BezierPatch& patch, PatchEdge edge, bool reversed) const {
    const Ribbon along = ribbon(patch, edge, reversed, Across::Into);
    const Poles position = along.position.leftCols<3>(), first = along.first.leftCols<3>(),
                second = along.second.leftCols<3>();
    return {basis_[0] * first, basis_[1] * position, basis_[0] * second, basis_[1] * first,
            basis_[2] * position};
  }

  const FillEdges& edges_;
  std::array<Eigen::MatrixXd, 3> basis_;
  std::vector<Beyond> beyond_;
};

/// The least-squares problem of all three coordinates together.
class Problem {
 public:
  Problem(const FillSpace& space, const EdgeSamples& samples, int order)
      : space_(space), samples_(samples), count_(space.coefficients.cols()) {
    forms_.resize(space.coefficients.rows(), count_ + 3);
    forms_ << space.coefficients, space.constants;
    const Eigen::MatrixXd rows =
        derivativeScale(space.degree, order) * differencesOf(space, forms_, order);
    fair_ = rows.leftCols(count_).transpose() * rows;
  }

  void begin(double fairness) {
    matrix_ = Eigen::MatrixXd::Zero(3 * count_, 3 * count_);
    right_ = Eigen::VectorXd::Zero(3 * count_);
    for (int c = 0; c < 3; ++c) {
      matrix_.block(c * count_, c * count_, count_, count_) = fairness * fair_.leftCols(count_);
      right_.segment(c * count_, count_) = -fairness * fair_.col(count_ + c);
    }
    rows_.clear(), values_.clear();
  }

  /// Adds the squared jumps, linearised at the patches where they were measured.
  void add(const Jumps& jumps, double weight) {
    const FillEdges& edges = samples_.edges();
    for (std::size_t e = 0; e < edges.outer.size(); ++e)
      for (std::size_t k = 0; k < jumps.outer[e].size(); k += finer)
        add(outerForm(edges.outer[e], jumps.outer[e][k]), jumps.outer[e][k], weight);
    for (std::size_t e = 0; e < edges.inner.size(); ++e)
      for (std::size_t k = 0; k < jumps.inner[e].size(); k += finer)
        add(innerForm(edges.inner[e], jumps.inner[e][k]), jumps.inner[e][k], weight);
  }

  Poles solve() {
    const Index size = static_cast<Index>(rows_.size());
    Eigen::MatrixXd rows(size, 3 * count_);
    for (Index i = 0; i < size; ++i) rows.row(i) = rows_[i];
    matrix_.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
    right_ += rows.transpose() * Eigen::Map<const Eigen::VectorXd>(values_.data(), size);
    // The shift keeps unknowns near zero that move no pole or have no influence on the sum.
    matrix_.diagonal().array() += 1e-13 * matrix_.diagonal().maxCoeff();
    const Eigen::VectorXd solution = matrix_.ldlt().solve(right_);  // only the lower half is read
    Poles unknowns(count_, 3);
    for (int c = 0; c < 3; ++c) unknowns.col(c) = solution.segment(c * count_, count_);
    return unknowns;
  }

 private:
  /// Adds the square of weight (normal . form - wanted).
  void add(const Form& form, const Jump& jump, double weight) {
    weight *= jump.scale;
    Form row(3 * count_);
    for (int c = 0; c < 3; ++c)
      row.segment(c * count_, count_) = weight * jump.normal(c) * form.head(count_);
    rows_.push_back(std::move(row));
    values_.push_back(weight * (jump.wanted - form.tail<3>().dot(jump.normal)));
  }

  Form outerForm(const OuterEdge& edge, const Jump& jump) const {
    return form(edge.patch, edge.edge, false, jump.sample, 2, 0);
  }

  Form innerForm(const InnerEdge& edge, const Jump& jump) const {
    const auto before = [&](int across, int along) {
      return form(edge.before, edge.before_edge, edge.reversed, jump.sample, across, along);
    };
    return form(edge.after, edge.after_edge, false, jump.sample, 2, 0) -
           jump.alpha * jump.alpha * before(2, 0) - 2 * jump.alpha * jump.beta * before(1, 1) -
           jump.beta * jump.beta * before(0, 2);
  }

  /// Derivatives of a patch along an edge: of order 0 to 2 into it, and along.
  Form form(int patch, PatchEdge edge, bool reversed, Index sample, int across, int along) const {
    const int n = space_.degree;
    const std::array<std::array<double, 3>, 3> stencils = {
        {{1, 0, 0},
         {-1.0 * n, 1.0 * n, 0},
         {1.0 * n * (n - 1), -2.0 * n * (n - 1), 1.0 * n * (n - 1)}}};
    Form result = Form::Zero(forms_.cols());
    for (int k = 0; k <= n; ++k)
      for (int r = 0; r <= across; ++r)
        result += samples_.basis(along)(sample, k) * stencils.at(across)[r] *
                  forms_.row(poleOf(patch, edge, reversed, r, k));
    return result;
  }

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
  const EdgeSamples& samples_;
  Index count_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> forms_;
  Eigen::MatrixXd fair_, matrix_;
  Eigen::VectorXd right_;
  std::vector<Form> rows_;
  std::vector<double> values_;
};

struct Candidate {
  std::vector<BezierPatch> patches;
  double squares = 0, largest_per_mm = 0;
};

double sizeOf(const std::vector<FillSide>& sides) {
  double length = 0;
  for (const FillSide& side : sides) length += (side.edge.point(1) - side.edge.point(0)).norm();
  return length / static_cast<double>(sides.size());
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
  constexpr std::array<PatchEdge, 4> middle = {PatchEdge::V0, PatchEdge::U1, PatchEdge::V1,
                                               PatchEdge::U0};
  FillEdges edges;
  for (int k = 0; k < 4; ++k) {
    edges.outer.push_back({k, PatchEdge::U1, static_cast<std::size_t>(k), 0, 1});
    edges.inner.push_back({(k + 3) % 4, PatchEdge::V1, false, k, PatchEdge::V0});
    edges.inner.push_back({4, middle.at(k), k >= 2, k, PatchEdge::U0});
  }
  return edges;
}

CurvedPatches leastCurvatureJump(
    const FillSpace& space, const std::vector<BezierPatch>& given, const FillEdges& edges,
    const std::vector<FillSide>& sides, int order,
    const std::function<std::vector<BezierPatch>(const Poles& unknowns)>& patchesOf) {
  // The sum of squares may fall while the largest jump, which is measured at more parameters, grows
  // a little.
  constexpr double most_growth = 1.02;
  const double size_mm = sizeOf(sides);
  const EdgeSamples samples(space.degree, edges, sides);
  Problem problem(space, samples, order);
  std::vector<Candidate> candidates;
  Jumps now = samples.jumps(given);
  const Jumps first = now;
  for (const double fairness : fairness_weights) {
    problem.begin(fairness);
    problem.add(now, size_mm * size_mm);
    std::vector<BezierPatch> at = patchesOf(problem.solve());
    now = samples.jumps(at);
    if (now.squares < first.squares && now.largest_per_mm <= most_growth * first.largest_per_mm)
      candidates.push_back({std::move(at), now.squares, now.largest_per_mm});
  }
  std::ranges::sort(candidates, {}, &Candidate::squares);
  for (Candidate& candidate : candidates)
    if (std::ranges::all_of(candidate.patches,
                            [](const BezierPatch& patch) { return provedRegular(patch); }))
      return {std::move(candidate.patches), candidate.largest_per_mm};
  return {given, first.largest_per_mm};
}

}  // namespace seamwright::fill
