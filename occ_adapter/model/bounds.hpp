// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

namespace seamwright::occ {

/// How long the reading process may run and how much memory it may take.
///
/// The time is 60 s and 30 s for each MB that it is given. Sound files take up to 1 s for a MB on
/// an idle processor, so that a slow machine that does much else still comes to an end with them.
///
/// The memory is 4 GB and 50 times the size that it is given, but not more than three quarters of
/// what the machine has available. Sound files take up to 30 times their size.
///
/// The environment variables SEAMWRIGHT_READER_SECONDS and SEAMWRIGHT_READER_MEMORY_MB set other
/// bounds.
struct ReaderBounds {
  double seconds = 0;
  std::uintmax_t memory_bytes = 0;
};

/// \param bytes the size of all files that the process is given
/// \throws std::invalid_argument if one of the environment variables is set and is no positive
/// number
ReaderBounds readerBounds(std::uintmax_t bytes);

}  // namespace seamwright::occ
