// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/occ_adapter/model/unfinished_files.hpp>

namespace seamwright::occ {

UnfinishedFiles unfinishedFiles() {
  struct OfProcess {
    std::mutex mutex;
    std::set<std::filesystem::path> paths;
    bool some_finished = false;
  };
  // Never destroyed: other threads may use it while the process ends.
  static auto& files = *new OfProcess;
  return {.lock = std::unique_lock(files.mutex),
          .paths = files.paths,
          .some_finished = files.some_finished};
}

}  // namespace seamwright::occ
