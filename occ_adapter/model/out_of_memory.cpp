// SPDX-License-Identifier: LGPL-2.1-or-later
#include <atomic>
#include <cstddef>

#include <seamwright/occ_adapter/model/out_of_memory.hpp>

namespace {

std::atomic<void (*)()> answer_out_of_memory = nullptr;

}  // namespace

namespace seamwright::occ {

void answerWhenOutOfMemory(void (*answer)()) {
  answer_out_of_memory = answer;
}

}  // namespace seamwright::occ

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

/// What was allocated. Answering needs memory too: a failure there is passed on.
void* orAnswer(void* memory, std::size_t bytes) {
  if (memory != nullptr || bytes == 0) return memory;
  if (const auto answer = answer_out_of_memory.exchange(nullptr)) answer();
  return nullptr;
}

}  // namespace

// The C library's own, which shared libraries call by these names too. NOLINTBEGIN
extern "C" {
void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* memory, std::size_t bytes);

void* malloc(std::size_t bytes) {
  return orAnswer(__libc_malloc(bytes), bytes);
}

void* calloc(std::size_t count, std::size_t bytes) {
  return orAnswer(__libc_calloc(count, bytes), count == 0 ? 0 : bytes);
}

void* realloc(void* memory, std::size_t bytes) {
  return orAnswer(__libc_realloc(memory, bytes), bytes);
}
}
// NOLINTEND

#endif
