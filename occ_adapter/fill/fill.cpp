// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Standard_Failure.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/occ_adapter/fill/continued_face.hpp>
#include <seamwright/occ_adapter/fill/fill.hpp>
#include <seamwright/occ_adapter/fill/fill_names.hpp>
#include <seamwright/occ_adapter/fill/filling.hpp>
#include <seamwright/occ_adapter/fill/hole_contradiction.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/model/coordinate_rounding.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/model/usable.hpp>

namespace seamwright::occ {

namespace {

std::optional<int> raiseFor(Level target) {
  if (target < Level::G1) return std::nullopt;
  return target == Level::G1 ? 1 : 2;
}

/// Whether the polynomials that stand for the sides miss them by more than a tolerance. Then no
/// patches along them reach the target.
bool sidesMiss(const FillHoleReport& report, const FillHoleOptions& options) {
  return std::ranges::any_of(report.sides, [&](const FilledSide& side) {
    return side.gap_mm > options.tolerance.gap_mm ||
           (options.target >= Level::G1 && side.angle_rad > options.tolerance.angle_rad);
  });
}

/// Attempts that may give a better fill. Polynomials of lower degree fit the sides less closely and
/// make fairer faces. A fill that ignores curvature may even have smaller jumps of it.
std::vector<FillAttempt> othersThan(const FillAttempt& first, const FillHoleReport& report,
                                    const FillHoleOptions& options) {
  // A choice: with ends and their derivatives fixed, degree 5 leaves two poles free.
  constexpr int fairer_degree = 5;
  std::vector<FillAttempt> others;
  if (report.faces.empty() || (!options.keep_anyway && sidesMiss(report, options))) return others;
  if (!isSound(report) && first.most_degree > fairer_degree)
    others.push_back({.most_degree = fairer_degree, .curvature_raise = first.curvature_raise});
  if (first.curvature_raise)
    others.push_back({.most_degree = first.most_degree, .curvature_raise = std::nullopt});
  return others;
}

/// The largest figure over its tolerance; HUGE_VAL if one is not known.
double excessOf(const FillHoleReport& report, const FillHoleOptions& options) {
  const double gap = report.largestGap_mm().value_or(HUGE_VAL) / options.tolerance.gap_mm;
  if (options.target < Level::G1) return gap;
  return std::max(gap, report.largestAngle_rad().value_or(HUGE_VAL) / options.tolerance.angle_rad);
}

/// How much larger the curvature of a fill may be than that of another one, and how much larger its
/// difference of curvature across a seam, before the other one is preferred although it misses G2
/// by more. A choice.
constexpr double much = 2;

/// Whether a fill that misses G2 bends so much less than another one that it is better.
bool isMuchFairer(const FillHoleReport& one, const FillHoleReport& other) {
  return one.curvature_per_mm && other.curvature_per_mm &&
         *other.curvature_per_mm > much * *one.curvature_per_mm &&
         one.largestCurvature_rel().value_or(HUGE_VAL) <=
             much * other.largestCurvature_rel().value_or(HUGE_VAL);
}

bool isBetter(const FillHoleReport& one, const FillHoleReport& other,
              const FillHoleOptions& options) {
  if (one.reached != other.reached) return one.reached;
  if (one.filled != other.filled) return one.filled;
  if (isSound(one) != isSound(other)) return isSound(one);
  if (!one.reached && options.target < Level::G2)
    return excessOf(one, options) < excessOf(other, options);
  if (options.target < Level::G2) return false;
  if (!one.reached && isMuchFairer(one, other)) return true;
  if (!one.reached && isMuchFairer(other, one)) return false;
  return one.largestCurvature_rel().value_or(HUGE_VAL) <
         other.largestCurvature_rel().value_or(HUGE_VAL);
}

void requireEdges(const Model& model, const Hole& hole) {
  const TopTools_IndexedMapOfShape edges = partsOf(model.shape, TopAbs_EDGE);
  for (const HoleSide& side : hole.sides)
    for (const HoleEdge& edge : side.edges)
      if (edges.FindIndex(edge.use.edge) != edge.edge)
        throw std::invalid_argument("hole " + std::to_string(hole.id) +
                                    ": the model has no such edge " + std::to_string(edge.edge));
}

/// Why the boundary of a hole can't be met; empty if it can.
FillReason whyNotMet(const TopoDS_Shape& shape, const Hole& hole) {
  const UnusableParts unusable(shape);
  for (const HoleSide& side : hole.sides)
    for (const HoleEdge& edge : side.edges)
      if (FillReason why = whyNotMet(unusable, edge.edge, edge.use.face); !why.empty()) return why;
  return {};
}

std::optional<double> largest(const FillHoleReport& report,
                              std::optional<Figure> SeamFigures::*figure) {
  std::optional<double> most;
  for (const auto* seams : {&report.outer, &report.inner})
    for (const SeamResult& seam : *seams) {
      const std::optional<Figure>& value = seam.figures.*figure;
      if (!value || !value->upper) return std::nullopt;
      most = std::max(most.value_or(0), *value->upper);
    }
  return most;
}

/// The face that continues a surface through the hole. Failures give nothing: patches are tried
/// next, and their reasons are reported.
std::optional<TopoDS_Face> faceThatGoesOn(const Hole& hole, const FillHoleOptions& options) {
  if (!options.continue_surface) return std::nullopt;
  try {
    return continuedFace(hole, options.tolerance.gap_mm / fit_share,
                         options.target == Level::G0
                             ? std::nullopt
                             : std::optional(options.tolerance.angle_rad / fit_share));
  } catch (const Standard_Failure&) {
    return std::nullopt;
  } catch (const GeometryError&) {
    return std::nullopt;
  }
}

/// Whether another method may give a fill that is kept: not if the neighbours contradict each
/// other by more than the target allows.
bool isWorthwhile(const FillTask& task) {
  const FillHoleOptions& options = task.options;
  return options.keep_anyway || options.target < Level::G1 ||
         causesOfContradiction(task.hole, options.tolerance.angle_rad, options.tolerance.gap_mm)
             .empty();
}

FillHoleReport bestByPatches(const FillTask& task, const Progress& progress) {
  constexpr double share_of_first = 0.5;  // of the progress bar
  const FillHoleOptions& options = task.options;
  const FillAttempt first{.most_degree = options.most_degree,
                          .curvature_raise = raiseFor(options.target)};
  FillHoleReport best = filledByPatches(task, first, partOf(progress, 0, share_of_first));
  const std::vector<FillAttempt> others =
      best.reached ? std::vector<FillAttempt>() : othersThan(first, best, options);
  double build_s = best.build_s, done = share_of_first;
  for (std::size_t k = 0; k < others.size(); ++k) {
    const double next = done + (1 - done) / static_cast<double>(others.size() - k);
    FillHoleReport other = filledByPatches(task, others[k], partOf(progress, done, next));
    done = next;
    build_s += other.build_s;
    if (isBetter(other, best, options)) best = std::move(other);
  }
  best.build_s = build_s;
  return best;
}

}  // namespace

void FillHoleOptions::setAngle(double angle_rad) {
  tolerance.angle_rad = angle_rad;
  if (angle_rad > tolerance.crease_rad) tolerance.crease_rad = angle_rad;
}

void FillHoleOptions::validate() const {
  tolerance.validate();
  HoleOptions{.corner_rad = corner_rad, .gap_mm = tolerance.gap_mm}.validate();
  if (!(tolerance.angle_rad > 0))
    throw std::invalid_argument("angle tolerance is 0 deg: a fill needs more, 0.01 say");
  if (target != Level::G0 && target != Level::G1 && target != Level::G2)
    throw std::invalid_argument("target " + std::string(name(target)) +
                                ": it must be G0, G1 or G2");
  if (most_degree < 3 || most_degree > 11)
    throw std::invalid_argument("largest degree is " + std::to_string(most_degree) +
                                ": it must be within 3 to 11");
  if (jobs < 0)
    throw std::invalid_argument("jobs is " + std::to_string(jobs) + ": it must not be negative");
}

const char* name(FillMethod method) {
  switch (method) {
    case FillMethod::Surface:
      return "surface";
    case FillMethod::Patches:
      return "patches";
    case FillMethod::Graph:
      return "graph";
    case FillMethod::Sheet:
      return "sheet";
    default:
      return "";
  }
}

std::optional<double> FillHoleReport::waves() const {
  // Choices: fair fills of real holes stay below 1.6, and 1e-9 is the curvature of a plane but for
  // rounding, in any unit of parts.
  constexpr double many = 2, flat_per_mm = 1e-9;
  if (!both_ways_per_mm || around_curvature_per_mm.value_or(0) <= flat_per_mm) return std::nullopt;
  const double times = *both_ways_per_mm / *around_curvature_per_mm;
  if (times < many) return std::nullopt;
  return times;
}

std::optional<double> FillHoleReport::largestGap_mm() const {
  return largest(*this, &SeamFigures::gap_mm);
}

std::optional<double> FillHoleReport::largestCurvature_rel() const {
  return largest(*this, &SeamFigures::curvature_rel);
}

std::optional<double> FillHoleReport::largestAngle_rad() const {
  return largest(*this, &SeamFigures::angle_rad);
}

void requireOptions(const Model& model, const FillHoleOptions& options) {
  options.validate();
  requireAboveRounding("gap tolerance", options.tolerance.gap_mm, model.shape);
}

FillHoleReport fillHole(const Model& model, const Hole& hole, const FillHoleOptions& options,
                        const Progress& progress) {
  requireOptions(model, options);
  requireEdges(model, hole);
  FillHoleReport report;
  report.reason = whyNotMet(model.shape, hole);
  if (report.reason.empty()) {
    const Model own = modelOfOwnParts(model);
    report = fillHole(own, holeIn(own, hole), options, numberedFace, progress);
  }
  if (!report.filled) report.model = model;
  return report;
}

FillHoleReport fillHole(const Model& model, const Hole& hole, const FillHoleOptions& options,
                        const FaceNames& names, const Progress& progress) {
  options.validate();
  requireEdges(model, hole);
  // Of the progress bar: where each method ends.
  constexpr double share_of_face = 0.1, share_of_patches = 0.7, share_of_sheet = 0.8;
  const FillTask task{.model = model, .hole = hole, .options = options, .names = names};
  std::optional<FillHoleReport> by_face;
  if (const std::optional<TopoDS_Face> face = faceThatGoesOn(hole, options))
    by_face = filledByFace(task, *face, partOf(progress, 0, share_of_face));
  // If the face meets others, patches would too, because they would lie where the face lies.
  if (by_face && (by_face->reached || by_face->meets_others)) {
    if (progress && !progress(1)) throw Cancelled();
    return std::move(*by_face);
  }
  FillHoleReport best = bestByPatches(task, partOf(progress, share_of_face, share_of_patches));
  if (by_face && !isBetter(best, *by_face, options)) best = std::move(*by_face);
  const auto consider = [&](std::optional<FillHoleReport> other) {
    if (other && isBetter(*other, best, options)) best = std::move(*other);
  };
  if (!best.reached && options.sheet && isWorthwhile(task))
    consider(filledBySheet(task, partOf(progress, share_of_patches, share_of_sheet)));
  if (!best.reached && options.graph && isWorthwhile(task))
    consider(filledByGraph(task, partOf(progress, share_of_sheet, 1)));
  if (progress && !progress(1)) throw Cancelled();
  return best;
}

}  // namespace seamwright::occ
