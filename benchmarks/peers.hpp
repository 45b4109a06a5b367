// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <vector>

#include <seamwright/occ_adapter/seams/find.hpp>

/// What a user of OpenCASCADE would call instead of Seamwright, as fast as its interface allows.
namespace seamwright::bench {

/// Reads a model in this process with OpenCASCADE's own reader: STEPControl_Reader,
/// IGESControl_Reader or BRepTools, by the extension of the file.
/// \throws std::runtime_error if the file cannot be read.
TopoDS_Shape readWithOpenCascade(const std::filesystem::path& path);

/// The results of LocalAnalysis_SurfaceContinuity.
struct LocalAnalysisSummary {
  double gap_mm = 0;     ///< largest distance
  double angle_rad = 0;  ///< largest angle between the normals, 0 to pi / 2
  int points = 0;        ///< number of points that it could evaluate
};

/// LocalAnalysis_SurfaceContinuity to order G2 at \p points parameters of each seam, equally spaced
/// and without its ends. For each side of a seam, its surface and pcurve are taken out of the shape
/// once, and GeomLProp_SLProps is made once.
LocalAnalysisSummary localAnalysis(const std::vector<occ::Seam>& seams, int points);

/// A copy of a shape for repeated calls of BRepLib::EncodeRegularity.
class RegularityPeer {
 public:
  /// Shares the geometry of \p shape and copies its topology.
  explicit RegularityPeer(const TopoDS_Shape& shape);
  /// Resets the regularity of every edge, since EncodeRegularity skips edges that have one.
  void forget();
  void encode(double angle_rad) const;

 private:
  TopoDS_Shape copy_;
  std::vector<occ::Seam> seams_;
};

}  // namespace seamwright::bench
