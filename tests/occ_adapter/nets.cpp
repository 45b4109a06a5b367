// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nets.hpp"

#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>

namespace seamwright::test {

namespace {

/// The Greville parameters of poles. Knots of full multiplicity at the ends do not matter here.
struct PoleParameters {
  std::vector<double> parameters;

  PoleParameters(const TColStd_Array1OfReal& flat, int degree, int count) {
    for (int i = 0; i < count; ++i) {
      double sum = 0;
      for (int k = 1; k <= degree; ++k) sum += flat(flat.Lower() + i + k);
      parameters.push_back(sum / degree);
    }
  }
};

double longestSpan(const TColStd_Array1OfReal& knots) {
  double longest = 0;
  for (int i = knots.Lower(); i < knots.Upper(); ++i)
    longest = std::max(longest, knots(i + 1) - knots(i));
  return longest;
}

gp_Vec anyBelow(double length, std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-length, length);
  for (;;) {
    const gp_Vec offset(coordinate(random), coordinate(random), coordinate(random));
    if (offset.SquareMagnitude() < length * length) return offset;
  }
}

std::vector<int> usesOf(const Net& net) {
  std::vector<int> uses(net.edges.size(), 0);
  for (const NetFace& face : net.faces)
    for (const NetSide& side : face.sides) ++uses[side.edge];
  return uses;
}

/// Points along the sides that are seams, in the parameter plane.
std::vector<gp_Pnt2d> seamPoints(const NetFace& face, const std::vector<int>& uses) {
  constexpr int points = 60;
  std::vector<gp_Pnt2d> result;
  for (const NetSide& side : face.sides)
    if (uses[side.edge] > 1)
      for (int k = 0; k <= points; ++k) result.push_back(side.path->Value(k / (1.0 * points)));
  return result;
}

class NetBuilder {
 public:
  explicit NetBuilder(const Net& net) : net_(net) {}

  TopoDS_Shape build() {
    for (const gp_Pnt& point : net_.vertices) {
      vertices_.emplace_back();
      builder_.MakeVertex(vertices_.back(), point, 1e-7);
    }
    for (const NetEdge& edge : net_.edges) {
      edges_.emplace_back();
      if (edge.curve.IsNull()) {
        builder_.MakeEdge(edges_.back());
        builder_.Degenerated(edges_.back(), true);
      } else {
        builder_.MakeEdge(edges_.back(), edge.curve, 1e-7);
      }
      builder_.Range(edges_.back(), 0, 1);
      builder_.Add(edges_.back(), vertices_[edge.ends[0]].Oriented(TopAbs_FORWARD));
      builder_.Add(edges_.back(), vertices_[edge.ends[1]].Oriented(TopAbs_REVERSED));
    }
    TopoDS_Shell shell;
    builder_.MakeShell(shell);
    for (const NetFace& face : net_.faces)
      builder_.Add(shell, face.turned ? faceOf(face).Reversed() : TopoDS_Shape(faceOf(face)));
    if (!net_.closed) return shell;
    shell.Closed(true);
    TopoDS_Solid solid;
    builder_.MakeSolid(solid);
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shell, properties);
    builder_.Add(solid, properties.Mass() > 0 ? shell : shell.Reversed());
    return solid;
  }

 private:
  TopoDS_Face faceOf(const NetFace& net_face) {
    TopoDS_Face face;
    builder_.MakeFace(face, opencascade::handle<Geom_Surface>(net_face.surface), 1e-7);
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (const NetSide& side : net_face.sides) {
      const TopoDS_Edge& edge = edges_[side.edge];
      builder_.UpdateEdge(edge, side.path, face, needed(side, net_face.surface));
      builder_.Range(edge, face, 0, 1);
      builder_.Add(wire, edge.Oriented(side.reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
    }
    wire.Closed(true);
    builder_.Add(face, wire);
    return face;
  }

  /// Also sees to the vertices.
  double needed(const NetSide& side, const Spline& surface) {
    constexpr int points = 200;
    constexpr double margin = 1.2, rounding = 1e-7;
    const NetEdge& edge = net_.edges[side.edge];
    const auto at = [&](double t) {
      const gp_Pnt2d uv = side.path->Value(t);
      return surface->Value(uv.X(), uv.Y());
    };
    const auto onEdge = [&](double t) {
      return edge.curve.IsNull() ? net_.vertices[edge.ends[0]] : edge.curve->Value(t);
    };
    double largest = 0;
    for (int k = 0; k <= points; ++k) {
      const double t = k / (1.0 * points);
      largest = std::max(largest, at(t).Distance(onEdge(t)));
    }
    const double tolerance = margin * largest + rounding;
    for (const int end : {0, 1}) {
      const gp_Pnt& vertex = net_.vertices[edge.ends[end]];
      const double away = std::max(at(end).Distance(vertex), onEdge(end).Distance(vertex));
      builder_.UpdateVertex(vertices_[edge.ends[end]],
                            std::max(tolerance, margin * away + rounding));
    }
    return tolerance;
  }

  const Net& net_;
  BRep_Builder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  std::vector<TopoDS_Edge> edges_;
};

}  // namespace

void disturbNear(const std::vector<gp_Pnt2d>& seams, double noise_mm, std::mt19937& random,
                 Geom_BSplineSurface& surface) {
  const PoleParameters u(surface.UKnotSequence(), surface.UDegree(), surface.NbUPoles());
  const PoleParameters v(surface.VKnotSequence(), surface.VDegree(), surface.NbVPoles());
  const double span_u = longestSpan(surface.UKnots()), span_v = longestSpan(surface.VKnots());
  for (int i = 1; i <= surface.NbUPoles(); ++i)
    for (int j = 1; j <= surface.NbVPoles(); ++j) {
      const bool near = std::ranges::any_of(seams, [&](const gp_Pnt2d& uv) {
        return std::hypot((uv.X() - u.parameters[i - 1]) / span_u,
                          (uv.Y() - v.parameters[j - 1]) / span_v) < 1;
      });
      if (near) surface.SetPole(i, j, surface.Pole(i, j).Translated(anyBelow(noise_mm, random)));
    }
}

void disturb(Net& net, double noise_mm, std::mt19937& random) {
  const std::vector<int> uses = usesOf(net);
  for (NetFace& face : net.faces)
    disturbNear(seamPoints(face, uses), noise_mm, random, *face.surface);
}

void swapParameters(NetFace& face) {
  face.surface = Spline::DownCast(face.surface->Copy());
  face.surface->ExchangeUV();
  std::ranges::reverse(face.sides);
  for (NetSide& side : face.sides) {
    side.reversed = !side.reversed;
    side.path = opencascade::handle<Geom2d_Curve>::DownCast(
        side.path->Mirrored(gp_Ax2d(gp_Pnt2d(0, 0), gp_Dir2d(1, 1))));
  }
  face.turned = !face.turned;
}

TopoDS_Shape shapeOf(const Net& net) {
  return NetBuilder(net).build();
}

}  // namespace seamwright::test
