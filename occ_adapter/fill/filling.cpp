// SPDX-License-Identifier: LGPL-2.1-or-later
#include <TopoDS.hxx>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <stdexcept>

#include <seamwright/occ_adapter/fill/face_curvature.hpp>
#include <seamwright/occ_adapter/fill/fill_verdict.hpp>
#include <seamwright/occ_adapter/fill/filling.hpp>
#include <seamwright/occ_adapter/fill/graph_face.hpp>
#include <seamwright/occ_adapter/fill/sheet_face.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/model/failure_text.hpp>
#include <seamwright/occ_adapter/model/parts.hpp>
#include <seamwright/occ_adapter/repair/sew.hpp>

namespace seamwright::occ {

namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<TopoDS_Shape> newFaces(const FillHoleReport& report) {
  const TopTools_IndexedMapOfShape all = partsOf(report.model.shape, TopAbs_FACE);
  std::vector<TopoDS_Shape> faces;
  for (const int face : report.faces) faces.push_back(all(face));
  return faces;
}

/// The largest normal curvature of the faces beside the fill, along its boundary.
std::optional<double> curvatureAround_per_mm(const FillHoleReport& report) {
  const TopTools_IndexedMapOfShape faces = partsOf(report.model.shape, TopAbs_FACE),
                                   edges = partsOf(report.model.shape, TopAbs_EDGE);
  std::optional<double> largest;
  for (const SeamResult& seam : report.outer)
    for (const int face : seam.faces) {
      if (std::ranges::count(report.faces, face) > 0) continue;
      for (const int edge : seam.edges)
        if (const auto there =
                largestCurvatureAlong_per_mm(TopoDS::Edge(edges(edge)), TopoDS::Face(faces(face))))
          largest = std::max(largest.value_or(0), *there);
    }
  return largest;
}

/// What sewing, measuring and judging find about new faces.
void complete(const FillTask& task, const FillFaces& made, const Progress& progress,
              const std::function<void(const char*)>& begin, FillHoleReport& report) {
  const auto start = std::chrono::steady_clock::now();
  begin("sewing the new faces");
  const SewnFill fill = sewFill(task, made.faces, made.cut, partOf(progress, 0, 0.3));
  report.face_names = fill.face_names;
  report.sew_s = secondsSince(start);
  begin("measuring the new seams");
  FillSeams seams = measureFill(fill, task.options, partOf(progress, 0.3, 0.9));
  report.faces.assign(fill.faces.begin(), fill.faces.end());
  report.measure_s = secondsSince(start) - report.sew_s;
  const FillVerdict verdict = judgeFill(task, made, fill, seams);
  report.outer = std::move(seams.outer);
  report.inner = std::move(seams.inner);
  report.meets_others = verdict.meets_others;
  report.reason = verdict.reason;
  report.reached = verdict.reason.empty();
  report.filled = verdict.valid && (report.reached || task.options.keep_anyway);
  if (!report.filled) return;
  report.model.attributes = attributesAfter(task.model.attributes, fill.whole, fill.sewn);
  report.model.shape = filledShape(fill, task.model.shape);
  if (const std::optional<Bends> bends = bendsOf(newFaces(report))) {
    report.curvature_per_mm = bends->largest_per_mm;
    report.both_ways_per_mm =
        std::min(bends->mean_per_mm.upper, std::abs(bends->mean_per_mm.lower));
  }
  report.around_curvature_per_mm = curvatureAround_per_mm(report);
}

/// Takes what the faces tell into the report.
void take(const FillTask& task, const FillFaces& made, FillHoleReport& report) {
  report.sides = filledSides(task.hole, made.cut);
  report.corners = made.corners;
  report.regular = made.regular;
  report.reach = made.reach;
  report.curvature_jump_per_mm = made.curvature_jump_per_mm;
}

using Begin = std::function<void(const char*)>;
using Make = std::function<FillFaces(const Begin&)>;

/// The faces of a construction of core. It refuses sides by std::invalid_argument and
/// std::domain_error, and by std::overflow_error if their numbers leave its range.
/// \throws NotFilled for these, and what else \p make throws.
FillFaces constructed(const Make& make, const Begin& begin) {
  const auto refused = [](const std::exception& error) {
    return NotFilled({.fault = FillFault::ConstructionRefused, .detail = error.what()});
  };
  try {
    return make(begin);
  } catch (const std::invalid_argument& error) {
    throw refused(error);
  } catch (const std::domain_error& error) {
    throw refused(error);
  } catch (const std::overflow_error& error) {
    throw refused(error);
  }
}

/// Runs the stages. What geometry can cause becomes a reason: a hole that no fill has (NotFilled),
/// an edge or a face that can't be evaluated (GeometryError), and a failure of OpenCASCADE. Other
/// exceptions are faults of the program, and pass.
FillHoleReport run(const FillTask& task, FillMethod method, const Progress& progress,
                   const Make& make) {
  FillHoleReport report;
  report.model = task.model;
  report.method = method;
  FillFaces made;
  const char* doing = "";
  const auto begin = [&doing](const char* stage) { doing = stage; };
  try {
    const auto start = std::chrono::steady_clock::now();
    made = constructed(make, begin);
    take(task, made, report);
    report.build_s = secondsSince(start);
    complete(task, made, progress, begin, report);
  } catch (const Cancelled&) {
    throw;
  } catch (const Standard_Failure& failure) {
    report.reason = reasonOf(doing, failure);
    report.reason.causes = causesOfDistance(task, made.cut);
  } catch (const NotFilled& why) {
    report.reason = why.reason();
  } catch (const GeometryError& error) {
    report.reason = {.fault = FillFault::ConstructionRefused, .detail = error.what()};
  }
  return report;
}

/// A fill of one face that is fitted to the surroundings, if \p fit makes one.
std::optional<FillHoleReport> filledByFit(
    const FillTask& task, FillMethod method, const char* doing, const Progress& progress,
    const std::function<std::optional<FillFaces>(const Progress&)>& fit) {
  constexpr double share_of_fit = 0.5;  // of the progress bar
  bool is_made = true;
  FillHoleReport report =
      run(task, method, partOf(progress, share_of_fit, 1), [&](const Begin& begin) {
        begin(doing);
        std::optional<FillFaces> made = fit(partOf(progress, 0, share_of_fit));
        is_made = made.has_value();
        if (!is_made) throw NotFilled({});
        made->is_fitted = true;
        return std::move(*made);
      });
  return is_made ? std::optional(std::move(report)) : std::nullopt;
}

/// Whether a sheet with more knots may reach what this one does not.
bool isWorthAFinerSheet(const FillHoleReport& report) {
  return !report.reached && !report.meets_others && !report.outer.empty();
}

}  // namespace

FillReason reasonOf(const std::string& doing, const Standard_Failure& failure) {
  return {.fault = FillFault::OpenCascadeFailed,
          .detail = doing + " failed: OpenCASCADE stopped at " + failureText(failure)};
}

bool isSound(const FillHoleReport& report) {
  return report.regular && report.reach <= most_reach && !report.outer.empty();
}

FillHoleReport filledByPatches(const FillTask& task, const FillAttempt& attempt,
                               const Progress& progress) {
  return run(task, FillMethod::Patches, progress, [&](const Begin& begin) {
    begin("fitting the sides");
    const HoleCuts cuts = cutsOf(task, attempt);
    begin("building patches");
    return fillFaces(cuts, task.options, attempt);
  });
}

FillHoleReport filledByFace(const FillTask& task, const TopoDS_Face& face,
                            const Progress& progress) {
  return run(task, FillMethod::Surface, progress, [&](const Begin&) {
    FillFaces made;
    made.faces = {face};
    made.regular = made.is_trimmed = true;
    return made;
  });
}

std::optional<FillHoleReport> filledByGraph(const FillTask& task, const Progress& progress) {
  return filledByFit(task, FillMethod::Graph, "fitting a graph", progress,
                     [&](const Progress& fitting) -> std::optional<FillFaces> {
                       const std::optional<TopoDS_Face> face = graphFace(task, fitting);
                       if (!face) return std::nullopt;
                       FillFaces made;
                       made.faces = {*face};
                       made.regular = made.is_trimmed = true;
                       return made;
                     });
}

std::optional<FillHoleReport> filledBySheet(const FillTask& task, const Progress& progress) {
  SheetFaces sheets(task);
  std::optional<FillHoleReport> best;
  while (!best || isWorthAFinerSheet(*best)) {
    std::optional<FillHoleReport> report =
        filledByFit(task, FillMethod::Sheet, "fitting a sheet", progress,
                    [&](const Progress& fitting) -> std::optional<FillFaces> {
                      const std::optional<SheetFace> sheet = sheets.next(fitting);
                      if (!sheet) return std::nullopt;
                      FillFaces made;
                      made.faces = {sheet->face};
                      made.regular = sheet->regular;
                      made.reach = sheet->reach;
                      return made;
                    });
    if (!report) break;
    best = std::move(report);
  }
  return best;
}

}  // namespace seamwright::occ
