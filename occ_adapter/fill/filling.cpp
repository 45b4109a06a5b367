// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <sstream>
#include <stdexcept>

#include <seamwright/core/angle.hpp>
#include <seamwright/core/fill/fill_corners.hpp>
#include <seamwright/core/fill/ring_fill.hpp>
#include <seamwright/occ_adapter/analyze/measure_seam.hpp>
#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/convert/bezier_surface.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/fill/clearance.hpp>
#include <seamwright/occ_adapter/fill/fill.hpp>
#include <seamwright/occ_adapter/fill/fill_form.hpp>
#include <seamwright/occ_adapter/fill/filling.hpp>
#include <seamwright/occ_adapter/fill/side_fit.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/repair/prove.hpp>
#include <seamwright/occ_adapter/repair/sew.hpp>
#include <seamwright/occ_adapter/seams/pair_free_edges.hpp>

namespace seamwright::occ {

namespace {

/// If tangents at a corner leave a side's tangent plane by more than this, no smooth surface
/// contains both: the side has position only.
constexpr double most_planar_rad = 0.1;

/// The errors of the sides and of the corners may each be the tolerance over this number, so that
/// the sum of all errors is well within the tolerance.
constexpr double fit_share = 20;

/// Bound of the rounding between the planes of both sides of a corner, which are fitted to agree.
constexpr double plane_noise_rad = 1e-7;

constexpr std::size_t ring_sides = 4;

/// Largest distance of poles from the middle of the hole, over half the diagonal of its sides. A
/// fill that exceeds it is rejected. For comparison, the poles of a hemisphere reach less than 2.
constexpr double most_reach = 3;

/// Degree from which a fill is costly: the time grows with the sixth power of the degree, and
/// several fills are tried until one is regular.
constexpr int costly_degree = 7;

/// A corner with a smaller angle, or nearer to a full turn than this, is a cusp.
constexpr double least_corner_rad = 1e-3;

/// Around corners with a larger angle, a ring of patches curls over.
constexpr double most_corner_rad = 5.3;

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

constexpr const char* fill_name = "the fill";

/// The shape with additional faces, which are numbered after its own.
TopoDS_Compound withFaces(const TopoDS_Shape& shape, const std::vector<TopoDS_Face>& faces) {
  BRep_Builder builder;
  TopoDS_Compound whole;
  builder.MakeCompound(whole);
  if (shape.ShapeType() == TopAbs_COMPOUND)
    for (TopoDS_Iterator part(shape); part.More(); part.Next()) builder.Add(whole, part.Value());
  else
    builder.Add(whole, shape);
  for (const TopoDS_Face& face : faces) builder.Add(whole, face);
  return whole;
}

/// The part at the position of the given shape in the compound of withFaces(); the compound itself
/// if the shape was a compound.
TopoDS_Shape unwrapped(const TopoDS_Shape& whole, const TopoDS_Shape& given) {
  if (given.ShapeType() == TopAbs_COMPOUND) return whole;
  TopoDS_Iterator part(whole);
  const TopoDS_Shape first = part.Value();
  part.Next();
  return part.More() ? whole : first;
}

class Filling {
 public:
  Filling(const Model& model, const Hole& hole, const FillHoleOptions& options,
          const FaceNames& names, const Progress& progress)
      : model_(model), hole_(hole), options_(options), names_(names), progress_(progress) {}

  FillHoleReport byPatches(const FillAttempt& attempt) {
    return run([&] {
      attempt_ = attempt;
      doing_ = "fitting the sides";
      fit();
      doing_ = "building patches";
      build();
    });
  }

  FillHoleReport byFace(const TopoDS_Face& face) {
    return run([&] {
      new_faces_.push_back(face);
      result_.regular = true;
    });
  }

 private:
  FillHoleReport run(const std::function<void()>& makeFaces) {
    result_.model = model_;
    try {
      const auto start = std::chrono::steady_clock::now();
      makeFaces();
      result_.build_s = secondsSince(start);
      doing_ = "sewing the new faces";
      sew();
      result_.sew_s = secondsSince(start) - result_.build_s;
      doing_ = "measuring the new seams";
      measure();
      result_.measure_s = secondsSince(start) - result_.build_s - result_.sew_s;
      keep();
    } catch (const Cancelled&) {
      throw;
    } catch (const Standard_Failure& failure) {
      result_.reason = failureText(doing_, failure) + nearness();
    } catch (const std::exception& error) {
      result_.reason = error.what();
    }
    return std::move(result_);
  }

  void fit() {
    const std::size_t corners = hole_.has_corners ? hole_.sides.size() : 0;
    if (corners > 12)
      throw NotFilled("the hole has " + std::to_string(corners) +
                      " corners: fills have 12 at most");
    const double gap_mm = options_.tolerance.gap_mm / fit_share;
    const std::vector<HoleAngle> angles = anglesOf(hole_, gap_mm);
    is_ring_ = corners < 3 || (corners <= ring_sides && std::ranges::any_of(angles, isReflex));
    for (std::size_t k = 0; k < angles.size(); ++k) requireAngle(angles[k], k);
    cuts_ = {fitted(is_ring_ ? cutSides(hole_, ring_sides, gap_mm, true) : wholeSides(hole_))};
    if (is_ring_ && cuts_.front().misses > 1) addCuts();
  }

  /// Adds other cuts of the hole into the sides of a ring, best fits first.
  void addCuts() {
    const double gap_mm = options_.tolerance.gap_mm / fit_share;
    cuts_.push_back(fitted(cutSides(hole_, ring_sides, gap_mm, false)));
    if (!hole_.has_corners)
      for (std::vector<SideInterval>& cut : loopCuts(hole_, ring_sides, gap_mm))
        cuts_.push_back(fitted(std::move(cut)));
    std::ranges::stable_sort(cuts_, {}, &Cut::misses);
  }

  static bool isReflex(const HoleAngle& corner) { return corner.angle_rad > std::numbers::pi; }

  void requireAngle(const HoleAngle& corner, std::size_t k) const {
    const double angle_rad = corner.angle_rad, angle_deg = angle_rad * degrees_per_radian;
    const auto refuse = [&](const std::string& why) {
      throw NotFilled("corner " + std::to_string(k + 1) + " of the hole, between edges " +
                      std::to_string(corner.edges[0]) + " and " + std::to_string(corner.edges[1]) +
                      " at " + placeText(corner.point) + ": " + why);
    };
    if (std::min(angle_rad, 2 * std::numbers::pi - angle_rad) < least_corner_rad)
      refuse("it is a cusp, with an angle of " + text(angle_deg) +
             " degrees, which no regular face has: cut it off by another edge");
    if (is_ring_ && angle_rad > most_corner_rad)
      refuse("its angle is " + text(angle_deg) + " degrees, fills have " +
             text(most_corner_rad * degrees_per_radian) + " at most: cut the hole in two there");
    if (!is_ring_ && isReflex(corner))
      refuse("its angle is " + text(angle_deg) + " degrees, above 180: a hole of more than " +
             std::to_string(ring_sides) + " corners has to be cut in two there, by a face between");
  }

  /// A cut of the hole into sides, with the ratio of their errors to the accepted ones.
  struct Cut {
    std::vector<SideInterval> intervals;
    std::vector<FittedSide> fitted;
    double misses = 0;
  };

  Cut fitted(std::vector<SideInterval> intervals) const {
    // With target G0 a smooth loop must be told to have position only. At corners the angle of the
    // planes decides.
    const bool position_only = is_ring_ && options_.target == Level::G0;
    std::vector<FittedSide> sides = fitSides(hole_.sides, intervals,
                                             {.gap_mm = options_.tolerance.gap_mm / fit_share,
                                              .angle_rad = options_.tolerance.angle_rad / fit_share,
                                              .most_degree = attempt_.most_degree,
                                              .planar_rad = position_only ? -1 : most_planar_rad,
                                              .curvature = attempt_.curvature_raise.has_value()});
    const double most = misses(sides);
    return {std::move(intervals), std::move(sides), most};
  }

  double misses(const std::vector<FittedSide>& sides) const {
    double most = 0;
    for (const FittedSide& side : sides)
      most = std::max({most, fit_share * side.gap_mm / options_.tolerance.gap_mm,
                       fit_share * side.angle_rad / options_.tolerance.angle_rad});
    return most;
  }

  void tellSides() {
    for (std::size_t k = 0; k < fitted_.size(); ++k) {
      const FittedSide& side = fitted_[k];
      FilledSide told{{},
                      !side.side.cross,
                      side.side.edge.degree(),
                      side.side.cross ? static_cast<int>(side.side.cross->rows()) - 1 : 0,
                      side.gap_mm,
                      side.angle_rad,
                      side.corner_rad};
      const HoleSide& of_hole = hole_.sides[intervals_[k].side];
      double begin_mm = 0;
      for (const HoleEdge& edge : of_hole.edges) {
        const double end_mm = begin_mm + edge.length_mm, round_mm = of_hole.length_mm;
        const double first_mm = intervals_[k].begin * round_mm,
                     last_mm = intervals_[k].end * round_mm;
        if ((end_mm > first_mm && begin_mm < last_mm) || begin_mm + round_mm < last_mm)
          told.edges.push_back(edge.edge);
        begin_mm = end_mm;
      }
      result_.sides.push_back(std::move(told));
    }
  }

  void build() {
    for (const BSplineSurface& surface : surfaces()) {
      const bool is_patch = surface.countU() == surface.degree_u + 1;
      const opencascade::handle<Geom_Surface> geometry =
          is_patch ? opencascade::handle<Geom_Surface>(toBezierSurface(bezierPatch(surface)))
                   : opencascade::handle<Geom_Surface>(geomSurface(surface));
      BRepBuilderAPI_MakeFace face(geometry, Precision::Confusion());
      if (!face.IsDone()) throw NotFilled("OpenCASCADE made no face of a patch");
      new_faces_.push_back(face.Face());
      result_.reach = std::max(result_.reach, reachOf(surface, fitted_));
    }
  }

  /// The surfaces for the first cut, or, for a ring, for the first acceptable cut with a regular
  /// fill.
  std::vector<BSplineSurface> surfaces() {
    if (!is_ring_) {
      take(cuts_.front());
      return starSurfaces(sides());
    }
    std::vector<BSplineSurface> result;
    for (const Cut& cut : cuts_) {
      if (!result.empty() && cut.misses > fit_share) break;
      take(cut);
      result = ringSurfaces(sides());
      if (result_.regular) return result;
    }
    if (cuts_.size() == 1) return result;
    take(cuts_.front());
    return ringSurfaces(sides());
  }

  void take(const Cut& cut) {
    intervals_ = cut.intervals;
    fitted_ = cut.fitted;
    result_.sides.clear();
    tellSides();
  }

  std::vector<FillSide> sides() const {
    std::vector<FillSide> sides;
    for (const FittedSide& side : fitted_) sides.push_back(side.side);
    return sides;
  }

  /// How much the degree is raised above the one that G1 needs, which is by \p more higher than the
  /// largest degree of edges and cross-boundary derivatives. Nothing for target G1 in high degrees,
  /// because the time grows with the sixth power of the degree.
  std::optional<int> curvatureDegrees(const std::vector<FillSide>& sides, int more) const {
    if (!attempt_.curvature_raise) return std::nullopt;
    Eigen::Index degree = 0;
    for (const FillSide& side : sides)
      degree = std::max(
          {degree, Eigen::Index{side.edge.degree()}, side.cross ? side.cross->rows() - 1 : 0});
    degree += more;
    if (options_.target == Level::G1 && degree >= costly_degree) return std::nullopt;
    const int most_degree = options_.target == Level::G1 ? costly_degree - 1 : 9;
    return std::clamp(most_degree - static_cast<int>(degree), 0, *attempt_.curvature_raise);
  }

  std::vector<BSplineSurface> ringSurfaces(const std::vector<FillSide>& sides) {
    const RingFill fill = ringFill(sides, {.corner_tolerance_rad = plane_noise_rad,
                                           .curvature_degrees = curvatureDegrees(sides, 3)});
    result_.curvature_jump_per_mm = fill.curvature_jump_per_mm;
    result_.corners = fill.corners;
    result_.regular = fill.regular;
    std::vector<BSplineSurface> surfaces;
    for (const BezierPatch& patch : fill.patches) surfaces.push_back(splineSurface(patch));
    return surfaces;
  }

  std::vector<BSplineSurface> starSurfaces(const std::vector<FillSide>& sides) {
    FillOptions options{.corner_tolerance_rad = plane_noise_rad,
                        .curvature_degrees = curvatureDegrees(sides, 1)};
    NSidedFill fill = nSidedFill(sides, options);
    if (!fill.regular && options.curvature_degrees) {
      options.curvature_degrees.reset();
      fill = nSidedFill(sides, options);
    }
    if (!fill.regular && fill.patches.front().degreeU() < costly_degree) {
      options.law = SpokeLaw::Quadratic;
      NSidedFill other = nSidedFill(sides, options);
      if (other.regular) fill = std::move(other);
    }
    result_.curvature_jump_per_mm = fill.curvature_jump_per_mm;
    result_.corners = fill.corners;
    result_.regular = fill.regular;
    return withCornerKnots(fill, options_.tolerance.angle_rad / fit_share);
  }

  int firstNewFace() const { return model_.faceCount() + 1; }
  bool isNew(int face) const { return face >= firstNewFace(); }

  void sew() {
    whole_ = withFaces(model_.shape, new_faces_);
    SeamGraph graph = findSeams(whole_);
    double reach_mm = options_.tolerance.gap_mm;
    for (const FittedSide& side : fitted_) reach_mm = std::max(reach_mm, 2 * side.gap_mm);
    matchFreeEdges({.match_mm = reach_mm, .gap_mm = options_.tolerance.gap_mm}, graph,
                   partOf(progress_, 0, 0.3));
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < graph.seams.size(); ++i)
      if (graph.seams[i].kind == SeamKind::Matched && isOfFill(graph.seams[i])) chosen.push_back(i);
    sewn_ =
        sewnShape(whole_, graph.seams, chosen, reach_mm, [this](int face) { return nameOf(face); });
    if (!sewn_.refused.empty())
      throw NotFilled("the fill can't be sewn " +
                      placeOf(graph.seams[sewn_.refused.begin()->first]) + nearness());
    for (std::size_t k = 0; k < new_faces_.size(); ++k)
      numbers_.insert(sewn_.faces[firstNewFace() + static_cast<int>(k)]);
    nameFaces();
    requireClosed();
  }

  /// Describes the position of a seam of the fill before sewing.
  std::string placeOf(const Seam& seam) const {
    for (const Coedge& side : seam.sides)
      if (!isNew(side.face))
        return "to edge " +
               std::to_string(partsOf(model_.shape, TopAbs_EDGE).FindIndex(side.edge)) + " of " +
               nameOf(side.face);
    return "to itself";
  }

  std::string nameOf(int face) const { return isNew(face) ? fill_name : names_(face); }

  void nameFaces() {
    const int count = model_.faceCount() + static_cast<int>(new_faces_.size());
    result_.face_names.resize(static_cast<std::size_t>(count));
    for (int face = 1; face <= count; ++face)
      result_.face_names[static_cast<std::size_t>(sewn_.faces[face]) - 1] = nameOf(face);
  }

  /// Whether the seam is between new faces, or between a new face and one beside the hole.
  bool isOfFill(const Seam& seam) const {
    const auto belongs = [this](const Coedge& side) {
      if (isNew(side.face)) return true;
      for (const HoleSide& of_hole : hole_.sides)
        for (const HoleEdge& edge : of_hole.edges)
          if (edge.use.face == side.face && edge.use.edge.IsSame(side.edge)) return true;
      return false;
    };
    return (isNew(seam.sides[0].face) || isNew(seam.sides[1].face)) && belongs(seam.sides[0]) &&
           belongs(seam.sides[1]);
  }

  void requireClosed() {
    graph_ = findSeams(sewn_.shape);
    int open = 0;
    for (const NonSeamEdge& edge : graph_.open)
      open += std::ranges::any_of(edge.faces, [this](int face) { return numbers_.count(face) > 0; })
                  ? 1
                  : 0;
    if (open > 0)
      throw NotFilled(std::to_string(open) +
                      " edges of the fill lie along no edge of the hole within the gap of " +
                      text(options_.tolerance.gap_mm) + " mm" + nearness());
  }

  /// A clause on the largest distance of the sides from the hole, if that is too large; otherwise
  /// empty.
  std::string nearness() const {
    if (fitted_.empty()) return {};
    const auto worst = std::ranges::max_element(fitted_, {}, &FittedSide::gap_mm);
    if (worst->gap_mm <= options_.tolerance.gap_mm) return {};
    const HoleAngle turn = sharpestTurn(hole_, options_.tolerance.gap_mm / fit_share);
    if (turn.angle_rad > most_planar_rad)
      return "; edges " + std::to_string(turn.edges[0]) + " and " + std::to_string(turn.edges[1]) +
             " are one side, but turn by " + text(turn.angle_rad * degrees_per_radian) +
             " degrees at " + placeText(turn.point) +
             ": a corner angle below that makes a corner of it";
    std::string edges;
    const FilledSide& side = result_.sides.at(static_cast<std::size_t>(worst - fitted_.begin()));
    for (const int edge : side.edges) edges += (edges.empty() ? " " : ", ") + std::to_string(edge);
    return "; one polynomial meets the side about " + placeText(worst->side.edge.point(0.5)) +
           " (" + (side.edges.size() == 1 ? "edge" : "edges") + edges + ") to " +
           text(worst->gap_mm) +
           " mm alone: a larger gap would help, or a face put across the hole there first";
  }

  static std::string text(double value) {
    std::ostringstream stream;
    stream.precision(3);
    stream << value;
    return stream.str();
  }

  static std::string placeText(const Eigen::Vector3d& point) {
    const auto rounded = [](double x) { return text(std::round(1e6 * x) / 1e6 + 0.0); };
    return "(" + rounded(point.x()) + ", " + rounded(point.y()) + ", " + rounded(point.z()) +
           ") mm";
  }

  void measure() {
    AnalyzeOptions options;
    options.tolerance = options_.tolerance;
    options.level = options_.target;
    options.jobs = options_.jobs;
    std::vector<const Seam*> seams;
    for (const Seam& seam : graph_.seams)
      if (numbers_.count(seam.sides[0].face) + numbers_.count(seam.sides[1].face) > 0)
        seams.push_back(&seam);
    std::vector<SeamResult> results(seams.size());
    runParallel(
        seams.size(), options.jobs,
        [&](std::size_t i) { results[i] = measureSeam(*seams[i], options); },
        partOf(progress_, 0.3, 0.9));
    for (SeamResult& seam : results) {
      const bool inner = numbers_.count(seam.faces[0]) > 0 && numbers_.count(seam.faces[1]) > 0;
      (inner ? result_.inner : result_.outer).push_back(std::move(seam));
    }
    result_.faces.assign(numbers_.begin(), numbers_.end());
  }

  /// Whether the seam misses the target for every value that the figures may have.
  bool surelyMisses(const SeamResult& seam) const {
    const auto beyond = [](const std::optional<Figure>& figure, double tolerance) {
      return figure && figure->lower > tolerance;
    };
    const ContinuityTolerance& tolerance = options_.tolerance;
    return beyond(seam.figures.gap_mm, tolerance.gap_mm) ||
           (options_.target >= Level::G1 && beyond(seam.figures.angle_rad, tolerance.angle_rad)) ||
           (options_.target >= Level::G2 &&
            beyond(seam.figures.curvature_rel, tolerance.curvature_rel));
  }

  std::string missed() const {
    const SeamResult* worst = nullptr;
    const auto angle = [](const SeamResult& seam) {
      const std::optional<Figure>& found = seam.figures.angle_rad;
      return found ? found->upper.value_or(HUGE_VAL) : HUGE_VAL;
    };
    for (const auto* seams : {&result_.outer, &result_.inner})
      for (const SeamResult& seam : *seams)
        if (!surelyReaches(seam.figures, options_.tolerance, options_.target) &&
            (worst == nullptr || angle(seam) > angle(*worst)))
          worst = &seam;
    if (worst == nullptr) return {};
    const std::string &one = result_.faceName(worst->faces[0]),
                      &other = result_.faceName(worst->faces[1]);
    return (one == other ? "a seam inside " + one : "a seam between " + one + " and " + other) +
           (surelyMisses(*worst) ? " is not " : " does not surely reach ") +
           std::string(name(options_.target)) + ": " + figuresText(*worst) + positionAlone();
  }

  /// A clause on the sides that could only be met in position; empty if there are none.
  std::string positionAlone() const {
    if (options_.target < Level::G1) return {};
    double turn_rad = 0;
    std::string edges;
    for (const FilledSide& side : result_.sides) {
      if (!side.position_only) continue;
      turn_rad = std::max({turn_rad, side.corner_rad[0], side.corner_rad[1]});
      for (const int edge : side.edges)
        edges += (edges.empty() ? " " : ", ") + std::to_string(edge);
    }
    if (edges.empty()) return {};
    constexpr double degree = radians_per_degree;
    return "; along" +
           (edges.find(',') == std::string::npos ? std::string(" edge") : std::string(" edges")) +
           edges +
           " the faces are met in position alone: at a corner the plane of the next edges leaves "
           "theirs by " +
           text(turn_rad / degree) + " degrees; the target G0 closes the hole";
  }

  std::string invalid() const {
    const Validity was = validityOf(model_.shape, options_.jobs),
                   is = validityOf(sewn_.shape, options_.jobs);
    for (int face = 1; face <= model_.faceCount() + static_cast<int>(new_faces_.size()); ++face)
      if ((isNew(face) || was.faces[face]) && !is.faces[sewn_.faces[face]])
        return "OpenCASCADE's checks would not pass for " + nameOf(face);
    if (was.whole && !is.whole) return "OpenCASCADE's checks would not pass for the filled shape";
    return {};
  }

  /// What is wrong with the form of the new faces, whose seams are good; empty if nothing.
  std::string misshapen() {
    if (!result_.regular) return "the new faces are not proved regular: they may fold over";
    if (turnsBack(new_faces_, fitted_))
      return "the new faces turn back over themselves, as their surroundings do not";
    if (result_.reach > most_reach)
      return "the new faces stand out to " + text(result_.reach) + " times the size of the hole";
    if (result_.outer.empty()) return "the hole is too small for a seam to be measured";
    if (const auto touching = touchingFaces(sewn_.shape, numbers_)) {
      result_.meets_others = true;
      return numbers_.count(touching->second) > 0
                 ? "the fill runs into itself"
                 : "the fill runs into " + result_.faceName(touching->second);
    }
    return {};
  }

  void keep() {
    result_.reason = missed();
    if (!result_.reason.empty()) result_.reason += nearness();
    if (result_.reason.empty()) result_.reason = misshapen();
    const std::string fault = invalid();
    if (!fault.empty()) result_.reason = fault;
    result_.reached = result_.reason.empty();
    if (!fault.empty() || (!result_.reached && !options_.keep_anyway)) return;
    result_.model.attributes = attributesAfter(model_.attributes, whole_, sewn_);
    result_.model.shape = unwrapped(sewn_.shape, model_.shape);
    result_.filled = true;
  }

  const Model& model_;
  const Hole& hole_;
  const FillHoleOptions& options_;
  const FaceNames& names_;
  const Progress progress_;
  FillAttempt attempt_;
  const char* doing_ = "";  ///< current operation, for the text of a failure
  bool is_ring_ = false;
  std::vector<Cut> cuts_;  ///< cuts of the hole into sides, in the order in which they are tried
  std::vector<SideInterval> intervals_;
  std::vector<FittedSide> fitted_;
  std::vector<TopoDS_Face> new_faces_;
  TopoDS_Shape whole_;
  SewnShape sewn_;
  SeamGraph graph_;        ///< seams of the sewn shape
  std::set<int> numbers_;  ///< numbers of the new faces in the sewn shape
  FillHoleReport result_;
};

}  // namespace

std::string failureText(const std::string& doing, const Standard_Failure& failure) {
  const std::string what = failure.GetMessageString();
  return doing + " failed: OpenCASCADE stopped at " + failure.DynamicType()->Name() +
         (what.empty() ? "" : " " + what);
}

bool isSound(const FillHoleReport& report) {
  return report.regular && report.reach <= most_reach && !report.outer.empty();
}

FillHoleReport filledByPatches(const Model& model, const Hole& hole, const FillHoleOptions& options,
                               const FaceNames& names, const FillAttempt& attempt,
                               const Progress& progress) {
  return Filling(model, hole, options, names, progress).byPatches(attempt);
}

FillHoleReport filledByFace(const Model& model, const Hole& hole, const FillHoleOptions& options,
                            const FaceNames& names, const TopoDS_Face& face,
                            const Progress& progress) {
  return Filling(model, hole, options, names, progress).byFace(face);
}

}  // namespace seamwright::occ
