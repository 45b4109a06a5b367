// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

namespace seamwright::occ {

/// Limits of time and memory of the reading process.
///
/// The time is 60 s plus 30 s for each MB of its files. Valid files take up to 1 s for a MB on an
/// idle processor, so that a slow, busy machine can also read them.
///
/// The memory is 4 GB plus 50 times the size of its files, but at most three quarters of what the
/// machine has available. Valid files take up to 30 times their size.
///
/// The environment variables SEAMWRIGHT_READER_SECONDS and SEAMWRIGHT_READER_MEMORY_MB replace
/// these limits.
struct ReaderBounds {
  double seconds = 0;
  std::uintmax_t memory_bytes = 0;
};

/// \param bytes the size of all files that the process is given.
/// \throws std::invalid_argument if one of the environment variables is set but is not a positive
/// number.
ReaderBounds readerBounds(std::uintmax_t bytes);

}  // namespace seamwright::occ
