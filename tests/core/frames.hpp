// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <seamwright/core/blend/frame_loft.hpp>
#include <seamwright/core/join/curve/beta.hpp>

#include "support/random.hpp"

/// Random frames that are exactly G^n, and what tests of lofts share.
namespace seamwright::test {

inline double drawn(double from, double to, std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

/// Frames of a chain: each segment continues the one before by nextPoles() with betas that depend
/// on omega; the other poles are polynomials of omega. So frames are G^n for every omega.
struct ChainFrames {
  int order = 2, degree = 5, segments = 3;
  std::vector<Poles> poles;            ///< coefficients of powers of omega
  std::vector<Eigen::MatrixXd> betas;  ///< likewise; one row for each segment
  std::vector<double> knots;

  BezierSpline operator()(double omega) const {
    Poles at = Poles::Zero(poles.front().rows(), 3);
    for (auto p = poles.rbegin(); p != poles.rend(); ++p) at = omega * at + *p;
    Eigen::MatrixXd beta = Eigen::MatrixXd::Zero(segments, order);
    for (auto b = betas.rbegin(); b != betas.rend(); ++b) beta = omega * beta + *b;
    std::vector<BezierCurve> curves;
    for (int i = 0; i < segments; ++i) {
      BezierCurve curve(at.middleRows(static_cast<Eigen::Index>(i) * degree, degree + 1));
      if (i > 0 && order > 0) {
        HomogeneousPoles rows = curve.homogeneousPoles();
        rows.topRows(order + 1) = nextPoles(
            curves.back(), degree,
            {.beta = beta.row(i).transpose(), .length = 1, .next_length = 1, .scale = {}});
        curve = BezierCurve::fromHomogeneous(rows);
      } else if (i > 0) {
        HomogeneousPoles rows = curve.homogeneousPoles();
        rows.row(0) = curves.back().homogeneousPoles().row(degree);
        curve = BezierCurve::fromHomogeneous(rows);
      }
      curves.push_back(curve);
    }
    return bezierSpline(curves, knots);
  }
};

/// \param power the degree of the poles in omega. \param equal the betas do not depend on omega.
inline ChainFrames chainFrames(int order, int segments, int power, bool equal,
                               std::mt19937_64& random) {
  ChainFrames result;
  result.order = order;
  result.degree = std::max(1, 2 * order + 1);
  result.segments = segments;
  for (int i = 0; i <= segments; ++i) result.knots.push_back(i);
  const Eigen::Index rows = static_cast<Eigen::Index>(segments) * result.degree + 1;
  for (int k = 0; k <= power; ++k) {
    Poles p(rows, 3);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double t = static_cast<double>(i) / result.degree;
      p.row(i) << drawn(-0.3, 0.3, random), drawn(-0.3, 0.3, random), drawn(-0.3, 0.3, random);
      if (k == 0) p.row(i) += Eigen::RowVector3d(10 * t, 4 * std::sin(1.3 * t), 0);
      if (k == 1) p.row(i) += Eigen::RowVector3d(0, std::cos(t), 8);
    }
    result.poles.push_back(p);
  }
  for (int k = 0; k <= (equal ? 0 : 1); ++k) {
    Eigen::MatrixXd beta(segments, order);
    for (Eigen::Index i = 0; i < segments; ++i)
      for (Eigen::Index j = 0; j < order; ++j)
        beta(i, j) = k == 0 && j == 0 ? drawn(0.8, 1.3, random) : drawn(-0.25, 0.25, random);
    result.betas.push_back(beta);
  }
  return result;
}

/// The largest distance of a surface from a frame, at equal parameters of the segments, by
/// evaluation.
inline double distanceAt(const BSplineSurface& surface, const BezierSpline& frame, double omega) {
  std::vector<double> knots = surface.knots_u;
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  double result = 0;
  for (int i = 0; i < frame.segments(); ++i)
    for (int k = 0; k <= 8; ++k) {
      const double t = k / 8.0, u = knots[i] + t * (knots[i + 1] - knots[i]);
      result = std::max(result, (jet(surface, u, omega).p - segment(frame, i).point(t)).norm());
    }
  return result;
}

/// A tolerance far below that of a user, so that enclosures are narrow.
inline ContinuityTolerance narrowTolerance() {
  ContinuityTolerance tolerance;
  tolerance.gap_mm = 1e-9;
  tolerance.angle_rad = 1e-9;
  tolerance.curvature_rel = 1e-7;
  return tolerance;
}

/// The seam is certified with G0, G1 or G2 by these bounds.
inline void expectCertified(const SeamFigures& figures, int order, const testing::Message& what,
                            double angle_rad = 1e-8, double curvature_rel = 1e-5) {
  ASSERT_TRUE(figures.certified) << what << figures.uncertified;
  EXPECT_LE(*figures.gap_mm->upper, 1e-9) << what;
  EXPECT_FALSE(figures.fold_at) << what;
  if (order > 0) {
    EXPECT_LE(*figures.angle_rad->upper, angle_rad) << what;
  }
  if (order > 1) {
    EXPECT_LE(*figures.curvature_rel->upper, curvature_rel) << what;
  }
}

}  // namespace seamwright::test
