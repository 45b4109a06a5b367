// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/// Allocations that fail, in the reading program; not a public header.
namespace seamwright::occ {

/// From now on the first allocation of this process that fails calls \p answer, which must not
/// return. OpenCASCADE catches many such failures and goes on without what it was about to make: a
/// model would lose faces without a word. Has no effect with the address sanitizer, which has an
/// allocator of its own.
void answerWhenOutOfMemory(void (*answer)());

}  // namespace seamwright::occ
