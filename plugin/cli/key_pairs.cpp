// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <seamwright/core/blend/spline_places.hpp>
#include <seamwright/plugin/cli/key_curves.hpp>
#include <seamwright/plugin/cli/key_pairs.hpp>
#include <sstream>
#include <stdexcept>

namespace seamwright::cli {

namespace {

/// The whole text as a number.
template <class Number>
bool isNumber(const std::string& text, Number& value) {
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, value);
  return fault == std::errc() && stop == end;
}

KeyPlace placeFrom(const std::string& text) {
  PointNumber number;
  if (isNumber(text, number.value) && number.value >= 1) return number;
  double percent = 0;
  if (text.ends_with('%') && isNumber(text.substr(0, text.size() - 1), percent) && percent >= 0 &&
      percent <= 100)
    return LengthShare{percent / 100};
  throw CLI::ValidationError(
      fmt::format("'{}' is neither the number of a point nor a share of the length such as 40%",
                  text),
      CLI::ExitCodes::ValidationError);
}

double parameterAtShare(const BezierSpline& spline, double share) {
  const match::Place place = match::Measured(spline).placeAt(share);
  const double begin = spline.knots[place.piece], end = spline.knots[place.piece + 1];
  return begin + place.t * (end - begin);
}

/// The parameter, or that of a joint beside it, so that no piece is shorter than places are known.
double joinedParameter(const BezierSpline& spline, double parameter) {
  constexpr double beside = 1e-8;
  const std::vector<double>& knots = spline.knots;
  for (const double knot : knots)
    if (std::abs(knot - parameter) <= beside * (knots.back() - knots.front())) return knot;
  return parameter;
}

double pointParameter(const KeyCurve& key, int number) {
  return key.sampled ? joinedParameter(key.curve, key.sampled->parameters[number - 1])
                     : key.curve.knots[number - 1];
}

double parameterOf(const KeyCurve& key, const std::string& path, const KeyPair& pair,
                   const KeyPlace& place) {
  if (const auto* share = std::get_if<LengthShare>(&place)) {
    const bool is_once_around = key.curve.closed && share->value == 1;
    return joinedParameter(key.curve,
                           parameterAtShare(key.curve, is_once_around ? 0 : share->value));
  }
  const int number = std::get<PointNumber>(place).value;
  if (key.points == 0)
    throw std::runtime_error(
        fmt::format("--pair {}: {} is a model, which has no points: name a share of the length "
                    "such as 40%",
                    pair.text, path));
  if (number > key.points)
    throw std::runtime_error(fmt::format("--pair {}: {} has {} points, and no point {}", pair.text,
                                         path, key.points, number));
  return pointParameter(key, number);
}

/// \throws std::runtime_error for an end, which corresponds to the ends of the other curves anyway.
void requireInside(const BezierSpline& spline, const std::string& path, const KeyPair& pair,
                   double parameter) {
  const bool inside =
      parameter < spline.knots.back() && (spline.closed || parameter > spline.knots.front());
  if (!inside)
    throw std::runtime_error(
        fmt::format("--pair {}: this is an end of the curve of {}, and ends correspond without it",
                    pair.text, path));
}

/// A pair with its parameters.
struct PairAt {
  const KeyPair* pair;
  std::vector<double> parameters;
};

PairAt pairAt(const KeyCurves& input, const KeyPair& pair) {
  if (pair.places.size() != input.curves.size())
    throw std::runtime_error(
        fmt::format("--pair {}: has {} place{}, and {} key curves need one each", pair.text,
                    pair.places.size(), pair.places.size() == 1 ? "" : "s", input.curves.size()));
  PairAt result{&pair, {}};
  for (std::size_t i = 0; i < input.curves.size(); ++i) {
    const KeyCurve& key = input.curves[i];
    const std::string& path = input.facts[key.input].path;
    result.parameters.push_back(parameterOf(key, path, pair, pair.places[i]));
    requireInside(key.curve, path, pair, result.parameters.back());
  }
  return result;
}

/// From the first pair on, once around a closed curve.
void unwrap(const KeyCurves& input, std::vector<PairAt>& pairs) {
  for (std::size_t i = 0; i < input.curves.size(); ++i) {
    const BezierSpline& curve = input.curves[i].curve;
    if (!curve.closed) continue;
    const double start = pairs.front().parameters[i];
    for (PairAt& pair : pairs)
      if (pair.parameters[i] < start)
        pair.parameters[i] += curve.knots.back() - curve.knots.front();
  }
}

/// Whether a curve has the pairs in the opposite order. Those of closed curves begin at the first.
bool haveOppositeOrder(const std::vector<PairAt>& pairs, std::size_t curve, bool closed) {
  const std::size_t first = closed ? 1 : 0;
  for (std::size_t k = first + 1; k < pairs.size(); ++k)
    if (!(pairs[k].parameters[curve] < pairs[k - 1].parameters[curve])) return false;
  return pairs.size() > first + 1;
}

/// \throws std::runtime_error unless the pairs have one order on all curves.
void requireOneOrder(const KeyCurves& input, const std::vector<PairAt>& pairs) {
  for (std::size_t k = 1; k < pairs.size(); ++k)
    for (std::size_t i = 0; i < input.curves.size(); ++i) {
      const PairAt &a = pairs[k - 1], &b = pairs[k];
      if (a.parameters[i] < b.parameters[i]) continue;
      const KeyCurve& key = input.curves[i];
      const std::string hint = !haveOppositeOrder(pairs, i, key.curve.closed) ? ""
                               : key.points > 0 ? ", which runs the other way: reverse its points"
                                                : ", which runs the other way";
      throw std::runtime_error(
          fmt::format("--pair {} and --pair {}: the second is not behind the first on the curve of "
                      "{}{}",
                      a.pair->text, b.pair->text, input.facts[key.input].path, hint));
    }
}

std::string nameOf(MatchedKind kind) {
  switch (kind) {
    case MatchedKind::Start:
      return "start";
    case MatchedKind::Corner:
      return "corner";
    case MatchedKind::Jump:
      return "jump";
    case MatchedKind::Extremum:
      return "extremum";
    case MatchedKind::Given:
      break;
  }
  return "given";
}

/// The points of a file by their share of the length of its curve.
std::map<double, int> numbersByShare(const KeyCurve& key) {
  std::map<double, int> result;
  const match::Measured measured(key.curve);
  for (int number = 1; number <= key.points; ++number)
    result.emplace(measured.shareAt(measured.placeOf(pointParameter(key, number))), number);
  return result;
}

/// The number of the point at a share of the length.
std::optional<int> numberAt(const std::map<double, int>& numbers, double share) {
  constexpr double same = 1e-7;  // above the precision of places, below the distance of points
  const auto found = numbers.lower_bound(share - same);
  if (found == numbers.end() || found->first > share + same) return std::nullopt;
  return found->second;
}

}  // namespace

KeyPair keyPair(const std::string& text) {
  KeyPair pair{text, {}};
  std::istringstream list(text + ',');
  for (std::string item; std::getline(list, item, ',');) pair.places.push_back(placeFrom(item));
  return pair;
}

std::vector<std::vector<double>> pairParameters(const KeyCurves& input,
                                                const std::vector<KeyPair>& pairs) {
  std::vector<PairAt> placed;
  for (const KeyPair& pair : pairs) placed.push_back(pairAt(input, pair));
  std::ranges::sort(placed, {}, [](const PairAt& pair) { return pair.parameters.front(); });
  if (!placed.empty()) unwrap(input, placed);
  requireOneOrder(input, placed);
  std::vector<std::vector<double>> result(input.curves.size());
  for (const PairAt& pair : placed)
    for (std::size_t i = 0; i < result.size(); ++i) result[i].push_back(pair.parameters[i]);
  return result;
}

std::vector<report::MatchedPairRecord> pairRecords(const KeyCurves& input,
                                                   const std::vector<MatchedPlaces>& pairs) {
  std::vector<report::MatchedPairRecord> result;
  for (const MatchedPlaces& pair : pairs) result.push_back({.kind = nameOf(pair.kind)});
  for (std::size_t i = 0; i < input.curves.size() && !pairs.empty(); ++i) {
    const std::map<double, int> numbers = numbersByShare(input.curves[i]);
    for (std::size_t k = 0; k < pairs.size(); ++k)
      result[k].places.push_back({.point = numberAt(numbers, pairs[k].shares[i]),
                                  .length_share = pairs[k].shares[i],
                                  .point_mm = pairs[k].points[i]});
  }
  return result;
}

}  // namespace seamwright::cli
