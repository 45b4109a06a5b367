// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/seam/judge.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

namespace seamwright::occ {

/// Where a seam is worst: the largest value of the figure that keeps it from the next level.
struct WorstPoint {
  std::string quantity;  ///< "gap", "angle", "curvature" or "curvature_change"
  double at = 0;         ///< 0..1 along the seam
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< mm, on side a
};

/// A seam with its figures and their verdict. Edges and faces are numbered from 1, in the order of
/// TopExp::MapShapes.
struct SeamResult {
  int id = 0;  ///< from 1, in the order of Report::seams
  SeamKind kind = SeamKind::Shared;
  std::vector<int> edges;
  std::array<int, 2> faces{};
  double length_mm = 0;
  SeamFigures figures;
  Verdict verdict;
  std::optional<WorstPoint> worst;  ///< nothing where no figure has a value
  std::string note;                 ///< what a user should know of this seam; empty if nothing
};

/// A model as reports name it.
struct ModelFacts {
  std::string path;
  std::string format;
  std::string length_unit;  ///< of the file; all figures are in mm
  int faces = 0;
  int edges = 0;
  std::vector<std::string> notes;
};

/// The seams of a model, judged.
struct Report {
  ModelFacts model;
  ContinuityTolerance tolerance;
  Level level = Level::G1;
  std::vector<SeamResult> seams;
  std::vector<NonSeamEdge> open;          ///< free edges, also those matched in part
  std::vector<NonSeamEdge> non_manifold;  ///< edges at which more than two faces meet
  double read_s = 0;
  double analyze_s = 0;

  /// All seams meet the level; creases are not defects.
  bool passed() const;
};

/// The level of a seam and the largest known values of its figures, in one line.
std::string figuresText(const SeamResult& seam);

/// The worst point of a seam that reaches \p level: where the figure that decides the next level is
/// largest. This is the gap below G0, the angle at G0 (or the fold), the curvature at G1, and its
/// change above. If that figure has no value, the last one before it that has one counts; nothing
/// if none has.
/// \param point_at the point of the seam at 0..1, on side a.
std::optional<WorstPoint> worstPoint(const SeamFigures& figures, Level level,
                                     const std::function<Eigen::Vector3d(double at)>& point_at);

}  // namespace seamwright::occ
