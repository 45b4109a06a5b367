// SPDX-License-Identifier: LGPL-2.1-or-later
#include <limits>
#include <seamwright/core/fill/fill_forms.hpp>
#include <seamwright/core/fill/spoke_curvature.hpp>
#include <seamwright/core/linear/dense.hpp>

namespace seamwright::fill {

namespace {

using Eigen::Index, Eigen::Vector2d, Eigen::Vector3d;

/// A patch along a spoke: the spoke, and the first and second derivative across, into the patch.
struct BesideSpoke {
  Forms position, first, second;
};

/// \param pole the form of the pole s along the spoke, in row r from it.
template <class Pole>
BesideSpoke besideSpoke(int degree, const Pole& pole) {
  const auto row = [&](int r) {
    Forms forms(degree + 1, pole(0, 0).cols());
    for (int s = 0; s <= degree; ++s) forms.row(s) = pole(r, s);
    return forms;
  };
  const double n = degree;
  const Forms position = row(0), beside = row(1);
  return {position, n * (beside - position), n * (n - 1) * (row(2) - 2 * beside + position)};
}

/// The polynomial that vanishes if the patches before and after a spoke meet there with G2.
Forms defect(const BesideSpoke& before, const BesideSpoke& after, int n) {
  const double c = starFactor(n), k = c / (2 + c);
  const Vector2d a(c, 0);
  const Forms spoke1 = derivative(before.position);
  const Forms jump = after.second - before.second + 2 * product(a, derivative(before.first)) -
                     product(Vector3d(c * c, 0, 0), derivative(spoke1));
  const int degree = static_cast<int>(before.position.rows()) - 1;
  return product(Vector2d(1, 1 - k), jump) +
         2 * k * product(a, before.first + elevated(spoke1, degree));
}

}  // namespace

FillSpace withG2Spokes(const FillSpace& space) {
  const int n = space.patches, degree = space.degree;
  const Index count = space.coefficients.cols();
  Forms poles(space.coefficients.rows(), count + 3);
  poles << space.coefficients, space.constants;
  Forms defects(static_cast<Index>(n) * (degree + 2), count + 3);
  for (int k = 0; k < n; ++k) {
    const BesideSpoke before =
        besideSpoke(degree, [&](int r, int s) { return poles.row(space.row(k, r, s)); });
    const BesideSpoke after =
        besideSpoke(degree, [&](int r, int s) { return poles.row(space.row((k + 1) % n, s, r)); });
    defects.middleRows(static_cast<Index>(k) * (degree + 2), degree + 2) = defect(before, after, n);
  }
  const Eigen::MatrixXd equations = defects.leftCols(count);
  const double rounding =
      16 * std::numeric_limits<double>::epsilon() * static_cast<double>(equations.rows());
  FillSpace result = space;
  result.centre.reset();
  result.coefficients = space.coefficients * linear::nullSpace(equations, rounding);
  result.constants -=
      space.coefficients * linear::LeastSquares(equations, rounding).solve(defects.rightCols(3));
  return result;
}

}  // namespace seamwright::fill
