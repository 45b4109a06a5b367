// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/plugin/cli/output.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <seamwright/plugin/cli/read_back.hpp>
#include <seamwright/plugin/report/json.hpp>

namespace seamwright::cli {

namespace {

report::WrittenModel readBack(const std::filesystem::path& waiting, const std::string& output,
                              const report::Judge& judge) {
  ProgressBar bar(doing("checking", output));
  return report::readBack(waiting, output, judge, bar.progress());
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
    how.unchanged = outcome.unchanged;
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
