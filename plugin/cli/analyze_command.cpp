// SPDX-License-Identifier: LGPL-2.1-or-later
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/plugin/cli/analyze_command.hpp>
#include <seamwright/plugin/cli/output.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <seamwright/plugin/report/csv.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/table.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

constexpr double degree = std::numbers::pi / 180;

occ::AnalyzeOptions optionsOf(const AnalyzeArguments& arguments) {
  occ::AnalyzeOptions options;
  options.tolerance = {arguments.gap_mm, arguments.angle_deg * degree, arguments.curvature_rel,
                       arguments.flat_radius_mm, arguments.crease_deg * degree};
  options.level = levelFromName(arguments.level).value_or(Level::None);
  options.jobs = arguments.jobs;
  options.validate();
  return options;
}

void requireOutputIsNoModel(const AnalyzeArguments& arguments) {
  for (const std::string& model : arguments.models) {
    std::error_code error;
    if (std::filesystem::equivalent(model, arguments.output, error))
      throw std::runtime_error(arguments.output + ": is a model to be read, it would be overwritten");
  }
}

occ::Report analyzeFile(const std::string& path, const occ::AnalyzeOptions& options) {
  const std::string file = std::filesystem::path(path).filename().string();
  const occ::Model model = [&] {
    ProgressBar bar("reading " + file);
    return occ::readModel(path, bar.progress());
  }();
  ProgressBar bar("analysing " + file);
  return occ::analyze(model, options, bar.progress());
}

std::string format(const occ::Report& report, const std::string& format) {
  if (format == "json") return report::toJsonLine(report) + '\n';
  if (format == "csv") return report::csvRows(report);
  return report::toTable(report);
}

}  // namespace

void addAnalyzeOptions(CLI::App& command, AnalyzeArguments& arguments) {
  const ContinuityTolerance defaults;
  arguments.gap_mm = defaults.gap_mm;
  arguments.angle_deg = defaults.angle_rad / degree;
  arguments.curvature_rel = defaults.curvature_rel;
  arguments.flat_radius_mm = defaults.flat_radius_mm;
  arguments.crease_deg = defaults.crease_rad / degree;
  command.add_option("MODEL", arguments.models, "STEP, IGES or BREP files, told by their content")
      ->required();
  command.add_option("--gap", arguments.gap_mm, "G0: largest distance of the two sides, mm")
      ->capture_default_str();
  command.add_option("--angle", arguments.angle_deg, "G1: largest angle of the tangent planes, degrees")
      ->capture_default_str();
  command
      .add_option("--curvature", arguments.curvature_rel,
                  "G2: largest relative difference of normal curvature")
      ->capture_default_str();
  command
      .add_option("--flat-radius", arguments.flat_radius_mm, "Flatter than this radius counts as flat, mm")
      ->capture_default_str();
  command
      .add_option("--crease", arguments.crease_deg, "Above this angle a seam is an edge by design, degrees")
      ->capture_default_str();
  command.add_option("--level", arguments.level, "What every seam must reach: G0, G1 or G2")
      ->check(CLI::IsMember({"G0", "G1", "G2", "G3"}))
      ->capture_default_str();
  command.add_option("--format", arguments.format, "table, json (one line for each model) or csv")
      ->check(CLI::IsMember({"table", "json", "csv"}))
      ->capture_default_str();
  command.add_option("-o", arguments.output, "Write to this file instead of standard output");
  command.add_option("--jobs", arguments.jobs, "Threads; 0: one for each processor")->capture_default_str();
}

int runAnalyze(const AnalyzeArguments& arguments) {
  const occ::AnalyzeOptions options = optionsOf(arguments);
  if (!arguments.output.empty()) {
    requireWritable(arguments.output);
    requireOutputIsNoModel(arguments);
  }
  bool passed = true;
  std::vector<std::string> warnings;
  std::string text = arguments.format == "csv" ? report::csvHeader() : "";
  for (const std::string& model : arguments.models) {
    const occ::Report report = analyzeFile(model, options);
    passed = passed && report.passed();
    for (const std::string& note : report.model.notes) warnings.push_back(model + ": " + note);
    if (arguments.format == "table" && !text.empty()) text += '\n';
    text += format(report, arguments.format);
  }
  if (arguments.output.empty())
    writeStandardOutput(text);
  else
    writeFile(arguments.output, text);
  for (const std::string& warning : warnings) std::cerr << "seamwright: warning: " << warning << std::endl;
  return passed ? 0 : 1;
}

}  // namespace seamwright::cli
