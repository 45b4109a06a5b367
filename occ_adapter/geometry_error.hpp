// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>

namespace seamwright::occ {

/// The geometry of a model can't be computed with: an edge without any curve, a path that is not
/// finite, a curve that can't be approximated. This is a fact about the model, so callers may turn
/// it into a reason or a note. Other exceptions of the standard library are faults of the program.
class GeometryError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace seamwright::occ
