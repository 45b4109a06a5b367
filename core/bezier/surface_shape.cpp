// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/graded_term.hpp>
#include <seamwright/core/bezier/surface_shape.hpp>

namespace seamwright {

namespace {

using Eigen::Vector3d;

constexpr double shape_epsilon = std::numeric_limits<double>::epsilon();

using Index2 = std::array<int, 2>;

Index2 between(const Index2& from, const Index2& to) {
  return {to[0] - from[0], to[1] - from[1]};
}

int area(const Index2& a, const Index2& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// The surface as sum_q g_q P_q / sum_q g_q.
struct GradedNet {
  std::vector<GradedTerm> terms;  ///< g_q, one per pole
  std::vector<Index2> indices;    ///< the q of each term
  GradedTerm jacobian{1};         ///< of the logarithms of the two parameter quotients, by u and v
  double rounding = 0;            ///< relative error of a term and of sums of terms
};

/// Powers 0..degree of a term, multiplied by binomial coefficients.
std::vector<GradedTerm> binomialPowers(const GradedTerm& base, int degree) {
  std::vector<GradedTerm> powers = {GradedTerm(1)};
  for (int i = 0; i < degree; ++i)
    powers.push_back(powers.back().times(static_cast<double>(degree - i) / (i + 1)).times(base));
  return powers;
}

GradedNet netOf(const BezierPatch& patch, double u, double v) {
  const GradedTerm a = gradedParameter(u), a1 = gradedParameter(1 - u), b = gradedParameter(v),
                   b1 = gradedParameter(1 - v);
  const auto in_u = binomialPowers(a.over(a1), patch.degreeU()),
             in_v = binomialPowers(b.over(b1), patch.degreeV());
  GradedNet net;
  for (int i = 0; i <= patch.degreeU(); ++i)
    for (int j = 0; j <= patch.degreeV(); ++j) {
      net.indices.push_back({i, j});
      net.terms.push_back(in_u[i].times(in_v[j]).times(
          GradedTerm(patch.homogeneousPoles()(static_cast<Eigen::Index>(net.terms.size()), 3))));
    }
  net.jacobian = GradedTerm(1).over(a.times(a1).times(b.times(b1)));
  net.rounding =
      (3 * (patch.degreeU() + patch.degreeV() + 3) + static_cast<double>(net.terms.size())) *
      shape_epsilon;
  return net;
}

GradedNet netOf(const BezierTriangle& triangle, double l0, double l1) {
  const int n = triangle.degree();
  const GradedTerm a = gradedParameter(l0), b = gradedParameter(l1),
                   c = gradedParameter(1 - l0 - l1);
  const auto in_a = binomialPowers(a.over(c), n);
  GradedNet net;
  for (int i = 0; i <= n; ++i) {
    const auto in_b = binomialPowers(b.over(c), n - i);  // C(n, i) C(n - i, j) = n! / (i! j! k!)
    for (int j = 0; i + j <= n; ++j) {
      net.indices.push_back({i, j});
      net.terms.push_back(in_a[i].times(in_b[j]).times(
          GradedTerm(triangle.homogeneousPoles()(static_cast<Eigen::Index>(net.terms.size()), 3))));
    }
  }
  net.jacobian = GradedTerm(1).over(a.times(b).times(c));
  net.rounding = (3 * (2 * n + 3) + static_cast<double>(net.terms.size())) * shape_epsilon;
  return net;
}

/// A vector that is a sum of terms, with its error, and the sum of the terms.
struct ShapeSum {
  Vector3d value = Vector3d::Zero();
  double error = 0;
  double weight = 0;
  double weight_error = 0;
};

class OwnJet {
 public:
  OwnJet(const GradedNet& net, const HomogeneousPoles& poles);
  SurfaceShape shape();

 private:
  bool choosePivots();
  ShapeSum partial(int k, int l) const;
  bool isFlat(const ShapeSum& a, const ShapeSum& b) const;
  void setJet(const ShapeSum& a, const ShapeSum& b, SurfaceShape& shape) const;

  const GradedNet& net_;
  std::array<std::size_t, 3> pivots_{};
  LocalPoles local_;
  std::vector<GradedTerm> shares_;  ///< g_q divided by their sum
  std::vector<double> sizes_;   ///< bounds of the summed sizes of each pole relative to the point
  Poles poles_;                 ///< relative to the point
  double weight_error_ = 0;     ///< relative error of the sum of g_q
  int span_ = 0;                ///< area of q_1 - q_0 and q_2 - q_0
  std::array<int, 2> units_{};  ///< exponents of the units of a and b
};

OwnJet::OwnJet(const GradedNet& net, const HomogeneousPoles& poles) : net_(net) {
  pivots_[0] = largestTerm(net.terms);
  local_ = localPoles(poles, static_cast<Eigen::Index>(pivots_[0]));
  double sum = 0, total = 0, point_size = 0;
  Eigen::RowVector3d point = Eigen::RowVector3d::Zero();
  for (std::size_t q = 0; q < net.terms.size(); ++q) {
    const double share = net.terms[q].overPowerOf2(net.terms[pivots_[0]].exponent);
    const auto pole = local_.poles.row(static_cast<Eigen::Index>(q));
    sum += share;
    total += std::abs(share);
    point += share * pole;
    point_size += std::abs(share) * pole.norm();
  }
  weight_error_ = net.rounding * total / std::abs(sum);
  poles_ = local_.poles.rowwise() - point / sum;
  for (std::size_t q = 0; q < net.terms.size(); ++q) {
    shares_.emplace_back(net.terms[q].mantissa / sum,
                         net.terms[q].exponent - net.terms[pivots_[0]].exponent);
    sizes_.push_back(local_.poles.row(static_cast<Eigen::Index>(q)).norm() +
                     3 * point_size / std::abs(sum));
  }
}

/// Chooses q_1 and q_2. False if the indices of all poles are in line.
bool OwnJet::choosePivots() {
  const Index2& first = net_.indices[pivots_[0]];
  const auto largest = [&](auto steps) {
    std::vector<GradedTerm> terms;
    for (std::size_t q = 0; q < shares_.size(); ++q)
      terms.push_back(shares_[q].times(steps(between(first, net_.indices[q]))));
    return largestTerm(terms);
  };
  pivots_[1] = largest([](const Index2& q) { return std::max(std::abs(q[0]), std::abs(q[1])); });
  const Index2 along = between(first, net_.indices[pivots_[1]]);
  pivots_[2] = largest([&](const Index2& q) { return area(along, q); });
  span_ = area(along, between(first, net_.indices[pivots_[2]]));
  // X_a x X_b must have the direction of X_u x X_v.
  if ((span_ < 0) != (net_.jacobian.mantissa < 0)) {
    std::swap(pivots_[1], pivots_[2]);
    span_ = -span_;
  }
  return span_ != 0;
}

/// The partial sum_q g_q x (x - 1) ... y (y - 1) ... (P_q - X) / sum_q g_q with k and l factors,
/// where q - q_0 = x (q_1 - q_0) + y (q_2 - q_0).
ShapeSum OwnJet::partial(int k, int l) const {
  const Index2& first = net_.indices[pivots_[0]];
  const Index2 a = between(first, net_.indices[pivots_[1]]),
               b = between(first, net_.indices[pivots_[2]]);
  ShapeSum sum;
  double weights = 0;
  for (std::size_t q = 0; q < shares_.size(); ++q) {
    const Index2 step = between(first, net_.indices[q]);
    GradedTerm term = shares_[q];
    for (int i = 0; i < k; ++i)
      term = term.times(static_cast<double>(area(step, b) - i * span_) / span_);
    for (int i = 0; i < l; ++i)
      term = term.times(static_cast<double>(area(a, step) - i * span_) / span_);
    const double coefficient = term.overPowerOf2(-k * units_[0] - l * units_[1]);
    sum.value += coefficient * poles_.row(static_cast<Eigen::Index>(q)).transpose();
    sum.error += std::abs(coefficient) * sizes_[q];
    sum.weight += coefficient;
    weights += std::abs(coefficient);
  }
  const double rounding = net_.rounding + (k + l) * shape_epsilon;
  sum.error = rounding * sum.error + weight_error_ * sum.value.norm();
  sum.weight_error = rounding * weights + weight_error_ * std::abs(sum.weight);
  return sum;
}

/// Whether X_u x X_v is within rounding of zero. At an end of a parameter only terms of a higher
/// order may be left of X_u x X_v; graded_end_exponent makes these tiny, and X_u x X_v then counts
/// as zero.
bool OwnJet::isFlat(const ShapeSum& a, const ShapeSum& b) const {
  const double size = a.value.cross(b.value).norm();
  const double noise = a.error * b.value.norm() + b.error * a.value.norm() + a.error * b.error +
                       4 * shape_epsilon * a.value.norm() * b.value.norm();
  const int exponent = net_.jacobian.exponent - units_[0] - units_[1];
  return !(size > noise) || exponent < graded_end_exponent / 2;
}

void OwnJet::setJet(const ShapeSum& a, const ShapeSum& b, SurfaceShape& shape) const {
  const ShapeSum aa = partial(2, 0), ab = partial(1, 1), bb = partial(0, 2);
  const std::array<const ShapeSum*, 2> first = {&a, &b};
  const std::array<const ShapeSum*, 3> second = {&aa, &ab, &bb};
  std::array<Vector3d, 4> third;
  for (int l = 0; l < 4; ++l) {
    // By the parameters a / (1 + w_a a + w_b b) and b / (...) the weight has no first derivative.
    // The third derivatives gain w_i X_jk + ...
    const ShapeSum sum = partial(3 - l, l);
    third[l] = sum.value;
    shape.third_errors[l] = sum.error;
    const auto add = [&](int i, int jk, double times) {
      third[l] += times * first[i]->weight * second[jk]->value;
      shape.third_errors[l] +=
          times * (std::abs(first[i]->weight) * second[jk]->error +
                   first[i]->weight_error * (second[jk]->value.norm() + second[jk]->error) +
                   2 * shape_epsilon * std::abs(first[i]->weight) * second[jk]->value.norm());
    };
    if (l < 3) add(0, l, 3 - l);
    if (l > 0) add(1, l - 1, l);
  }
  const double unit = std::ldexp(1, local_.exponent);
  shape.jet = {Vector3d::Zero(), unit * a.value,  unit * b.value,  unit * aa.value,
               unit * ab.value,  unit * bb.value, unit * third[0], unit * third[1],
               unit * third[2],  unit * third[3]};
  shape.first_errors = {unit * a.error, unit * b.error};
  shape.second_errors = {unit * aa.error, unit * ab.error, unit * bb.error};
  for (double& error : shape.third_errors) error *= unit;
}

/// The dual basis of X_a and X_b, with a bound of the error of each vector.
struct DualBasis {
  std::array<Vector3d, 2> d;
  std::array<double, 2> error;
  double turn;  ///< bound of |J+ dJ|, J = [X_a X_b]
};

DualBasis dualBasisOf(const SurfaceShape& shape) {
  const Vector3d cross = shape.jet.u.cross(shape.jet.v);
  DualBasis dual{{shape.jet.v.cross(cross) / cross.squaredNorm(),
                  cross.cross(shape.jet.u) / cross.squaredNorm()},
                 {},
                 0};
  const double spread =
      dual.d[0].norm() * shape.jet.u.norm() + dual.d[1].norm() * shape.jet.v.norm();
  const double turn = dual.d[0].norm() * shape.first_errors[0] +
                      dual.d[1].norm() * shape.first_errors[1] + 8 * shape_epsilon * spread;
  dual.turn = turn < 1 ? turn / (1 - turn) : std::numeric_limits<double>::infinity();
  // In the plane J+ changes by -J+ dJ J+; in addition it turns with the plane.
  for (int i = 0; i < 2; ++i)
    dual.error[i] = dual.d[i].norm() * (dual.turn + shape.normal_error_rad);
  return dual;
}

void setTensor(SurfaceShape& shape) {
  const DualBasis dual = dualBasisOf(shape);
  shape.tensor = curvatureTensor(shape.jet, shape.normal);
  const Vector3d* second[] = {&shape.jet.uu, &shape.jet.uv, &shape.jet.vv};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const double form = std::abs(shape.normal.dot(*second[i + j])),
                   size = second[i + j]->norm() + shape.second_errors[i + j];
      const double form_error =
          shape.second_errors[i + j] + (shape.normal_error_rad + 4 * shape_epsilon) * size;
      const double di = dual.d[i].norm(), dj = dual.d[j].norm();
      shape.tensor_error_per_mm +=
          form_error * (di + dual.error[i]) * (dj + dual.error[j]) +
          form * (dual.error[i] * dj + di * dual.error[j] + dual.error[i] * dual.error[j] +
                  12 * shape_epsilon * di * dj);
    }
}

SurfaceShape OwnJet::shape() {
  SurfaceShape shape;
  const auto degenerate = [](Degeneracy why) {
    SurfaceShape nothing;
    nothing.degeneracy = why;
    return nothing;
  };
  if (!poles_.allFinite()) return degenerate(Degeneracy::NotFinite);
  if (!choosePivots()) return degenerate(Degeneracy::VanishingNormal);
  // The units of a and b make X_a and X_b about as large as the distances of the poles.
  for (const int i : {0, 1}) {
    units_[i] = -shares_[pivots_[i + 1]].exponent;
    int rest = 0;
    std::frexp(partial(i == 0, i == 1).value.cwiseAbs().maxCoeff(), &rest);
    units_[i] -= rest;
  }
  const ShapeSum a = partial(1, 0), b = partial(0, 1);
  if (isFlat(a, b)) return degenerate(Degeneracy::VanishingNormal);
  setJet(a, b, shape);
  const Vector3d cross = a.value.cross(b.value);
  const double noise = a.error * b.value.norm() + b.error * a.value.norm() + a.error * b.error +
                       4 * shape_epsilon * a.value.norm() * b.value.norm();
  shape.normal = cross.normalized();
  shape.normal_error_rad = std::asin(std::min(1.0, noise / cross.norm())) + 4 * shape_epsilon;
  setTensor(shape);
  if (!shape.tensor.allFinite() || !std::isfinite(shape.tensor_error_per_mm))
    return degenerate(Degeneracy::NotFinite);
  return shape;
}

void requireFiniteParameters(double u, double v) {
  for (const double t : {u, v})
    if (!std::isfinite(t))
      throw std::invalid_argument("parameter is " + bernstein::text(t) + ": it must be finite");
}

}  // namespace

SurfaceShape surfaceShape(const BezierPatch& patch, double u, double v) {
  requireFiniteParameters(u, v);
  return OwnJet(netOf(patch, u, v), patch.homogeneousPoles()).shape();
}

SurfaceShape surfaceShape(const BezierTriangle& triangle, double l0, double l1) {
  requireFiniteParameters(l0, l1);
  return OwnJet(netOf(triangle, l0, l1), triangle.homogeneousPoles()).shape();
}

BoundedChange curvatureChange(const SurfaceShape& shape, const Eigen::Vector3d& direction) {
  const DualBasis dual = dualBasisOf(shape);
  const SurfaceJet& jet = shape.jet;
  const Vector3d* second[] = {&jet.uu, &jet.uv, &jet.vv};
  const Vector3d* third[] = {&jet.uuu, &jet.uuv, &jet.uvv, &jet.vvv};
  // v1 is the direction in the parameters a and b. v2 is the second derivative of the parameter
  // curve that keeps its image in the normal section.
  std::array<double, 2> v1{}, e1{}, v2{}, e2{};
  for (int i = 0; i < 2; ++i) {
    v1[i] = dual.d[i].dot(direction);
    e1[i] = dual.error[i] + 4 * shape_epsilon * dual.d[i].norm();
  }
  Vector3d bend = Vector3d::Zero();
  double bend_size = 0, bend_error = 0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const double size = second[i + j]->norm(), a = std::abs(v1[i]), b = std::abs(v1[j]);
      bend += v1[i] * v1[j] * *second[i + j];
      bend_size += a * b * size;
      bend_error += a * b * shape.second_errors[i + j] +
                    (size + shape.second_errors[i + j]) * (a * e1[j] + e1[i] * b + e1[i] * e1[j]);
    }
  bend_error += 8 * shape_epsilon * bend_size;
  for (int i = 0; i < 2; ++i) {
    v2[i] = -dual.d[i].dot(bend);
    e2[i] = (dual.d[i].norm() + dual.error[i]) * bend_error + dual.error[i] * bend.norm() +
            4 * shape_epsilon * dual.d[i].norm() * bend.norm();
  }
  BoundedChange change{curvatureChange(jet, shape.normal, direction), 0};
  const double tilt = shape.normal_error_rad + 16 * shape_epsilon;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const Vector3d& x = *second[i + j];
      const double form = std::abs(shape.normal.dot(x)),
                   error = shape.second_errors[i + j] + tilt * x.norm();
      const double a = std::abs(v1[i]), b = std::abs(v2[j]);
      change.error_per_mm2 +=
          3 * (error * (a + e1[i]) * (b + e2[j]) + form * (a * e2[j] + e1[i] * b + e1[i] * e2[j]));
      for (int k = 0; k < 2; ++k) {
        const Vector3d& y = *third[i + j + k];
        const double height = std::abs(shape.normal.dot(y)),
                     off = shape.third_errors[i + j + k] + tilt * y.norm();
        const double full = (a + e1[i]) * (std::abs(v1[j]) + e1[j]) * (std::abs(v1[k]) + e1[k]);
        change.error_per_mm2 +=
            off * full + height * (full - a * std::abs(v1[j]) * std::abs(v1[k]));
      }
    }
  return change;
}

}  // namespace seamwright
