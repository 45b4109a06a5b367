// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include <seamwright/occ_adapter/topology/sewn_intervals.hpp>

namespace seamwright::occ {

namespace {

class Cutter {
 public:
  Cutter(const std::vector<Seam>& seams, const std::vector<std::size_t>& chosen, double gap_mm)
      : seams_(seams), gap_mm_(gap_mm) {
    for (const std::size_t seam : chosen) add(seam);
  }

  SewnIntervals run() {
    for (auto& [edge, cuts] : result_.cuts) cuts = merged(edge, cuts);
    for (SewnInterval& interval : result_.intervals) settle(interval);
    return std::move(result_);
  }

 private:
  void add(std::size_t number) {
    const Seam& seam = seams_[number];
    SewnInterval interval;
    interval.seam = number;
    interval.ranges = {ParameterRange{seam.correspondence.a.front(), seam.correspondence.a.back()},
                       ParameterRange{seam.correspondence.b.front(), seam.correspondence.b.back()}};
    for (const int side : {0, 1}) {
      const int edge = seam.edges[side];
      interval.edges[side] = edge;
      if (paths_.count(edge) == 0) {
        const Coedge& use = seam.sides[side];
        paths_[edge] = {surfaceOf(use.shape), pathOrBuilt(use.edge, use.shape, gap_mm_)};
      }
      for (const double parameter : interval.ranges[side]) result_.cuts[edge].push_back(parameter);
    }
    result_.intervals.push_back(interval);
  }

  gp_Pnt point(int edge, double parameter) const {
    const EdgeSide& side = paths_.at(edge);
    return side.placed.at(
        side.path.curve->Value(side.path.first + parameter * (side.path.last - side.path.first)));
  }

  bool areOne(int edge, double a, double b) const {
    // The ends of a closed edge are one point in space, but not one parameter.
    constexpr double half_way_round = 0.5;
    return std::abs(a - b) < half_way_round && point(edge, a).Distance(point(edge, b)) <= gap_mm_;
  }

  std::vector<double> merged(int edge, std::vector<double> parameters) const {
    std::ranges::sort(parameters);
    std::vector<double> kept = {0};
    for (const double parameter : parameters)
      if (!areOne(edge, kept.back(), parameter) && !areOne(edge, parameter, 1))
        kept.push_back(parameter);
    kept.push_back(1);
    return kept;
  }

  static int nearest(const std::vector<double>& cuts, double parameter) {
    const auto found = std::ranges::min_element(
        cuts, {}, [parameter](double cut) { return std::abs(cut - parameter); });
    return static_cast<int>(found - cuts.begin());
  }

  void settle(SewnInterval& interval) {
    SewReason why;
    for (const int side : {0, 1}) {
      const std::vector<double>& cuts = result_.cuts.at(interval.edges[side]);
      ParameterRange& range = interval.ranges[side];
      const int from = nearest(cuts, range[0]), to = nearest(cuts, range[1]);
      if (std::abs(to - from) > 1)
        why = why_not_sewn::intervalDivided(interval.edges[side]);
      else if (to == from)
        why = why_not_sewn::intervalShort(interval.edges[side]);
      interval.pieces[side] = std::min(from, to);
      range = {cuts[from], cuts[to]};
    }
    for (const int side : {0, 1})
      if (why.empty() && !taken_.insert({interval.edges[side], interval.pieces[side]}).second)
        why = why_not_sewn::intervalTaken(interval.edges[side]);
    if (!why.empty()) result_.refused[interval.seam] = why;
  }

  const std::vector<Seam>& seams_;
  double gap_mm_;
  std::map<int, EdgeSide> paths_;
  std::set<std::pair<int, int>> taken_;
  SewnIntervals result_;
};

}  // namespace

SewnIntervals sewnIntervals(const std::vector<Seam>& seams, const std::vector<std::size_t>& chosen,
                            double gap_mm) {
  return Cutter(seams, chosen, gap_mm).run();
}

}  // namespace seamwright::occ
