// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <vector>

#include <seamwright/core/fill/graph_fill.hpp>
#include <seamwright/core/fill/graph_knots.hpp>

/// The boundary of a spline graph, and what its joints need; not a public header.
namespace seamwright::fill {

/// The square of the smallest box, in units of half its diagonal, around the origin.
struct GraphScale {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double middle_mm = 0, unit_mm = 1;

  GraphSample scaled(GraphSample sample) const {
    sample.at = (sample.at - centre) / unit_mm;
    sample.height_mm = (sample.height_mm - middle_mm) / unit_mm;
    sample.bend_per_mm *= unit_mm;
    sample.speed_mm /= unit_mm;
    return sample;
  }
};

GraphScale scaleOf(const std::vector<GraphBoundary>& boundary);

/// As near to the ends of parts as samples are taken.
inline constexpr double least_t = 1e-5;

/// A part of the boundary, scaled, whose samples are computed once.
class GraphPart {
 public:
  GraphPart(const GraphBoundary& boundary, const GraphScale& scale)
      : boundary_(&boundary), scale_(scale) {}

  /// \throws std::invalid_argument if the sample is not finite.
  const GraphSample& at(double t);

  /// Parameters so close that there are several in each span that the part crosses. Ends are left
  /// out, because a surface may have no tangent plane there.
  std::vector<double> parameters(const GraphKnots& u, const GraphKnots& v);

 private:
  void divide(double from, double to, const GraphKnots& u, const GraphKnots& v,
              std::vector<double>& all);

  const GraphBoundary* boundary_;
  GraphScale scale_;
  std::map<double, GraphSample> samples_;
};

/// Where one part of the boundary ends and the next begins.
struct GraphJoint {
  Eigen::Vector2d at, in, out;        ///< unit tangents of the parts there
  Eigen::Vector2d rate_in, rate_out;  ///< derivatives of the slope along both

  bool isSmooth() const {
    constexpr double least_cosine = 0.9;
    return in.dot(out) > least_cosine;
  }
};

std::vector<GraphJoint> jointsOf(std::vector<GraphPart>& parts);

/// By direction.
using GraphBends = std::array<std::vector<double>, 2>;

/// By direction, where second derivatives may jump, so that the slopes on both sides of a joint can
/// be met. No smoother spline follows them closely.
GraphBends bendsOf(const std::vector<GraphJoint>& joints, const Eigen::Vector2d& low,
                   const Eigen::Vector2d& high);

}  // namespace seamwright::fill
