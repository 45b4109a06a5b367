// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/// Failing allocations of the reading program. Not a public header.
namespace seamwright::occ {

/// From now on, the first allocation of this process that fails calls \p answer, which must not
/// return. Otherwise OpenCASCADE would catch many such failures and go on without what it was about
/// to make: a model would lose faces silently. Has no effect with the address sanitizer, which has
/// an allocator of its own.
void answerWhenOutOfMemory(void (*answer)());

}  // namespace seamwright::occ
