// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

/// The poles of one side of a joint as polynomials of omega; not a public header.
namespace seamwright::loft {

/// A polynomial of omega: Bernstein coefficients, one row each; a constant has one row.
using Bern = Eigen::MatrixXd;

Bern raisedTo(Bern p, Eigen::Index degree);

/// The poles 0..n from a joint on, of a segment of that degree, whose derivatives at the joint are
/// B(b) W. \param jet W_0..W_n. \param change b_1..b_n. \param before the segment ends at the
/// joint; pole 0 is that of the joint also then.
/// Source: docs/theory/surfaces.md S7.1.
std::vector<Bern> jointPoles(const std::vector<Bern>& jet, const std::vector<Bern>& change,
                             int degree, bool before);

}  // namespace seamwright::loft
