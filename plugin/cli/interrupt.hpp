// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace seamwright::cli {

/// From now on Ctrl-C and SIGTERM set a flag, and the work ends at its next step. After a second
/// the process ends in any case, unless a result is in its place already; at a second signal it
/// ends at once. No unfinished file is left.
void noteInterrupts();
bool interrupted();

/// Says once that the process was stopped. \returns its exit status: 128 plus the number of the
/// signal, as shells give it.
int endStopped();

}  // namespace seamwright::cli
