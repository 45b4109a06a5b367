// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <seamwright/core/seam/survey.hpp>
#include <seamwright/core/seam/tolerance.hpp>

namespace seamwright {

/// Geometric continuity reached; None when the sides do not even meet.
enum class Level { None, G0, G1, G2, G3 };

enum class SeamClass {
  Smooth,  ///< meets the level asked for
  Defect,  ///< falls short of it
  Crease   ///< sharp by design: meets in position, at more than the crease angle
};

std::string_view name(Level level);
std::string_view name(SeamClass seam_class);
/// The level of that name ("G0".."G3"); nothing for other text.
std::optional<Level> levelFromName(std::string_view name);

struct Verdict {
  Level level = Level::None;
  SeamClass seam_class = SeamClass::Defect;
  bool certain = false;  ///< the same for every value within the enclosures of the figures
};

/// Judges the figures of a seam by what the user accepts.
///
/// Level: G0 iff gap <= gap_mm; G1 iff moreover angle <= angle_rad and there is no fold; G2 iff
/// moreover relative curvature difference <= curvature_rel; G3 iff moreover relative difference of
/// the change of curvature <= curvature_rel. A figure without a value (nothing could be measured,
/// or the change of curvature was not asked for) stops the climb, and so does a seam that has no
/// tangent plane over more than a twentieth of its length.
///
/// Class: Crease iff G0 holds and the angle is above crease_rad or the seam folds, unless the angle
/// is within crease_rad over more than half of its length: a sharp spot is a Defect. Otherwise
/// Smooth iff the level reaches \p required.
///
/// Level and class are those of the lower ends of the enclosures; certain iff the upper ends
/// (infinite where none is known), those of what the figures leave out among them (see
/// LeftOut::isWithin()), give the same, and nothing else they depend on is only sampled.
Verdict judge(const SeamFigures& figures, const ContinuityTolerance& tolerance, Level required);

/// The level is reached by every value within the enclosures, also of what the figures leave out;
/// without an upper end of a figure it is not known, thus false.
bool surelyReaches(const SeamFigures& figures, const ContinuityTolerance& tolerance, Level level);

/// What the angle and the verdict do not show by themselves, for a note beside them, joined by ";
/// ": a sharp spot in a seam that is below the crease angle over more than half of its length; a
/// fold, whose tangent planes agree as those of a smooth seam do; figures that still changed when
/// sampling ended. Empty if there is nothing of that.
std::string remarksOn(const SeamFigures& figures, const ContinuityTolerance& tolerance);

}  // namespace seamwright
