// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <GProp_GProps.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <numeric>
#include <set>
#include <sstream>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/convert/nearest.hpp>
#include <seamwright/occ_adapter/convert/spline_surface.hpp>
#include <seamwright/occ_adapter/match/least_moves.hpp>
#include <seamwright/occ_adapter/repair/displace.hpp>
#include <seamwright/core/surface/judge.hpp>
#include <seamwright/occ_adapter/repair/displacement.hpp>
#include <seamwright/occ_adapter/repair/face_change.hpp>
#include <seamwright/occ_adapter/repair/path_place.hpp>
#include <seamwright/occ_adapter/seams/match.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;

constexpr double no_limit = std::numeric_limits<double>::infinity();

handle<Geom_BSplineSurface> splineOfFace(const TopoDS_Face& face) {
  TopLoc_Location location;
  const handle<Geom_Surface> surface = BRep_Tool::Surface(face, location);
  const auto spline = handle<Geom_BSplineSurface>::DownCast(surface);
  const bool periodic = !spline.IsNull() && (spline->IsUPeriodic() || spline->IsVPeriodic());
  if (!periodic) return clampedSpline(surface, location);
  return handle<Geom_BSplineSurface>::DownCast(spline->Transformed(location.Transformation()));
}

/// A face that moves.
struct Mover {
  int face = 0;
  Displacement displacement;
  std::vector<int> unknown;  ///< by coefficient: its number, -1: it stays
  double budget_per_mm = 0;  ///< by how much its curvature may vary more
  double area_mm2 = 0;
};

enum class Ask {
  Join,    ///< the sides are to meet
  Keep,    ///< what they lack may not grow
  Outline  ///< one side, which keeps its place
};

/// A boundary shared by two sides, or an open one.
struct Joint {
  std::size_t seam = 0;
  Ask ask = Ask::Keep;
  int order = 1;  ///< 0: place, 1: tangent planes, 2: curvature
  std::vector<FaceUse> sides;
  std::vector<Pcurve> paths;
  Correspondence map;
  std::set<double> also;  ///< places that samples missed before
};

/// A side at a sample: a mover's shares, or what a face that stays shows.
struct SampleSide {
  Mover* mover = nullptr;
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  PoleShares shares;
  SidePoint shown;  ///< before any move
};

struct Differences {
  Eigen::Vector3d gap = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> normal;    ///< of the unit normals, aligned
  Eigen::Vector3d bend = Eigen::Vector3d::Zero();  ///< of the curvature tensors: TT, TC, CC
};

struct Sample {
  std::vector<SampleSide> sides;
  double s = 0;
  Differences given;  ///< of the surfaces as they were
  double part = 0;    ///< of the seam's length
  double weight = 1;  ///< grows where the sample is missed
  double ratio = 0;
};

struct Frame {
  Eigen::Vector3d normal, tangent, cross;
};

double linearIn(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const std::size_t i =
      std::clamp<std::size_t>(std::ranges::upper_bound(x, at) - x.begin(), 1, x.size() - 1);
  const double width = x[i] - x[i - 1];
  return width > 0 ? y[i - 1] + (at - x[i - 1]) / width * (y[i] - y[i - 1]) : y[i];
}

/// One connected set of movers.
class Displacing {
 public:
  Displacing(const RepairTask& task, std::vector<Joint> joints, std::map<int, Mover>& movers,
             const Progress& progress)
      : task_(task), joints_(std::move(joints)), movers_(movers), progress_(progress) {}

  /// By joint: what it misses over its tolerance.
  const std::vector<double>& run() {
    constexpr int most_refinements = 4;
    placeSamples();
    freeAll();
    if (debug) std::fprintf(stderr, "times assemble %.2f solve %.2f look %.2f energy %.2f place %.2f\n", assemble_s, solve_s, look_s, energy_s, place_s);
    for (int refinement = 0;; ++refinement) {
      solve();
      if (debug) std::fprintf(stderr, "  refinement %d: unknowns %d worst %g\n", refinement, unknowns_, worst());
      if (worst() <= enough || refinement == most_refinements || !refine()) break;
    }
    return ratios_;
  }

  double effortOf(std::size_t j) const { return effort(j); }

  std::string tell(std::size_t j) const {
    const Sample* worst = nullptr;
    for (const Sample& sample : samples_[j])
      if (worst == nullptr || sample.ratio > worst->ratio) worst = &sample;
    const Differences now = differences(joints_[j], *worst);
    std::ostringstream text;
    text << "s " << worst->s << " order " << joints_[j].order << " gap " << now.gap.norm() << " (" << worst->given.gap.norm() << ") angle "
         << (now.normal ? now.normal->norm() : -1) << " (" << (worst->given.normal ? worst->given.normal->norm() : -1) << ") weight " << worst->weight << " part " << worst->part;
    for (std::size_t k = 0; k < worst->sides.size(); ++k) {
      const SurfaceJet jet = jetAt(worst->sides[k]);
      text << " face " << joints_[j].sides[k].face << (worst->sides[k].mover ? " moves" : " stays") << " |u| " << jet.u.norm() << " |v| " << jet.v.norm() << " sin "
           << jet.u.cross(jet.v).norm() / (jet.u.norm() * jet.v.norm());
    }
    return text.str();
  }

 private:
  static inline double assemble_s = 0, solve_s = 0, place_s = 0, energy_s = 0, look_s = 0;
  static inline const bool debug = std::getenv("SW_DEBUG") != nullptr;
  static constexpr double enough = 0.6;

  Mover* moverOf(int face) {
    const auto found = movers_.find(face);
    return found == movers_.end() ? nullptr : &found->second;
  }

  static std::vector<double> mirrored(const std::vector<double>& s) {
    std::vector<double> turned;
    for (auto at = s.rbegin(); at != s.rend(); ++at) turned.push_back(1 - *at);
    return turned;
  }

  static double seamParameter(const Joint& joint, std::size_t side, double place) {
    if (joint.map.s.empty()) return place;
    const std::vector<double>& places = side == 0 ? joint.map.a : joint.map.b;
    if (places.front() < places.back()) return linearIn(places, joint.map.s, place);
    return 1 - linearIn({places.rbegin(), places.rend()}, mirrored(joint.map.s), place);
  }

  /// Even in the spans of the movers' surfaces that are crossed, with both ends.
  std::vector<double> sampleParameters(const Joint& joint) {
    constexpr double per_pole = 2;
    constexpr int least = 24, most = 400;
    std::vector<double> best;
    for (std::size_t side = 0; side < joint.sides.size(); ++side) {
      Mover* const mover = moverOf(joint.sides[side].face);
      if (mover == nullptr) continue;
      FollowPath path;
      path.path = joint.paths[side];
      const PlanePath plane(path);
      const SurfaceBasis& basis = mover->displacement.givenBasis();
      const Eigen::Vector2d poles(std::max(1.0, polesPerSpan(basis.u())), std::max(1.0, polesPerSpan(basis.v())));
      const SpanMeasure measure(plane, basis, mover->displacement.givenSurface(), poles);
      const int count = std::clamp(static_cast<int>(std::ceil(per_pole * measure.crossed())), least, most);
      if (count < static_cast<int>(best.size())) continue;
      best.clear();
      for (int k = 0; k <= count; ++k)
        best.push_back(std::clamp(seamParameter(joint, side, measure.at(static_cast<double>(k) / count)), 0.0, 1.0));
    }
    best.push_back(0);
    best.push_back(1);
    const double near = 0.25 / static_cast<double>(best.size());
    for (const double s : joint.also)
      for (const double beside : {-near, -near / 3, 0.0, near / 3, near})
        if (s + beside >= 0 && s + beside <= 1) best.push_back(s + beside);
    std::ranges::sort(best);
    best.erase(std::unique(best.begin(), best.end(), [](double a, double b) { return b - a < 1e-9; }), best.end());
    return best;
  }

  void placeSamples() {
    const auto t5 = std::chrono::steady_clock::now();
    const std::vector<std::vector<Sample>> before = std::move(samples_);
    samples_.assign(joints_.size(), {});
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      const Joint& joint = joints_[j];
      std::vector<std::unique_ptr<FaceStrip>> strips;
      for (std::size_t side = 0; side < joint.sides.size(); ++side)
        strips.push_back(std::make_unique<FaceStrip>(joint.sides[side], joint.paths[side]));
      for (const double s : sampleParameters(joint)) samples_[j].push_back(sampleAt(joint, strips, s));
      std::vector<Sample>& samples = samples_[j];
      double length = 0;
      for (std::size_t k = 1; k < samples.size(); ++k) {
        const double chord = (samples[k].sides[0].shown.jet.p - samples[k - 1].sides[0].shown.jet.p).norm();
        samples[k].part += chord / 2;
        samples[k - 1].part += chord / 2;
        length += chord;
      }
      for (Sample& sample : samples) {
        sample.part = length > 0 ? sample.part / length : 1.0 / static_cast<double>(samples.size());
        if (joint.ask != Ask::Join) sample.given = differences(joint, sample, true);
      }
      if (j < before.size()) inheritWeights(before[j], samples);
    }
    place_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - t5).count();
  }

  static void inheritWeights(const std::vector<Sample>& from, std::vector<Sample>& to) {
    if (from.empty()) return;
    for (Sample& sample : to) {
      const auto nearest = std::ranges::min_element(from, {}, [&](const Sample& other) { return std::abs(other.s - sample.s); });
      sample.weight = nearest->weight;
    }
  }

  Sample sampleAt(const Joint& joint, const std::vector<std::unique_ptr<FaceStrip>>& strips, double s) {
    Sample made;
    made.s = s;
    for (std::size_t side = 0; side < joint.sides.size(); ++side) {
      double place = s;
      if (!joint.map.s.empty()) {
        place = linearIn(joint.map.s, side == 0 ? joint.map.a : joint.map.b, s);
        if (side == 1) {
          const auto [low, high] = std::minmax(joint.map.b.front(), joint.map.b.back());
          place = nearestPlace(*strips[1], strips[0]->trace(linearIn(joint.map.s, joint.map.a, s)).p, place, low, high);
        }
      }
      SampleSide& made_side = made.sides.emplace_back();
      made_side.mover = moverOf(joint.sides[side].face);
      made_side.shown = strips[side]->at(place);
      if (made_side.mover == nullptr) continue;
      const Pcurve& path = joint.paths[side];
      gp_Pnt2d p;
      gp_Vec2d d;
      path.curve->D1(path.first + place * (path.last - path.first), p, d);
      Eigen::Vector2d left(-d.Y(), d.X());
      if (joint.sides[side].edge.Orientation() != TopAbs_FORWARD) left = -left;
      const Displacement& displacement = made_side.mover->displacement;
      made_side.uv = {p.X(), p.Y()};
      made_side.shares = displacement.shares(made_side.uv, left);
      made_side.shown.jet = displacement.given(made_side.uv, left);
    }
    return made;
  }

  static SurfaceJet jetAt(const SampleSide& side, bool as_given = false) {
    return side.mover == nullptr || as_given ? side.shown.jet
                                             : side.mover->displacement.moved(side.shown.jet, side.shares);
  }

  static std::optional<Eigen::Vector3d> normalAt(const SampleSide& side, const SurfaceJet& jet) {
    return unitNormal(jet, side.mover == nullptr ? side.shown.noise : side.mover->displacement.noise(jet));
  }

  static Frame frameOf(const Sample& sample, const Eigen::Vector3d& normal) {
    Eigen::Vector3d tangent = sample.sides[0].shown.tangent;
    tangent -= normal.dot(tangent) * normal;
    if (!(tangent.norm() > 0)) tangent = normal.unitOrthogonal();
    tangent.normalize();
    return {normal, tangent, normal.cross(tangent)};
  }

  static Differences differences(const Joint& joint, const Sample& sample, bool as_given = false) {
    Differences found;
    const SurfaceJet a = jetAt(sample.sides[0], as_given);
    if (sample.sides.size() == 1) {
      found.gap = a.p - sample.sides[0].shown.jet.p;
      return found;
    }
    const SurfaceJet b = jetAt(sample.sides[1], as_given);
    found.gap = a.p - b.p;
    if (joint.order < 1) return found;
    const auto na = normalAt(sample.sides[0], a);
    auto nb = normalAt(sample.sides[1], b);
    if (!na || !nb) return found;
    if (na->dot(*nb) < 0) *nb = -*nb;
    found.normal = *na - *nb;
    if (joint.order < 2) return found;
    const Frame frame = frameOf(sample, (*na + *nb).normalized());
    const Eigen::Matrix3d difference = curvatureTensor(a, *na) - curvatureTensor(b, *nb);
    found.bend = {frame.tangent.dot(difference * frame.tangent), frame.tangent.dot(difference * frame.cross),
                  frame.cross.dot(difference * frame.cross)};
    return found;
  }

  double curvatureLimit(const Sample& sample) const {
    const SurfaceJet jet = jetAt(sample.sides[0]);
    const auto normal = normalAt(sample.sides[0], jet);
    const double flat = 1 / task_.options.tolerance.flat_radius_mm;
    const double norm = normal ? curvatureTensor(jet, *normal).norm() : 0;
    return norm < flat ? flat : task_.options.tolerance.curvature_rel * norm;
  }

  /// The sum of factor times unknown.
  struct Row {
    std::vector<int> unknowns;
    std::vector<double> factors;
    Eigen::Vector3d now = Eigen::Vector3d::Zero();  ///< its value

    void add(int unknown, double factor) {
      const auto found = std::ranges::find(unknowns, unknown);
      if (found == unknowns.end()) {
        unknowns.push_back(unknown);
        factors.push_back(factor);
      } else {
        factors[found - unknowns.begin()] += factor;
      }
    }
    void add(const SampleSide& side, const Eigen::RowVectorXd& shares, double sign) {
      if (side.mover == nullptr) return;
      for (std::size_t k = 0; k < side.shares.poles.size(); ++k) {
        const double factor = sign * shares[static_cast<Eigen::Index>(k)];
        const int unknown = side.mover->unknown[side.shares.poles[k]];
        if (unknown < 0) continue;
        add(unknown, factor);
        now += factor * side.mover->displacement.coefficients().row(side.shares.poles[k]).transpose();
      }
    }
    Eigen::RowVectorXd weighted(double weight) const {
      return weight * Eigen::Map<const Eigen::RowVectorXd>(factors.data(), static_cast<Eigen::Index>(factors.size()));
    }
  };

  /// As if each seam had so many samples.
  static double weightOf(const Sample& sample) {
    constexpr double samples_per_seam = 16;
    return sample.weight * std::sqrt(samples_per_seam * sample.part) / share_;
  }

  void addSample(const Joint& joint, const Sample& sample, LeastMoves& system) const {
    const ContinuityTolerance& tolerance = task_.options.tolerance;
    const Differences now = differences(joint, sample);
    Row place;
    for (std::size_t k = 0; k < sample.sides.size(); ++k)
      if (sample.sides[k].mover != nullptr)
        place.add(sample.sides[k], sample.sides[k].shares.share.row(0), k == 0 ? 1 : -1);
    if (place.unknowns.empty()) return;
    const double gap_weight = weightOf(sample) / tolerance.gap_mm;
    system.addPoint(place.unknowns, place.weighted(gap_weight), gap_weight * (place.now - now.gap + sample.given.gap));
    if (joint.order < 1 || sample.sides.size() < 2) return keepNormals(sample, system);
    if (!now.normal) return;
    const SurfaceJet a = jetAt(sample.sides[0]), b = jetAt(sample.sides[1]);
    const Eigen::Vector3d na = *normalAt(sample.sides[0], a);
    const Frame frame = frameOf(sample, (na - 0.5 * *now.normal).normalized());
    const std::array<Eigen::Vector3d, 2> ways = {frame.tangent, frame.cross};
    const Eigen::Vector3d left = *now.normal - sample.given.normal.value_or(Eigen::Vector3d::Zero());
    const std::array<const SurfaceJet*, 2> jets = {&a, &b};
    const double angle_weight = weightOf(sample) / tolerance.angle_rad;
    for (const Eigen::Vector3d& way : ways) {
      Row row;
      for (const int k : {0, 1})
        if (const SampleSide& side = sample.sides[k]; side.mover != nullptr)
          row.add(side, derivative(side.shares, parameterStep(*jets[k], way)), k == 0 ? -1 : 1);
      if (row.unknowns.empty()) continue;
      system.add(row.unknowns, row.weighted(angle_weight), frame.normal,
                 Eigen::VectorXd::Constant(1, angle_weight * (frame.normal.dot(row.now) - way.dot(left))));
    }
    if (joint.order < 2) return;
    const double bend_weight = weightOf(sample) / curvatureLimit(sample);
    const Eigen::Vector3d bend = now.bend - sample.given.bend;
    constexpr std::array<std::array<int, 2>, 3> pairs = {{{0, 0}, {0, 1}, {1, 1}}};
    for (int m = 0; m < 3; ++m) {
      Row row;
      for (const int k : {0, 1}) {
        const SampleSide& side = sample.sides[k];
        if (side.mover == nullptr) continue;
        const SurfaceJet& jet = *jets[k];
        const Eigen::Vector2d x = parameterStep(jet, ways[pairs[m][0]]), y = parameterStep(jet, ways[pairs[m][1]]);
        const Eigen::Vector3d second =
            x[0] * y[0] * jet.uu + (x[0] * y[1] + x[1] * y[0]) * jet.uv + x[1] * y[1] * jet.vv;
        row.add(side, secondDerivative(side.shares, x, y) - derivative(side.shares, parameterStep(jet, second)), k == 0 ? 1 : -1);
      }
      system.add(row.unknowns, row.weighted(bend_weight), frame.normal,
                 Eigen::VectorXd::Constant(1, bend_weight * (frame.normal.dot(row.now) - bend[m])));
    }
  }

  /// Beside a crease, and at an outline.
  void keepNormals(const Sample& sample, LeastMoves& system) const {
    const double weight = 0.1 * weightOf(sample) / task_.options.tolerance.angle_rad;
    for (const SampleSide& side : sample.sides) {
      if (side.mover == nullptr) continue;
      const auto normal = normalAt(side, side.shown.jet);
      if (!normal || sample.sides.size() < 2) continue;
      const Frame frame = frameOf(sample, *normal);
      Row row;
      row.add(side, derivative(side.shares, parameterStep(side.shown.jet, frame.cross)), 1);
      if (row.unknowns.empty()) continue;
      const SurfaceJet by = jetOf(side.shares, side.mover->displacement.coefficients());
      const Eigen::Vector2d step = parameterStep(side.shown.jet, frame.cross);
      const double now = frame.normal.dot(step[0] * by.u + step[1] * by.v);
      system.add(row.unknowns, row.weighted(weight), frame.normal, Eigen::VectorXd::Constant(1, weight * (frame.normal.dot(row.now) - now)));
    }
  }

  void solve() {
    constexpr int most_passes = 10;
    constexpr double most_growth = 5, most_weight = 1e5;
    static const double fairness = std::getenv("SW_K") ? std::atof(std::getenv("SW_K")) : 300;
    std::optional<std::map<int, PointRows>> best;
    double best_ratio = no_limit, last = no_limit;
    int idle = 0;
    const auto t4 = std::chrono::steady_clock::now();
    const std::vector<SoftRow> energy = energyRows();
    energy_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - t4).count();
    for (int pass = 0; pass < most_passes; ++pass) {
      if (progress_ && !progress_(0)) throw Cancelled();
      const auto t0 = std::chrono::steady_clock::now();
      LeastMoves system = assemble(energy);
      const auto t1 = std::chrono::steady_clock::now();
      const PointRows coefficients = system.solve(0, fairness);
      const auto t2 = std::chrono::steady_clock::now();
      assemble_s += std::chrono::duration<double>(t1 - t0).count();
      solve_s += std::chrono::duration<double>(t2 - t1).count();
      for (auto& [face, mover] : movers_) {
        PointRows own = mover.displacement.coefficients();
        for (std::size_t k = 0; k < mover.unknown.size(); ++k)
          if (mover.unknown[k] >= 0) own.row(static_cast<Eigen::Index>(k)) = coefficients.row(mover.unknown[k]);
        mover.displacement.setCoefficients(std::move(own));
      }
      const auto t3 = std::chrono::steady_clock::now();
      look();
      look_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - t3).count();
      if (debug) std::fprintf(stderr, "    pass %d ratio %g\n", pass, worst());
      if (pass > 0 && worst() < best_ratio) {
        best_ratio = worst();
        best.emplace();
        for (auto& [face, mover] : movers_) (*best)[face] = mover.displacement.coefficients();
      }
      if (pass > 0 && worst() <= enough) return;
      if (worst() > 4 * best_ratio) break;
      idle = pass > 1 && worst() > 0.7 * last ? idle + 1 : 0;
      last = worst();
      if (idle >= (worst() > 3 ? 1 : 4)) break;
      if (pass > 0)
        for (auto& samples : samples_)
          for (Sample& sample : samples)
            if (sample.ratio > enough) sample.weight = std::min(most_weight, sample.weight * std::min(most_growth, sample.ratio / (0.7 * enough)));
    }
    if (!best) return;
    for (auto& [face, mover] : movers_) mover.displacement.setCoefficients((*best)[face]);
    look();
  }

  /// A term of the energy and what the coefficients that stay give to it.
  struct SoftRow {
    std::vector<int> unknowns;
    Eigen::RowVectorXd factors;
    Eigen::Vector3d rest;
  };

  std::vector<SoftRow> energyRows() const {
    std::vector<SoftRow> rows;
    for (const auto& [face, mover] : movers_) {
      const double unit = 1 / (mover.budget_per_mm * std::sqrt(mover.area_mm2));
      for (const EnergyRow& row : mover.displacement.bending()) {
        Row merged;
        Eigen::Vector3d rest = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < row.coefficients.size(); ++k) {
          const int coefficient = row.coefficients[k];
          const double factor = unit * row.factors[static_cast<Eigen::Index>(k)];
          if (mover.unknown[coefficient] >= 0)
            merged.add(mover.unknown[coefficient], factor);
          else
            rest += factor * mover.displacement.coefficients().row(coefficient).transpose();
        }
        if (!merged.unknowns.empty()) rows.push_back({merged.unknowns, merged.weighted(1), rest});
      }
      // The integral of |D|^2 / size^4, as if coefficients were spread evenly.
      const double rest = unit / (mover.displacement.size_mm() * std::sqrt(static_cast<double>(mover.displacement.count())));
      for (const int unknown : mover.unknown)
        if (unknown >= 0) rows.push_back({{unknown}, Eigen::RowVectorXd::Constant(1, rest), Eigen::Vector3d::Zero()});
    }
    return rows;
  }

  LeastMoves assemble(const std::vector<SoftRow>& energy) const {
    LeastMoves system(unknowns_);
    for (std::size_t j = 0; j < joints_.size(); ++j)
      for (const Sample& sample : samples_[j]) addSample(joints_[j], sample, system);
    for (const SoftRow& row : energy) system.addSoft(row.unknowns, row.factors, -row.rest);
    return system;
  }

  double ratioAt(const Joint& joint, const Sample& sample) const {
    if (joint.ask == Ask::Outline) return 0;
    const ContinuityTolerance& tolerance = task_.options.tolerance;
    const Differences now = differences(joint, sample);
    const double given_gap = std::min(joint.ask == Ask::Join ? 0.0 : sample.given.gap.norm(), 1e6);
    double ratio = joint.ask == Ask::Join ? now.gap.norm() / tolerance.gap_mm : std::max(0.0, now.gap.norm() - std::max(given_gap, 0.5 * tolerance.gap_mm)) / (0.2 * tolerance.gap_mm);
    if (now.normal && joint.order > 0) {
      const double given = sample.given.normal ? sample.given.normal->norm() : 0;
      ratio = std::max(ratio, joint.ask == Ask::Join ? now.normal->norm() / tolerance.angle_rad : (now.normal->norm() - std::max(given, 0.5 * tolerance.angle_rad)) / (0.2 * tolerance.angle_rad));
      if (joint.order > 1)
        ratio = std::max(ratio, (now.bend - sample.given.bend).cwiseAbs().maxCoeff() / curvatureLimit(sample));
    }
    return ratio;
  }

  void look() {
    ratios_.assign(joints_.size(), 0);
    for (std::size_t j = 0; j < joints_.size(); ++j)
      for (Sample& sample : samples_[j]) {
        sample.ratio = ratioAt(joints_[j], sample);
        ratios_[j] = std::max(ratios_[j], sample.ratio);
      }
  }

  double effort(std::size_t j) const {
    double most = 1;
    for (const Sample& sample : samples_[j]) most = std::max(most, sample.weight);
    return most;
  }

  double worst() const { return ratios_.empty() ? 0 : std::ranges::max(ratios_); }

  /// Halves spans beside samples that are missed. \returns whether any was.
  bool refine() {
    constexpr int most_unknowns = 1500;
    constexpr double shortest = 1.0 / 128;
    std::map<int, std::array<std::set<int>, 2>> spans;
    for (const std::vector<Sample>& samples : samples_)
      for (const Sample& sample : samples) {
        if (sample.ratio <= enough) continue;
        for (const SampleSide& side : sample.sides) {
          if (side.mover == nullptr) continue;
          const SurfaceBasis& basis = side.mover->displacement.basis();
          const std::array<const SplineAxis*, 2> axes = {&basis.u(), &basis.v()};
          for (const int k : {0, 1}) {
            double t = side.uv[k];
            const int span = axes[k]->span(t, 0);
            if (axes[k]->length(span) > shortest * (axes[k]->last - axes[k]->first)) spans[side.mover->face][k].insert(span);
          }
        }
      }
    bool any = false;
    for (auto& [face, halves] : spans) {
      Displacement& displacement = movers_.at(face).displacement;
      const auto total = (displacement.basis().u().poles + halves[0].size()) * (displacement.basis().v().poles + halves[1].size());
      if (total <= most_unknowns && displacement.halve(halves)) any = true;
    }
    if (!any) return false;
    placeSamples();
    look();
    freeNearMissed();
    return true;
  }

  void freeAll() {
    unknowns_ = 0;
    for (auto& [face, mover] : movers_) {
      mover.unknown.resize(static_cast<std::size_t>(mover.displacement.count()));
      for (int& unknown : mover.unknown) unknown = unknowns_++;
    }
  }

  /// What is far from all that is missed was found with fewer knots.
  void freeNearMissed() {
    for (auto& [face, mover] : movers_) mover.unknown.assign(static_cast<std::size_t>(mover.displacement.count()), -1);
    for (const std::vector<Sample>& samples : samples_)
      for (const Sample& sample : samples)
        if (sample.ratio > enough)
          for (const SampleSide& side : sample.sides)
            if (side.mover != nullptr)
              for (const int coefficient : side.mover->displacement.coefficientsNear(side.uv)) side.mover->unknown[coefficient] = 0;
    unknowns_ = 0;
    for (auto& [face, mover] : movers_)
      for (int& unknown : mover.unknown)
        if (unknown == 0) unknown = unknowns_++;
  }

  static constexpr double share_ = 0.25;
  const RepairTask& task_;
  std::vector<Joint> joints_;
  std::map<int, Mover>& movers_;
  const Progress& progress_;
  int unknowns_ = 0;
  std::vector<std::vector<Sample>> samples_;
  std::vector<double> ratios_;
};

int orderKept(const SeamResult& seam, const ContinuityTolerance& tolerance) {
  if (seam.verdict.seam_class == SeamClass::Crease) return 0;
  return seam.verdict.level >= Level::G2 && !anyCurvatureDoes(tolerance) ? 2 : 1;
}

}  // namespace

FairSolution displaceFaces(const RepairTask& task, const MissedPlaces& missed, SolvedComponents& known, const Progress& progress) {
  FairSolution all;
  const bool keeps_curvature = std::getenv("SW_KEEP2") != nullptr;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(task.shape, TopAbs_FACE, faces);
  std::set<int> moving;
  for (std::size_t i = 0; i < task.seams.size(); ++i)
    if (task.treated[i])
      for (const FaceUse& side : task.seams[i].sides)
        if (task.faces[side.face].may_move) moving.insert(side.face);
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < task.seams.size(); ++i) {
    const Seam& seam = task.seams[i];
    if (moving.count(seam.sides[0].face) == 0 && moving.count(seam.sides[1].face) == 0) continue;
    Joint joint;
    joint.seam = i;
    joint.ask = task.treated[i] ? Ask::Join : Ask::Keep;
    joint.order = task.treated[i] ? (task.sharp[i] ? 0 : task.options.order)
                                  : orderKept(task.before[i], task.options.tolerance);
    if (!task.treated[i] && !keeps_curvature) joint.order = std::min(joint.order, 1);
    if (!task.treated[i] && task.before[i].verdict.seam_class == SeamClass::Defect &&
        !(task.before[i].figures.angle_rad && task.before[i].figures.angle_rad->lower < task.options.tolerance.crease_rad))
      joint.order = 0;
    for (const FaceUse& side : seam.sides) {
      joint.sides.push_back(side);
      joint.paths.push_back(pcurveOf(side.edge, side.shape, task.options.tolerance.gap_mm));
    }
    joint.map = seam.correspondence;
    if (const auto places = missed.find(i); places != missed.end()) joint.also = places->second;
    joints.push_back(std::move(joint));
  }
  for (const FaceUse& use : findSeams(task.shape).open_uses) {
    if (moving.count(use.face) == 0) continue;
    Joint joint;
    joint.ask = Ask::Outline;
    joint.order = 0;
    joint.sides.push_back(use);
    joint.paths.push_back(pcurveOf(use.edge, use.shape, task.options.tolerance.gap_mm));
    joints.push_back(std::move(joint));
  }
  const auto moverFor = [&](int face) {
    const TopoDS_Face& shape = TopoDS::Face(faces(face));
    std::array<double, 4> range{};
    BRepTools::UVBounds(shape, range[0], range[1], range[2], range[3]);
    constexpr int spans = 4;
    Mover mover{face, Displacement(splineOfFace(shape), range, spans, task.options.tolerance.gap_mm / 100), {}, 0, 0};
    const double visible = visibleVariation(task.options.tolerance, mover.displacement.size_mm());
    const SurfaceChange still = measureChange(shape, splineOfFace(shape), 0, visible, {.lines = 16});
    mover.budget_per_mm = 0.5 * still.before.variation_per_mm + visible;
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(shape, properties);
    mover.area_mm2 = properties.Mass();
    return mover;
  };
  // Movers that seams connect.
  std::map<int, int> group;
  for (const int face : moving) group[face] = face;
  const auto leader = [&group](int face) {
    while (group[face] != face) face = group[face];
    return face;
  };
  for (const Joint& joint : joints)
    if (joint.sides.size() == 2 && moving.count(joint.sides[0].face) > 0 && moving.count(joint.sides[1].face) > 0)
      group[leader(joint.sides[0].face)] = leader(joint.sides[1].face);
  std::map<int, std::vector<Joint>> joints_of;
  for (Joint& joint : joints)
    for (const FaceUse& side : joint.sides)
      if (moving.count(side.face) > 0) {
        joints_of[leader(side.face)].push_back(std::move(joint));
        break;
      }
  for (auto& [first, members] : joints_of) {
    std::ostringstream key;
    key.precision(17);
    for (const int face : moving)
      if (leader(face) == first) key << face << ' ';
    for (const Joint& joint : members) {
      key << joint.seam << ':' << static_cast<int>(joint.ask) << joint.order;
      for (const double s : joint.also) key << '@' << s;
      key << ' ';
    }
    auto found = known.find(key.str());
    if (found == known.end()) {
      FairSolution own_solution;
      RepairSolution& solution = own_solution.solution;
      std::map<int, Mover> own;
      for (const int face : moving)
        if (leader(face) == first) own.emplace(face, moverFor(face));
      const std::vector<Joint> kept = members;
      Displacing displacement(task, std::move(members), own, progress);
      const std::vector<double>& ratios = displacement.run();
      for (std::size_t j = 0; j < kept.size(); ++j) {
        if (std::getenv("SW_DEBUG") && ratios[j] > 0.61)
          std::fprintf(stderr, "  edge %d ask %d ratio %g %s\n", task.before[kept[j].seam].edges.front(), int(kept[j].ask), ratios[j], displacement.tell(j).c_str());
        if (kept[j].ask != Ask::Join) continue;
        own_solution.effort[kept[j].seam] = displacement.effortOf(j);
        if (ratios[j] <= 1) continue;
        std::ostringstream text;
        text << "what moves fairly leaves " << ratios[j] << " times the tolerance";
        solution.failures[kept[j].seam] = text.str();
      }
      for (auto& [face, mover] : own)
        if (mover.displacement.coefficients().cwiseAbs().maxCoeff() > 0)
          solution.changes.push_back({face, handle<Geom_Surface>(mover.displacement.surface()), mover.displacement.largestMove_mm()});
      found = known.emplace(key.str(), std::move(own_solution)).first;
    }
    const FairSolution& one = found->second;
    all.effort.insert(one.effort.begin(), one.effort.end());
    all.solution.failures.insert(one.solution.failures.begin(), one.solution.failures.end());
    all.solution.changes.insert(all.solution.changes.end(), one.solution.changes.begin(), one.solution.changes.end());
  }
  all.solution.complete = all.solution.failures.empty();
  return all;
}

}  // namespace seamwright::occ
