// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <vector>

#include <seamwright/occ_adapter/seams/find.hpp>

/// What a user of OpenCASCADE would call in Seamwright's place, as fast as its interface allows.
namespace seamwright::bench {

/// The model as OpenCASCADE's own reader gives it, in this process: STEPControl_Reader,
/// IGESControl_Reader or BRepTools, by the ending of the file's name.
/// \throws std::runtime_error if the file can't be read.
TopoDS_Shape readWithOpenCascade(const std::filesystem::path& path);

/// What LocalAnalysis_SurfaceContinuity saw.
struct LocalAnalysisSummary {
  double gap_mm = 0;     ///< largest distance
  double angle_rad = 0;  ///< largest angle of the normals, 0 to pi / 2
  int points = 0;        ///< points that it could judge
};

/// LocalAnalysis_SurfaceContinuity to order G2 at \p points places spread evenly over each seam,
/// not at its ends. Surfaces and pcurves are taken out of the shape and GeomLProp_SLProps is made
/// once for each side of a seam.
LocalAnalysisSummary localAnalysis(const std::vector<occ::Seam>& seams, int points);

/// A copy of a shape whose edges BRepLib::EncodeRegularity can judge again and again.
class RegularityPeer {
 public:
  /// Geometry is shared with \p shape, topology is copied.
  explicit RegularityPeer(const TopoDS_Shape& shape);
  /// Every edge forgets its regularity: EncodeRegularity skips edges that have one.
  void forget();
  void encode(double angle_rad) const;

 private:
  TopoDS_Shape copy_;
  std::vector<occ::Seam> seams_;
};

}  // namespace seamwright::bench
