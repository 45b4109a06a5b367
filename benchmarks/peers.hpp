// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <vector>

#include <seamwright/occ_adapter/seams/find.hpp>

/// What a user of OpenCASCADE would call in Seamwright's place, as fast as its interface allows.
namespace seamwright::bench {

/// The model as OpenCASCADE's own reader gives it, in this process: STEPControl_Reader, IGESControl_Reader or BRepTools.
/// \throws std::runtime_error if the file can't be read.
TopoDS_Shape readWithOpenCascade(const std::filesystem::path& path);

/// What LocalAnalysis_SurfaceContinuity is asked to look at; made once, so that its cost is not counted.
struct LocalAnalysisSummary {
  double gap_mm = 0;     ///< largest C0 value
  double angle_rad = 0;  ///< largest G1 angle
  int points = 0;        ///< points that it could judge
};

/// LocalAnalysis_SurfaceContinuity to order G2 at \p points places evenly inside each seam. Surfaces and pcurves are taken out of
/// the shape once a seam, GeomLProp_SLProps is made once a side.
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
