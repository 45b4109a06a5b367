// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace seamwright::cli {

/// Makes Ctrl-C and SIGTERM set a flag from now on instead of ending the process.
void noteInterrupts();
bool interrupted();

}  // namespace seamwright::cli
