// SPDX-License-Identifier: LGPL-2.1-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/fill/repaired_fill.hpp>
#include <seamwright/plugin/cli/fill_command.hpp>
#include <seamwright/plugin/cli/output.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <seamwright/plugin/cli/read_back.hpp>
#include <seamwright/plugin/report/fill_json.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

occ::FillHoleOptions optionsOf(const FillArguments& arguments) {
  occ::FillHoleOptions options;
  options.target = *levelFromName(arguments.target);
  options.tolerance.gap_mm = arguments.gap_mm;
  options.setAngle(arguments.angle_deg * radians_per_degree);
  options.tolerance.curvature_rel = arguments.curvature_rel;
  options.keep_anyway = arguments.keep_anyway;
  options.corner_rad = arguments.corner_deg * radians_per_degree;
  options.jobs = arguments.jobs;
  options.validate();
  return options;
}

/// Includes the edges that belong to no hole, with the reason, because they may explain why a hole
/// is missing.
std::string listed(const occ::Holes& found) {
  std::string text;
  for (const occ::Hole& hole : found.holes) text += "; " + report::shortly(hole);
  for (const std::string& note : found.notes) text += "; " + note;
  return text;
}

occ::Hole holeOf(const occ::Model& model, const FillArguments& arguments,
                 const occ::FillHoleOptions& options) {
  const occ::Holes found =
      occ::findHoles(model.shape, {options.corner_rad, options.tolerance.gap_mm});
  const std::vector<occ::Hole>& holes = found.holes;
  if (holes.empty()) throw std::runtime_error(arguments.model + ": has no hole" + listed(found));
  if (arguments.hole == 0 && holes.size() == 1) return holes.front();
  if (arguments.hole == 0)
    throw std::runtime_error(arguments.model + ": has " + std::to_string(holes.size()) +
                             " holes, name one with --hole" + listed(found));
  const auto hole = std::ranges::find(holes, arguments.hole, &occ::Hole::id);
  if (hole == holes.end())
    throw std::runtime_error(arguments.model + ": has no hole " + std::to_string(arguments.hole) +
                             listed(found));
  return *hole;
}

occ::FillHoleReport filled(const occ::Model& model, const FillArguments& arguments,
                           const occ::FillHoleOptions& options) {
  ProgressBar bar(doing("filling", arguments.model));
  const auto replace = arguments.repair_first ? occ::repairedAndReplacedFaces : occ::replaceFaces;
  if (!arguments.faces.empty()) return replace(model, arguments.faces, options, bar.progress());
  const occ::Hole hole = holeOf(model, arguments, options);
  return arguments.repair_first ? occ::repairedAndFilledHole(model, hole, options, bar.progress())
                                : occ::fillHole(model, hole, options, bar.progress());
}

}  // namespace

void addFillOptions(CLI::App& command, FillArguments& arguments) {
  command
      .add_option("MODEL", arguments.model, "STEP, IGES or BREP file, recognised by its content")
      ->required();
  command
      .add_option("--target", arguments.target,
                  "Level that every new seam must reach: G0, G1 or G2")
      ->check(CLI::IsMember({"G0", "G1", "G2"}))
      ->capture_default_str();
  CLI::Option* hole = command
                          .add_option("--hole", arguments.hole,
                                      "Number of the hole; may be left out if there is only one")
                          ->type_name("N")
                          ->transform(numberOf("Hole"));
  command
      .add_option("--face", arguments.faces,
                  "Remove this face, or these, and fill the hole that is left")
      ->type_name("N,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->transform(numberOf("Face"))
      ->excludes(hole);
  command.add_option("--gap", arguments.gap_mm, "G0: largest gap along a new seam, mm")
      ->type_name("MM")
      ->check(numberIn(Range::NotNegative))
      ->capture_default_str();
  command
      .add_option("--angle", arguments.angle_deg,
                  "G1: largest angle between the tangent planes, degrees")
      ->type_name("DEG")
      ->check(numberIn(Range::NotNegative))
      ->capture_default_str();
  command
      .add_option("--curvature", arguments.curvature_rel,
                  "G2: largest relative difference of normal curvature")
      ->type_name("REL")
      ->check(numberIn(Range::NotNegative))
      ->capture_default_str();
  command
      .add_option("--corner", arguments.corner_deg,
                  "A point where the boundary turns by more than this is a corner, degrees")
      ->type_name("DEG")
      ->check(numberIn(Range::NotNegative))
      ->capture_default_str();
  command.add_flag("--repair-first", arguments.repair_first,
                   "Repair the seams that end at the hole, between the faces around it, before");
  command.add_flag("--keep-anyway", arguments.keep_anyway,
                   "Write OUT even if the fill misses the target");
  addJobsOption(command, arguments.jobs);
  addOutputOptions(command, "filled", arguments.output);
  exitStatus(command, "the new seams meet the target, also in OUT",
             "some fall short (OUT is written only with --keep-anyway)");
}

int runFill(const FillArguments& arguments) {
  const occ::FillHoleOptions options = optionsOf(arguments);
  requireOutputs(arguments.model, arguments.output);
  const occ::Model model = readUnderBar(arguments.model);
  const occ::FillHoleReport report = filled(model, arguments, options);
  const auto json = [&](const std::optional<report::WrittenModel>& output) {
    return report::toJson(report, options, occ::factsOf(model), output);
  };
  const report::ModelCounts memory = report::countsOf(report, options);
  const WrittenOutcome written =
      writeOutcome({report.filled ? &report.model : nullptr, report::judgeOf(report, options), json,
                    false, memory},
                   arguments.output);
  writeStandardOutput(report::toTable(report, options, written.model));
  warn(arguments.model, model.notes);
  warnOf(written, arguments.output, memory);
  return report.reached && written.model->isAsGoodAs(memory) ? 0 : 1;
}

}  // namespace seamwright::cli
