// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace seamwright::bench {

/// Memory of this process in kB, as Linux counts it.
struct Memory {
  double resident_kB = 0;
  double peak_kB = 0;  ///< largest resident_kB since forgetPeak()
};

/// \throws std::runtime_error where /proc/self/status cannot be read.
Memory memoryNow();
void forgetPeak();

}  // namespace seamwright::bench
