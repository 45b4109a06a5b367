// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include <seamwright/core/planar/biarc_spline.hpp>
#include <seamwright/core/planar/clothoid.hpp>
#include <seamwright/core/progress.hpp>

/// The fairing of a run of clothoids between corners: the least variation of the curvature for a
/// shape of the curve. Not a public header.
namespace seamwright {

/// The part of a curve between corners, or all of it.
struct FairingRun {
  PlanarPoints points;
  Eigen::VectorXd tolerances_mm;  ///< 0 for points that stay
  bool closed = false;
  Progress progress = {};

  Eigen::Index count() const { return points.rows(); }
  Eigen::Index segments() const { return closed ? count() : count() - 1; }
  Eigen::Index next(Eigen::Index i) const { return (i + 1) % count(); }
};

/// The curve through the points; two points have a line.
/// \throws as clothoidSpline() does.
std::vector<Clothoid> chainThrough(const PlanarPoints& points, bool closed);

/// Curvatures at the points. They are continuous, so that each is that of the piece after it.
Eigen::VectorXd curvaturesAt(const std::vector<Clothoid>& chain, bool closed);

/// The integral of the squared derivative of the curvature.
double variationOf(const std::vector<Clothoid>& chain);

/// Points, their moves as shares of the tolerances, and the curve.
struct FairingState {
  Eigen::VectorXd shares;
  PlanarPoints points;
  std::vector<Clothoid> chain;
};

/// Bounds of curvatures at points, which keep the curve from turning to the other side, and of
/// their differences, which keep the curvature monotone.
class CurvatureShape {
 public:
  /// sign * curvature >= margin
  void keepSide(Eigen::Index point, double sign, double margin_per_mm) {
    add({{point, sign}}, margin_per_mm);
  }
  /// sign * (curvature at next - curvature at point) >= margin
  void keepSlope(Eigen::Index point, Eigen::Index next, double sign, double margin_per_mm) {
    add({{next, sign}, {point, -sign}}, margin_per_mm);
  }
  Eigen::SparseMatrix<double> rows(Eigen::Index points) const {
    Eigen::SparseMatrix<double> result(std::ssize(margins_per_mm_), points);
    result.setFromTriplets(entries_.begin(), entries_.end());
    return result;
  }
  Eigen::VectorXd margins_per_mm() const {
    return Eigen::VectorXd::Map(margins_per_mm_.data(), std::ssize(margins_per_mm_));
  }
  /// What is missing, summed up.
  double miss(const Eigen::VectorXd& curvatures_per_mm) const {
    const Eigen::VectorXd slack =
        rows(curvatures_per_mm.size()) * curvatures_per_mm - margins_per_mm();
    return (-slack.array()).max(0).sum();
  }

 private:
  void add(std::initializer_list<std::pair<Eigen::Index, double>> terms, double margin_per_mm) {
    for (const auto& [point, factor] : terms)
      entries_.emplace_back(std::ssize(margins_per_mm_), point, factor);
    margins_per_mm_.push_back(margin_per_mm);
  }

  std::vector<Eigen::Triplet<double>> entries_;
  std::vector<double> margins_per_mm_;
};

struct FairingSearch {
  FairingState state;
  int steps = 0;
  bool feasible = false;  ///< the last program had a solution
};

/// The moves of the points of a run, along the normals of fairPoints().
class RunFairing {
 public:
  RunFairing(const FairingRun& run, const PlanarPoints& fair_points);

  /// The run with its points moved to these, as far as normals and tolerances allow; none if there
  /// is no curve through them.
  std::optional<FairingState> stateAt(const PlanarPoints& points) const;

  /// Sequential quadratic programming.
  /// \param steps_before of other searches, for the progress.
  FairingSearch improved(FairingState now, const CurvatureShape& shape, int steps_before) const;

 private:
  std::optional<FairingState> stateOf(const Eigen::VectorXd& shares) const;
  double meritOf(const std::vector<Clothoid>& chain, const CurvatureShape& shape,
                 double penalty) const;
  bool takeStep(FairingState& now, const Eigen::VectorXd& change, const CurvatureShape& shape,
                double penalty) const;

  const FairingRun& run_;
  PlanarPoints normals_;
};

}  // namespace seamwright
