// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/planar/arc.hpp>
#include <string>
#include <vector>

/// Drawings of arcs and lines as text.
namespace seamwright::cli {

/// Arcs and lines end to end.
struct ArcOutline {
  std::vector<PlanarArc> arcs;
  bool closed = false;
};

/// An outline to draw, and its distance from the curve that it stands for.
struct DrawnOutline {
  ArcOutline outline;
  double distance_mm = 0;
};

/// The outline with lines in place of arcs that turn by less than 1e-5 rad, where the line is
/// within \p most_mm of the arc. Programs that read a drawing compute the centre of an arc from its
/// ends, and lose as many digits as the radius has lengths: they put such an arc elsewhere, or
/// leave it out.
DrawnOutline withFlatArcsStraight(ArcOutline outline, double most_mm);

/// A DXF file of the version R12 in ASCII, in mm, which $INSUNITS and $MEASUREMENT state. One line
/// is a LINE, one arc an ARC, a full circle a CIRCLE, everything else a POLYLINE with bulges,
/// closed if the outline is. A bulge is the tangent of a quarter of the sweep; arcs that turn by
/// more than half a circle become two. Coordinates have the fewest digits that read back as the
/// same double.
std::string dxfText(const std::vector<ArcOutline>& outlines);

/// An SVG file with a path for each outline, 1 unit = 1 mm. The second axis points upwards, as in
/// the plane. Arcs that turn by more than a third of a circle become several.
std::string svgText(const std::vector<ArcOutline>& outlines);

/// A table with a line for each arc: number of the outline, start, end, and for arcs centre, radius
/// and sweep in degrees (above 0 to the left).
std::string arcsCsv(const std::vector<ArcOutline>& outlines);

}  // namespace seamwright::cli
