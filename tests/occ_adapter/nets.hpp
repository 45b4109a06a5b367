// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Curve.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <random>
#include <string>
#include <vector>

/// Models of spline faces that are smooth everywhere, by constructions that know nothing of joins,
/// and noise that breaks them.
namespace seamwright::test {

using Spline = opencascade::handle<Geom_BSplineSurface>;

/// A side of a face in the sense of its wire.
struct NetSide {
  int edge = 0;
  bool reversed = false;                   ///< the wire runs against the edge
  opencascade::handle<Geom2d_Curve> path;  ///< over 0..1 in the sense of the edge
};

struct NetFace {
  Spline surface;
  std::vector<NetSide> sides;  ///< counter-clockwise in the parameter plane
  bool turned = false;         ///< it lies in the shell with the other sense
};

struct NetEdge {
  std::array<int, 2> ends{};
  opencascade::handle<Geom_Curve>
      curve;  ///< over 0..1; null: the edge is one point, where a side of a surface collapses
};

struct Net {
  std::vector<gp_Pnt> vertices;
  std::vector<NetEdge> edges;
  std::vector<NetFace> faces;
  bool closed = false;  ///< a solid
};

/// How a surface is divided; each inner vertex has as many seams.
enum class Division {
  Bricks,    ///< hexagons, three
  Quads,     ///< four
  Triangles  ///< rows of quadrilaterals and rows of pairs of triangles, five
};

struct NetShape {
  Division division = Division::Quads;
  int columns = 3;
  int rows = 2;         ///< of bricks on a closed surface: even
  bool closed = false;  ///< a ring, else a sheet
  double bend = 0;  ///< of the seams, in units of a column's width; 0: seams are straight in the
                    ///< parameter plane
  double overhang = 0;     ///< what the surfaces reach beyond their faces in the same unit; 0 with
                           ///< straight seams: natural sides
  bool alternate = false;  ///< every second face has no overhang
  bool refitted = false;   ///< each face has its own degrees, knots and parameters
};

/// One bicubic surface of class C^2 in pieces, each a bit larger than its face or cut off at its
/// sides. A column is about 20 mm wide.
Net piecesOfOne(const NetShape& shape, std::mt19937& random);

enum class Polyhedron {
  Cube,            ///< 6 faces, 12 seams, three at each vertex
  CubeOfFour,      ///< 24 faces, 48 seams, three or four at a vertex
  Triacontahedron  ///< 30 faces, 60 seams, three or five at a vertex
};

/// A smooth star-shaped solid, its faces over those of a polyhedron: fits of degree 5 with natural
/// sides, smooth to the error of the fit.
Net blob(Polyhedron polyhedron, double radius_mm, std::mt19937& random);

/// The upper half of a ball in sectors, from its rim to the top, where a side of each face
/// collapses.
Net dome(int sectors, double radius_mm);

/// The same face with a copy of its surface that has the parameters swapped.
void swapParameters(NetFace& face);

/// Moves the poles over parameters nearer than a knot span to one of those given in the parameter
/// plane, by less than noise_mm each.
void disturbNear(const std::vector<gp_Pnt2d>& seams, double noise_mm, std::mt19937& random,
                 Geom_BSplineSurface& surface);

/// Near the sides of all faces that are seams.
void disturb(Net& net, double noise_mm, std::mt19937& random);

/// A shell, or a solid. The tolerances of edges and vertices are what they need.
TopoDS_Shape shapeOf(const Net& net);

}  // namespace seamwright::test
