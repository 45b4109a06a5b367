// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include <seamwright/occ_adapter/convert/natural_face.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;
using opencascade::handle;

struct CurveNet {
  Poles poles;
  Eigen::VectorXd weights;
};

template <class Curve>
CurveNet netOf(const Curve& curve) {
  CurveNet net{Poles(curve.NbPoles(), 3), Eigen::VectorXd(curve.NbPoles())};
  for (int i = 0; i < curve.NbPoles(); ++i) {
    net.poles.row(i) = vector(curve.Pole(i + 1));
    net.weights(i) = curve.Weight(i + 1);
  }
  return net;
}

template <class Surface>
Poles polesOf(const Surface& surface) {
  Poles poles(surface.NbUPoles() * surface.NbVPoles(), 3);
  Eigen::Index row = 0;
  for (int i = 1; i <= surface.NbUPoles(); ++i)
    for (int j = 1; j <= surface.NbVPoles(); ++j) poles.row(row++) = vector(surface.Pole(i, j));
  return poles;
}

Poles polesOf(const Geom_BoundedSurface& surface) {
  if (const auto* bezier = dynamic_cast<const Geom_BezierSurface*>(&surface))
    return polesOf<Geom_BezierSurface>(*bezier);
  if (const auto* spline = dynamic_cast<const Geom_BSplineSurface*>(&surface))
    return polesOf<Geom_BSplineSurface>(*spline);
  throw std::domain_error(std::string(surface.DynamicType()->Name()) +
                          " is not a Bezier or B-spline surface");
}

double farthest(const Poles& points, const Vector3d& from) {
  return (points.rowwise() - from.transpose()).rowwise().norm().maxCoeff();
}

/// A side of the surface, in the sense of the parameter.
struct Side {
  handle<Geom_Curve> curve;
  CurveNet net;
  handle<Geom2d_Line> path;
  double first = 0, last = 1;
  int start = 0, end = 0;  ///< corners
  bool is_point = false;
};

/// Of two sides with the same weights: the largest distance of their poles.
double poleDistance(const Side& a, const Side& b) {
  return (a.net.poles - b.net.poles).rowwise().norm().maxCoeff();
}

/// Sides and corners are numbered around the rectangle of parameters: v0, u1, v1, u0, and the
/// corner k is where side k begins in that sense.
class NaturalFace {
 public:
  NaturalFace(const handle<Geom_BoundedSurface>& surface, double tolerance_mm)
      : tolerance_mm_(tolerance_mm) {
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    surface->Bounds(u0, u1, v0, v1);
    const Range u{.first = u0, .last = u1}, v{.first = v0, .last = v1};
    sides_ = {side(surface->VIso(v0), u, new Geom2d_Line(gp_Pnt2d(0, v0), gp::DX2d())),
              side(surface->UIso(u1), v, new Geom2d_Line(gp_Pnt2d(u1, 0), gp::DY2d())),
              side(surface->VIso(v1), u, new Geom2d_Line(gp_Pnt2d(0, v1), gp::DX2d())),
              side(surface->UIso(u0), v, new Geom2d_Line(gp_Pnt2d(u0, 0), gp::DY2d()))};
    // The wire runs along v0 and u1 with the parameter, and along v1 and u0 against it.
    for (int k = 0; k < 4; ++k) {
      sides_.at(k).start = k < 2 ? k : (k + 1) % 4;
      sides_.at(k).end = k < 2 ? k + 1 : k;
    }
    builder_.MakeFace(face_, surface, Precision::Confusion());
    closed_v_ = coincide(sides_[0], sides_[2]);
    closed_u_ = coincide(sides_[1], sides_[3]);
    joinCorners();
  }

  TopoDS_Face face() {
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    const TopoDS_Edge v0 = closed_v_ ? closedEdge(0, 2) : edge(0),
                      u1 = closed_u_ ? closedEdge(1, 3) : edge(1);
    builder_.Add(wire, v0);
    builder_.Add(wire, u1);
    builder_.Add(wire, (closed_v_ ? v0 : edge(2)).Reversed());
    builder_.Add(wire, (closed_u_ ? u1 : edge(3)).Reversed());
    wire.Closed(true);
    builder_.Add(face_, wire);
    builder_.NaturalRestriction(face_, true);
    return face_;
  }

 private:
  struct Range {
    double first, last;
  };

  Side side(const handle<Geom_Curve>& curve, Range range, const handle<Geom2d_Line>& path) const {
    Side result{.curve = curve, .net = {}, .path = path, .first = range.first, .last = range.last};
    const auto bezier = handle<Geom_BezierCurve>::DownCast(curve);
    result.net =
        bezier.IsNull() ? netOf(*handle<Geom_BSplineCurve>::DownCast(curve)) : netOf(*bezier);
    result.is_point = farthest(result.net.poles, result.net.poles.row(0)) <= tolerance_mm_;
    return result;
  }

  bool coincide(const Side& a, const Side& b) const {
    return !a.is_point && !b.is_point && a.net.weights == b.net.weights &&
           poleDistance(a, b) <= tolerance_mm_;
  }

  Vector3d corner(int k) const {
    const Side& side = sides_.at(k);
    return side.start == k ? side.net.poles.row(0) : side.net.poles.row(side.net.poles.rows() - 1);
  }

  /// One vertex for the corners at both ends of a point, and of sides that are one edge.
  void joinCorners() {
    std::array<int, 4> group = {0, 1, 2, 3};
    const auto join = [&group](int a, int b) { std::ranges::replace(group, group[a], group[b]); };
    for (const Side& side : sides_)
      if (side.is_point) join(side.end, side.start);
    if (closed_v_) join(3, 0), join(2, 1);
    if (closed_u_) join(1, 0), join(2, 3);
    for (int k = 0; k < 4; ++k) {
      TopoDS_Vertex& vertex = vertices_.at(group[k]);
      if (vertex.IsNull())
        builder_.MakeVertex(vertex, pointOf(corner(group[k])), Precision::Confusion());
      cover(vertex, corner(k).transpose());
      vertices_.at(k) = vertex;
    }
    for (const Side& side : sides_)
      if (side.is_point) cover(vertices_.at(side.start), side.net.poles);
  }

  /// The tolerance of the vertex grows to the distance of the points.
  void cover(const TopoDS_Vertex& vertex, const Poles& points) const {
    // The distance itself has a rounding.
    constexpr double rounding = 1 + 1e-12;
    builder_.UpdateVertex(vertex, rounding * farthest(points, vector(BRep_Tool::Pnt(vertex))));
  }

  /// An edge with the curve of the side, or of a point with none.
  TopoDS_Edge edgeWithout(const Side& side) const {
    TopoDS_Edge edge;
    if (side.is_point) {
      builder_.MakeEdge(edge);
      builder_.Degenerated(edge, true);
    } else {
      builder_.MakeEdge(edge, side.curve, Precision::Confusion());
    }
    builder_.Add(edge, vertices_.at(side.start).Oriented(TopAbs_FORWARD));
    builder_.Add(edge, vertices_.at(side.end).Oriented(TopAbs_REVERSED));
    return edge;
  }

  TopoDS_Edge edge(int k) const {
    const Side& side = sides_.at(k);
    const TopoDS_Edge edge = edgeWithout(side);
    builder_.UpdateEdge(edge, side.path, face_, Precision::Confusion());
    builder_.Range(edge, side.first, side.last);
    return edge;
  }

  /// \param forward, backward sides along which the wire runs with the parameter, and against it.
  TopoDS_Edge closedEdge(int forward, int backward) const {
    const Side &side = sides_.at(forward), &other = sides_.at(backward);
    const TopoDS_Edge edge = edgeWithout(side);
    const double tolerance_mm = std::max(Precision::Confusion(), poleDistance(side, other));
    builder_.UpdateEdge(edge, side.path, other.path, face_, tolerance_mm);
    builder_.Range(edge, side.first, side.last);
    return edge;
  }

  double tolerance_mm_;
  BRep_Builder builder_;
  TopoDS_Face face_;
  std::array<Side, 4> sides_;
  bool closed_u_ = false, closed_v_ = false;
  std::array<TopoDS_Vertex, 4> vertices_;
};

}  // namespace

void requireArea(const Poles& poles, double tolerance_mm) {
  Eigen::Index far = 0;
  const Vector3d origin = poles.row(0);
  const double length_mm = (poles.rowwise() - origin.transpose()).rowwise().norm().maxCoeff(&far);
  if (length_mm <= tolerance_mm)
    throw std::invalid_argument(
        fmt::format("all poles are within {:.3g} mm of a point, ({:.6g}, {:.6g}, {:.6g}): the face "
                    "would have no area",
                    tolerance_mm, origin.x(), origin.y(), origin.z()));
  const Vector3d along = (poles.row(far).transpose() - origin) / length_mm;
  double width_mm = 0;
  for (Eigen::Index i = 0; i < poles.rows(); ++i)
    width_mm = std::max(width_mm, (poles.row(i).transpose() - origin).cross(along).norm());
  if (width_mm <= tolerance_mm)
    throw std::invalid_argument(fmt::format(
        "all poles are within {:.3g} mm of a line: the face would have no area", tolerance_mm));
}

TopoDS_Face naturalFace(const handle<Geom_BoundedSurface>& surface, double tolerance_mm) {
  requireArea(polesOf(*surface), tolerance_mm);
  return NaturalFace(surface, tolerance_mm).face();
}

}  // namespace seamwright::occ
