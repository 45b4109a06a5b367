// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

namespace seamwright {

struct VertexOptions {
  /// Tangents within this angle of their plane are put into it. A larger angle is an error.
  double flat_rad = 1e-6;
};

/// The tangents of spokes at a common point O, and the resulting conditions for members that join
/// G1 across the spokes.
///
/// Member i lies between spoke i, which is its edge v = 0, and spoke i + 1, its edge u = 0; (u, v)
/// = (0, 0) is O. A closed fan of m members has m spokes, counted cyclically, and all are inner
/// spokes. An open fan has m + 1 spokes; the first and the last are its boundary spokes.
///
/// With r_i the tangent of spoke i, det(x, y) = N.(x x y) and S_i = det(r_i, r_(i+1)), members i -
/// 1 and i join across spoke i at O iff
///   r_(i+1) = alpha_i r_i + beta_i r_(i-1): alpha_i = det(r_(i-1), r_(i+1)) / S_(i-1), beta_i =
///   -S_i / S_(i-1) < 0.
/// Identities (each has a test of its number):
///   (1) The equation above holds.
///   (2) In a closed fan the product of the matrices [[alpha_i, beta_i], [1, 0]] around O is the
///       identity.
///   (3) In reversed order alpha_i becomes -alpha_i / beta_i, beta_i its reciprocal, N the
///       opposite; Rigid motions and linear maps change nothing. A factor f_i on r_i gives alpha_i
///       f_(i+1) / f_i and beta_i f_(i+1) / f_(i-1).
/// Source: docs/theory/fills.md F1.1 to F1.3; [DuSchmitt1990].
struct UmbrellaVertex {
  bool closed = true;
  Eigen::Vector3d
      normal;  ///< N, of length 1: seen from its tip the spokes follow each other counter-clockwise
  Eigen::Matrix3Xd tangents;   ///< r_i, in the plane across N; 3 by #spokes
  Eigen::VectorXd sectors;     ///< S_i > 0 of each member
  Eigen::VectorXd angles_rad;  ///< of each member, between 0 and pi
  /// One entry for each spoke; 0 for boundary spokes. alpha is exactly 0 if the neighbours are
  /// opposite up to rounding.
  Eigen::VectorXd alpha, beta;
  double out_of_plane_rad = 0;  ///< the largest angle of a given tangent with the plane
  /// Condition of the equations of the twists with all tangents of length 1: the ratio of the
  /// largest to the smallest singular value, without the one that is 0 if m is even. Errors of
  /// second derivatives grow by this factor. It is about m in a regular fan, and of the size of 1 /
  /// sin of the smallest or largest angle in other fans.
  double condition = 1;

  int members() const { return static_cast<int>(sectors.size()); }
  int spokes() const { return static_cast<int>(tangents.cols()); }
  /// Whether members meet across the spoke.
  bool isInner(int spoke) const { return closed || (spoke > 0 && spoke + 1 < spokes()); }
  /// The next or the previous spoke; -1 if a boundary spoke has none.
  int after(int spoke) const { return wrapped(spoke + 1); }
  int before(int spoke) const { return wrapped(spoke - 1); }
  /// The member between the previous spoke and this one; -1 if a boundary spoke has none.
  int memberBefore(int spoke) const { return before(spoke); }
  /// Whether the vertex is regular: four spokes, opposite in pairs. Then the condition of the even
  /// fan does not depend on the second derivatives.
  bool isRegular() const;

 private:
  int wrapped(int spoke) const {
    if (closed) return (spoke + spokes()) % spokes();
    return spoke < spokes() ? spoke : -1;
  }
};

/// \param tangents r_i = C_i'(0) of the spokes in their order around O, of either sense; 3 by
/// #spokes.
/// \throws std::invalid_argument for fewer than 3 spokes, a tangent that is not finite or zero,
/// tangents that are all parallel or further from one plane than allowed, a sector whose angle is
/// not between 0 and pi (members would be singular at O, or fold), and spokes that do not go around
/// once. Each message names the spoke or sector and the figure.
UmbrellaVertex umbrellaVertex(const Eigen::Matrix3Xd& tangents, bool closed,
                              const VertexOptions& options = {});

}  // namespace seamwright
