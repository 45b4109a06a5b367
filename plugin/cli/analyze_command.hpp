// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/plugin/cli/model_arguments.hpp>
#include <string>
#include <vector>

namespace seamwright::cli {

/// Arguments of `seamwright analyze`.
struct AnalyzeArguments {
  std::vector<std::string> models;
  MeasureArguments measure;
  std::string level = "G1";
  std::string format = "table";
  std::string output;
  bool verdict_only = false;
};

/// Adds the options to a command. Parsing stores them in \p arguments.
void addAnalyzeOptions(CLI::App& command, AnalyzeArguments& arguments);

/// \returns exit status 0 (all seams meet the level) or 1. Writes nothing if it throws.
int runAnalyze(const AnalyzeArguments& arguments);

}  // namespace seamwright::cli
