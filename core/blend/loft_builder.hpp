// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/blend/loft_plan.hpp>

/// The common work of frameLoft() and frameSheet(); not a public header.
namespace seamwright::loft {

/// The loft through the frames with these ends.
FrameLoft builtLoft(const FrameFunction& frame, const Interval& omegas, const Ends& ends,
                    const FrameLoftOptions& options);

}  // namespace seamwright::loft
