// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/progress.hpp>

namespace seamwright::occ {

using seamwright::Cancelled;
using seamwright::partOf;
using seamwright::Progress;

}  // namespace seamwright::occ
