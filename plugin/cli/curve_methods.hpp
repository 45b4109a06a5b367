// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/planar/clothoid.hpp>
#include <seamwright/core/planar/planar_chain.hpp>
#include <seamwright/core/progress.hpp>
#include <seamwright/plugin/report/curve_json.hpp>
#include <string>
#include <vector>

namespace seamwright::cli {

/// A curve of the input in the coordinates of its plane: either points or a chain.
struct GivenCurve {
  /// Edges, points, plane and closed are set.
  report::CurveRecord record;
  PlanarPoints points;
  PlanarChain chain;
  double gap_mm = 0;            ///< the largest gap between curves of the chain
  double rounding_mm = 0;       ///< of the points, by the digits of their file
  std::vector<int> lines = {};  ///< of the points in their file
  /// Fairing: of each point; empty if all have that of the task, which is the least of them above 0
  /// otherwise.
  Eigen::VectorXd tolerances_mm = {};
  bool polygon = false;    ///< arcs: the points are corners, with lines between them
  bool free_ends = false;  ///< fairing: the ends move as well
};

/// What a method made of a curve.
struct MadeCurve {
  report::CurveRecord record;
  PlanarChain chain = {};        ///< what a model file holds
  double chain_distance_mm = 0;  ///< of the chain from the clothoids
  std::vector<Clothoid> clothoids = {};
  PlanarPoints points = {};  ///< faired ones
};

struct CurveTask {
  double tolerance_mm = 0;
  Progress progress = {};
};

/// Names of the methods: "arcs", "clothoid", "conic", "fair".
const std::vector<std::string>& curveMethods();

/// \throws std::domain_error, std::invalid_argument and Cancelled as the functions of core do.
MadeCurve madeCurve(const std::string& method, const GivenCurve& given, const CurveTask& task);

}  // namespace seamwright::cli
