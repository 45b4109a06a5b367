// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include <seamwright/occ_adapter/model/bounds.hpp>

namespace seamwright::occ {

namespace {

constexpr double bytes_per_megabyte = 1e6;

std::optional<double> positiveVariable(const char* name) {
  const char* text = std::getenv(name);
  if (text == nullptr) return std::nullopt;
  const char* end = text + std::strlen(text);
  double value = 0;
  const auto [stop, error] = std::from_chars(text, end, value);
  // Larger values could not be counted in bytes.
  if (error != std::errc() || stop != end || !(value > 0 && value <= 1e12))
    throw std::invalid_argument("the environment variable " + std::string(name) + " is '" + text +
                                "': it must be a positive number, at most 1e12");
  return value;
}

/// Memory that the machine can give without taking it from others.
std::uintmax_t availableMemory() {
  std::ifstream file("/proc/meminfo");
  for (std::string word; file >> word;) {
    std::uintmax_t kibibytes = 0;
    if (word == "MemAvailable:" && file >> kibibytes) return 1024 * kibibytes;
  }
  return std::numeric_limits<std::uintmax_t>::max();
}

}  // namespace

ReaderBounds readerBounds(std::uintmax_t bytes) {
  ReaderBounds bounds;
  bounds.seconds = 60 + 30 * (static_cast<double>(bytes) / bytes_per_megabyte);
  bounds.memory_bytes = std::min(4'000'000'000 + 50 * bytes, availableMemory() / 4 * 3);
  if (const auto seconds = positiveVariable("SEAMWRIGHT_READER_SECONDS")) bounds.seconds = *seconds;
  if (const auto megabytes = positiveVariable("SEAMWRIGHT_READER_MEMORY_MB"))
    bounds.memory_bytes = static_cast<std::uintmax_t>(*megabytes * bytes_per_megabyte);
  return bounds;
}

}  // namespace seamwright::occ
