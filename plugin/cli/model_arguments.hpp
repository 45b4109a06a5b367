// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <seamwright/core/seam/judge.hpp>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
class Validator;
}  // namespace CLI

/// Options and helpers that the commands on models share.
namespace seamwright::cli {

/// Tolerances of the seams; angles in degrees as the user types them. A tolerance without a value
/// is that of the profile.
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

/// Output files of a command that changes a model: the model and its report.
struct OutputArguments {
  std::string model;
  std::string report;  ///< empty: none
  bool overwrite = false;
  bool overwrite_source = false;

  occ::WriteOptions writeOptions() const {
    return {.overwrite = overwrite, .overwrite_source = overwrite_source};
  }
};

/// -o, --json, --overwrite and --overwrite-source. \param done what the command did to the model of
/// OUT, for example "repaired".
void addOutputOptions(CLI::App& command, const std::string& done, OutputArguments& arguments);

/// Lets the option accept the name of a part, for example "Edge39", as well as its number.
/// \param kind "Edge", "Face", "Vertex" or "Hole"
CLI::Validator numberOf(const std::string& kind);

/// Which numbers an option accepts.
enum class Range { NotNegative, Positive, PositiveOrInfinite };

/// Refuses all texts but decimal numbers in the range. Without it CLI11 takes an empty text for the
/// option's default and accepts hexadecimal numbers.
CLI::Validator numberIn(Range range);

/// Refuses all texts but whole numbers that are not negative.
CLI::Validator wholeNumber();

/// Adds an option whose values are separated by commas and any blanks.
/// \param check applies to each value, which it may rewrite
template <typename T>
CLI::Option* addList(CLI::App& command, const std::string& name, std::vector<T>& values,
                     const std::string& help, const CLI::Validator& check);

/// Appends the exit statuses to the end of a command's help, after all other text.
void exitStatus(CLI::App& command, const std::string& of_0, const std::string& of_1);

/// Checks the output files before \p model is read, with requireReport() and occ::requireTarget().
/// \throws std::runtime_error, occ::ModelError.
void requireOutputs(const std::string& model, const OutputArguments& arguments);

/// Checks the report's file alone: it is neither standard output nor \p model nor OUT.
/// \throws std::runtime_error
void requireReportBeside(const std::string& model, const OutputArguments& arguments);

/// Adds --jobs, the number of threads.
void addJobsOption(CLI::App& command, int& jobs);

/// Adds profile, gap, angle and threads to a command, and the profiles to its help. Parsing stores
/// the values in \p arguments.
void addG1Options(CLI::App& command, MeasureArguments& arguments);
/// Adds profile, tolerances and threads to a command, and the profiles to its help. Parsing stores
/// the values in \p arguments.
void addToleranceOptions(CLI::App& command, MeasureArguments& arguments);
/// Adds the same and --match.
void addMeasureOptions(CLI::App& command, MeasureArguments& arguments);

/// The profile's tolerances; a tolerance that is given separately replaces the profile's.
ContinuityTolerance toleranceOf(const MeasureArguments& arguments);

/// "reading part.step": the text of a progress bar for a file.
std::string doing(const std::string& what, const std::string& path);

/// Reads the model of a file and shows a progress bar.
occ::Model readUnderBar(const std::string& path, occ::Needed needed = occ::Needed::Faces);

occ::WriteReport writeUnderBar(const occ::Model& model, const std::string& path,
                               const occ::WriteOptions& options);

/// Checks a report's file before the \p models are read. The report may replace an older report,
/// but not a model given by mistake.
/// \throws std::runtime_error
void requireReport(const std::string& report, const std::vector<std::string>& models);

/// Prints the notes of a file on standard error.
void warn(const std::string& path, const std::vector<std::string>& notes);

}  // namespace seamwright::cli
