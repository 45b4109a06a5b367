// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace seamwright::cli {

/// What `seamwright analyze` was asked to do; angles in degrees as the user types them. A tolerance without a
/// value is that of the profile.
struct AnalyzeArguments {
  std::vector<std::string> models;
  std::string profile = "default";
  std::optional<double> gap_mm;
  std::optional<double> angle_deg;
  std::optional<double> curvature_rel;
  std::optional<double> flat_radius_mm;
  std::optional<double> crease_deg;
  double match_mm = 0;
  std::string level = "G1";
  std::string format = "table";
  std::string output;
  int jobs = 0;
};

/// Adds the options to a command; they are parsed into \p arguments.
void addAnalyzeOptions(CLI::App& command, AnalyzeArguments& arguments);

/// \returns exit status 0 (all seams meet the level) or 1. Writes nothing if it throws.
int runAnalyze(const AnalyzeArguments& arguments);

}  // namespace seamwright::cli
