// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/fill/triangle_space.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>

namespace seamwright::fill {

namespace {

/// One point as an affine function of the unknowns: their coefficients, then the constant's x, y,
/// z.
using Form = Eigen::RowVectorXd;

class TriangleBuilder {
 public:
  TriangleBuilder(const CentreFields& fields, int degree) : fields_(fields) {
    space_.degree = degree;
    unknowns_ = 3 * (degree - 2) * (degree - 3) / 2;
    for (const std::optional<Poles>& field : fields.sides)
      if (!field) unknowns_ += degree - 2;
    nets_ = Eigen::MatrixXd::Zero(3 * space_.count(), unknowns_ + 3);
  }

  TriangleSpace build(const std::vector<FillSide>& sides) {
    for (int k = 0; k < 3; ++k) setSide(k, rows::elevated<3>(sides[k].edge.poles(), space_.degree));
    for (int k = 0; k < 3; ++k) setInterior(k);
    setSpokes();
    space_.coefficients = nets_.leftCols(unknowns_);
    space_.constants = nets_.rightCols(3);
    return std::move(space_);
  }

 private:
  Form unknown() {
    Form form = Form::Zero(unknowns_ + 3);
    form(next_++) = 1;
    return form;
  }
  Form constant(const Eigen::RowVector3d& point) const {
    Form form = Form::Zero(unknowns_ + 3);
    form.tail(3) = point;
    return form;
  }
  auto pole(int k, int i, int j) { return nets_.row(space_.row(k, i, j)); }
  /// Pole s from the corner on, in both triangles.
  void setSpoke(int k, int s, const Form& form) {
    pole(k, space_.degree - s, 0) = form;
    pole((k + 2) % 3, 0, space_.degree - s) = form;
  }

  /// The side's poles and the row behind it.
  void setSide(int k, const Poles& edge) {
    const int n = space_.degree;
    for (int s = 0; s <= n; ++s) pole(k, n - s, s) = constant(edge.row(s));
    setSpoke(k, 1, constant(edge.row(0) + fields_.spokes.row(k) / n));
    const std::optional<Poles>& across = fields_.sides[k];
    for (int s = 1; s < n - 1; ++s)
      pole(k, n - 1 - s, s) = across ? constant(edge.row(s) + across->row(s) / n) : unknown();
  }

  void setInterior(int k) {
    const int n = space_.degree;
    for (int i = 1; i < n - 2; ++i)
      for (int j = 1; i + j <= n - 2; ++j) pole(k, i, j) = unknown();
  }

  /// Each pole is the mean of the three poles of the previous row.
  void setSpokes() {
    const int n = space_.degree;
    for (int s = 1; s < n; ++s)
      for (int k = 0; k < 3; ++k) {
        const Form mean =
            (pole(k, n - s, 0) + pole(k, n - 1 - s, 1) + pole((k + 2) % 3, 1, n - 1 - s)) / 3;
        setSpoke(k, s + 1, mean);
      }
  }

  const CentreFields& fields_;
  int unknowns_ = 0, next_ = 0;
  Eigen::MatrixXd nets_;
  TriangleSpace space_;
};

/// Poles of the derivative in a direction of barycentric coordinates, without the degree as factor.
Eigen::MatrixXd derivative(const Eigen::MatrixXd& net, int degree,
                           const Eigen::Vector3d& direction) {
  Eigen::MatrixXd result(BezierTriangle::row(degree - 1, degree - 1, 0) + 1, net.cols());
  for (int i = 0; i < degree; ++i)
    for (int j = 0; i + j < degree; ++j)
      result.row(BezierTriangle::row(degree - 1, i, j)) =
          direction(0) * net.row(BezierTriangle::row(degree, i + 1, j)) +
          direction(1) * net.row(BezierTriangle::row(degree, i, j + 1)) +
          direction(2) * net.row(BezierTriangle::row(degree, i, j));
  return result;
}

}  // namespace

TriangleSpace triangleSpace(const std::vector<FillSide>& sides, const CentreFields& fields,
                            int degree) {
  return TriangleBuilder(fields, degree).build(sides);
}

Eigen::MatrixXd tensorsOf(const TriangleSpace& space, const Eigen::MatrixXd& poles, int order) {
  // An orthonormal frame of the equilateral triangle: along the side, and from its middle to the
  // third corner.
  const Eigen::Vector3d along(-1, 1, 0), across = std::sqrt(3.0) * Eigen::Vector3d(-1, -1, 2);
  const Eigen::VectorXd often = bernstein::binomials(order);
  const Eigen::Index lowest = space.degree - order, height = (lowest + 1) * (lowest + 2) / 2;
  Eigen::MatrixXd result(3 * (order + 1) * height, poles.cols());
  Eigen::Index row = 0;
  for (int k = 0; k < 3; ++k)
    for (int entry = 0; entry <= order; ++entry, row += height) {
      Eigen::MatrixXd net = poles.middleRows(k * space.count(), space.count());
      for (int d = 0; d < order; ++d)
        net = derivative(net, space.degree - d, d < entry ? along : across);
      result.middleRows(row, height) = std::sqrt(often(entry)) * net;
    }
  return result;
}

std::vector<BezierTriangle> trianglesOf(const TriangleSpace& space, const Poles& unknowns) {
  Poles all = space.coefficients * unknowns + space.constants;
  for (int k = 0; k < 3; ++k)
    for (int s = 0; s <= space.degree; ++s)
      all.row(space.row((k + 2) % 3, 0, space.degree - s)) =
          all.row(space.row(k, space.degree - s, 0));
  for (int k = 0; k < 3; ++k) all.row(space.row(k, 0, 0)) = all.row(space.row(0, 0, 0));
  std::vector<BezierTriangle> triangles;
  for (int k = 0; k < 3; ++k)
    triangles.emplace_back(all.middleRows(k * space.count(), space.count()));
  return triangles;
}

}  // namespace seamwright::fill
