// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <seamwright/core/seam/judge.hpp>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
class Validator;
}  // namespace CLI

/// What the commands on models share.
namespace seamwright::cli {

/// How seams are measured; angles in degrees as the user types them. A tolerance without a value is
/// that of the profile.
struct MeasureArguments {
  std::string profile = "default";
  std::optional<double> gap_mm;
  std::optional<double> angle_deg;
  std::optional<double> curvature_rel;
  std::optional<double> flat_radius_mm;
  std::optional<double> crease_deg;
  double match_mm = 0;
  int jobs = 0;
};

/// Where a command that changes a model leaves it, and its report.
struct OutputArguments {
  std::string model;
  std::string report;  ///< empty: none
  bool overwrite = false;
  bool overwrite_source = false;

  occ::WriteOptions writeOptions() const {
    return {.overwrite = overwrite, .overwrite_source = overwrite_source};
  }
};

/// -o, --json, --overwrite and --overwrite-source. \param done what was done to the model of OUT,
/// as "repaired".
void addOutputOptions(CLI::App& command, const std::string& done, OutputArguments& arguments);

/// Takes the name of a part, as "Edge39", for its number; both are understood.
/// \param kind "Edge", "Face", "Vertex" or "Hole"
CLI::Validator numberOf(const std::string& kind);

/// Values with commas between them, and blanks as one likes. After the option's other
/// transformations.
CLI::Option* listOf(CLI::Option* option);

/// Says what is wanted where a text is no number.
CLI::Validator lengthInMm();

/// Says at the end of a command's help what it exits with, after all else that is said there.
void exitStatus(CLI::App& command, const std::string& of_0, const std::string& of_1);

/// What can be told of the files before \p model is read, as requireReport() and
/// occ::requireTarget().
/// \throws std::runtime_error, occ::ModelError.
void requireOutputs(const std::string& model, const OutputArguments& arguments);

/// Adds profile, gap, angle and threads to a command, and the profiles to its help; they are parsed
/// into \p arguments.
void addG1Options(CLI::App& command, MeasureArguments& arguments);
/// Adds profile, tolerances and threads to a command, and the profiles to its help; they are parsed
/// into \p arguments.
void addToleranceOptions(CLI::App& command, MeasureArguments& arguments);
/// The same, and --match.
void addMeasureOptions(CLI::App& command, MeasureArguments& arguments);

/// The profile's tolerances, with those given one by one in their place.
ContinuityTolerance toleranceOf(const MeasureArguments& arguments);

/// "reading part.step": what a progress bar says of a file.
std::string doing(const std::string& what, const std::string& path);

/// The model of a file, read under a progress bar.
occ::Model readUnderBar(const std::string& path);

occ::WriteReport writeUnderBar(const occ::Model& model, const std::string& path,
                               const occ::WriteOptions& options);

/// What can be told of a report's file before the \p models are read. It replaces an older report,
/// but no model by a slip of the hand.
/// \throws std::runtime_error
void requireReport(const std::string& report, const std::vector<std::string>& models);

/// Notes of a file on standard error.
void warn(const std::string& path, const std::vector<std::string>& notes);

}  // namespace seamwright::cli
