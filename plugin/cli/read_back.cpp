// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/plugin/cli/model_arguments.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <seamwright/plugin/cli/read_back.hpp>

namespace seamwright::cli {

report::WrittenModel readBack(const std::filesystem::path& waiting, const std::string& output,
                              const report::Judge& judge) {
  ProgressBar bar(doing("checking", output));
  return report::readBack(waiting, output, judge, bar.progress());
}

}  // namespace seamwright::cli
