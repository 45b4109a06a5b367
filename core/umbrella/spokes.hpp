// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/umbrella/twists.hpp>

/// The curves of an umbrella and their derivatives at O; not a public header.
namespace seamwright::umbrella {

/// The curves raised to one degree, with their starts moved to the mean of the starts.
/// \throws std::invalid_argument for rational curves, curves of degree 0, and starts that are
/// further from their mean than \p gap_mm and rounding.
std::vector<BezierCurve> fromOnePoint(const std::vector<BezierCurve>& curves, double gap_mm);

/// First, second and third derivatives at 0; 3 by #spokes.
Eigen::Matrix3Xd tangentsOf(const std::vector<BezierCurve>& spokes);
Eigen::Matrix3Xd secondsOf(const std::vector<BezierCurve>& spokes);
Eigen::Matrix3Xd thirdsOf(const std::vector<BezierCurve>& spokes);

/// The spokes with these tangents. If their degree is 3 or more, the second derivatives stay.
std::vector<BezierCurve> withTangents(const std::vector<BezierCurve>& spokes,
                                      const Eigen::Matrix3Xd& tangents);
/// The spokes with these second derivatives, raised to degree 3 before. A spoke whose second
/// derivative differs only by rounding stays.
std::vector<BezierCurve> withSeconds(const std::vector<BezierCurve>& spokes,
                                     const Eigen::Matrix3Xd& seconds);
/// The same for third derivatives and degree 4.
std::vector<BezierCurve> withThirds(const std::vector<BezierCurve>& spokes,
                                    const Eigen::Matrix3Xd& thirds);

/// shapedBy() with a form that is checked.
Eigen::Matrix3Xd shaped(const UmbrellaVertex& vertex, const Eigen::Matrix3d& form,
                        const Eigen::Matrix3Xd& second);

/// The largest move of a pole, after \p from is raised to the degree of \p to.
double largestMove(const std::vector<BezierCurve>& from, const std::vector<BezierCurve>& to);

}  // namespace seamwright::umbrella
