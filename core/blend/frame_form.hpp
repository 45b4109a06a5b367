// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <seamwright/core/blend/omega_spline.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

/// The numbers of a frame that a loft interpolates; not a public header.
namespace seamwright::loft {

/// What all frames of a loft have in common.
struct FrameShape {
  int degree = 0;             ///< of the surface along the frames
  std::vector<double> knots;  ///< of the surface along the frames, each once
  bool closed = false;
  int order = 0;                       ///< G^n across the lines of joints
  std::vector<int> joint_orders = {};  ///< of single joints; see FrameLoftOptions

  int segments() const { return static_cast<int>(knots.size()) - 1; }
};

/// The poles of a surface along omega, as Bernstein coefficients on each piece: 4 columns for each
/// pole along the frames (homogeneous), degree pieces + 1 rows.
struct FormPoles {
  int degree = 3;
  Eigen::MatrixXd rows;
  /// Pieces in which the ratio of the speeds at a joint may not be positive.
  std::vector<int> unsafe;
};

/// A chart of all frames of one shape that are G^n at their joints: any numbers are a frame again
/// (as long as lengths stay positive), polynomial numbers a polynomial surface.
class FrameForm {
 public:
  virtual ~FrameForm() = default;
  /// The numbers of a frame of the shape's degree. \throws std::invalid_argument without a tangent
  /// at a joint, with its index.
  virtual Row numbers(const BezierSpline& frame) const = 0;
  /// The numbers of a curve that is C^n by the knots of the shape.
  virtual Row smoothNumbers(const BezierSpline& curve) const = 0;
  /// Their derivatives by omega, where the derivative of the frame is this C^n vector field.
  virtual Row smoothDerivatives(const BezierSpline& field) const = 0;
  virtual FormPoles poles(const OmegaSpline& spline) const = 0;
  virtual std::vector<double> knotsAlong() const = 0;  ///< flat
};

/// Frames that are C^n by the knots of the shape: their B-spline poles.
std::unique_ptr<FrameForm> smoothForm(const FrameShape& shape);
/// Other frames: free poles and, at each joint, a common jet and the two parameter changes that
/// make the sides of it. Source: docs/theory/surfaces.md S7.1, S7.2.
std::unique_ptr<FrameForm> jointForm(const FrameShape& shape);

/// The spline with its segments raised to that degree.
BezierSpline raised(const BezierSpline& spline, int degree);

}  // namespace seamwright::loft
