// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/blend/match_pieces.hpp>
#include <seamwright/plugin/report/blend_json.hpp>
#include <string>
#include <variant>
#include <vector>

namespace seamwright::cli {

struct KeyCurves;

/// Number of a point in its file, from 1.
struct PointNumber {
  int value = 1;
};

/// Share of the length of a curve, 0..1.
struct LengthShare {
  double value = 0;
};

using KeyPlace = std::variant<PointNumber, LengthShare>;

/// What --pair says: a place on each key curve.
struct KeyPair {
  std::string text;  ///< as it was given
  std::vector<KeyPlace> places;
};

/// From places such as "3,40%": points by their number, shares of the length with %.
/// \throws CLI::ValidationError
KeyPair keyPair(const std::string& text);

/// Of each key curve the parameters of the pairs, in the order of the first curve.
/// \throws std::runtime_error for a pair that does not name a place of each curve, for the ends of
/// open curves, and for pairs whose order differs from curve to curve.
std::vector<std::vector<double>> pairParameters(const KeyCurves& input,
                                                const std::vector<KeyPair>& pairs);

/// Which places of the key curves correspond, with the numbers of points that are there.
std::vector<report::MatchedPairRecord> pairRecords(const KeyCurves& input,
                                                   const std::vector<MatchedPlaces>& pairs);

}  // namespace seamwright::cli
