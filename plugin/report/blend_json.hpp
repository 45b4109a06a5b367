// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <seamwright/core/seam/judge.hpp>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/plugin/report/curve_json.hpp>
#include <string>
#include <vector>

namespace seamwright::report {

/// A key curve of a blend.
struct KeyCurveRecord {
  std::size_t input = 0;        ///< index of its file
  std::vector<int> edges = {};  ///< of a model; empty for points
  std::ptrdiff_t points = 0;    ///< of a file of points; 0 for edges
  double omega = 0;
  int segments = 0;          ///< before the curves were matched
  double gap_mm = 0;         ///< the largest gap that was closed
  double refitted_mm = 0;    ///< bound of the distance of the curve over common knots
  double polynomial_mm = 0;  ///< bound of the distance from the rational curve of the model
};

/// A place of a key curve that corresponds to one of each other.
struct MatchedPlaceRecord {
  std::optional<int> point = {};  ///< number in its file, from 1
  double length_share = 0;        ///< of the key curve as it is given
  Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();
};

struct MatchedPairRecord {
  std::string kind;                             ///< start, corner, jump, extremum or given
  std::vector<MatchedPlaceRecord> places = {};  ///< one for each key curve
};

/// A joint of a frame.
struct BlendJointRecord {
  int joint = 0;                  ///< from 1 along the frame; of a closed one the last is its start
  int order = 0;                  ///< n of the G^n that holds
  std::vector<double> beta = {};  ///< beta_1..beta_n
  std::vector<double> defects = {};  ///< of derivatives by arc length, times powers of the length
  std::string remedy = {};
  double moved_mm = 0;  ///< of poles, from linear blending
};

struct BlendFrameRecord {
  double omega = 0;
  double length_mm = 0;
  std::vector<BlendJointRecord> joints = {};
};

/// A line of joints of the loft, with proven figures.
struct LoftLineRecord {
  int joint = 0;
  int order = 0;  ///< n of the G^n that all key curves have there, up to the order asked for
  SeamFigures figures = {};
};

struct BlendLoftRecord {
  int degree_u = 0, degree_v = 0;
  int poles_u = 0, poles_v = 0;
  double distance_mm = 0;  ///< of the iso-curves from the frames, measured between stations
  bool reached = false;    ///< the distance is within the tolerance
  int faces = 1;           ///< one for each part between lines of corners
  std::vector<LoftLineRecord> lines = {};
};

/// A run of `seamwright curve blend`.
struct BlendReport {
  std::vector<occ::ModelFacts> inputs;
  int order = 0;
  double tolerance_mm = 0;
  std::string match;
  std::string in_between = {};
  bool closed = false;
  std::vector<KeyCurveRecord> key_curves = {};
  std::vector<MatchedPairRecord> pairs = {};
  std::vector<BlendFrameRecord> frames = {};
  std::optional<BlendLoftRecord> loft = {};
  std::vector<std::string> notes = {};
  std::optional<CurveOutput> output = {};

  /// Every joint has the order asked for, or that of the key curves where it is lower, and the loft
  /// is within the tolerance.
  bool reached = false;
};

/// The object "seamwright.blend/1" (docs/blend-1.schema.json), lengths in mm.
nlohmann::ordered_json toJson(const BlendReport& report);

/// A line for the key curves, the joints, the loft and the output.
std::string toText(const BlendReport& report);

}  // namespace seamwright::report
