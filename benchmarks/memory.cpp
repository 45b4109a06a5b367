// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

#include "memory.hpp"

namespace seamwright::bench {

Memory memoryNow() {
  Memory memory;
  std::ifstream status("/proc/self/status");
  for (std::string key; status >> key;
       status.ignore(std::numeric_limits<std::streamsize>::max(), '\n')) {
    if (key == "VmRSS:") status >> memory.resident_kB;
    if (key == "VmHWM:") status >> memory.peak_kB;
  }
  if (memory.peak_kB == 0) throw std::runtime_error("/proc/self/status: no VmHWM");
  return memory;
}

void forgetPeak() {
  std::ofstream file("/proc/self/clear_refs");
  file << 5 << std::flush;
  if (!file) throw std::runtime_error("/proc/self/clear_refs: not writable");
}

}  // namespace seamwright::bench
