// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <seamwright/core/planar/plane_frame.hpp>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <string>
#include <vector>

namespace seamwright::report {

/// The shape of a curve before or after the work.
struct CurveFigures {
  double length_mm = 0;
  std::optional<double> energy_per_mm = {};      ///< integral of the squared curvature
  std::optional<double> variation_per_mm3 = {};  ///< of points made fair: ClothoidFigures
  int extrema = 0;
  int inflections = 0;
};

/// One curve of a run of `seamwright curve`.
struct CurveRecord {
  std::vector<int> edges = {};  ///< of the model, from 1; empty for points
  std::ptrdiff_t points = 0;    ///< of a file of points; 0 for edges
  bool closed = false;
  PlaneFrame plane = {};
  double off_plane_mm = 0;  ///< upper bound of the distance of the input from the plane
  int pieces = 0;           ///< arcs and lines, clothoids, conics or spans
  int lines = 0;            ///< of the pieces
  int corners = 0;
  /// No point of the result is further from the curve, and no point of the curve is further from
  /// the result. For points, except to arcs: none of them is further from the result.
  std::optional<double> distance_mm = {};
  std::optional<double> moved_mm = {};  ///< fairing: the largest move of a point
  CurveFigures before = {}, after = {};
  std::vector<std::string> notes = {};
  bool reached = true;  ///< the distance is within the tolerance, and the joints are as asked for
  /// The notes say what falls short of the promise of the method although the distance is kept.
  bool with_reservations = false;
};

/// A curve of the input that could not be done.
struct RefusedCurve {
  std::vector<int> edges = {};  ///< of the model, from 1
  std::string reason = {};
};

/// The file that was written.
struct CurveOutput {
  std::string path;
  std::string format;      ///< "STEP", "DXF", ...
  double distance_mm = 0;  ///< of what was written from the result; 0: exact
};

/// A run of `seamwright curve`.
struct CurveReport {
  std::string method;  ///< "arcs", "clothoid", "conic", "fair"
  occ::ModelFacts input;
  double tolerance_mm = 0;
  std::vector<CurveRecord> curves = {};
  std::vector<RefusedCurve> refused = {};
  std::optional<CurveOutput> output = {};

  /// Every curve is done and within the tolerance.
  bool reached() const;
  bool withReservations() const;
};

/// Path, format and distance of a file; null without one.
nlohmann::ordered_json outputJson(const std::optional<CurveOutput>& output);

/// The object "seamwright.curve/1" (docs/curve-1.schema.json), lengths in mm.
nlohmann::ordered_json toJson(const CurveReport& report);

/// "Edge3,Edge4 and 7 more".
std::string namesOf(const std::vector<int>& edges);

/// One line for each curve, and one for the output.
std::string toText(const CurveReport& report);

}  // namespace seamwright::report
