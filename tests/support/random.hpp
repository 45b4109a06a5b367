// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>

namespace seamwright {

/// The seed of the running test: the 32-bit FNV-1a hash of "Suite.Name". Each test thus draws
/// numbers of its own, the same on every machine. A test that needs several generators gives them
/// different indices.
///
/// The environment variable SEAMWRIGHT_SEED, a number below 2^32, replaces the hash. When a test
/// that asked for its seed fails, the seed is printed.
///
/// @throws std::logic_error outside of tests and of their SetUpTestSuite
/// @throws std::invalid_argument when SEAMWRIGHT_SEED is no such number
std::uint32_t testSeed(std::uint32_t index = 0);

}  // namespace seamwright
