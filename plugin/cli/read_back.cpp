// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/plugin/cli/output.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <seamwright/plugin/cli/read_back.hpp>
#include <seamwright/plugin/report/json.hpp>

namespace seamwright::cli {

WrittenOutcome writeOutcome(const Outcome& outcome, const OutputArguments& arguments) {
  WrittenOutcome written;
  std::optional<PendingFile> report;
  const auto prepareReport = [&] {
    if (!arguments.report.empty())
      report.emplace(arguments.report, report::toLine(outcome.report(written.model)) + '\n')
          .writeStraight();
  };
  if (outcome.model != nullptr) {
    occ::WriteOptions how = arguments.writeOptions();
    how.unchanged = outcome.unchanged;
    ProgressBar writing(doing("writing", arguments.model)),
        checking(doing("checking", arguments.model));
    const auto accepted = [&](const report::WrittenModel& model) {
      if (outcome.accepts) outcome.accepts(model);
      written.model = model;
      prepareReport();
    };
    written.notes = report::writeJudged(*outcome.model, arguments.model, how,
                                        {outcome.judge, outcome.memory, outcome.given},
                                        {writing.progress(), checking.progress()}, accepted)
                        .report.notes;
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
