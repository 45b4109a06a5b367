// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/convert/adaptor_jet.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/repair/face_change.hpp>
#include <seamwright/occ_adapter/repair/reasons.hpp>

namespace seamwright::occ {

namespace {

/// The boundary of a face in its parameter plane, as polygons.
class Outline {
 public:
  explicit Outline(const TopoDS_Face& face) {
    for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
      double first = 0, last = 0;
      const auto path = BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Current()), face, first, last);
      if (path.IsNull()) continue;
      gp_Pnt2d before = path->Value(first);
      for (int k = 1; k <= chords; ++k) {
        const gp_Pnt2d here = path->Value(first + (last - first) * k / chords);
        chords_.push_back({std::array{before.X(), before.Y()}, std::array{here.X(), here.Y()}});
        before = here;
      }
    }
  }

  /// The intervals inside the face of the iso-line with that parameter, as pairs of ends.
  /// \param fixed 0: u is constant, 1: v is.
  std::vector<std::pair<double, double>> inside(int fixed, double at) const {
    std::vector<double> crossings;
    for (const auto& [a, b] : chords_) {
      if ((a[fixed] <= at) == (b[fixed] <= at)) continue;
      const double share = (at - a[fixed]) / (b[fixed] - a[fixed]);
      crossings.push_back(a[1 - fixed] + share * (b[1 - fixed] - a[1 - fixed]));
    }
    std::ranges::sort(crossings);
    std::vector<std::pair<double, double>> parts;
    for (std::size_t k = 1; k < crossings.size(); k += 2)
      parts.emplace_back(crossings[k - 1], crossings[k]);
    return parts;
  }

 private:
  /// Chords of a pcurve. The polygon of a full circle strays by 0.0012 of its radius.
  static constexpr int chords = 64;
  std::vector<std::array<std::array<double, 2>, 2>> chords_;
};

/// Parameters equally spaced in the knot spans.
class SpanScale {
 public:
  SpanScale(const TColStd_Array1OfReal& knots, double first, double last) : ends_{first} {
    for (const double knot : knots)
      if (knot > first && knot < last) ends_.push_back(knot);
    ends_.push_back(last);
  }
  int spans() const { return static_cast<int>(ends_.size()) - 1; }
  double at(double share) const {
    const double position = share * spans();
    const int span = std::clamp(static_cast<int>(position), 0, spans() - 1);
    return ends_[span] + (position - span) * (ends_[span + 1] - ends_[span]);
  }

 private:
  std::vector<double> ends_;
};

/// Adds the mean curvature, and the normal curvature along the line. Both are NaN where there is no
/// normal.
void addCurvature(const CurvedPoint& point, const Eigen::Vector3d& tangent, CurvatureLine& line) {
  double mean = std::nan(""), along = std::nan("");
  if (point.normal) {
    const Eigen::Vector3d way = tangent.normalized();
    mean = point.curvature_per_mm.trace() / 2;
    along = way.dot(point.curvature_per_mm * way);
  }
  line.mean_per_mm.push_back(mean);
  line.normal_per_mm.push_back(along);
}

/// The parameters that the face shows: u from, to, v from, to.
std::array<double, 4> rangeOf(const TopoDS_Face& face) {
  std::array<double, 4> range{};
  BRepTools::UVBounds(face, range[0], range[1], range[2], range[3]);
  return range;
}

/// Samples lines on a surface and, if there is one, on the surface after it at the same parameters.
class LineWalk {
 public:
  /// \param after null: none. \param range of the parameters that the face shows: u from, to, v
  /// from, to.
  LineWalk(const Adaptor3d_Surface& before, const Adaptor3d_Surface* after,
           const std::array<double, 4>& range, const FaceGrid& grid)
      : before_(before), after_(after), grid_(grid), noise_(noiseOn(range)) {}

  /// \param knots surface whose knots determine the lines and samples.
  void walk(const TopoDS_Face& face, const opencascade::handle<Geom_BSplineSurface>& knots,
            SurfaceChange& change) {
    const std::array<double, 4> range = rangeOf(face);
    const SpanScale u(knots->UKnots(), range[0], range[1]), v(knots->VKnots(), range[2], range[3]);
    const Outline outline(face);
    walk(outline, 0, u, v, change);
    walk(outline, 1, v, u, change);
  }

  SurfaceMeasure before(double noise_per_mm) const {
    return measureSurface(lines_before_, noise_per_mm);
  }
  SurfaceMeasure after(double noise_per_mm) const {
    return measureSurface(lines_after_, noise_per_mm);
  }

 private:
  void walk(const Outline& outline, int fixed, const SpanScale& across, const SpanScale& along,
            SurfaceChange& change) {
    const int points = std::clamp(grid_.samples_per_span * along.spans(), grid_.least, grid_.most);
    for (int line = 0; line < grid_.lines; ++line) {
      const double at = across.at((line + 0.5) / grid_.lines);
      const auto parts = outline.inside(fixed, at);
      auto part = parts.begin();
      start();
      for (int k = 0; k < points && part != parts.end(); ++k) {
        const double parameter = along.at((k + 0.5) / points);
        while (part != parts.end() && parameter > part->second) {
          ++part;
          finish();
        }
        if (part == parts.end() || parameter < part->first) continue;
        look(fixed == 0 ? at : parameter, fixed == 0 ? parameter : at, fixed == 1, change);
      }
      finish();
    }
  }

  void start() { of_before_ = of_after_ = {}; }
  /// Ends a line. The next part begins a new line, so that a jump across a hole of the face does
  /// not count as variation.
  void finish() {
    if (!of_before_.mean_per_mm.empty()) {
      lines_before_.push_back(std::move(of_before_));
      lines_after_.push_back(std::move(of_after_));
    }
    start();
  }
  void look(double u, double v, bool along_u, SurfaceChange& change) {
    const SurfaceJet was = jetOn(before_, u, v);
    const CurvedPoint point = curvedPoint(was, noise_);
    addCurvature(point, along_u ? was.u : was.v, of_before_);
    if (after_ == nullptr) return;
    const SurfaceJet is = jetOn(*after_, u, v);
    const CurvedPoint moved = curvedPoint(is, noise_);
    addCurvature(moved, along_u ? is.u : is.v, of_after_);
    include(change, point, moved);
  }
  /// Derivatives below a millionth of the longest one count as zero. The longest one is sought on
  /// an equally spaced grid, because lines crowd where knots do, for example beside a degenerate
  /// side.
  JetNoise noiseOn(const std::array<double, 4>& range) const {
    // In each direction. A choice: the scale of derivatives is enough.
    constexpr int points = 8;
    constexpr double share = 1e-6;
    double longest_u = 0, longest_v = 0;
    for (int i = 0; i < points; ++i)
      for (int j = 0; j < points; ++j)
        for (const Adaptor3d_Surface* surface : {&before_, after_}) {
          if (surface == nullptr) continue;
          gp_Pnt p;
          gp_Vec along_u, along_v;
          surface->D1(range[0] + (i + 0.5) / points * (range[1] - range[0]),
                      range[2] + (j + 0.5) / points * (range[3] - range[2]), p, along_u, along_v);
          longest_u = std::max(longest_u, along_u.Magnitude());
          longest_v = std::max(longest_v, along_v.Magnitude());
        }
    return {share * longest_u, share * longest_v};
  }

  const Adaptor3d_Surface& before_;
  const Adaptor3d_Surface* after_;
  const FaceGrid& grid_;
  const JetNoise noise_;
  CurvatureLine of_before_, of_after_;
  std::vector<CurvatureLine> lines_before_, lines_after_;
};

}  // namespace

SurfaceChange measureChange(const TopoDS_Face& face,
                            const opencascade::handle<Geom_BSplineSurface>& after, double bound_mm,
                            double visible_per_mm, const FaceGrid& grid) {
  const BRepAdaptor_Surface before(face, false);
  const GeomAdaptor_Surface moved(after);
  SurfaceChange change;
  LineWalk walk(before, &moved, rangeOf(face), grid);
  walk.walk(face, after, change);
  change.move_mm.upper = std::max(change.move_mm.lower, bound_mm);
  // Share of the variation before that belongs to the noise, see measureChange().
  constexpr double unseen = 0.05;
  const double noise = visible_per_mm + unseen * walk.before(0).variation_per_mm;
  change.before = walk.before(noise);
  change.after = walk.after(noise);
  return change;
}

double variationOf_per_mm(const TopoDS_Face& face,
                          const opencascade::handle<Geom_BSplineSurface>& surface,
                          const FaceGrid& grid) {
  const GeomAdaptor_Surface given(surface);
  SurfaceChange none;
  LineWalk walk(given, nullptr, rangeOf(face), grid);
  walk.walk(face, surface, none);
  return walk.before(0).variation_per_mm;
}

namespace {

double diagonal_mm(const TopoDS_Face& face) {
  Bnd_Box box;
  BRepBndLib::Add(face, box, false);
  return std::sqrt(box.SquareExtent());
}

/// Area of the face; 0 where the face can't be integrated.
double area_mm2(const TopoDS_Face& face) {
  try {
    GProp_GProps area;
    BRepGProp::SurfaceProperties(face, area);
    return area.Mass();
  } catch (const Standard_Failure&) {
    return 0;
  }
}

/// Length of the face's edges; 0 where they can't be integrated.
double perimeter_mm(const TopoDS_Face& face) {
  try {
    GProp_GProps boundary;
    BRepGProp::LinearProperties(face, boundary);
    return boundary.Mass();
  } catch (const Standard_Failure&) {
    return 0;
  }
}

/// The mean width of a face beside a seam, at most its diagonal; 0 where the face can't be
/// integrated.
double widthBeside_mm(const TopoDS_Face& face, double length_mm) {
  return std::min(diagonal_mm(face), area_mm2(face) / length_mm);
}

}  // namespace

NeededVariation neededVariation(const TopoDS_Shape& shape, const std::vector<SeamResult>& seams,
                                const std::vector<bool>& treated, std::optional<double> depth_mm,
                                bool to_curvature) {
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
  NeededVariation needed;
  for (std::size_t i = 0; i < seams.size(); ++i) {
    const auto& angle = seams[i].figures.angle_rad;
    if (!treated[i] || !angle || !(seams[i].length_mm > 0)) continue;
    const auto& curvature = seams[i].figures.curvature_per_mm;
    const double of_curvature =
        to_curvature && curvature ? curvature->upper.value_or(curvature->lower) : 0;
    for (const int number : seams[i].faces) {
      const double beside_mm = widthBeside_mm(TopoDS::Face(faces(number)), seams[i].length_mm),
                   width_mm = std::clamp(depth_mm.value_or(beside_mm), beside_mm / 2, beside_mm);
      if (width_mm > 0)
        needed[number] = std::max(
            needed[number],
            visibleVariation(angle->upper.value_or(angle->lower), width_mm) + of_curvature);
    }
  }
  return needed;
}

double sizeOf_mm(const TopoDS_Face& face) {
  const double area = area_mm2(face), perimeter = perimeter_mm(face),
               largest_mm = diagonal_mm(face);
  if (!(area > 0 && perimeter > 0)) return largest_mm;
  return std::min(4 * std::sqrt(2.0) * area / perimeter, largest_mm);
}

MoveLimits moveLimits(const TopoDS_Shape& shape, const std::vector<SeamResult>& seams,
                      const std::set<int>& may_move, const std::vector<bool>& treated,
                      const RepairOptions& options) {
  // docs/theory/repair.md, "How far", derives both from R1.
  constexpr double share_of_size = 0.01, times_gap = 2;
  const TopTools_IndexedMapOfShape faces = partsOf(shape, TopAbs_FACE);
  std::map<int, double> gaps_mm;
  for (std::size_t i = 0; i < seams.size(); ++i)
    if (const auto& gap = seams[i].figures.gap_mm; treated[i] && gap)
      for (const int face : seams[i].faces)
        gaps_mm[face] = std::max(gaps_mm[face], gap->upper.value_or(gap->lower));
  MoveLimits limits;
  for (const int face : may_move)
    limits[face] = options.max_move_mm ? *options.max_move_mm
                                       : share_of_size * sizeOf_mm(TopoDS::Face(faces(face))) +
                                             times_gap * gaps_mm[face];
  return limits;
}

double allowedVariation(int number, const TopoDS_Face& face, const ContinuityTolerance& tolerance,
                        const NeededVariation& needed, double fairness) {
  const auto found = needed.find(number);
  return visibleVariation(tolerance.angle_rad, diagonal_mm(face)) +
         (found == needed.end() ? 0 : fairness * found->second);
}

FaceMove judgedMove(int number, const TopoDS_Face& face,
                    const opencascade::handle<Geom_BSplineSurface>& after, double largest_move_mm,
                    const RepairOptions& options, const NeededVariation& needed) {
  FaceMove move{number, largest_move_mm};
  const double visible =
      allowedVariation(number, face, options.tolerance, needed, options.fairness);
  move.surface = measureChange(face, after, largest_move_mm, visible);
  const SurfaceFault fault = judgeSurface(*move.surface, {options.fairness, visible});
  move.less_fair = why::lessFair(fault, *move.surface);
  return move;
}

}  // namespace seamwright::occ
