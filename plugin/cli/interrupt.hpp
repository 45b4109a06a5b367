// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace seamwright::cli {

/// From now on Ctrl-C and SIGTERM are noted instead of ending the process.
void noteInterrupts();
bool interrupted();

}  // namespace seamwright::cli
