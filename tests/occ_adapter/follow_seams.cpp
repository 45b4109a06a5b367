// SPDX-License-Identifier: LGPL-2.1-or-later
#include "follow_seams.hpp"

#include <BRep_Builder.hxx>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <cmath>

#include <seamwright/occ_adapter/analyze/measure_seam.hpp>

namespace seamwright::test {

namespace {

Eigen::Vector3d vector(const gp_XYZ& xyz) {
  return {xyz.X(), xyz.Y(), xyz.Z()};
}

handle<Geom_BSplineCurve> inSpace(const PathOn& side) {
  constexpr int points = 30;
  const handle<TColgp_HArray1OfPnt> through = new TColgp_HArray1OfPnt(1, points);
  const handle<TColStd_HArray1OfReal> at = new TColStd_HArray1OfReal(1, points);
  for (int k = 0; k < points; ++k) {
    const double t = k / (points - 1.0);
    const gp_Pnt2d uv = side.path->Value(t);
    through->SetValue(k + 1, side.surface->Value(uv.X(), uv.Y()));
    at->SetValue(k + 1, t);
  }
  GeomAPI_Interpolate interpolation(through, at, false, 1e-9);
  interpolation.Perform();
  return interpolation.Curve();
}

}  // namespace

occ::Seam seamBetween(const PathOn& a, const PathOn& b, const std::array<int, 2>& faces,
                      const std::array<TopoDS_Vertex, 2>& ends) {
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge, inSpace(a), 1);
  builder.Range(edge, 0, 1);
  for (const int end : {0, 1})
    if (!ends[end].IsNull())
      builder.Add(edge, ends[end].Oriented(end == 0 ? TopAbs_FORWARD : TopAbs_REVERSED));
  occ::Seam seam;
  seam.id = 1;
  seam.edges = {1};
  int number = 0;
  for (const PathOn* side : {&a, &b}) {
    builder.UpdateEdge(edge, side->path, side->surface, TopLoc_Location(), 1);
    occ::FaceUse& use = seam.sides[number];
    use.face = faces[number++];
    builder.MakeFace(use.shape, side->surface, 1e-7);
    use.edge = TopoDS::Edge(edge.Oriented(side->face_on_left ? TopAbs_FORWARD : TopAbs_REVERSED));
  }
  return seam;
}

occ::SeamResult certified(const occ::Seam& seam, const ContinuityTolerance& tolerance, int order) {
  occ::AnalyzeOptions options;
  options.tolerance = tolerance;
  options.level = order == 1 ? Level::G1 : Level::G2;
  return occ::measureSeam(seam, options);
}

occ::TargetPoint shownBy(const handle<Geom_Surface>& surface, const gp_Pnt2d& uv, double sign) {
  gp_Pnt p;
  gp_Vec u, v, uu, vv, uv2;
  surface->D2(uv.X(), uv.Y(), p, u, v, uu, vv, uv2);
  const Eigen::Vector3d n = sign * vector(u.Crossed(v).XYZ()).normalized();
  // W = J I^-1 II I^-1 J^T
  Eigen::Matrix<double, 3, 2> j;
  j << vector(u.XYZ()), vector(v.XYZ());
  Eigen::Matrix2d second;
  second << n.dot(vector(uu.XYZ())), n.dot(vector(uv2.XYZ())), n.dot(vector(uv2.XYZ())),
      n.dot(vector(vv.XYZ()));
  const Eigen::Matrix2d inverse = (j.transpose() * j).inverse();
  return {vector(p.XYZ()), n, j * inverse * second * inverse * j.transpose()};
}

occ::Pcurve wholePath(const handle<Geom2d_Curve>& path) {
  return {path, 0, 1, {}};
}

occ::FollowPath pathTo(const PathOn& own, const PathOn& shown, int order, double sign) {
  occ::FollowPath path;
  path.path = wholePath(own.path);
  path.order = order;
  path.face_on_left = own.face_on_left;
  path.target = [=](double s) { return shownBy(shown.surface, shown.path->Value(s), sign); };
  return path;
}

void addNoise(const Spline& surface, std::mt19937& generator, double size) {
  disturb(surface, generator, surface->NbUPoles(), size);
}

ContinuityTolerance fine() {
  ContinuityTolerance tolerance;
  tolerance.gap_mm = 0.001;
  tolerance.angle_rad = 0.01 * degree;
  tolerance.curvature_rel = 0.02;
  return tolerance;
}

double logRandom(std::mt19937& generator, double size, double span) {
  return size * std::pow(10, -span * std::uniform_real_distribution<double>(0, 1)(generator));
}

}  // namespace seamwright::test
