// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <functional>

#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// Calls work(0) .. work(count - 1), each once, on \p jobs threads, while this thread reports progress.
/// \p work must not throw. \throws Cancelled once progress returned false and the threads have stopped.
void runParallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                 const Progress& progress);

}  // namespace seamwright::occ
