// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/plugin/cli/model_arguments.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <seamwright/plugin/cli/read_back.hpp>

namespace seamwright::cli {

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

}  // namespace seamwright::cli
