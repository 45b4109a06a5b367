// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <functional>

#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// Calls work(0) .. work(count - 1), each once, on \p jobs threads (0: one for each processor),
/// while this thread reports progress. All threads have ended when it returns or throws.
/// \throws what \p work threw first; no further work is begun then. \throws Cancelled once progress
/// returned false.
void runParallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                 const Progress& progress);

}  // namespace seamwright::occ
