// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <Eigen/QR>
#include <seamwright/core/fill/fill_forms.hpp>
#include <seamwright/core/fill/ring_curvature.hpp>
#include <seamwright/core/fill/ring_fields.hpp>
#include <seamwright/core/fill/ring_space.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <string>

namespace seamwright::fill {

namespace {

using Eigen::Index;

constexpr int count = 4;  // of sides; also the number of the middle patch

/// Share of the largest pivot. Some equations follow from others: their pivots are rounding, below
/// 1e-12 for a few hundred unknowns. The pivots of the others are values of functions and
/// binomials, above 1e-8, unless sides are nearly equal. Then there are some of any size, and what
/// is left out is missed by less than that share.
constexpr double rank_threshold = 1e-11;

int next(int k) {
  return (k + 1) % count;
}

/// The functions of c V + d U = e S' along an edge, linear, by their ends.
struct Factors {
  Eigen::Vector2d c, d, e;
};

const Factors middle = {.c = {1, 1}, .d = {1, 1}, .e = {-1, 1}};

Forms total(const std::vector<Forms>& terms) {
  Index size = 0;
  for (const Forms& term : terms) size = std::max(size, term.rows());
  Forms sum = Forms::Zero(size, terms.front().cols());
  for (const Forms& term : terms) sum += elevated(term, static_cast<int>(size) - 1);
  return sum;
}

/// The equations of the inner joins between all poles, and the poles that the sides fix.
class Equations {
 public:
  Equations(const std::vector<FillSide>& sides, const RingFields& fields,
            const std::optional<RingCurvature>& curvature, const FillSpace& space)
      : space_(space), n_(fields.degree) {
    const Index total = (count + 1) * (n_ + 1) * (n_ + 1);
    known_.assign(total, false);
    points_ = Poles::Zero(total, 3);
    for (int k = 0; k < count; ++k) fixSide(k, sides[k], fields.fields[k]);
    for (int k = 0; k < count; ++k) {
      const SpokeEnd& end = fields.spokes[k];
      const Factors spoke{.c = {1, end.c}, .d = {1, end.d}, .e = {-1, end.e}};
      add(spokeRow(k, 0), spokeRow(k, 1), spokeRow(k, -1), spoke);
      add(innerRow(k, 0), innerRow(k, 1), innerRow(k, -1), middle);
      if (!curvature) continue;
      addSecond([&](int beside) { return spokeRow(k, beside); }, spoke, curvature->spokes.at(k));
      addSecond([&](int beside) { return innerRow(k, beside); }, middle, curvature->middle.at(k));
    }
  }

  /// All solutions: poles as affine functions of unknowns, written to \p space.
  void solve(FillSpace& space) const;

 private:
  Forms row(const std::vector<Index>& poles) const {
    Forms forms = Forms::Zero(static_cast<Index>(poles.size()), static_cast<Index>(known_.size()));
    for (std::size_t s = 0; s < poles.size(); ++s) forms(static_cast<Index>(s), poles[s]) = 1;
    return forms;
  }

  /// The spoke to corner k (0), the first and second rows beside it in the patch after it (1, 2),
  /// in the patch before it (-1, -2).
  Forms spokeRow(int k, int beside) const {
    std::vector<Index> poles;
    for (int s = 0; s <= n_; ++s)
      poles.push_back(beside < 0 ? sharedRow(space_, next(k + 2), s, n_ + beside)
                                 : sharedRow(space_, k, s, beside));
    return row(poles);
  }

  /// Edge k of the middle patch (0), the rows beside it in the ring (1, 2), in the middle (-1, -2).
  Forms innerRow(int k, int beside) const {
    std::vector<Index> poles;
    for (int s = 0; s <= n_; ++s) {
      const int in = -beside;
      const std::array<std::array<int, 2>, count> inside = {
          {{s, in}, {n_ - in, s}, {n_ - s, n_ - in}, {in, n_ - s}}};
      poles.push_back(beside < 0 ? sharedRow(space_, count, inside.at(k)[0], inside.at(k)[1])
                                 : sharedRow(space_, k, beside, s));
    }
    return row(poles);
  }

  /// c V + d U = e S'.
  void add(const Forms& edge, const Forms& after, const Forms& before, const Factors& f) {
    append(product(f.c, after - edge) + product(f.d, before - edge) -
               elevated(product(f.e, derivative(edge)), n_ + 1) / n_,
           Poles::Zero(n_ + 2, 3));
  }

  /// The equation of CurvatureLaw, with derivatives in differences of poles.
  /// \param row  as spokeRow() and innerRow() of an edge
  template <class Row>
  void addSecond(const Row& row, const Factors& f, const CurvatureLaw& law) {
    const Forms edge = row(0), v = row(1) - edge, u = row(-1) - edge,
                v2 = row(2) - 2 * row(1) + edge, u2 = row(-2) - 2 * row(-1) + edge;
    const Forms between = product(f.d, u) - product(f.c, v), along = derivative(edge) / n_;
    const double first = 1.0 / (n_ - 1);  // of derivatives of first order
    const Forms equation =
        total({product(rows::times(f.c, f.c), v2), -product(rows::times(f.d, f.d), u2),
               first * product(rows::times(f.e, f.d), derivative(u)),
               -first * product(rows::times(f.e, f.c), derivative(v)),
               -first * product(law.p, between), -first * product(law.q, along)});
    // Of a degree below that of the rows, so that V2 and U2 take it whatever c and d are.
    Poles defect = Poles::Zero(n_, 3);
    defect.row(n_ - 1) = law.defect.transpose();
    defect.row(n_ - 2) = (law.defect - law.defect_slope / (n_ - 1)).transpose();
    append(equation, elevated(defect, static_cast<int>(equation.rows()) - 1) / (n_ * (n_ - 1)));
  }

  void append(const Forms& forms, const Poles& values) {
    const Index old = equations_.rows();
    equations_.conservativeResize(old + forms.rows(), forms.cols());
    equations_.bottomRows(forms.rows()) = forms;
    values_.conservativeResize(old + forms.rows(), 3);
    values_.bottomRows(forms.rows()) = values;
  }

  void fix(Index pole, const Eigen::RowVector3d& point) {
    known_[pole] = true;
    points_.row(pole) = point;
  }

  void fixSide(int k, const FillSide& side, const std::optional<Poles>& field) {
    const Poles edge = rows::elevated<3>(rows::Field<3>(side.edge.poles()), n_);
    for (int s = 0; s <= n_; ++s) {
      fix(sharedRow(space_, k, n_, s), edge.row(s));
      if (field) fix(sharedRow(space_, k, n_ - 1, s), edge.row(s) - field->row(s) / n_);
    }
  }

  const FillSpace& space_;
  int n_;
  std::vector<bool> known_;
  Poles points_;
  Forms equations_;
  Poles values_;
};

void Equations::solve(FillSpace& space) const {
  std::vector<Index> bound, loose;  // poles of the equations, and others
  for (Index pole = 0; pole < equations_.cols(); ++pole) {
    const bool is_shared = sharedRow(space, static_cast<int>(pole) / ((n_ + 1) * (n_ + 1)),
                                     static_cast<int>(pole) / (n_ + 1) % (n_ + 1),
                                     static_cast<int>(pole) % (n_ + 1)) != pole;
    if (is_shared || known_[pole]) continue;
    (equations_.col(pole).isZero(0) ? loose : bound).push_back(pole);
  }
  const Eigen::MatrixXd matrix = equations_(Eigen::indexing::all, bound);
  const Poles right = values_ - equations_ * points_;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> least;
  least.setThreshold(rank_threshold);  // before compute(), which uses the rank
  least.compute(matrix);
  const Poles particular = least.solve(right);
  const double missed = (matrix * particular - right).cwiseAbs().maxCoeff();
  // Rounding leaves far less, as the rank is decided at 1e-11; a contradiction leaves far more.
  constexpr double contradiction = 1e-9;
  if (missed > contradiction * (rows::size(points_) + rows::size(particular)))
    throw RingContradiction(
        fmt::format("the equations of the joins contradict each other by {:.3g} mm: no ring of "
                    "five patches is found",
                    missed),
        missed);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix.transpose());
  qr.setThreshold(rank_threshold);
  const Eigen::MatrixXd all = qr.householderQ();
  const Eigen::MatrixXd idle = all.rightCols(matrix.cols() - qr.rank());

  space.coefficients =
      Eigen::MatrixXd::Zero(equations_.cols(), idle.cols() + static_cast<Index>(loose.size()));
  space.constants = points_;
  space.coefficients(bound, Eigen::seqN(0, idle.cols())) = idle;
  space.constants(bound, Eigen::indexing::all) = particular;
  for (std::size_t k = 0; k < loose.size(); ++k)
    space.coefficients(loose[k], idle.cols() + static_cast<Index>(k)) = 1;
  for (int patch = 0; patch <= count; ++patch)
    for (int i = 0; i <= n_; ++i)
      for (int j = 0; j <= n_; ++j) {
        const Index own = space.row(patch, i, j), kept = sharedRow(space, patch, i, j);
        if (own == kept) continue;
        space.coefficients.row(own) = space.coefficients.row(kept);
        space.constants.row(own) = space.constants.row(kept);
      }
}

}  // namespace

Index sharedRow(const FillSpace& space, int patch, int i, int j) {
  const int n = space.degree;
  if (patch < count) return j == n ? space.row(next(patch), i, 0) : space.row(patch, i, j);
  if (j == 0) return sharedRow(space, 0, 0, i);
  if (i == n) return sharedRow(space, 1, 0, j);
  if (j == n) return sharedRow(space, 2, 0, n - i);
  return i == 0 ? sharedRow(space, 3, 0, n - j) : space.row(patch, i, j);
}

RingSpace ringSpace(const std::vector<FillSide>& sides, SpokeLaw law, double spoke_scale,
                    double tolerance_rad, int more_degrees) {
  RingFields fields = ringFields(sides, spoke_scale, tolerance_rad, more_degrees);
  std::optional<RingCurvature> curvature;
  if (law == SpokeLaw::G2) curvature = ringCurvature(sides, fields);
  RingSpace result;
  result.space.patches = count + 1;
  result.space.degree = fields.degree;
  Equations(sides, fields, curvature, result.space).solve(result.space);
  result.corners = std::move(fields.corners);
  if (curvature) result.spoke_jump_per_mm = curvature->spoke_jump_per_mm;
  return result;
}

std::vector<BezierPatch> ringPatches(const FillSpace& space, const Poles& unknowns) {
  const Poles own = space.coefficients * unknowns + space.constants;
  const int n = space.degree;
  std::vector<BezierPatch> patches;
  for (int patch = 0; patch < space.patches; ++patch) {
    Poles net((n + 1) * (n + 1), 3);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        net.row(i * (n + 1) + j) = own.row(sharedRow(space, patch, i, j));
    patches.emplace_back(n, n, std::move(net));
  }
  return patches;
}

}  // namespace seamwright::fill
