// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <seamwright/core/fill/fill_forms.hpp>
#include <seamwright/core/fill/fill_space.hpp>
#include <seamwright/core/fill/hole_corner.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>

namespace seamwright::fill {

namespace {

/// One point as an affine function of the unknowns: their coefficients, then the constant's x, y,
/// z.
using Form = Eigen::RowVectorXd;
class Builder {
 public:
  Builder(const std::vector<FillSide>& sides, const CrossBoundaryDerivatives& fields, SpokeLaw law,
          int degree)
      : sides_(sides),
        given_(fields.sides),
        law_(law),
        n_(static_cast<int>(sides.size())),
        degree_(degree) {
    spoke_degree_ = law != SpokeLaw::Quadratic || n_ == 4 ? degree : degree - 1;
    // Forms need their length in advance: centre, tangents of the spokes, spokes, twist,
    // cross-boundary derivatives, differences, interiors.
    const int inner = degree - 3;
    unknowns_ = 3 + n_ * (spoke_degree_ - 3) - (isConstrained() ? 1 : 0) + (n_ % 2 == 0 ? 1 : 0) +
                n_ * inner + n_ * inner * inner;
    for (int k = 0; k < n_; ++k)
      if (isFree(k)) unknowns_ += (isFree(before(k)) ? 1 : 0) + (degree - 1) + (degree - 3);
  }

  FillSpace build() {
    makeEdges();
    makeFields();
    makeSpokes();
    makeTwists();
    space_.patches = n_;
    space_.degree = degree_;
    nets_ =
        Forms::Zero(static_cast<Eigen::Index>(n_) * (degree_ + 1) * (degree_ + 1), unknowns_ + 3);
    for (int k = 0; k < n_; ++k) setBoundary(k);
    for (int k = 0; k < n_; ++k) setBesideSpoke(k);
    for (int k = 0; k < n_; ++k) setInterior(k);
    space_.coefficients = nets_.leftCols(unknowns_);
    space_.constants = nets_.rightCols(3);
    return std::move(space_);
  }

 private:
  int before(int k) const { return (k + n_ - 1) % n_; }
  int after(int k) const { return (k + 1) % n_; }
  bool isFree(int k) const { return !given_[k]; }
  /// The spokes' second derivatives at the centre have to add up to zero with alternating signs.
  bool isConstrained() const { return n_ % 2 == 0 && n_ > 4; }

  Form unknown() {
    Form form = Form::Zero(unknowns_ + 3);
    form(next_++) = 1;
    return form;
  }
  Forms constants(const Poles& points) const {
    Forms forms = Forms::Zero(points.rows(), unknowns_ + 3);
    forms.rightCols(3) = points;
    return forms;
  }
  auto pole(int patch, int i, int j) { return nets_.row(space_.row(patch, i, j)); }

  void makeEdges() {
    space_.middles.resize(n_, 3);
    for (int k = 0; k < n_; ++k) {
      const std::array<Poles, 2> halves = halved(sides_[k].edge.poles());
      edges_.push_back({constants(rows::elevated<3>(halves[0], degree_)),
                        constants(rows::elevated<3>(halves[1], degree_))});
      space_.middles.row(k) = halves[1].row(0);
    }
  }

  /// The cross-boundary derivatives out of the hole. On a side of position alone they are free
  /// except for the values and mixed derivatives at the corners and the jump of the slope in the
  /// middle.
  void makeFields() {
    fields_.resize(n_);
    for (int k = 0; k < n_; ++k)
      for (std::size_t h = 0; h < 2; ++h)
        fields_[k][h] =
            isFree(k) ? Forms::Zero(degree_ + 1, unknowns_ + 3) : constants(given_[k]->halves[h]);
    for (int k = 0; k < n_; ++k)
      if (isFree(k)) beginField(k);
    for (int k = 0; k < n_; ++k)
      if (isFree(k)) completeField(k);
  }

  void beginField(int k) {
    Forms& left = fields_[k][0];
    left.row(0) = constants(tangentAtEnd(sides_[before(k)]).transpose() / 2);
    const Forms& last = fields_[before(k)][1];
    if (isFree(before(k)))
      left.row(1) = unknown();
    else
      left.row(1) = left.row(0) + last.row(degree_ - 1) - last.row(degree_);
    for (int i = 2; i <= degree_; ++i) left.row(i) = unknown();
  }

  void completeField(int k) {
    const Forms &left = fields_[k][0], &first = fields_[after(k)][0];
    Forms& right = fields_[k][1];
    right.row(0) = left.row(degree_);
    right.row(1) =
        (2 + slopeAtSide(law_, n_) / degree_) * left.row(degree_) - left.row(degree_ - 1);
    for (int i = 2; i <= degree_ - 2; ++i) right.row(i) = unknown();
    right.row(degree_) = constants(-tangentAtBegin(sides_[after(k)]).transpose() / 2);
    right.row(degree_ - 1) = right.row(degree_) + first.row(1) - first.row(0);
  }

  void makeSpokes() {
    space_.centre = next_;
    const Form centre = unknown(), x = unknown(), y = unknown();
    const int d = spoke_degree_;
    Form alternating = Form::Zero(unknowns_ + 3);
    for (int k = 0; k < n_; ++k) {
      const double angle = 2 * std::numbers::pi * k / n_;
      star_.emplace_back(std::cos(angle) * x + std::sin(angle) * y);
      Forms spoke(d + 1, unknowns_ + 3);
      spoke.row(0) = centre;
      spoke.row(1) = centre + star_[k] / d;
      const bool follows = isConstrained() && k == n_ - 1;
      spoke.row(2) = follows ? alternating : unknown();
      alternating += (k % 2 == 0 ? 1 : -1) * spoke.row(2);
      for (int i = 3; i <= d - 2; ++i) spoke.row(i) = unknown();
      spoke.row(d) = edges_[k][0].row(degree_);
      spoke.row(d - 1) = spoke.row(d) - fields_[k][0].row(degree_) / d;
      spokes_.push_back(std::move(spoke));
    }
  }

  /// X_(k+1) + X_k = a(0) S_k''(0) + a'(0) S_k'(0).
  void makeTwists() {
    const double c = starFactor(n_), slope = law_ == SpokeLaw::Quadratic ? -2 * c : -c;
    std::vector<Form> sums;
    Form first = Form::Zero(unknowns_ + 3);
    for (int k = 0; k < n_; ++k) {
      const Form second = derivative(derivative(spokes_[k])).row(0);
      sums.emplace_back(c * second + slope * star_[k]);
      first += (k % 2 == 0 ? 0.5 : -0.5) * sums.back();
    }
    twists_.push_back(n_ % 2 == 0 ? unknown() : first);
    for (int k = 0; k + 1 < n_; ++k) twists_.emplace_back(sums[k] - twists_[k]);
  }

  /// The rows along the sides, from the cross-boundary derivatives, and the poles next to the
  /// centre.
  void setBoundary(int k) {
    const Forms &right = edges_[before(k)][1], &left = edges_[k][0];
    const Forms &across_right = fields_[before(k)][1], &across_left = fields_[k][0];
    const Forms bottom = elevated(spokes_[before(k)], degree_),
                beside = elevated(spokes_[k], degree_);
    for (int s = 0; s <= degree_; ++s) {
      pole(k, s, 0) = bottom.row(s);
      pole(k, 0, s) = beside.row(s);
    }
    for (int s = 0; s <= degree_; ++s) {
      pole(k, degree_, s) = right.row(s);
      pole(k, s, degree_) = left.row(degree_ - s);
    }
    for (int s = 1; s < degree_; ++s) {
      pole(k, s, degree_ - 1) = left.row(degree_ - s) - across_left.row(degree_ - s) / degree_;
      pole(k, degree_ - 1, s) = right.row(s) - across_right.row(s) / degree_;
    }
    pole(k, 1, 1) =
        twists_[k] / (degree_ * degree_) + pole(k, 1, 0) + pole(k, 0, 1) - pole(k, 0, 0);
  }

  /// V + U = a S' across spoke k, in the poles that do not belong to the centre or to the side.
  void setBesideSpoke(int k) {
    const double c = starFactor(n_);
    const Eigen::VectorXd law = law_ == SpokeLaw::Quadratic
                                    ? Eigen::VectorXd(Eigen::Vector3d(c, 0, 0))
                                    : Eigen::VectorXd(Eigen::Vector2d(c, 0));
    const Forms spoke = elevated(spokes_[k], degree_);
    Forms mean = spoke;
    if (c != 0) mean += elevated(product(law, derivative(spokes_[k])), degree_) / (2.0 * degree_);
    for (int s = 2; s <= degree_ - 2; ++s) {
      const Form half_difference = unknown();
      pole(after(k), s, 1) = mean.row(s) + half_difference;
      pole(k, 1, s) = mean.row(s) - half_difference;
    }
  }

  void setInterior(int k) {
    for (int i = 2; i <= degree_ - 2; ++i)
      for (int j = 2; j <= degree_ - 2; ++j) pole(k, i, j) = unknown();
  }

  const std::vector<FillSide>& sides_;
  const std::vector<std::optional<SideField>>& given_;
  SpokeLaw law_;
  int n_, degree_, spoke_degree_ = 0, unknowns_ = 0, next_ = 0;
  std::vector<std::array<Forms, 2>> edges_, fields_;
  std::vector<Form> star_, twists_;
  std::vector<Forms> spokes_;
  Forms nets_;
  FillSpace space_;
};

}  // namespace

FillSpace fillSpace(const std::vector<FillSide>& sides, const CrossBoundaryDerivatives& fields,
                    SpokeLaw law, int degree) {
  return Builder(sides, fields, law, degree).build();
}

std::vector<BezierPatch> patchesOf(const FillSpace& space, const Poles& unknowns) {
  Poles all = space.coefficients * unknowns + space.constants;
  for (int k = 0; k < space.patches; ++k)
    for (int s = 0; s <= space.degree; ++s)
      all.row(space.row((k + 1) % space.patches, s, 0)) = all.row(space.row(k, 0, s));
  for (int k = 0; k < space.patches; ++k) all.row(space.row(k, 0, 0)) = all.row(0);
  const Eigen::Index count = static_cast<Eigen::Index>(space.degree + 1) * (space.degree + 1);
  std::vector<BezierPatch> patches;
  for (int k = 0; k < space.patches; ++k)
    patches.emplace_back(space.degree, space.degree, all.middleRows(k * count, count));
  return patches;
}

}  // namespace seamwright::fill
