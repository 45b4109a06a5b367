// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomLProp_SLProps.hxx>
#include <IGESControl_Reader.hxx>
#include <LocalAnalysis_SurfaceContinuity.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <optional>
#include <stdexcept>

#include "peers.hpp"

namespace seamwright::bench {

namespace {

/// One side of a seam in OpenCASCADE's terms.
class Side {
 public:
  explicit Side(const occ::Coedge& use)
      : path_(BRep_Tool::CurveOnSurface(use.edge, use.shape, first_, last_)),
        properties_(BRep_Tool::Surface(use.shape), 2, 1e-7) {}

  bool hasPath() const { return !path_.IsNull(); }
  GeomLProp_SLProps& at(double s) {
    const gp_Pnt2d place = path_->Value(first_ + s * (last_ - first_));
    properties_.SetParameters(place.X(), place.Y());
    return properties_;
  }

 private:
  double first_ = 0;
  double last_ = 0;
  opencascade::handle<Geom2d_Curve> path_;
  GeomLProp_SLProps properties_;
};

void analyzeSeam(const occ::Seam& seam, int points, LocalAnalysisSummary& summary) {
  Side a(seam.sides[0]);
  Side b(seam.sides[1]);
  if (!a.hasPath() || !b.hasPath()) return;
  LocalAnalysis_SurfaceContinuity analysis;
  for (int i = 0; i < points; ++i) {
    const double s = (i + 0.5) / points;
    analysis.ComputeAnalysis(a.at(s), b.at(s), GeomAbs_G2);
    if (!analysis.IsDone()) continue;
    summary.gap_mm = std::max(summary.gap_mm, analysis.C0Value());
    summary.angle_rad = std::max(summary.angle_rad, analysis.G1Angle());
    ++summary.points;
  }
}

template <typename Reader>
TopoDS_Shape transfer(const std::filesystem::path& path) {
  Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw std::runtime_error(path.string() + ": not read");
  reader.TransferRoots();
  return reader.OneShape();
}

}  // namespace

TopoDS_Shape readWithOpenCascade(const std::filesystem::path& path) {
  const std::string extension = path.extension();
  if (extension == ".step" || extension == ".stp") return transfer<STEPControl_Reader>(path);
  if (extension == ".iges" || extension == ".igs") return transfer<IGESControl_Reader>(path);
  TopoDS_Shape shape;
  if (!BRepTools::Read(shape, path.c_str(), BRep_Builder()))
    throw std::runtime_error(path.string() + ": not read");
  return shape;
}

LocalAnalysisSummary localAnalysis(const std::vector<occ::Seam>& seams, int points) {
  LocalAnalysisSummary summary;
  for (const occ::Seam& seam : seams) {
    try {
      analyzeSeam(seam, points, summary);
    } catch (const Standard_Failure&) {  // skip the rest of a seam after a point without a normal
    }
  }
  return summary;
}

RegularityPeer::RegularityPeer(const TopoDS_Shape& shape)
    : copy_(BRepBuilderAPI_Copy(shape, false).Shape()), seams_(occ::findSeams(copy_).seams) {}

void RegularityPeer::forget() {
  const BRep_Builder builder;
  for (const occ::Seam& seam : seams_)
    builder.Continuity(seam.sides[0].edge, seam.sides[0].shape, seam.sides[1].shape, GeomAbs_C0);
}

void RegularityPeer::encode(double angle_rad) const {
  BRepLib::EncodeRegularity(copy_, angle_rad);
}

}  // namespace seamwright::bench
