// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>

/// Sheets of several faces joined smoothly, and outlines of holes across the joints.
namespace seamwright::test {

/// A plane for x < 0 that goes over into a cylinder of radius 200, 100 by 80 mm.
TopoDS_Shape bentPlate();
/// A wavy spline sheet in 2 x 2 faces of different surfaces, 100 by 80 mm.
TopoDS_Shape quarteredSheet();

/// Outlines in the plane z = 0 around the origin, turned by an angle there.
TopoDS_Wire roundedRectangle(double length_mm, double width_mm, double radius_mm, double turn_rad);
TopoDS_Wire ellipse(double length_mm, double width_mm, double turn_rad);
TopoDS_Wire halfDisc(double radius_mm, double turn_rad);
/// An L of two bars, the reflex corner at the origin.
TopoDS_Wire elbow(double size_mm, double turn_rad);

/// The sheet less what is above and below the outline.
TopoDS_Shape cutThrough(const TopoDS_Shape& sheet, const TopoDS_Wire& outline);

}  // namespace seamwright::test
