// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/angle.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

/// How places of different frames correspond.
enum class MatchBy {
  Length,    ///< equal fractions of the length
  Features,  ///< corners, jumps and extrema of the curvature in order; between them by length
  Given      ///< given parameters; between them by length. commonKnots() keeps the speeds smooth
             ///< there, unless all frames have a corner or a jump of the curvature
};

struct MatchOptions {
  MatchBy by = MatchBy::Length;
  /// Joints of different frames are one joint if their places differ by at most this share of the
  /// length: places <= closeness. The user's choice; 0 merges equal places only.
  double closeness = 0.01;
  /// MatchBy::Given: for each frame increasing parameters by its knots, equally many. For closed
  /// frames the first of them is the start.
  std::vector<std::vector<double>> given = {};
  /// Closed frames start where they are nearest to the first frame, about their centroids (not for
  /// MatchBy::Given). If that one starts at a corner, or at a jump of the curvature, they do: if
  /// there are equally many, where the sum of their squared distances is least, if possible where
  /// all of them are alike in order; corners of different numbers, where they match at the least
  /// cost. If all frames have corners, the first one starts at a corner too, and if it has more
  /// than another one, at one that corresponds to one of those. For MatchBy::Features it starts at
  /// a corner or jump, too, if those of all frames are alike in cyclic order.
  bool find_start = false;
  /// Frames run in the direction in which they are nearer to the first frame; closed ones in that
  /// in which they go round as it does, unless they lie in planes across or are figures of eight.
  bool find_direction = false;
  /// Joints whose tangents turn by more are corners.
  double corner_rad = 10 * radians_per_degree;
  /// An extremum of the curvature counts if it differs from its neighbours by this share of the
  /// range of the curvature of its frame, and so does a jump. Fainter extrema are left out in
  /// pairs, the faintest first.
  double prominence = 0.1;
  /// MatchBy::Features: features whose places differ by more than this share are not matched,
  /// unless they are all corners, or all jumps between corners, and alike in order.
  double reach = 0.2;
};

/// What corresponds: where closed frames start, features, or given parameters.
enum class MatchedKind { Start, Corner, Jump, Extremum, Given };

/// A place that is the same in all frames.
struct MatchedPlaces {
  MatchedKind kind = MatchedKind::Start;
  std::vector<Eigen::Vector3d> points;  ///< of each frame
  std::vector<double> shares;           ///< likewise, of the length of the frame as it is given
};

struct MatchSummary {
  std::vector<int> pieces_before;  ///< of each frame
  int pieces_after = 0;
  int merged = 0;             ///< joints that belong to several frames because they are close
  std::vector<int> features;  ///< found in each frame
  /// Matched in all frames; given pairs count, too, and so does the start of closed frames if it is
  /// a feature of one kind.
  int matched_features = 0;
  /// In the order of the first frame. The start of closed frames is always among them, the ends of
  /// open ones never.
  std::vector<MatchedPlaces> pairs;
  /// MatchBy::Features: features were found, but equal shares of the length between corners, and
  /// between jumps if all of these correspond: with them the tangents at corresponding places
  /// differ less.
  bool lengths_fit_better = false;
  int unknown_pieces = 0;      ///< whose curvature has no certain profile: no features from them
  std::vector<bool> reversed;  ///< of each frame
  std::vector<double> start;   ///< of each frame: the parameter at which it now starts, 0..1 of
                               ///< its length in its new direction
  /// The largest quotient, over all pieces, of the shares of the length that a piece has in two
  /// frames.
  double largest_ratio = 1;
};

struct MatchedFrames {
  std::vector<BezierSpline> frames;  ///< of one degree and one number of segments
  MatchSummary summary;
};

/// Frames of different numbers of pieces and degrees as frames of equal structure, without a change
/// of any curve: pieces are only divided (de Casteljau) and raised in degree; closed ones may start
/// elsewhere, and curves may run backwards, where asked.
///
///     const MatchedFrames matched = matchPieces({first, last}, {.by = MatchBy::Features});
///
/// Places are shares of the length of the whole curve, 0..1. Where features or parameters are
/// matched, the place is corrected piecewise linearly, so that all frames have them at the same
/// place (the mean). Then all places of inner joints are sorted, and neighbours within the
/// closeness are linked. Linked joints are one joint, but one frame never loses a joint: where a
/// frame comes again a new joint begins. A frame that has a joint of its own among them keeps it;
/// the others are divided at the mean place. Matched features become joints of all frames.
///
/// Identities (each has a test of its number):
///   (1) Every frame is the same point set as before: X_new(t) = X(t) by its knots (shifted, if the
///       start is another).
///   (2) All inner joints of a frame are joints of its result.
///   (3) Unless two joints of one frame are linked, no new piece is shorter than the closeness, as
///       a share of corrected places.
///   (4) Rigid motion and scale move the poles and leave the knots. Reversal of all frames
///       reverses the result. Places are precise to 1e-9 of the length of a piece, and equal
///       within that.
/// Frames keep knots of their own; those of new joints divide the old interval.
///
/// The features are joints that turn by more than corner_rad, and between them joints at which the
/// curvature jumps and the extrema of the curvature, in pieces and at joints: signed for frames
/// that lie in z = 0, otherwise of the curvature in space. An extremum that is a plateau, as on an
/// arc, is in its middle. They are matched in order, and only of one kind, such that the sum of
/// costs is least: displacement by reach for a pair, 1/2 for each extremum that is left alone, 1
/// for a jump, 2 for a corner. A pair of corners costs twice the sum of displacement, distance (3/2
/// at most, about the centroids of frames of radius 1), and 1 if they turn to different sides. All
/// corners are matched whatever that costs if frames have as many, which turn alike in order, and
/// so are between them as many jumps up and down in one order; the others by their places between.
/// Equal shares of the length correspond instead if the tangents of neighbouring frames, turned to
/// fit, then differ less in the mean square. \throws std::invalid_argument for fewer than two
/// frames, a frame that requireValid() refuses (with its index), open and closed frames together, a
/// piece without length (with frame and piece), and options out of range: closeness, reach and
/// prominence 0 to 1/2, counts, order and range of given parameters. Source: docs/theory/curves.md
/// C12.1, C12.2.
MatchedFrames matchPieces(const std::vector<BezierSpline>& frames,
                          const MatchOptions& options = {});

}  // namespace seamwright
