// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/plugin/cli/model_arguments.hpp>
#include <seamwright/plugin/report/written.hpp>
#include <string>
#include <vector>

namespace seamwright::cli {

/// The output of a command: model and report.
struct Outcome {
  const occ::Model* model = nullptr;  ///< null: none is written
  report::Judge judge;                ///< of the model's file
  /// The report as a function of what was written.
  std::function<nlohmann::ordered_json(const std::optional<report::WrittenModel>&)> report;
  bool unchanged = false;             ///< as of occ::WriteOptions
  report::ModelCounts memory;         ///< of the model
  const occ::Model* given = nullptr;  ///< as of report::FileJudge
  /// Called before a file replaces its target. If it throws, the exception is passed on and nothing
  /// is written.
  std::function<void(const report::WrittenModel&)> accepts = {};
};

struct WrittenOutcome {
  std::optional<report::WrittenModel> model;
  std::vector<std::string> notes;  ///< as of occ::WriteReport
};

/// Writes the model, if there is one, with report::writeJudged(), and the report, if one was asked
/// for.
/// \throws std::runtime_error, occ::ModelError, occ::Cancelled.
WrittenOutcome writeOutcome(const Outcome& outcome, const OutputArguments& arguments);

/// Warns of differences between the file and the model in memory, and of what the file's format
/// cannot hold.
void warnOf(const WrittenOutcome& written, const OutputArguments& arguments,
            const report::ModelCounts& memory);

}  // namespace seamwright::cli
