// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>

#include <seamwright/core/planar/narrow_band.hpp>

namespace seamwright {

using Eigen::Index;

template <std::size_t width>
void NarrowLeastSquares::rotateIn(Index column, Row row, double right) {
  for (; column <= last_; ++column) {
    double* const pivot = &factor_(column, 0);
    if (row[0] != 0) {
      const double size = std::sqrt(pivot[0] * pivot[0] + row[0] * row[0]);
      const double cosine = pivot[0] / size, sine = row[0] / size;
      for (std::size_t k = 0; k < width; ++k) {
        const double up = pivot[k], down = row[k];
        pivot[k] = cosine * up + sine * down;
        row[k] = cosine * down - sine * up;
      }
      const double up = right_(column);
      right_(column) = cosine * up + sine * right;
      right = cosine * right - sine * up;
    }
    for (std::size_t k = 1; k < width; ++k) row[k - 1] = row[k];
    row[width - 1] = 0;
  }
}

template void NarrowLeastSquares::rotateIn<4>(Index, Row, double);
template void NarrowLeastSquares::rotateIn<NarrowLeastSquares::widest>(Index, Row, double);

Eigen::VectorXd NarrowLeastSquares::solve() const {
  const Index count = order_.count;
  Eigen::VectorXd x = right_;
  for (Index i = count - 1; i >= 0; --i) {
    const Index width = std::min(factor_.cols(), count - i);
    for (Index k = 1; k < width; ++k) x(i) -= factor_(i, k) * x(i + k);
    x(i) /= factor_(i, 0);
  }
  Eigen::VectorXd result(count);
  for (Index i = 0; i < count; ++i) result(i) = x(order_.placeOf(i));
  return result;
}

}  // namespace seamwright
