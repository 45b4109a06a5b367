// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <seamwright/core/bezier/casteljau.hpp>
#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bezier/patch.hpp>

namespace seamwright {

namespace {

void requireNetSize(int degree_u, int degree_v, Eigen::Index rows) {
  if (degree_u < 0 || degree_v < 0 || (degree_u + 1) * (degree_v + 1) != rows)
    throw std::invalid_argument("degrees " + std::to_string(degree_u) + " by " +
                                std::to_string(degree_v) + ", poles " + std::to_string(rows) +
                                ": (m+1)(n+1) poles are needed");
}

HomogeneousPartials patchPartials(const HomogeneousPoles& poles, int degree_u, int degree_v,
                                  double u, double v) {
  // Derivatives along v first: row i of along_v[l] is the l-th v-derivative of the i-th row of the
  // net.
  std::array<HomogeneousPoles, 4> along_v;
  along_v.fill(HomogeneousPoles(degree_u + 1, 4));
  for (int i = 0; i <= degree_u; ++i) {
    const HomogeneousPoles row = poles.middleRows(i * (degree_v + 1), degree_v + 1);
    const casteljau::Derivatives<4, 4> derivatives = casteljau::derivatives<4, 4>(row, v);
    for (int l = 0; l < 4; ++l) along_v[l].row(i) = derivatives.row(l);
  }
  HomogeneousPartials result;
  for (int l = 0; l < 4; ++l) {
    const casteljau::Derivatives<4, 4> derivatives = casteljau::derivatives<4, 4>(along_v[l], u);
    for (int k = 0; k + l < 4; ++k) result[k][l] = derivatives.row(k).transpose();
  }
  return result;
}

}  // namespace

BezierPatch::BezierPatch(int degree_u, int degree_v, const Eigen::Ref<const Poles>& poles)
    : BezierPatch(degree_u, degree_v, poles, Eigen::VectorXd::Ones(poles.rows())) {}

BezierPatch::BezierPatch(int degree_u, int degree_v, const Eigen::Ref<const Poles>& poles,
                         const Eigen::Ref<const Eigen::VectorXd>& weights)
    : degree_u_(degree_u), degree_v_(degree_v) {
  requireNetSize(degree_u, degree_v, poles.rows());
  homogeneous_ = seamwright::homogeneousPoles(poles, weights);
}

BezierPatch BezierPatch::fromHomogeneous(int degree_u, int degree_v, HomogeneousPoles poles) {
  requireNetSize(degree_u, degree_v, poles.rows());
  requireValid(poles);
  return {Homogeneous{}, degree_u, degree_v, std::move(poles)};
}

bool BezierPatch::isRational() const {
  return seamwright::isRational(homogeneous_);
}

Poles BezierPatch::poles() const {
  return affinePoles(homogeneous_);
}

Eigen::Vector3d BezierPatch::pole(int i, int j) const {
  const auto h = homogeneous_.row(i * (degree_v_ + 1) + j);
  return h.head<3>().transpose() / h(3);
}

Eigen::Vector3d BezierPatch::point(double u, double v) const {
  return isoCurveU(u).point(v);
}

SurfaceJet BezierPatch::jet(double u, double v) const {
  const auto of = [&](const HomogeneousPoles& poles) {
    return affineJet(patchPartials(poles, degree_u_, degree_v_, u, v));
  };
  if (!isRational()) return of(homogeneous_);
  const Eigen::Vector4d value = patchPartials(homogeneous_, degree_u_, degree_v_, u, v)[0][0];
  const Eigen::Vector3d here = value.head<3>() / value(3);
  SurfaceJet result = of(about(homogeneous_, here));
  result.p += here;
  return result;
}

JetNoise BezierPatch::noise() const {
  const double size = poles().cwiseAbs().maxCoeff();
  const double weight_ratio = homogeneous_.col(3).maxCoeff() / homogeneous_.col(3).minCoeff();
  const double unit = 8 * (degree_u_ + degree_v_ + 4) * std::numeric_limits<double>::epsilon() *
                      size * weight_ratio;
  return {unit * degree_u_, unit * degree_v_};
}

BezierPatch BezierPatch::transposed() const {
  HomogeneousPoles result(homogeneous_.rows(), 4);
  for (int i = 0; i <= degree_u_; ++i)
    for (int j = 0; j <= degree_v_; ++j)
      result.row(j * (degree_u_ + 1) + i) = homogeneous_.row(i * (degree_v_ + 1) + j);
  return {Homogeneous{}, degree_v_, degree_u_, std::move(result)};
}

BezierPatch BezierPatch::reversedU() const {
  HomogeneousPoles result(homogeneous_.rows(), 4);
  const int columns = degree_v_ + 1;
  for (int i = 0; i <= degree_u_; ++i)
    result.middleRows(i * columns, columns) =
        homogeneous_.middleRows((degree_u_ - i) * columns, columns);
  return {Homogeneous{}, degree_u_, degree_v_, std::move(result)};
}

std::pair<BezierPatch, BezierPatch> BezierPatch::splitU(double t) const {
  // Each row of the net is one coefficient of a polynomial in u with 4 (n+1) columns.
  using Net = casteljau::Coefficients<Eigen::Dynamic>;
  const Net net = homogeneous_.reshaped<Eigen::RowMajor>(degree_u_ + 1, 4 * (degree_v_ + 1));
  const auto [left, right] = casteljau::split<Eigen::Dynamic>(net, t);
  const auto patch = [&](const Net& half) {
    return BezierPatch(Homogeneous{}, degree_u_, degree_v_,
                       HomogeneousPoles(half.reshaped<Eigen::RowMajor>(homogeneous_.rows(), 4)));
  };
  return {patch(left), patch(right)};
}

BezierCurve BezierPatch::isoCurveU(double u) const {
  using Net = casteljau::Coefficients<Eigen::Dynamic>;
  Net net = homogeneous_.reshaped<Eigen::RowMajor>(degree_u_ + 1, 4 * (degree_v_ + 1));
  const Eigen::RowVectorXd row = casteljau::collapse<Eigen::Dynamic>(net, u);
  const HomogeneousPoles h = row.reshaped<Eigen::RowMajor>(degree_v_ + 1, 4);
  return {affinePoles(h), h.col(3)};
}

}  // namespace seamwright
