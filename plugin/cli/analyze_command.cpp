// SPDX-License-Identifier: LGPL-2.1-or-later
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iomanip>
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
#include <sstream>
#include <stdexcept>

namespace seamwright::cli {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// The profile's tolerances, with those given one by one in their place.
ContinuityTolerance toleranceOf(const AnalyzeArguments& arguments) {
  ContinuityTolerance tolerance = toleranceProfile(arguments.profile).value();
  if (arguments.gap_mm) tolerance.gap_mm = *arguments.gap_mm;
  if (arguments.angle_deg) tolerance.angle_rad = *arguments.angle_deg * degree;
  if (arguments.curvature_rel) tolerance.curvature_rel = *arguments.curvature_rel;
  if (arguments.flat_radius_mm) tolerance.flat_radius_mm = *arguments.flat_radius_mm;
  if (arguments.crease_deg) tolerance.crease_rad = *arguments.crease_deg * degree;
  return tolerance;
}

occ::AnalyzeOptions optionsOf(const AnalyzeArguments& arguments) {
  occ::AnalyzeOptions options;
  options.tolerance = toleranceOf(arguments);
  options.match_mm = arguments.match_mm;
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

std::vector<std::string> profileNames() {
  std::vector<std::string> names;
  for (const ToleranceProfile& profile : toleranceProfiles()) names.emplace_back(profile.name);
  return names;
}

std::string profilesHelp() {
  std::ostringstream text;
  text << "Profiles (an option given by itself overrides that figure of the profile, in any order):\n";
  for (const ToleranceProfile& profile : toleranceProfiles()) {
    const ContinuityTolerance& t = profile.tolerance;
    text << "  " << std::left << std::setw(9) << profile.name << "gap " << t.gap_mm << " mm, angle "
         << t.angle_rad / degree << " deg, curvature " << t.curvature_rel << ", flat radius "
         << t.flat_radius_mm << " mm, crease " << t.crease_rad / degree << " deg\n           "
         << profile.purpose << '\n';
  }
  return text.str();
}

std::string format(const occ::Report& report, const std::string& format) {
  if (format == "json") return report::toJsonLine(report) + '\n';
  if (format == "csv") return report::csvRows(report);
  return report::toTable(report);
}

}  // namespace

void addAnalyzeOptions(CLI::App& command, AnalyzeArguments& arguments) {
  command.add_option("MODEL", arguments.models, "STEP, IGES or BREP files, told by their content")
      ->required();
  command.add_option("--profile", arguments.profile, "What is accepted, by name (see below)")
      ->check(CLI::IsMember(profileNames()))
      ->capture_default_str();
  command.add_option("--gap", arguments.gap_mm, "G0: largest distance of the two sides, mm")->type_name("MM");
  command.add_option("--angle", arguments.angle_deg, "G1: largest angle of the tangent planes, degrees")
      ->type_name("DEG");
  command
      .add_option("--curvature", arguments.curvature_rel,
                  "G2: largest relative difference of normal curvature")
      ->type_name("REL");
  command
      .add_option("--flat-radius", arguments.flat_radius_mm, "Flatter than this radius counts as flat, mm")
      ->type_name("MM");
  command
      .add_option("--crease", arguments.crease_deg, "Above this angle a seam is an edge by design, degrees")
      ->type_name("DEG");
  command.add_option("--level", arguments.level, "What every seam must reach: G0, G1, G2 or G3")
      ->check(CLI::IsMember({"G0", "G1", "G2", "G3"}))
      ->capture_default_str();
  command
      .add_option("--match", arguments.match_mm,
                  "Measure also between open edges no further apart than this, mm; 0: between none")
      ->type_name("MM")
      ->capture_default_str();
  command.add_option("--format", arguments.format, "table, json (one line for each model) or csv")
      ->check(CLI::IsMember({"table", "json", "csv"}))
      ->capture_default_str();
  command.add_option("-o", arguments.output, "Write to this file instead of standard output");
  command.add_option("--jobs", arguments.jobs, "Threads; 0: one for each processor")->capture_default_str();
  command.footer(profilesHelp());
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
