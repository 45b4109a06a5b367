// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <seamwright/core/angle.hpp>
#include <seamwright/plugin/cli/curve_drawing.hpp>
#include <utility>

namespace seamwright::cli {

namespace {

using Eigen::Vector2d;

bool isLine(const PlanarArc& arc) {
  return arc.curvature_per_mm == 0;
}

/// A sum of sweeps may miss a full turn by its rounding.
bool isCircle(const PlanarArc& arc) {
  return std::abs(arc.sweep_rad()) > 2 * std::numbers::pi * (1 - 1e-12);
}

/// The centre of an arc with a radius of so many lengths loses as many digits; its bulge loses
/// none.
bool isFlat(const PlanarArc& arc) {
  return !isLine(arc) && std::abs(arc.sweep_rad()) < 1e-5;
}

/// Of a flat arc: the distance of its middle from the chord.
double height_mm(const PlanarArc& arc) {
  return arc.length_mm * std::abs(arc.sweep_rad()) / 8;
}

/// The chord of a flat arc.
PlanarArc chordOf(const PlanarArc& arc) {
  const Vector2d chord = arc.end() - arc.start;
  return {.start = arc.start, .direction_rad = directionOf(chord), .length_mm = chord.norm()};
}

Vector2d centreOf(const PlanarArc& arc) {
  return arc.start +
         Vector2d(-std::sin(arc.direction_rad), std::cos(arc.direction_rad)) / arc.curvature_per_mm;
}

/// The same points by arcs that turn by no more than \p most_rad, up to the rounding of sweeps.
std::vector<PlanarArc> withShortArcs(const std::vector<PlanarArc>& arcs, double most_rad) {
  std::vector<PlanarArc> result;
  for (const PlanarArc& arc : arcs) {
    const double ratio = std::abs(arc.sweep_rad()) / most_rad;
    const int parts = std::max(1, static_cast<int>(std::ceil(ratio - 1e-9)));
    PlanarArc part = arc;
    part.length_mm /= parts;
    for (int i = 0; i < parts; ++i) {
      result.push_back(part);
      part.start = part.end();
      part.direction_rad = part.endDirection_rad();
    }
  }
  return result;
}

/// A bulge is a tangent, which ends at a whole circle.
constexpr double half_circle_rad = std::numbers::pi;

/// SVG gives an arc by its ends and radius. The centre then is a square root, which has half of the
/// digits at a half circle, and all of them up to a third.
constexpr double third_of_circle_rad = 2 * std::numbers::pi / 3;

std::string group(int code, const std::string& value) {
  return fmt::format("{:>3}\n{}\n", code, value);
}

std::string group(int code, int value) {
  return group(code, std::to_string(value));
}

std::string group(int code, double value) {
  return group(code, fmt::format("{}", value));
}

std::string pointGroups(const Vector2d& point) {
  return group(10, point.x()) + group(20, point.y()) + group(30, 0.0);
}

std::string entity(const std::string& name) {
  return group(0, name) + group(8, 0);  // on the layer 0, which every drawing has
}

std::string dxfLine(const PlanarArc& line) {
  const Vector2d end = line.end();
  return entity("LINE") + pointGroups(line.start) + group(11, end.x()) + group(21, end.y()) +
         group(31, 0.0);
}

std::string dxfCircle(const PlanarArc& arc) {
  return entity("CIRCLE") + pointGroups(centreOf(arc)) +
         group(40, 1 / std::abs(arc.curvature_per_mm));
}

/// An angle in [0, 360).
double degreesOf(const Vector2d& direction) {
  const double angle = directionOf(direction) * degrees_per_radian;
  return angle < 0 ? angle + 360 : angle;
}

/// Arcs of DXF run counter-clockwise.
std::string dxfArc(const PlanarArc& arc) {
  const Vector2d centre = centreOf(arc);
  const double start = degreesOf(arc.start - centre), end = degreesOf(arc.end() - centre);
  const bool left = arc.curvature_per_mm > 0;
  return entity("ARC") + pointGroups(centre) + group(40, 1 / std::abs(arc.curvature_per_mm)) +
         group(50, left ? start : end) + group(51, left ? end : start);
}

std::string vertex(const Vector2d& point, double bulge) {
  return entity("VERTEX") + pointGroups(point) + (bulge == 0 ? "" : group(42, bulge));
}

std::string dxfPolyline(const ArcOutline& outline) {
  constexpr int vertices_follow = 66;
  std::string text = entity("POLYLINE") + group(vertices_follow, 1) +
                     pointGroups(Vector2d::Zero()) + group(70, outline.closed ? 1 : 0);
  const std::vector<PlanarArc> arcs = withShortArcs(outline.arcs, half_circle_rad);
  for (const PlanarArc& arc : arcs) text += vertex(arc.start, std::tan(arc.sweep_rad() / 4));
  if (!outline.closed) text += vertex(arcs.back().end(), 0);
  // Without a layer, which some programs take for the beginning of an entity.
  return text + group(0, "SEQEND");
}

std::string dxfOutline(const ArcOutline& outline) {
  const PlanarArc& arc = outline.arcs.front();
  if (outline.arcs.size() > 1 || isFlat(arc)) return dxfPolyline(outline);
  return isLine(arc) ? dxfLine(arc) : isCircle(arc) ? dxfCircle(arc) : dxfArc(arc);
}

/// The box of the points of the arcs themselves.
Eigen::AlignedBox2d boxOf(const std::vector<ArcOutline>& outlines) {
  constexpr double quarter = std::numbers::pi / 2;
  Eigen::AlignedBox2d box;
  for (const ArcOutline& outline : outlines)
    for (const PlanarArc& arc : outline.arcs) {
      box.extend(arc.start);
      box.extend(arc.end());
      if (isLine(arc)) continue;
      // A coordinate is extreme where the tangent is parallel to an axis.
      const auto [least, most] = std::minmax({arc.direction_rad, arc.endDirection_rad()});
      for (double turn = std::ceil(least / quarter); turn <= most / quarter; ++turn)
        box.extend(arc.point((turn * quarter - arc.direction_rad) / arc.curvature_per_mm));
    }
  return box;
}

std::string svgPath(const ArcOutline& outline) {
  const std::vector<PlanarArc> arcs = withShortArcs(outline.arcs, third_of_circle_rad);
  std::string path = fmt::format("M {} {}", arcs.front().start.x(), arcs.front().start.y());
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const PlanarArc& arc = arcs[i];
    const bool last = i + 1 == arcs.size();
    const Vector2d end =
        last ? (outline.closed ? arcs.front().start : arc.end()) : arcs[i + 1].start;
    if (isLine(arc))
      path += fmt::format(" L {} {}", end.x(), end.y());
    else
      path += fmt::format(" A {0} {0} 0 0 {1} {2} {3}", 1 / std::abs(arc.curvature_per_mm),
                          arc.curvature_per_mm > 0 ? 1 : 0, end.x(), end.y());
  }
  return path + (outline.closed ? " Z" : "");
}

}  // namespace

DrawnOutline withFlatArcsStraight(ArcOutline outline, double most_mm) {
  double distance_mm = 0;
  for (PlanarArc& arc : outline.arcs) {
    if (!isFlat(arc) || height_mm(arc) > most_mm) continue;
    distance_mm = std::max(distance_mm, height_mm(arc));
    arc = chordOf(arc);
  }
  return {std::move(outline), distance_mm};
}

std::string dxfText(const std::vector<ArcOutline>& outlines) {
  constexpr int millimetres = 4, metric = 1;
  std::string text = group(999, "Seamwright, lengths in mm") + group(0, "SECTION") +
                     group(2, "HEADER") + group(9, "$ACADVER") + group(1, "AC1009") +
                     group(9, "$INSUNITS") + group(70, millimetres) + group(9, "$MEASUREMENT") +
                     group(70, metric) + group(0, "ENDSEC") + group(0, "SECTION") +
                     group(2, "ENTITIES");
  for (const ArcOutline& outline : outlines) text += dxfOutline(outline);
  return text + group(0, "ENDSEC") + group(0, "EOF");
}

std::string svgText(const std::vector<ArcOutline>& outlines) {
  const Eigen::AlignedBox2d box = boxOf(outlines);
  constexpr double margin = 0.05;  // of the longer side
  const double border = margin * box.sizes().maxCoeff();
  const Vector2d least = box.min() - Vector2d(border, border),
                 size = box.sizes() + 2 * Vector2d(border, border);
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\""
      " viewBox=\"{2} {3} {0} {1}\">\n"
      "<g transform=\"scale(1,-1)\" fill=\"none\" stroke=\"black\" stroke-width=\"{4}\">\n",
      size.x(), size.y(), least.x(), -least.y() - size.y(), size.maxCoeff() / 500);
  for (const ArcOutline& outline : outlines)
    text += fmt::format("<path d=\"{}\"/>\n", svgPath(outline));
  return text + "</g>\n</svg>\n";
}

std::string arcsCsv(const std::vector<ArcOutline>& outlines) {
  std::string text = "curve,x0,y0,x1,y1,centre_x,centre_y,radius,sweep_deg\n";
  for (std::size_t i = 0; i < outlines.size(); ++i)
    for (const PlanarArc& arc : outlines[i].arcs) {
      const Vector2d end = arc.end();
      text += fmt::format("{},{},{},{},{}", i + 1, arc.start.x(), arc.start.y(), end.x(), end.y());
      if (isLine(arc)) {
        text += ",,,,\n";
        continue;
      }
      const Vector2d centre = centreOf(arc);
      text += fmt::format(",{},{},{},{}\n", centre.x(), centre.y(),
                          1 / std::abs(arc.curvature_per_mm), arc.sweep_rad() * degrees_per_radian);
    }
  return text;
}

}  // namespace seamwright::cli
