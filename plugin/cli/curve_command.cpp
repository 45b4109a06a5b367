// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/occ_adapter/planar/planar_wires.hpp>
#include <seamwright/plugin/cli/curve_command.hpp>
#include <seamwright/plugin/cli/curve_help.hpp>
#include <seamwright/plugin/cli/curve_input.hpp>
#include <seamwright/plugin/cli/curve_methods.hpp>
#include <seamwright/plugin/cli/curve_output.hpp>
#include <seamwright/plugin/cli/edge_list.hpp>
#include <seamwright/plugin/cli/output.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <seamwright/plugin/report/curve_json.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

/// Stops the work at the user's wish, and when its time is over.
class WorkLimit {
 public:
  explicit WorkLimit(double max_time_s) : max_time_s_(max_time_s) {}

  /// The progress of a part of the work, under a bar. It throws when the time is over.
  Progress progress(ProgressBar& bar) const {
    return [this, draw = bar.progress()](double share) {
      const double spent_s =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
      if (spent_s > max_time_s_)
        throw std::runtime_error(fmt::format(
            "--max-time {} s is over before the curves are done: nothing is written", max_time_s_));
      return draw(share);
    };
  }

 private:
  double max_time_s_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// What became of the curves of the input. One that can't be done does not stop the others.
struct CurveResults {
  std::vector<MadeCurve> made;
  std::vector<report::RefusedCurve> refused;
};

/// Without any curve there is nothing to write: the first reason is an error, under the name of its
/// edges.
void requireSome(const CurveResults& results, const std::string& path) {
  if (!results.made.empty()) return;
  const report::RefusedCurve& first = results.refused.front();
  const std::string name = first.edges.empty() ? "" : report::namesOf(first.edges) + ": ";
  const std::string others =
      results.refused.size() == 1
          ? ""
          : fmt::format("; none of its {} curves can be done", results.refused.size());
  throw std::runtime_error(path + ": " + name + first.reason + others);
}

/// The tolerance of a curve, the least one if points have their own.
double leastTolerance(const GivenCurve& given, const CurveArguments& arguments) {
  double least_mm = HUGE_VAL;
  for (const double tolerance_mm : given.tolerances_mm)
    if (tolerance_mm > 0) least_mm = std::min(least_mm, tolerance_mm);
  if (least_mm < HUGE_VAL) return least_mm;
  return given.tolerances_mm.size() > 0 ? 0 : arguments.tolerance_mm;
}

CurveResults madeCurves(const CurveInput& input, const CurveArguments& arguments,
                        const WorkLimit& limit) {
  ProgressBar bar(doing("working on", arguments.input));
  const Progress progress = limit.progress(bar);
  const auto whole = static_cast<double>(input.curves.size());
  CurveResults results{.made = {}, .refused = input.refused};
  double done = 0;
  for (const GivenCurve& given : input.curves) {
    const CurveTask task{.tolerance_mm = leastTolerance(given, arguments),
                         .progress = partOf(progress, done / whole, (done + 1) / whole)};
    ++done;
    try {
      results.made.push_back(madeCurve(arguments.method, given, task));
    } catch (const std::logic_error& error) {
      results.refused.push_back({.edges = given.record.edges, .reason = error.what()});
    } catch (const std::overflow_error& error) {
      results.refused.push_back({.edges = given.record.edges, .reason = error.what()});
    }
  }
  return results;
}

report::CurveReport reportOf(const CurveInput& input, const CurveArguments& arguments,
                             const CurveResults& results) {
  report::CurveReport report{.method = arguments.method,
                             .input = input.facts,
                             .tolerance_mm = arguments.tolerance_mm,
                             .refused = results.refused};
  for (const MadeCurve& curve : results.made) report.curves.push_back(curve.record);
  return report;
}

/// That of the curve of points, or of all curves of a model.
double drawnTolerance(const CurveInput& input, const CurveArguments& arguments) {
  return input.curves.size() == 1 ? leastTolerance(input.curves.front(), arguments)
                                  : arguments.tolerance_mm;
}

/// Arcs of a drawing are this near to curves of other kinds.
double drawnWithin(double tolerance_mm, const std::vector<MadeCurve>& curves) {
  constexpr double share = 0.1, of_length = 1e-6;
  if (tolerance_mm > 0) return share * tolerance_mm;
  return of_length * curves.front().record.after.length_mm;
}

/// The lines of a drawing or table. Curves that can't be drawn become refused ones.
CurveText drawnCurves(CurveFormat format, const CurveArguments& arguments, double tolerance_mm,
                      CurveResults& results, const WorkLimit& limit) {
  ProgressBar bar(doing("drawing", arguments.output.model));
  CurveText text = curveText(format, arguments.method, results.made,
                             drawnWithin(tolerance_mm, results.made), limit.progress(bar));
  for (auto undrawn = text.undrawn.rbegin(); undrawn != text.undrawn.rend(); ++undrawn) {
    const auto curve = results.made.begin() + static_cast<std::ptrdiff_t>(undrawn->curve);
    results.refused.push_back({.edges = curve->record.edges, .reason = undrawn->reason});
    results.made.erase(curve);
  }
  requireSome(results, arguments.input);
  return text;
}

/// The curves in their planes as a model file. \returns what its format can't hold.
std::vector<std::string> writeCurves(const std::vector<MadeCurve>& curves,
                                     report::CurveReport& report,
                                     const OutputArguments& arguments) {
  std::vector<occ::PlanarWire> wires;
  for (const MadeCurve& curve : curves) {
    occ::PlanarWire wire;
    wire.frame = curve.record.plane;
    wire.chain = curve.chain;
    wires.push_back(std::move(wire));
    report.output->distance_mm = std::max(report.output->distance_mm, curve.chain_distance_mm);
  }
  occ::Model model;
  model.shape = occ::wiresOf(wires);
  return writeModel(std::move(model), report::toLine(report::toJson(report)) + '\n', arguments);
}

}  // namespace

void addCurveOptions(CLI::App& command, CurveArguments& arguments) {
  // Not marked as required, because a subcommand has options of its own.
  command.final_callback([&command] {
    if (!command.get_subcommands().empty()) return;
    for (const char* name : {"METHOD", "INPUT", "-o"})
      if (command.get_option(name)->count() == 0) throw CLI::RequiredError(name);
  });
  const CLI::Option* method =
      command.add_option("METHOD", arguments.method, methodsText() + " (METHOD --help shows more)")
          ->check(CLI::IsMember(curveMethods()));
  helpByMethod(command, *method);
  command.add_option(
      "INPUT", arguments.input,
      "Points (.csv, .txt, .dat, .xy, .xyz: x,y or x,y,z on each line; after a header with the "
      "last column tolerance, for fair: of each point), or a STEP, IGES or BREP file with planar "
      "curves");
  command
      .add_option("--tolerance", arguments.tolerance_mm,
                  "Largest distance from the curve, mm; fair: largest move of a point. 0: arcs "
                  "and conics through all points; clothoids always pass through them")
      ->type_name("MM")
      ->check(numberIn(Range::NotNegative))
      ->capture_default_str();
  command
      .add_option("--flatness", arguments.flatness_mm,
                  "Largest distance of the input from its plane, mm")
      ->type_name("MM")
      ->check(numberIn(Range::NotNegative))
      ->capture_default_str();
  command.add_flag("--closed", arguments.closed, "Join the last point with the first one");
  command.add_flag("--polygon", arguments.polygon,
                   "arcs: the points are the corners of a polygon, with lines between them");
  command.add_flag("--free-ends", arguments.free_ends,
                   "fair: the first and the last point may move as well");
  command
      .add_option_function<std::string>(
          "--edge", [&arguments](const std::string& text) { arguments.edges = edgeList(text); },
          "Edges of the model: numbers as 3 or Edge3, separated by commas, or all, each alone; not "
          "given: the free edges, joined where they meet")
      ->type_name("N[,N...]");
  command
      .add_option("--max-time", arguments.max_time_s,
                  "Stop after this time, seconds; nothing is written then")
      ->type_name("S")
      ->check(numberIn(Range::PositiveOrInfinite));
  command
      .add_option(
          "-o", arguments.output.model,
          "The result: .dxf, .svg, .csv, or a model (.step, .stp, .iges, .igs, .brep, .brp, "
          ".bin)")
      ->type_name("OUT");
  command.add_option("--json", arguments.output.report, "Write a JSON report to this file")
      ->type_name("FILE");
  command.add_flag("--overwrite", arguments.output.overwrite, "Replace OUT if it exists");
  command.add_flag("--overwrite-source", arguments.output.overwrite_source,
                   "Allow OUT to replace INPUT itself");
  exitStatus(command, "every curve is within the tolerance",
             "some are not, or could not be done (OUT has the others)");
}

int runCurve(const CurveArguments& arguments) {
  requireCurveOutputs(arguments.input, arguments.output);
  const CurveFormat format = curveFormat(arguments.output.model);
  const CurveInput input = curveInput(arguments);
  const WorkLimit limit(arguments.max_time_s);
  CurveResults results = madeCurves(input, arguments, limit);
  requireSome(results, arguments.input);
  std::optional<CurveText> text;
  if (format != CurveFormat::Model)
    text = drawnCurves(format, arguments, drawnTolerance(input, arguments), results, limit);
  report::CurveReport report = reportOf(input, arguments, results);
  report.output = {.path = arguments.output.model,
                   .format = formatName(format, arguments.output.model)};
  std::vector<std::string> notes;
  if (text) {
    report.output->distance_mm = text->distance_mm;
    writeTexts(text->text, report::toLine(report::toJson(report)) + '\n', arguments.output);
  } else {
    notes = writeCurves(results.made, report, arguments.output);
  }
  warn(arguments.output.model, notes);
  writeStandardOutput(report::toText(report));
  warn(arguments.input, input.notes);
  return report.reached() ? 0 : 1;
}

}  // namespace seamwright::cli
