// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <optional>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/occ_adapter/planar/planar_wires.hpp>
#include <seamwright/plugin/cli/curve_command.hpp>
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

/// "out.csv" or "Edge3 of part.step": the beginning of a message.
std::string nameOf(const GivenCurve& given, const std::string& path) {
  if (given.record.edges.empty()) return path;
  return path + ": Edge" + std::to_string(given.record.edges.front());
}

std::vector<MadeCurve> madeCurves(const CurveInput& input, const CurveArguments& arguments,
                                  const WorkLimit& limit) {
  ProgressBar bar(doing("working on", arguments.input));
  const Progress progress = limit.progress(bar);
  const auto whole = static_cast<double>(input.curves.size());
  std::vector<MadeCurve> result;
  for (const GivenCurve& given : input.curves) {
    const auto done = static_cast<double>(result.size());
    const CurveTask task{.tolerance_mm = arguments.tolerance_mm,
                         .progress = partOf(progress, done / whole, (done + 1) / whole)};
    try {
      result.push_back(madeCurve(arguments.method, given, task));
    } catch (const std::logic_error& error) {
      throw std::runtime_error(nameOf(given, arguments.input) + ": " + error.what());
    }
  }
  return result;
}

report::CurveReport reportOf(const CurveInput& input, const CurveArguments& arguments,
                             const std::vector<MadeCurve>& curves) {
  report::CurveReport report{
      .method = arguments.method, .input = input.facts, .tolerance_mm = arguments.tolerance_mm};
  for (const MadeCurve& curve : curves) report.curves.push_back(curve.record);
  return report;
}

/// Arcs of a drawing are this near to curves of other kinds.
double drawnWithin(double tolerance_mm, const std::vector<MadeCurve>& curves) {
  constexpr double share = 0.1, of_length = 1e-6;
  if (tolerance_mm > 0) return share * tolerance_mm;
  return of_length * curves.front().record.after.length_mm;
}

CurveText drawnCurves(CurveFormat format, const CurveArguments& arguments,
                      const std::vector<MadeCurve>& curves, const WorkLimit& limit) {
  ProgressBar bar(doing("drawing", arguments.output.model));
  return curveText(format, arguments.method, curves, drawnWithin(arguments.tolerance_mm, curves),
                   limit.progress(bar));
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
  command
      .add_option("METHOD", arguments.method,
                  "arcs: arcs and lines; clothoid: clothoids with continuous curvature; conic: "
                  "conics with continuous curvature; fair: the curve or the points made fair")
      ->check(CLI::IsMember(curveMethods()));
  command.add_option(
      "INPUT", arguments.input,
      "Points (.csv, .txt, .dat, .xy, .xyz: x,y or x,y,z on each line), or a STEP, IGES "
      "or BREP file with planar curves");
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
  exitStatus(command, "every curve is within the tolerance", "some are not (OUT is written)");
}

int runCurve(const CurveArguments& arguments) {
  requireCurveOutputs(arguments.input, arguments.output);
  const CurveFormat format = curveFormat(arguments.output.model);
  const CurveInput input = curveInput(arguments);
  const WorkLimit limit(arguments.max_time_s);
  const std::vector<MadeCurve> curves = madeCurves(input, arguments, limit);
  report::CurveReport report = reportOf(input, arguments, curves);
  report.output = {.path = arguments.output.model,
                   .format = formatName(format, arguments.output.model)};
  std::vector<std::string> notes;
  if (format == CurveFormat::Model) {
    notes = writeCurves(curves, report, arguments.output);
  } else {
    const CurveText text = drawnCurves(format, arguments, curves, limit);
    report.output->distance_mm = text.distance_mm;
    writeTexts(text.text, report::toLine(report::toJson(report)) + '\n', arguments.output);
  }
  warn(arguments.output.model, notes);
  writeStandardOutput(report::toText(report));
  warn(arguments.input, input.notes);
  return report.reached() ? 0 : 1;
}

}  // namespace seamwright::cli
