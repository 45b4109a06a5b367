// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <seamwright/core/seam/survey.hpp>
#include <seamwright/core/seam/tolerance.hpp>

namespace seamwright {

/// Geometric continuity that a seam reaches; None if the sides do not even meet.
enum class Level { None, G0, G1, G2, G3 };

enum class SeamClass {
  Smooth,  ///< reaches the required level
  Defect,  ///< does not reach it
  Crease   ///< sharp by design: meets in position, at more than the crease angle
};

std::string_view name(Level level);
std::string_view name(SeamClass seam_class);
/// The level of that name ("G0".."G3"); nothing for other text.
std::optional<Level> levelFromName(std::string_view name);

struct Verdict {
  Level level = Level::None;
  SeamClass seam_class = SeamClass::Defect;
  bool certain = false;  ///< every value within the enclosures gives the same verdict
};

/// Judges the figures of a seam by the tolerances of the user.
///
/// Level: each level requires the level before it.
///   G0 iff gap <= gap_mm.
///   G1 iff angle <= angle_rad and there is no fold.
///   G2 iff the relative curvature difference is <= curvature_rel.
///   G3 iff the relative difference of the change of curvature is <= curvature_rel.
/// A figure without a value ends the climb: nothing could be measured, or the change of curvature
/// was not asked for. A seam without tangent plane over more than a twentieth of its length is at
/// most G0.
///
/// Class: Crease iff G0 holds and the angle is above crease_rad or the seam folds, unless the angle
/// is within crease_rad over more than half of the length. In that case the seam has a sharp spot
/// and is not a crease. A seam that is not a crease is Smooth iff the level reaches \p required,
/// else Defect.
///
/// Level and class are those of the lower ends of the enclosures. The verdict is certain iff the
/// upper ends give the same level and class, and nothing else on which these depend is only
/// sampled. The upper ends include those of what the figures leave out (see LeftOut::isWithin());
/// an unknown upper end counts as infinite.
Verdict judge(const SeamFigures& figures, const ContinuityTolerance& tolerance, Level required);

/// Whether every value within the enclosures reaches the level, including what the figures leave
/// out. False if a figure that matters has no upper end.
bool certainlyReaches(const SeamFigures& figures, const ContinuityTolerance& tolerance,
                      Level level);

/// Remarks on what the angle and the verdict do not show, joined by "; ". Empty if there is none of
/// the following:
///   - a sharp spot in a seam that is below the crease angle over more than half of its length;
///   - a fold: its tangent planes agree like those of a smooth seam;
///   - figures that still changed when sampling ended.
std::string remarksOn(const SeamFigures& figures, const ContinuityTolerance& tolerance);

}  // namespace seamwright
