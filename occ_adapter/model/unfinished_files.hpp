// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <mutex>
#include <set>

namespace seamwright::occ {

/// The files of this process that are to take the place of their targets, and the right to make,
/// rename and remove them: other threads wait for it. So a thread that ends the process can keep
/// this object, remove the files, and be sure that no more appear.
struct UnfinishedFiles {
  std::unique_lock<std::mutex> lock;
  std::set<std::filesystem::path>& paths;
  bool& some_finished;  ///< a file took the place of its target
};

/// \returns once no other thread has them.
UnfinishedFiles unfinishedFiles();

}  // namespace seamwright::occ
