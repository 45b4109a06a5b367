// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/analyze/analyze.hpp>

namespace seamwright::occ {

/// Measures and judges one seam. The figures are enclosed where the kinds of its surfaces and
/// curves allow it, and otherwise sampled.
///
/// Never throws: a failure becomes the note of the seam, which then has no figures, level None and
/// class Defect. Several threads may measure different seams of one shape.
SeamResult measureSeam(const Seam& seam, const AnalyzeOptions& options);

}  // namespace seamwright::occ
