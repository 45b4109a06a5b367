// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/enclosure/vector_model.hpp>

namespace seamwright {

namespace {

/// Row and column of each stored entry.
constexpr std::array<std::array<int, 2>, 6> positions = {
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
/// Index of the entry that stores row i, column j.
constexpr std::array<std::array<int, 3>, 3> entry = {{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}}};

template <std::size_t Size, class Operation>
std::array<ChebyshevModel, Size> each(const Operation& operation) {
  std::array<ChebyshevModel, Size> result;
  for (std::size_t i = 0; i < Size; ++i) result[i] = operation(i);
  return result;
}

}  // namespace

VectorModel constantModel(const Eigen::Vector3d& vector) {
  return each<3>([&](std::size_t i) { return ChebyshevModel(vector[static_cast<int>(i)]); });
}

VectorModel operator+(const VectorModel& a, const VectorModel& b) {
  return each<3>([&](std::size_t i) { return a[i] + b[i]; });
}

VectorModel operator-(const VectorModel& a, const VectorModel& b) {
  return each<3>([&](std::size_t i) { return a[i] - b[i]; });
}

VectorModel operator-(const VectorModel& a) {
  return each<3>([&](std::size_t i) { return -a[i]; });
}

VectorModel operator*(const ChebyshevModel& factor, const VectorModel& vector) {
  return each<3>([&](std::size_t i) { return factor * vector[i]; });
}

VectorModel operator*(double factor, const VectorModel& vector) {
  return each<3>([&](std::size_t i) { return factor * vector[i]; });
}

ChebyshevModel dot(const VectorModel& a, const VectorModel& b) {
  return ProductSum().add(a[0], b[0]).add(a[1], b[1]).add(a[2], b[2]).model();
}

ProductSum& addDot(ProductSum& sum, const VectorModel& a, const VectorModel& b, double factor) {
  return sum.add(a[0], b[0], factor).add(a[1], b[1], factor).add(a[2], b[2], factor);
}

VectorModel cross(const VectorModel& a, const VectorModel& b) {
  return each<3>([&](std::size_t i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    return ProductSum().add(a[j], b[k]).add(a[k], b[j], -1).model();
  });
}

VectorModel operator*(const Eigen::Matrix3d& matrix, const VectorModel& vector) {
  return each<3>([&](std::size_t i) {
    const auto row = static_cast<int>(i);
    return combination({matrix(row, 0), matrix(row, 1), matrix(row, 2)},
                       {&vector[0], &vector[1], &vector[2]});
  });
}

SymmetricModel operator+(const SymmetricModel& a, const SymmetricModel& b) {
  return each<6>([&](std::size_t i) { return a[i] + b[i]; });
}

SymmetricModel operator-(const SymmetricModel& a, const SymmetricModel& b) {
  return each<6>([&](std::size_t i) { return a[i] - b[i]; });
}

SymmetricModel operator-(const SymmetricModel& a) {
  return each<6>([&](std::size_t i) { return -a[i]; });
}

SymmetricModel operator*(const ChebyshevModel& factor, const SymmetricModel& matrix) {
  return each<6>([&](std::size_t i) { return factor * matrix[i]; });
}

SymmetricModel operator*(double factor, const SymmetricModel& matrix) {
  return each<6>([&](std::size_t i) { return factor * matrix[i]; });
}

VectorModel operator*(const SymmetricModel& matrix, const VectorModel& vector) {
  return each<3>([&](std::size_t i) {
    ProductSum sum;
    for (std::size_t j = 0; j < 3; ++j) sum.add(matrix[entry[i][j]], vector[j]);
    return sum.model();
  });
}

SymmetricModel symmetricProduct(const VectorModel& a, const VectorModel& b) {
  return each<6>([&](std::size_t k) {
    const auto [i, j] = positions[k];
    if (i == j) return a[i] * b[i];
    return ProductSum().add(a[i], b[j], 0.5).add(a[j], b[i], 0.5).model();
  });
}

ChebyshevModel trace(const SymmetricModel& matrix) {
  return matrix[0] + matrix[1] + matrix[2];
}

ChebyshevModel contraction(const SymmetricModel& a, const SymmetricModel& b) {
  ProductSum sum;
  for (std::size_t k = 0; k < 6; ++k) sum.add(a[k], b[k], k < 3 ? 1 : 2);
  return sum.model();
}

}  // namespace seamwright
