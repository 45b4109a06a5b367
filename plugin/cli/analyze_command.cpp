// SPDX-License-Identifier: LGPL-2.1-or-later
#include <CLI/CLI.hpp>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/plugin/cli/analyze_command.hpp>
#include <seamwright/plugin/cli/output.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <seamwright/plugin/report/csv.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/table.hpp>

namespace seamwright::cli {

namespace {

occ::AnalyzeOptions optionsOf(const AnalyzeArguments& arguments) {
  occ::AnalyzeOptions options;
  options.tolerance = toleranceOf(arguments.measure);
  options.match_mm = arguments.measure.match_mm;
  options.level = levelFromName(arguments.level).value_or(Level::None);
  options.jobs = arguments.measure.jobs;
  options.figures = !arguments.verdict_only;
  options.validate();
  return options;
}

occ::Report analyzeFile(const std::string& path, const occ::AnalyzeOptions& options) {
  const occ::Model model = readUnderBar(path);
  ProgressBar bar(doing("analysing", path));
  return occ::analyze(model, options, bar.progress());
}

std::string format(const occ::Report& report, const std::string& format) {
  if (format == "json") return report::toJsonLine(report) + '\n';
  if (format == "csv") return report::csvRows(report);
  return report::toTable(report);
}

}  // namespace

void addAnalyzeOptions(CLI::App& command, AnalyzeArguments& arguments) {
  command
      .add_option("MODEL", arguments.models,
                  "STEP, IGES or BREP files, recognised by their content")
      ->required();
  command
      .add_option("--level", arguments.level, "Level that every seam must reach: G0, G1, G2 or G3")
      ->check(CLI::IsMember({"G0", "G1", "G2", "G3"}))
      ->capture_default_str();
  addMeasureOptions(command, arguments.measure);
  command.add_flag("--verdict-only", arguments.verdict_only,
                   "Stop at certain verdicts: figures may have wide bounds");
  command
      .add_option("--format", arguments.format,
                  "Output format: table, json (one line per model) or csv")
      ->check(CLI::IsMember({"table", "json", "csv"}))
      ->capture_default_str();
  command.add_option("-o", arguments.output, "Write to this file instead of standard output");
  exitStatus(command, "all seams meet the level (a crease is not a defect)", "some fall short");
}

int runAnalyze(const AnalyzeArguments& arguments) {
  const occ::AnalyzeOptions options = optionsOf(arguments);
  if (!arguments.output.empty()) requireReport(arguments.output, arguments.models);
  bool passed = true;
  std::vector<occ::ModelFacts> analyzed;
  std::string text = arguments.format == "csv" ? report::csvHeader() : "";
  for (const std::string& model : arguments.models) {
    const occ::Report report = analyzeFile(model, options);
    passed = passed && report.passed();
    analyzed.push_back(report.model);
    if (arguments.format == "table" && !text.empty()) text += '\n';
    text += format(report, arguments.format);
  }
  if (arguments.output.empty())
    writeStandardOutput(text);
  else
    writeFile(arguments.output, text);
  for (const occ::ModelFacts& model : analyzed) warn(model.path, model.notes);
  return passed ? 0 : 1;
}

}  // namespace seamwright::cli
