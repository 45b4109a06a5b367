// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/plugin/cli/output.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <seamwright/plugin/cli/read_back.hpp>
#include <seamwright/plugin/report/json.hpp>

namespace seamwright::cli {

namespace {

report::WrittenModel readBack(const std::filesystem::path& waiting, const std::string& output,
                              const Judge& judge) {
  constexpr double read = 0.5;
  ProgressBar bar(doing("checking", output));
  const occ::Progress progress = bar.progress();
  try {
    const occ::Model model = occ::readModel(waiting.string(), occ::partOf(progress, 0, read));
    return {output, occ::targetFormat(output), judge(model, occ::partOf(progress, read, 1))};
  } catch (const occ::ModelError& error) {
    throw occ::ModelError(occ::ModelErrc::NotWritten, output,
                          std::string("can't be read back, so it is not written: ") + error.what());
  }
}

}  // namespace

WrittenOutcome writeOutcome(const Outcome& outcome, const OutputArguments& arguments) {
  WrittenOutcome written;
  std::optional<PendingFile> report;
  const auto prepareReport = [&] {
    if (!arguments.report.empty())
      report.emplace(arguments.report, report::toLine(outcome.report(written.model)) + '\n');
  };
  if (outcome.model != nullptr) {
    occ::WriteOptions how = arguments.writeOptions();
    how.check = [&](const std::filesystem::path& waiting) {
      written.model = readBack(waiting, arguments.model, outcome.judge);
      prepareReport();
    };
    written.notes = writeUnderBar(*outcome.model, arguments.model, how).notes;
  } else {
    prepareReport();
  }
  if (report) report->takePlace();
  return written;
}

void warnOf(const WrittenOutcome& written, const OutputArguments& arguments,
            const report::ModelCounts& memory) {
  warn(arguments.model, written.notes);
  if (!written.model) return;
  if (const std::string differences = written.model->differences(memory); !differences.empty())
    warn(arguments.model, {differences});
}

}  // namespace seamwright::cli
