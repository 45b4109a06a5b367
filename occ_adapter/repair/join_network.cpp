// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BSplCLib.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <exception>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include <seamwright/core/join/network.hpp>
#include <seamwright/occ_adapter/analyze/workers.hpp>
#include <seamwright/occ_adapter/match/candidate.hpp>
#include <seamwright/occ_adapter/repair/groups.hpp>
#include <seamwright/occ_adapter/repair/solve.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;
using Surface = handle<Geom_BSplineSurface>;

/// A face of the network, its surface cut off where its natural sides end.
struct Member {
  TopoDS_Face face;
  Surface surface;
  int number = 0;
};

/// A side of a seam that is a natural side of its face.
struct NaturalUse {
  std::size_t seam = 0;
  int face = 0;
  MatchSide side;
};

/// Poles that points of the path depend on.
void fixBeside(const Pcurve& path, const Geom_BSplineSurface& surface, std::vector<bool>& fixed) {
  constexpr int points = 65;
  const auto firstPole = [](double at, int degree, const TColStd_Array1OfReal& flat) {
    int span = 0;
    double parameter = at;
    BSplCLib::LocateParameter(degree, flat, at, false, flat.Lower() + degree, flat.Upper() - degree, span,
                              parameter);
    return std::clamp(span, flat.Lower() + degree, flat.Upper() - degree - 1) - flat.Lower() - degree;
  };
  for (int k = 0; k < points; ++k) {
    const gp_Pnt2d uv = path.curve->Value(path.first + (path.last - path.first) * k / (points - 1));
    const int i = firstPole(uv.X(), surface.UDegree(), surface.UKnotSequence());
    const int j = firstPole(uv.Y(), surface.VDegree(), surface.VKnotSequence());
    for (int di = 0; di <= surface.UDegree(); ++di)
      for (int dj = 0; dj <= surface.VDegree(); ++dj)
        fixed[static_cast<std::size_t>((i + di) * surface.NbVPoles() + j + dj)] = true;
  }
}

/// A seam of the network.
struct JoinedSeam {
  std::size_t number = 0;
  std::array<NaturalUse, 2> uses;
};

/// Surfaces that hang together through seams, and these.
struct ConnectedPart {
  std::vector<int> members;
  std::vector<std::size_t> joined;  ///< seams
  std::vector<NetworkSurface> surfaces;
  std::vector<NetworkSeam> seams;
  NetworkResult result = {};
  std::exception_ptr error = {};

  void solve(const NetworkOptions& options) {
    try {
      result = nearestNetwork(surfaces, seams, options);
    } catch (...) {
      error = std::current_exception();
    }
  }
};

std::vector<ConnectedPart> connectedParts(const std::vector<NetworkSurface>& surfaces,
                                          const std::vector<NetworkSeam>& seams) {
  Groups groups(static_cast<int>(surfaces.size()));
  for (const NetworkSeam& seam : seams) groups.join(seam.surfaces[0], seam.surfaces[1]);
  std::map<int, ConnectedPart> parts;
  std::vector<int> numbers;
  for (int member = 0; member < groups.count(); ++member) {
    ConnectedPart& part = parts[groups.of(member)];
    numbers.push_back(static_cast<int>(part.members.size()));
    part.members.push_back(member);
    part.surfaces.push_back(surfaces[member]);
  }
  for (std::size_t k = 0; k < seams.size(); ++k) {
    ConnectedPart& part = parts.at(groups.of(seams[k].surfaces[0]));
    part.joined.push_back(k);
    part.seams.push_back(seams[k]);
    for (int& member : part.seams.back().surfaces) member = numbers[member];
  }
  std::vector<ConnectedPart> all;
  for (auto& [group, part] : parts) all.push_back(std::move(part));
  return all;
}

/// Each connected part by itself; of the result what is used here.
NetworkResult nearestNetworks(const std::vector<NetworkSurface>& surfaces,
                              const std::vector<NetworkSeam>& seams, const NetworkOptions& options,
                              int jobs) {
  std::vector<ConnectedPart> parts = connectedParts(surfaces, seams);
  runParallel(parts.size(), jobs, [&](std::size_t k) { parts[k].solve(options); }, {});
  NetworkResult all;
  all.surfaces.resize(surfaces.size());
  all.moves_mm.resize(surfaces.size());
  all.seams.resize(seams.size());
  for (ConnectedPart& part : parts) {
    if (part.error) std::rethrow_exception(part.error);
    all.iterations = std::max(all.iterations, part.result.iterations);
    for (std::size_t k = 0; k < part.members.size(); ++k) {
      all.surfaces[part.members[k]] = std::move(part.result.surfaces[k]);
      all.moves_mm[part.members[k]] = part.result.moves_mm[k];
    }
    for (std::size_t k = 0; k < part.joined.size(); ++k)
      all.seams[part.joined[k]] = std::move(part.result.seams[k]);
  }
  return all;
}

class Network {
 public:
  Network(const RepairTask& task, DearSeams* dear, const Progress& progress)
      : task_(task), dear_(dear), progress_(progress) {}

  RepairSolution run() {
    for (std::size_t i = 0; i < task_.treated.size(); ++i)
      if (task_.treated[i]) {
        if (const std::string why = add(i); !why.empty()) solution_.failures[i] = why;
      }
    if (seams_.empty()) return std::move(solution_);
    addCarried();
    if (progress_ && !progress_(0.2)) throw Cancelled();
    align();
    solve();
    return std::move(solution_);
  }

 private:
  /// \returns why the seam can't be a part of the network, or nothing.
  std::string add(std::size_t i) {
    if (task_.sharp[i]) return "it is sharp";
    const Seam& seam = task_.seams[i];
    std::array<NaturalUse, 2> uses;
    for (const int which : {0, 1}) {
      const FaceUse& use = seam.sides[which];
      FaceMatchOptions options;
      options.tolerance = task_.options.tolerance;
      options.match_mm = task_.options.match_mm;
      try {
        uses[which] = {i, use.face, matchSide(use.shape, use, options)};
      } catch (const std::runtime_error& error) {
        return error.what();
      }
      const MatchSide& side = uses[which].side;
      if (!side.isNatural()) return "face " + std::to_string(use.face) + " " + side.cannot_move;
      if (side.spline->IsURational() || side.spline->IsVRational())
        return "face " + std::to_string(use.face) + " is rational";
    }
    if (seam.kind == SeamKind::Matched) return "it is no edge that both faces share";
    for (const NaturalUse& use : uses) join(use);
    seams_.push_back({i, {uses[0], uses[1]}});
    taken_.insert(i);
    return {};
  }

  void join(const NaturalUse& use) {
    const auto [at, is_new] = members_.try_emplace(use.face);
    Member& member = at->second;
    if (is_new) {
      member.face = use.side.face;
      member.surface = Surface::DownCast(use.side.spline->Copy());
      return;
    }
    std::array<double, 4> own{}, other{};
    member.surface->Bounds(own[0], own[1], own[2], own[3]);
    use.side.spline->Bounds(other[0], other[1], other[2], other[3]);
    const std::array<double, 4> both = {std::max(own[0], other[0]), std::min(own[1], other[1]),
                                        std::max(own[2], other[2]), std::min(own[3], other[3])};
    if (both != own) member.surface->Segment(both[0], both[1], both[2], both[3]);
  }

  bool meetsTreated(const Seam& seam) const {
    for (const FaceUse& side : seam.sides)
      if (ends_.Contains(TopExp::FirstVertex(side.edge)) || ends_.Contains(TopExp::LastVertex(side.edge)))
        return true;
    return false;
  }

  /// Smooth seams that end where a treated one does stay smooth while they move.
  void addCarried() {
    for (const auto& seam : seams_)
      TopExp::MapShapes(task_.seams[seam.number].sides[0].edge, TopAbs_VERTEX, ends_);
    for (std::size_t i = 0; i < task_.seams.size(); ++i) {
      const bool smooth = task_.before[i].verdict.seam_class == SeamClass::Smooth;
      if (!task_.treated[i] && smooth && meetsTreated(task_.seams[i])) add(i);
    }
  }

  EdgeRows rowsOf(const NaturalUse& use) {
    return EdgeRows(members_.at(use.face).surface, use.side.edge, !use.side.with_edge);
  }

  /// Rows enough for the opposite sides to stay, then the same degrees and knots on both sides of all seams.
  void align() {
    const int order = task_.options.order;
    for (const JoinedSeam& seam : seams_)
      for (const NaturalUse& use : seam.uses) {
        EdgeRows rows = rowsOf(use);
        const bool is_one_span = rows.rows() == rows.degreeAcross() + 1;
        rows.raiseDegreeAcross(is_one_span ? 2 * order + 1 : order);
        rows.refineAcross(2 * order + 2);
      }
    for (bool changed = true; changed;) {
      changed = false;
      for (const JoinedSeam& seam : seams_) {
        EdgeRows a = rowsOf(seam.uses[0]), b = rowsOf(seam.uses[1]);
        const std::vector<double> knots_a = a.knotsAlong(), knots_b = b.knotsAlong();
        if (knots_a.size() == knots_b.size() && a.degreeAlong() == b.degreeAlong()) {
          double apart = 0;
          for (std::size_t k = 0; k < knots_a.size(); ++k)
            apart = std::max(apart, std::abs(knots_a[k] - knots_b[k]));
          if (apart == 0) continue;
        }
        const int before = a.columns() + b.columns();
        alignAlong(a, b);
        changed = changed || a.columns() + b.columns() != before;
      }
    }
  }

  bool moves(int face) const { return task_.faces[face].may_move; }

  std::vector<bool> fixedPoles(int number, const Member& member) const {
    const Geom_BSplineSurface& surface = *member.surface;
    std::vector<bool> fixed(static_cast<std::size_t>(surface.NbUPoles() * surface.NbVPoles()), false);
    for (std::size_t i = 0; i < task_.seams.size(); ++i) {
      if (taken_.count(i) > 0) continue;
      for (const FaceUse& use : task_.seams[i].sides)
        if (use.face == number)
          fixBeside(pcurveOf(use.edge, use.shape, task_.options.tolerance.gap_mm), surface, fixed);
    }
    return fixed;
  }

  void solve() {
    std::vector<NetworkSurface> surfaces;
    for (auto& [number, member] : members_) {
      member.number = static_cast<int>(surfaces.size());
      surfaces.push_back({coreSurface(*member.surface), moves(number), {}, fixedPoles(number, member)});
    }
    std::vector<NetworkSeam> seams;
    for (const JoinedSeam& seam : seams_) {
      NetworkSeam joined;
      for (const int which : {0, 1}) {
        joined.surfaces[which] = members_.at(seam.uses[which].face).number;
        joined.edges[which] = seam.uses[which].side.edge;
      }
      joined.reversed = seam.uses[0].side.with_edge != seam.uses[1].side.with_edge;
      const bool keep_curvature = !task_.treated[seam.number] &&
                                  task_.before[seam.number].verdict.level >= Level::G2 &&
                                  !anyCurvatureDoes(task_.options.tolerance);
      joined.order = keep_curvature ? 2 : task_.options.order;
      seams.push_back(joined);
    }
    // One step tells what is far from being near.
    constexpr double far = 2, surely_far = 5;
    constexpr NetworkOptions rough{.max_iterations = 1};
    const int jobs = task_.options.jobs;
    NetworkResult result = nearestNetworks(surfaces, seams, dear_ ? rough : NetworkOptions(), jobs);
    if (dear_) leaveDear(result, surely_far);
    if (!solution_.complete) return;
    if (dear_ && result.iterations == rough.max_iterations)
      result = nearestNetworks(surfaces, seams, {}, jobs);
    if (dear_) leaveDear(result, far);
    for (std::size_t k = 0; k < seams_.size(); ++k)
      if (result.seams[k].status == SeamStatus::Left && isTreated(k))
        solution_.failures[seams_[k].number] = result.seams[k].why;
    if (!solution_.complete) return;
    for (const auto& [number, member] : members_)
      if (result.moves_mm[member.number] > 0)
        solution_.changes.push_back({number,
                                     handle<Geom_Surface>(geomSurface(result.surfaces[member.number])),
                                     result.moves_mm[member.number]});
  }

  bool isTreated(std::size_t k) const { return task_.treated[seams_[k].number]; }

  /// What the defects of a seam amount to in moves of poles of the first two rows.
  double neededMove(const JoinedSeam& seam) {
    const SeamFigures& figures = task_.before[seam.number].figures;
    const double angle_rad = figures.angle_rad ? figures.angle_rad->lower : 0;
    double reach_mm = 0;
    for (const NaturalUse& use : seam.uses) {
      const EdgeRows rows = rowsOf(use);
      for (int c = 0; c < rows.columns(); ++c)
        reach_mm = std::max(reach_mm, (rows.pole(1, c) - rows.pole(0, c)).norm());
    }
    return std::max(figures.gap_mm ? figures.gap_mm->lower : 0, angle_rad * reach_mm);
  }

  /// All that is connected with a face that would move \p far times what the defects are.
  void leaveDear(const NetworkResult& result, double far) {
    Groups groups(static_cast<int>(members_.size()));
    for (const JoinedSeam& seam : seams_) groups.join(numberOf(seam, 0), numberOf(seam, 1));
    std::map<int, double> needed_mm, moved_mm;
    for (std::size_t k = 0; k < seams_.size(); ++k)
      if (double& needed = needed_mm[groups.of(numberOf(seams_[k], 0))]; isTreated(k))
        needed = std::max(needed, neededMove(seams_[k]));
    for (int member = 0; member < groups.count(); ++member)
      moved_mm[groups.of(member)] = std::max(moved_mm[groups.of(member)], result.moves_mm[member]);
    for (std::size_t k = 0; k < seams_.size(); ++k) {
      const int group = groups.of(numberOf(seams_[k], 0));
      if (!isTreated(k) || moved_mm[group] <= far * needed_mm[group]) continue;
      std::ostringstream why;
      why << "the exact join asks for a move of " << moved_mm[group] << " mm where the defects are of "
          << needed_mm[group] << " mm";
      solution_.failures[seams_[k].number] = why.str();
      solution_.complete = false;
      dear_->insert(seams_[k].number);
    }
  }

  int numberOf(const JoinedSeam& seam, int which) const { return members_.at(seam.uses[which].face).number; }

  const RepairTask& task_;
  DearSeams* dear_;
  const Progress& progress_;
  std::map<int, Member> members_;  ///< by face
  std::vector<JoinedSeam> seams_;
  std::set<std::size_t> taken_;
  TopTools_IndexedMapOfShape ends_;
  RepairSolution solution_;
};

}  // namespace

RepairSolution joinNetwork(const RepairTask& task, DearSeams* dear, const Progress& progress) {
  return Network(task, dear, progress).run();
}

}  // namespace seamwright::occ
