// SPDX-License-Identifier: LGPL-2.1-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <optional>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/plugin/cli/output.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <seamwright/plugin/cli/read_back.hpp>
#include <seamwright/plugin/cli/repair_command.hpp>
#include <seamwright/plugin/report/numbers.hpp>
#include <seamwright/plugin/report/repair_json.hpp>
#include <seamwright/plugin/report/repair_table.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace seamwright::cli {

namespace {

occ::RepairOptions optionsOf(const RepairArguments& arguments) {
  occ::RepairOptions options;
  options.order = arguments.target == "G2" ? 2 : 1;
  options.tolerance = toleranceOf(arguments.measure);
  options.max_move_mm = arguments.max_move_mm;
  options.fairness = arguments.fairness;
  options.keep_curvature = arguments.keep_curvature;
  options.max_time_s = arguments.max_time_s;
  options.edges = arguments.edges;
  options.fixed_faces = arguments.fixed_faces;
  options.match_mm = arguments.measure.match_mm;
  options.sew = arguments.sew;
  options.convert_analytic = arguments.convert_analytic;
  options.jobs = arguments.measure.jobs;
  options.validate();
  return options;
}

occ::RepairReport repaired(const occ::Model& model, const std::string& path,
                           const occ::RepairOptions& options) {
  ProgressBar bar(doing("repairing", path));
  return occ::repair(model, options, bar.progress());
}

/// A file that is not kept, because the repair made seams of these faces worse in it.
struct FacesToHold : std::exception {
  std::vector<int> faces;
  double repair_s = 0;  ///< spent on the repair
};

/// A repair and its written file.
struct Done {
  occ::RepairReport report;
  WrittenOutcome written;
};

/// \param asked the options of the report; \param used the options of the repair, which may hold
/// more faces
/// \throws FacesToHold if \p may_refuse
Done repairedAndWritten(const occ::Model& model, const RepairArguments& arguments,
                        const occ::RepairOptions& asked, const occ::RepairOptions& used,
                        double spent_s, bool may_refuse) {
  Done done;
  done.report = repaired(model, arguments.model, used);
  occ::RepairReport& report = done.report;
  report.repair_s += spent_s;
  const auto json = [&](const std::optional<report::WrittenModel>& output) {
    return report::toJson(report, asked, output);
  };
  const auto accepts = [&](const report::WrittenModel& written) {
    FacesToHold hold;
    hold.repair_s = report.repair_s;
    for (const occ::SeamResult& seam : written.worse)
      for (const int face : seam.faces)
        if (std::ranges::count(used.fixed_faces, face) + std::ranges::count(used.held_faces, face) +
                std::ranges::count(hold.faces, face) ==
            0)
          hold.faces.push_back(face);
    if (may_refuse && !hold.faces.empty()) throw hold;
  };
  done.written =
      writeOutcome({&report.model, report::judgeOf(report, asked), json, !report.changed(),
                    report::countsOf(report.after, report.model), &model, accepts},
                   arguments.output);
  return done;
}

/// Restores the original faces of seams that the repair made worse in the file: these faces are
/// held, and the rest is repaired again.
Done repairForFile(const occ::Model& model, const RepairArguments& arguments,
                   const occ::RepairOptions& asked) {
  // Choices. What a file still spoils after two repeats is reported. A limit must be positive, so a
  // spent one is a millisecond.
  constexpr int most_repeats = 2;
  constexpr double least_s = 1e-3;
  occ::RepairOptions used = asked;
  double spent_s = 0;
  for (int repeat = 0;; ++repeat) {
    try {
      return repairedAndWritten(model, arguments, asked, used, spent_s, repeat < most_repeats);
    } catch (const FacesToHold& hold) {
      spent_s = hold.repair_s;
      used.max_time_s = std::max(least_s, asked.max_time_s - spent_s);
      std::string names;
      for (const int face : hold.faces) names += (names.empty() ? "" : ", ") + std::to_string(face);
      used.held_faces.insert(used.held_faces.end(), hold.faces.begin(), hold.faces.end());
      warn(arguments.output.model,
           {"repairs that move these faces make seams beside them worse in the file, so these "
            "faces are held: " +
            names});
    }
  }
}

}  // namespace

void addRepairOptions(CLI::App& command, RepairArguments& arguments) {
  command
      .add_option("MODEL", arguments.model, "STEP, IGES or BREP file, recognised by its content")
      ->required();
  command.add_option("--target", arguments.target, "Level that the seams must reach: G1 or G2")
      ->check(CLI::IsMember({"G1", "G2"}))
      ->capture_default_str();
  command
      .add_option("--max-move", arguments.max_move_mm,
                  "No point of a face moves further than this, mm; above 0, or inf for no limit; "
                  "default: a hundredth of the size of the face plus twice the gap of its seams")
      ->type_name("MM")
      ->check(numberIn(Range::PositiveOrInfinite));
  command
      .add_option("--fairness", arguments.fairness,
                  "Largest factor by which the variation of the mean curvature of a face may grow; "
                  "at least 1")
      ->type_name("FACTOR")
      ->check(numberIn(Range::Positive))
      ->capture_default_str();
  command.add_flag("--keep-curvature", arguments.keep_curvature,
                   "Keep seams that are G2 at G2, even if the target is G1");
  addList(command, "--edges", arguments.edges,
          "Edges whose seams are repaired, as 3,7,12 or Edge3,Edge7; default: all defects",
          numberOf("Edge"))
      ->type_name("EDGES");
  addList(command, "--fix", arguments.fixed_faces,
          "Faces that must not move, as 1,4 or Face1,Face4", numberOf("Face"))
      ->type_name("FACES");
  command
      .add_option(
          "--max-time", arguments.max_time_s,
          "Start no more repairs after this time, s, and keep those already made; default: no "
          "limit")
      ->type_name("SECONDS")
      ->check(numberIn(Range::PositiveOrInfinite));
  addMeasureOptions(command, arguments.measure);
  command.add_flag(
      "--convert", arguments.convert_analytic,
      "Convert planes, cylinders and other analytic faces to splines where they have to move");
  command.add_flag_callback(
      "--no-sew", [&arguments] { arguments.sew = false; },
      "Do not join the edges that --match pairs, even if they meet within the gap tolerance");
  addOutputOptions(command, "repaired", arguments.output);
  exitStatus(command,
             "all seams of the result meet the target, also in OUT (a crease is not a defect)",
             "some fall short (OUT is written)");
}

int runRepair(const RepairArguments& arguments) {
  const occ::RepairOptions options = optionsOf(arguments);
  requireOutputs(arguments.model, arguments.output);
  const occ::Model model = readUnderBar(arguments.model);
  const auto [report, written] = repairForFile(model, arguments, options);
  writeStandardOutput(report::toTable(report, written.model));
  warn(arguments.model, report.before.model.notes);
  warnOf(written, arguments.output, report::countsOf(report.after, report.model));
  return report.after.passed() && written.model->found.defects == 0 ? 0 : 1;
}

}  // namespace seamwright::cli
