// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <ShapeConstruct_ProjectCurveOnSurface.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <seamwright/occ_adapter/convert/pcurve.hpp>

namespace seamwright::occ {

namespace {

struct SpaceCurve {
  opencascade::handle<Geom_Curve> curve;
  double first = 0;
  double last = 0;
};

/// Largest distance at 9 points between the edge's curve and the image of the pcurve; infinite if not even
/// finite.
double strayDistance(const Pcurve& pcurve, const SpaceCurve& space, const TopoDS_Face& face) {
  const BRepAdaptor_Surface surface(face, false);
  double largest = 0;
  for (int i = 0; i <= 8; ++i) {
    const double share = i / 8.0;
    const gp_Pnt2d uv = pcurve.curve->Value(pcurve.first + share * (pcurve.last - pcurve.first));
    const double distance =
        surface.Value(uv.X(), uv.Y())
            .Distance(space.curve->Value(space.first + share * (space.last - space.first)));
    if (!(distance <= std::numeric_limits<double>::max())) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, distance);
  }
  return largest;
}

Pcurve projected(const SpaceCurve& space, const TopoDS_Face& face, double precision) {
  ShapeConstruct_ProjectCurveOnSurface projector;
  projector.Init(BRep_Tool::Surface(face), precision);
  opencascade::handle<Geom_Curve> curve = space.curve;
  Pcurve pcurve{nullptr, space.first, space.last, {}};
  projector.Perform(curve, space.first, space.last, pcurve.curve);
  return pcurve;
}

std::string strayNote(const Pcurve& stored, double before, double after) {
  std::ostringstream text;
  if (stored.curve.IsNull())
    text << "its pcurve was missing and was rebuilt";
  else
    text << "its pcurve was " << before << " mm off the edge and was rebuilt";
  text << " (" << after << " mm)";
  return text.str();
}

}  // namespace

Pcurve pcurveOf(const TopoDS_Edge& edge, const TopoDS_Face& face, double gap_mm) {
  if (BRep_Tool::Surface(face).IsNull())
    throw std::runtime_error("a face has no surface, only a mesh or nothing");
  Pcurve stored;
  stored.curve = BRep_Tool::CurveOnSurface(edge, face, stored.first, stored.last);
  SpaceCurve space;
  space.curve = BRep_Tool::Curve(edge, space.first, space.last);
  if (space.curve.IsNull()) {
    if (stored.curve.IsNull()) throw std::runtime_error("the edge has neither a curve in space nor a pcurve");
    return stored;
  }
  const double infinity = std::numeric_limits<double>::infinity();
  const double before = stored.curve.IsNull() ? infinity : strayDistance(stored, space, face);
  // Which of the two pcurves of a closed face a projection would give is not known.
  const bool ambiguous = BRep_Tool::IsClosed(edge, face);
  const double allowed = std::max(BRep_Tool::Tolerance(edge), gap_mm / 100);
  if (before <= allowed || (ambiguous && !stored.curve.IsNull())) return stored;

  Pcurve rebuilt = projected(space, face, Precision::Confusion());
  const double after = rebuilt.curve.IsNull() ? infinity : strayDistance(rebuilt, space, face);
  if (std::isfinite(after) && after <= before / 2) {
    rebuilt.note = strayNote(stored, before, after);
    return rebuilt;
  }
  if (stored.curve.IsNull()) throw std::runtime_error("the edge has no pcurve and none could be built");
  return stored;
}

}  // namespace seamwright::occ
