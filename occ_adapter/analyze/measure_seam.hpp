// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/analyze/analyze.hpp>

namespace seamwright::occ {

/// Measures and judges one seam. The figures are enclosed where the kinds of its surfaces and
/// curves allow it, and otherwise sampled.
///
/// A failure becomes the note of the seam, which then has no figures, level None and class Defect.
/// Failures are those of OpenCASCADE, geometry that can't be computed with (GeometryError), and
/// internal errors (std::logic_error), which the note calls so. Other exceptions, such as
/// std::bad_alloc, pass. Several threads may measure different seams of one shape.
SeamResult measureSeam(const Seam& seam, const AnalyzeOptions& options);

}  // namespace seamwright::occ
