// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <random>
#include <string>
#include <vector>

#include "shapes.hpp"

#include <seamwright/occ_adapter/match/match.hpp>

/// Pairs of faces made for the tests of matchFaces(), and what is promised of them.
namespace seamwright::test {

using occ::FaceMatchOptions;
using occ::matchFaces;
using occ::MatchMoves;
using occ::MatchReport;
using opencascade::handle;
using Spline = handle<Geom_BSplineSurface>;

double random(std::mt19937& generator, double size = 1);

Spline splineOf(const TColgp_Array2OfPnt& poles, int degree_u, int degree_v);

/// A gently curved sheet of 60 mm by 40 mm.
Spline sheet(std::mt19937& generator, int rows, int columns, int degree_u, int degree_v);

/// The sheet cut at u = 0.4: two surfaces that join smoothly, and share nothing.
std::array<Spline, 2> cutInTwo(const Spline& whole);

/// Moves the poles of the first rows behind u = first.
void disturb(const Spline& surface, std::mt19937& generator, int rows, double size);

/// The edges keep what the gap needs, as those of valid models do.
TopoDS_Shape withTolerance(const TopoDS_Shape& shape, double mm);

TopoDS_Shape joinedSheets(const std::array<Spline, 2>& parts, int side_a = 1, int side_b = 3);

/// Two sheets that were one, disturbed.
std::array<Spline, 2> disturbedSheets(std::mt19937& generator, double noise_mm);

TopoDS_Face face(const TopoDS_Shape& shape, int number);

/// The number of the edge whose middle is nearest to a point.
int edgeNear(const TopoDS_Shape& shape, const gp_Pnt& point);

/// Every path lies within the tolerance of its edge from the curve in space, and the ends of the
/// curve within that of their vertices.
void expectTolerancesHold(const TopoDS_Shape& shape);

/// What is promised of a pair that is matched, seen by plain evaluation.
void expectMatched(const MatchReport& report, const FaceMatchOptions& options,
                   const std::string& what);

MatchReport matchedPair(const TopoDS_Shape& shape, const FaceMatchOptions& options,
                        const std::string& what);

/// Two loose faces.
TopoDS_Shape loose(const TopoDS_Shape& a, const TopoDS_Shape& b);

handle<Geom2d_BSplineCurve> curvedPath(const std::vector<gp_Pnt2d>& points);

/// The part of a surface between a curved path and the same path shifted.
TopoDS_Face trimmedFace(const handle<Geom_Surface>& surface,
                        const handle<Geom2d_BSplineCurve>& path, const gp_Vec2d& shift);

/// A strip of degree 3 by 3 whose rows run through points of a surface over a path that is shifted
/// away more and more: it nearly continues the surface. Row 4 leaves it.
Spline stripBeside(const handle<Geom_Surface>& surface, const handle<Geom2d_BSplineCurve>& path,
                   const gp_Vec2d& shift, int points, std::mt19937& generator, double noise_mm);

TopoDS_Face wholeFace(const Spline& surface);

struct Trimmed {
  std::string name;
  handle<Geom_Surface> surface;
  handle<Geom2d_BSplineCurve> path;
  gp_Vec2d into, away;
};
std::vector<Trimmed> trimmedKinds();

FaceMatchOptions ofOrder(int order);

/// So that noise of 0.001 mm is a defect.
FaceMatchOptions strict(int order);

}  // namespace seamwright::test
