// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <stdexcept>
#include <string>

#include <seamwright/occ_adapter/convert/bezier_surface.hpp>
#include <seamwright/occ_adapter/convert/natural_face.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

void requireDegree(int degree) {
  if (degree < 1 || degree > Geom_BezierCurve::MaxDegree())
    throw std::invalid_argument("degree " + std::to_string(degree) +
                                ": OpenCASCADE holds degrees 1 to " +
                                std::to_string(Geom_BezierCurve::MaxDegree()));
}

[[noreturn]] void refuse(const Standard_Transient& object, const std::string& why) {
  throw std::domain_error(std::string(object.DynamicType()->Name()) + ' ' + why);
}

/// \param count of the knots of a B-spline; \param first, last their multiplicities at the ends.
void requireOneSpan(const Standard_Transient& object, const char* in, int degree, int count,
                    int first, int last) {
  if (count != 2)
    refuse(object, "has " + std::to_string(count - 1) + " spans" + in + ": one is needed");
  if (first != degree + 1 || last != degree + 1)
    refuse(object, std::string("has end knots") + in + " of multiplicities " +
                       std::to_string(first) + " and " + std::to_string(last) +
                       ": degree + 1 is needed");
}

template <class Curve>
BezierCurve curveOf(const Curve& curve) {
  Poles poles(curve.NbPoles(), 3);
  Eigen::VectorXd weights(curve.NbPoles());
  for (int i = 0; i < curve.NbPoles(); ++i) {
    poles.row(i) = vector(curve.Pole(i + 1));
    weights(i) = curve.Weight(i + 1);
  }
  return {poles, weights};
}

template <class Surface>
BezierPatch patchOf(const Surface& surface) {
  const int columns = surface.NbVPoles();
  Poles poles(surface.NbUPoles() * columns, 3);
  Eigen::VectorXd weights(poles.rows());
  for (int i = 0; i < surface.NbUPoles(); ++i)
    for (int j = 0; j < columns; ++j) {
      poles.row(i * columns + j) = vector(surface.Pole(i + 1, j + 1));
      weights(i * columns + j) = surface.Weight(i + 1, j + 1);
    }
  return {surface.UDegree(), surface.VDegree(), poles, weights};
}

/// Makes the three faces over the patches of a triangle. Face k belongs to corner k; M_k is the
/// middle of the edge from corner k to k + 1.
class ShellOfThree {
 public:
  ShellOfThree(const BezierTriangle& triangle, double tolerance_mm)
      : point_mm_(tolerance_mm), patches_(regularPatches(triangle)) {
    for (int k = 0; k < 3; ++k) {
      const int n = patches_[k].degreeU();
      builder_.MakeFace(faces_[k], toBezierSurface(patches_[k]), tolerance_);
      corners_[k] = vertex(patches_[k].pole(0, 0));
      middles_[k] = vertex(patches_[k].pole(n, 0));
    }
    centroid_ = vertex(patches_[0].pole(patches_[0].degreeU(), patches_[0].degreeV()));
    joinCorners();
  }

  TopoDS_Shell shell() {
    std::array<TopoDS_Edge, 3> inner;
    for (int k = 0; k < 3; ++k) {
      inner[k] = innerEdge(k);
      lay(inner[k], (k + 1) % 3, PatchEdge::V1);
    }
    TopoDS_Shell shell;
    builder_.MakeShell(shell);
    for (int k = 0; k < 3; ++k) {
      TopoDS_Wire wire;
      builder_.MakeWire(wire);
      builder_.Add(wire, edge(k, PatchEdge::V0, corners_[k], middles_[k]));
      builder_.Add(wire, inner[k]);
      builder_.Add(wire, inner[(k + 2) % 3].Reversed());
      builder_.Add(wire, edge(k, PatchEdge::U0, corners_[k], middles_[(k + 2) % 3]).Reversed());
      wire.Closed(true);
      builder_.Add(faces_[k], wire);
      builder_.Add(shell, faces_[k]);
    }
    return shell;
  }

 private:
  const double tolerance_ = Precision::Confusion();

  TopoDS_Vertex vertex(const Eigen::Vector3d& p) const {
    TopoDS_Vertex result;
    builder_.MakeVertex(result, pointOf(p), tolerance_);
    return result;
  }

  BezierCurve curveAlong(int k, PatchEdge boundary) const {
    const BezierPatch& patch = patches_[k];
    return boundary == PatchEdge::U0   ? patch.isoCurveU(0)
           : boundary == PatchEdge::U1 ? patch.isoCurveU(1)
                                       : patch.transposed().isoCurveU(0);
  }

  static double extent(const Poles& poles, const Eigen::Vector3d& from) {
    return (poles.rowwise() - from.transpose()).rowwise().norm().maxCoeff();
  }

  bool isPoint(const Poles& poles) const {
    return extent(poles, poles.row(0)) <= std::max(point_mm_, tolerance_);
  }

  /// One vertex for all of an edge of the triangle that is a point.
  void joinCorners() {
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      const std::array<Poles, 2> halves = {curveAlong(k, PatchEdge::V0).poles(),
                                           curveAlong(next, PatchEdge::U0).poles()};
      if (!isPoint(halves[0]) || !isPoint(halves[1])) continue;
      const TopoDS_Vertex joined = corners_[k], old = corners_[next];
      for (TopoDS_Vertex& vertex : corners_)
        if (vertex.IsSame(old)) vertex = joined;
      for (TopoDS_Vertex& vertex : middles_)
        if (vertex.IsSame(old)) vertex = joined;
      middles_[k] = joined;
      // The distance itself has a rounding.
      constexpr double rounding = 1 + 1e-12;
      const Eigen::Vector3d at = vector(BRep_Tool::Pnt(joined));
      for (const Poles& half : halves) builder_.UpdateVertex(joined, rounding * extent(half, at));
    }
  }

  /// The edge from the middle of side k to the centroid.
  TopoDS_Edge innerEdge(int k) const {
    const Poles poles = curveAlong(k, PatchEdge::U1).poles();
    if (isPoint(poles))
      throw std::invalid_argument("the middle of the edge from corner " + std::to_string(k) +
                                  " is the centroid, (" + std::to_string(poles(0, 0)) + ", " +
                                  std::to_string(poles(0, 1)) + ", " + std::to_string(poles(0, 2)) +
                                  "): the triangle has no area there");
    return edge(k, PatchEdge::U1, middles_[k], centroid_);
  }

  /// The edge along that boundary of face k; of a point, a degenerated one.
  TopoDS_Edge edge(int k, PatchEdge boundary, const TopoDS_Vertex& from,
                   const TopoDS_Vertex& to) const {
    const BezierCurve curve = curveAlong(k, boundary);
    TopoDS_Edge result;
    if (from.IsSame(to) && isPoint(curve.poles())) {
      builder_.MakeEdge(result);
      builder_.Degenerated(result, true);
    } else {
      builder_.MakeEdge(result, toBezierCurve(curve), tolerance_);
    }
    builder_.Add(result, from.Oriented(TopAbs_FORWARD));
    builder_.Add(result, to.Oriented(TopAbs_REVERSED));
    lay(result, k, boundary);
    return result;
  }

  /// Gives the edge its path on face k, from 0 to 1 along that boundary.
  void lay(const TopoDS_Edge& edge, int k, PatchEdge boundary) const {
    const bool along_v = boundary == PatchEdge::U0 || boundary == PatchEdge::U1;
    const gp_Pnt2d start(boundary == PatchEdge::U1 ? 1 : 0, boundary == PatchEdge::V1 ? 1 : 0);
    const handle<Geom2d_Line> path = new Geom2d_Line(start, along_v ? gp::DY2d() : gp::DX2d());
    builder_.UpdateEdge(edge, path, faces_[k], tolerance_);
    builder_.Range(edge, 0, 1);
  }

  const double point_mm_;
  BRep_Builder builder_;
  std::array<BezierPatch, 3> patches_;
  std::array<TopoDS_Face, 3> faces_;
  std::array<TopoDS_Vertex, 3> corners_, middles_;
  TopoDS_Vertex centroid_;
};

}  // namespace

handle<Geom_BezierCurve> toBezierCurve(const BezierCurve& curve) {
  requireDegree(curve.degree());
  const Poles rows = curve.poles();
  const Eigen::VectorXd w = curve.weights();
  const int count = curve.degree() + 1;
  TColgp_Array1OfPnt poles(1, count);
  TColStd_Array1OfReal weights(1, count);
  for (int i = 0; i < count; ++i) {
    poles(i + 1) = pointOf(rows.row(i));
    weights(i + 1) = w(i);
  }
  return curve.isRational() ? new Geom_BezierCurve(poles, weights) : new Geom_BezierCurve(poles);
}

handle<Geom_BezierSurface> toBezierSurface(const BezierPatch& patch) {
  requireDegree(patch.degreeU());
  requireDegree(patch.degreeV());
  const Poles rows = patch.poles();
  const Eigen::VectorXd w = patch.weights();
  const int m = patch.degreeU(), n = patch.degreeV();
  TColgp_Array2OfPnt poles(1, m + 1, 1, n + 1);
  TColStd_Array2OfReal weights(1, m + 1, 1, n + 1);
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j) {
      poles(i + 1, j + 1) = pointOf(rows.row(i * (n + 1) + j));
      weights(i + 1, j + 1) = w(i * (n + 1) + j);
    }
  return patch.isRational() ? new Geom_BezierSurface(poles, weights)
                            : new Geom_BezierSurface(poles);
}

BezierCurve bezierCurve(const Geom_Curve& curve) {
  if (const auto* bezier = dynamic_cast<const Geom_BezierCurve*>(&curve)) return curveOf(*bezier);
  const auto* spline = dynamic_cast<const Geom_BSplineCurve*>(&curve);
  if (!spline) refuse(curve, "is not a Bezier curve");
  requireOneSpan(curve, "", spline->Degree(), spline->NbKnots(), spline->Multiplicity(1),
                 spline->Multiplicity(spline->NbKnots()));
  return curveOf(*spline);
}

BezierPatch bezierPatch(const Geom_Surface& surface) {
  if (const auto* bezier = dynamic_cast<const Geom_BezierSurface*>(&surface))
    return patchOf(*bezier);
  const auto* spline = dynamic_cast<const Geom_BSplineSurface*>(&surface);
  if (!spline) refuse(surface, "is not a Bezier surface");
  requireOneSpan(surface, " in u", spline->UDegree(), spline->NbUKnots(), spline->UMultiplicity(1),
                 spline->UMultiplicity(spline->NbUKnots()));
  requireOneSpan(surface, " in v", spline->VDegree(), spline->NbVKnots(), spline->VMultiplicity(1),
                 spline->VMultiplicity(spline->NbVKnots()));
  return patchOf(*spline);
}

std::array<handle<Geom_BezierSurface>, 3> toBezierSurfaces(const BezierTriangle& triangle) {
  requireDegree(triangle.degree());
  const std::array<BezierPatch, 3> patches = regularPatches(triangle);
  return {toBezierSurface(patches[0]), toBezierSurface(patches[1]), toBezierSurface(patches[2])};
}

TopoDS_Shell toShell(const BezierTriangle& triangle, double tolerance_mm) {
  requireDegree(triangle.degree());
  requireArea(triangle.poles(), std::max(tolerance_mm, Precision::Confusion()));
  return ShellOfThree(triangle, tolerance_mm).shell();
}

TriangleRecognition recogniseTriangle(const Geom_Surface& surface,
                                      std::optional<double> tolerance_mm) {
  return seamwright::recogniseTriangle(bezierPatch(surface), tolerance_mm);
}

}  // namespace seamwright::occ
