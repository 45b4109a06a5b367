// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include <seamwright/occ_adapter/convert/nearest.hpp>
#include <seamwright/occ_adapter/convert/seam_strips.hpp>
#include <seamwright/occ_adapter/match/follow.hpp>
#include <seamwright/occ_adapter/repair/end_blends.hpp>
#include <seamwright/occ_adapter/repair/path_place.hpp>
#include <seamwright/occ_adapter/repair/seam_target.hpp>

namespace seamwright::occ {

namespace {

/// Of s, over which derivatives are taken as differences.
constexpr double difference_step = 1e-4;
/// Of s, from a pole on: nearer, its normals and curvatures are mostly rounding and what the pole is not smooth by.
constexpr double pole_stretch = 0.02;
/// Of s, of a lead: it ends in the middle of the seam.
constexpr double largest_span = 1.0 / 6;

Eigen::Matrix3d inPlane(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& normal) {
  const Eigen::Matrix3d onto = Eigen::Matrix3d::Identity() - normal * normal.transpose();
  return onto * tensor * onto;
}

/// The vector along a direction; nothing of it where a path stands still and has none.
Eigen::Vector3d partAlong(const Eigen::Vector3d& vector, const Eigen::Vector3d& direction) {
  const double squared = direction.squaredNorm();
  if (squared == 0) return Eigen::Vector3d::Zero();
  return vector.dot(direction) / squared * direction;
}

Eigen::Vector3d orthogonal(const Eigen::Vector3d& normal, const Eigen::Vector3d& tangent) {
  return (normal - partAlong(normal, tangent)).normalized();
}

/// The part of a vector that lies in the span of up to two unit normals.
Eigen::Vector3d alongNormals(const Eigen::Vector3d& vector, const std::vector<Eigen::Vector3d>& normals) {
  if (normals.empty()) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d first = vector.dot(normals[0]) * normals[0];
  if (normals.size() == 1) return first;
  const Eigen::Vector3d other = normals[1] - normals[0].dot(normals[1]) * normals[0];
  constexpr double parallel = 1e-3;
  return other.norm() < parallel ? first : first + vector.dot(other) / other.squaredNorm() * other;
}

TargetPoint turned(TargetPoint target, const Eigen::Vector3d& normal) {
  if (target.normal.dot(normal) >= 0) return target;
  return {target.point, -target.normal, -target.curvature};
}

/// y at x, linear between points of which the x increase or decrease.
double linear(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  const bool rises = xs.back() >= xs.front();
  std::size_t i = 1;
  while (i + 1 < xs.size() && (rises ? xs[i] < x : xs[i] > x)) ++i;
  const double width = xs[i] - xs[i - 1];
  return ys[i - 1] + (width == 0 ? 0 : (x - xs[i - 1]) / width) * (ys[i] - ys[i - 1]);
}

/// The derivative at s of a function on [0, 1], by differences.
template <class Function>
auto derivative(const Function& function, double s) {
  constexpr double h = difference_step;
  if (s < h) return Eigen::Vector3d((4 * function(s + h) - 3 * function(s) - function(s + 2 * h)) / (2 * h));
  if (s > 1 - h)
    return Eigen::Vector3d((3 * function(s) - 4 * function(s - h) + function(s - 2 * h)) / (2 * h));
  return Eigen::Vector3d((function(s + h) - function(s - h)) / (2 * h));
}

}  // namespace

SeamTarget::SeamTarget(const Seam& seam, const std::array<Pcurve, 2>& pcurves,
                       const std::array<bool, 2>& stays, int order, LeadReach reach)
    : seam_(seam),
      pcurves_(pcurves),
      stays_(stays),
      order_(order),
      reach_(reach),
      strips_{FaceStrip(seam.sides[0], pcurves[0]), FaceStrip(seam.sides[1], pcurves[1])} {
  double agreement = 0;
  for (const double s : {0.2, 0.5, 0.8})
    agreement += view(0, s, 1).shown.normal.dot(view(1, s, 1).shown.normal);
  if (agreement < 0) second_sign_ = -1;
  for (const int side : {0, 1})
    for (const int end : {0, 1}) {
      const SidePoint point = strips_[side].at(place(side, end));
      const bool has_normal = degeneracy(point.jet, point.noise) == Degeneracy::None;
      double& length = pole_reach_.at(side).at(end);
      if (seam.correspondence.s.empty()) length = strips_[side].poleReach(end);
      if (!has_normal) length = std::max(length, difference_step);
    }
}

SeamTarget SeamTarget::renewed() const {
  SeamTarget target(seam_, pcurves_, stays_, order_, reach_);
  target.leads_ = leads_;
  return target;
}

double SeamTarget::placeOnSecond(double s) const {
  const Correspondence& map = seam_.correspondence;
  const auto [low, high] = std::minmax(map.b.front(), map.b.back());
  const Eigen::Vector3d on_first = strips_[0].trace(placeOnFirst(map, s)).p;
  return nearestPlace(strips_[1], on_first, linear(map.s, map.b, s), low, high);
}

double SeamTarget::place(int side, double s) const {
  if (seam_.correspondence.s.empty()) return s;
  return side == 0 ? placeOnFirst(seam_.correspondence, s) : placeOnSecond(s);
}

double SeamTarget::seamParameter(int side, double place) const {
  const Correspondence& map = seam_.correspondence;
  if (map.s.empty()) return place;
  if (side == 0) return linear(map.a, map.s, place);
  double s = std::clamp(linear(map.b, map.s, place), 0.0, 1.0);
  const Eigen::Vector3d own = strips_[1].trace(place).p;
  constexpr int steps = 4;
  for (int k = 0; k < steps; ++k) {
    const Mean there = led(s, 1);
    const double step = (there.point - own).dot(there.slope) / there.slope.squaredNorm();
    if (!std::isfinite(step)) break;  // the seam stands still
    s = std::clamp(s - step, 0.0, 1.0);
  }
  return s;
}

SeamTarget::View SeamTarget::view(int side, double s, int order) const {
  for (const int end : {0, 1}) {
    const double distance = end == 0 ? s : 1 - s;
    if (isPole(side, end) && distance < pole_stretch) return nearPole(side, end, distance, order);
  }
  return regular(side, s, order);
}

SeamTarget::View SeamTarget::nearPole(int side, int end, double distance, int order) const {
  const auto at = [end](double from_end) { return end == 0 ? from_end : 1 - from_end; };
  const Eigen::Vector3d far = regular(side, at(2 * pole_stretch), 1).shown.normal;
  TargetPoint target = regular(side, at(pole_stretch), order).shown;
  const PathPoint here = strips_[side].trace(place(side, at(distance)));
  target.point = here.p;
  target.normal += (1 - distance / pole_stretch) * (target.normal - far);
  target.normal.normalize();
  target.curvature = inPlane(target.curvature, target.normal);
  return {target, slope(side, at(distance), here.d)};
}

SeamTarget::View SeamTarget::regular(int side, double s, int order) const {
  const FaceStrip& strip = strips_[side];
  const auto pointAt = [&](double at) {
    return order < 2 ? strip.firstOrderAt(place(side, at)) : strip.at(place(side, at));
  };
  SidePoint point = pointAt(s);
  View view;
  view.shown.point = point.jet.p;
  view.slope = slope(side, s, (pcurves_[side].last - pcurves_[side].first) * point.tangent);
  for (double step = difference_step; step < 0.5 && degeneracy(point.jet, point.noise) != Degeneracy::None;
       step *= 2)
    point = pointAt(s < 0.5 ? s + step : s - step);
  if (const auto normal = unitNormal(point.jet, point.noise)) {
    view.shown.normal = (side == 0 ? 1 : second_sign_) * *normal;
    if (order > 1) view.shown.curvature = curvatureTensor(point.jet, view.shown.normal);
  }
  return view;
}

/// \param along the derivative of the side's point by its place.
Eigen::Vector3d SeamTarget::slope(int side, double s, const Eigen::Vector3d& along) const {
  const Correspondence& map = seam_.correspondence;
  if (map.s.empty()) return along;
  auto right = std::upper_bound(map.s.begin() + 1, map.s.end() - 1, s) - map.s.begin();
  while (right > 1 && map.s[right] == map.s[right - 1]) --right;
  const double rate = (map.a[right] - map.a[right - 1]) / (map.s[right] - map.s[right - 1]);
  if (side == 0) return rate * along;
  // The foot of the first side's point on the second side's path moves with what it moves along it.
  const Eigen::Vector3d first = strips_[0].trace(placeOnFirst(map, s)).d;
  return rate * partAlong(first, along);
}

SeamTarget::Mean SeamTarget::mean(double s, int order) const {
  const View a = view(0, s, order), b = view(1, s, order);
  Mean mean;
  mean.point = (a.shown.point + b.shown.point) / 2;
  mean.slope = (a.slope + b.slope) / 2;
  mean.normal = (a.shown.normal + b.shown.normal).normalized();
  mean.curvature = (a.shown.curvature + b.shown.curvature) / 2;
  return mean;
}

SeamTarget::Mean SeamTarget::led(double s, int order) const {
  Mean led = mean(s, order);
  for (const int end : {0, 1}) {
    const auto& lead = leads_[end];
    if (!lead) continue;
    const Blends blends = blendsAt(end == 0 ? s : 1 - s, lead->span);
    const double sense = end == 0 ? 1 : -1;
    led.point += blends.value * lead->point + sense * blends.slope * lead->slope + blends.bend * lead->bend;
    led.slope += sense * blends.d_value * lead->point + blends.d_slope * lead->slope +
                 sense * blends.d_bend * lead->bend;
    led.normal += blends.brief_value * lead->normal + sense * blends.brief_slope * lead->normal_slope;
    led.curvature += blends.brief_value * lead->curvature;
  }
  led.normal = orthogonal(led.normal, led.slope);
  return led;
}

double SeamTarget::spanAt(int end) const {
  if (reach_ == LeadReach::Half) return largest_span;
  if (!spans_) {
    spans_ = {0, 0};
    for (const int side : {0, 1}) {
      const std::array<double, 2> of_side = spansAtEnds(seam_.sides[side], path(side));
      for (const int k : {0, 1}) (*spans_)[k] = std::max((*spans_)[k], of_side[k]);
    }
  }
  const double span = (*spans_)[end];
  return span > 0 ? std::min(span, largest_span) : largest_span;
}

bool SeamTarget::isLedBriefly() const {
  return spanAt(0) < largest_span || spanAt(1) < largest_span;
}

Eigen::Vector3d SeamTarget::way(int end) const {
  return (end == 0 ? 1 : -1) * spanAt(end) * mean(end, 1).slope;
}

SeamTarget::Lead SeamTarget::lead(int end, const TargetPoint& target) const {
  const Mean here = mean(end, 2);
  Lead lead;
  lead.span = spanAt(end);
  lead.point = target.point - here.point;
  lead.slope = -here.slope.dot(target.normal) * target.normal;
  lead.normal = target.normal - here.normal;
  lead.curvature = target.curvature - here.curvature;
  lead.bend.setZero();
  lead.normal_slope.setZero();
  if (order_ < 1) return lead;
  // Also for order 1: what the normals do along the seams at a vertex has to fit one tensor.
  const Eigen::Vector3d along = here.slope + lead.slope;
  const Eigen::Vector3d bend = derivative([&](double s) { return mean(s, 1).slope; }, end);
  lead.bend = (along.dot(target.curvature * along) - bend.dot(target.normal)) * target.normal;
  lead.normal_slope =
      -target.curvature * along - derivative([&](double s) { return mean(s, 1).normal; }, end);
  return lead;
}

void SeamTarget::setEnd(int end, const TargetPoint& target) {
  leads_[end] = lead(end, turned(target, mean(end, 1).normal));
}

void SeamTarget::setSharpEnd(int end, const Eigen::Vector3d& point,
                             const std::map<int, Eigen::Vector3d>& normals) {
  const Mean here = mean(end, 1);
  std::vector<Eigen::Vector3d> planes;
  for (const FaceUse& side : seam_.sides)
    if (const auto normal = normals.find(side.face); normal != normals.end())
      planes.push_back(normal->second);
  Lead lead;
  lead.span = spanAt(end);
  lead.point = point - here.point;
  lead.slope = -alongNormals(here.slope, planes);
  for (Eigen::Vector3d* none : {&lead.bend, &lead.normal, &lead.normal_slope}) none->setZero();
  lead.curvature.setZero();
  leads_[end] = lead;
}

TargetPoint SeamTarget::common(double s, int order) const {
  for (const int side : {0, 1})
    if (stays_[side]) return view(side, s, order).shown;
  const Mean here = led(s, order);
  if (order < 2) return {here.point, here.normal, Eigen::Matrix3d::Zero()};
  if (here.slope.isZero(0)) return {here.point, here.normal, inPlane(here.curvature, here.normal)};
  // The curve and the normal along it give all of the tensor but the curvature across.
  const Eigen::Vector3d t = here.slope.normalized(), b = here.normal.cross(t);
  const Eigen::Vector3d turn =
      -derivative([&](double at) { return led(at, 1).normal; }, s) / here.slope.norm();
  const double tt = turn.dot(t), tb = turn.dot(b), bb = b.dot(here.curvature * b);
  return {here.point, here.normal,
          tt * t * t.transpose() + tb * (t * b.transpose() + b * t.transpose()) + bb * b * b.transpose()};
}

TargetPoint SeamTarget::at(int side, double s, int order) const {
  const Correspondence& map = seam_.correspondence;
  double place = s;
  if (!map.s.empty()) {
    const std::vector<double>& places = side == 0 ? map.a : map.b;
    const auto [low, high] = std::minmax(places.front(), places.back());
    place = low + s * (high - low);
  }
  const double at_seam = seamParameter(side, place);
  TargetPoint target = common(at_seam, order);
  for (const int end : {0, 1})
    if ((end == 0 ? at_seam : 1 - at_seam) < pole_reach_.at(side).at(end)) target.normal.setZero();
  if (side == 0 || second_sign_ > 0) return target;
  return {target.point, -target.normal, -target.curvature};
}

Pcurve SeamTarget::path(int side) const {
  Pcurve path = pcurves_[side];
  const Correspondence& map = seam_.correspondence;
  if (map.s.empty()) return path;
  const std::vector<double>& places = side == 0 ? map.a : map.b;
  const auto [low, high] = std::minmax(places.front(), places.back());
  const double first = path.first, range = path.last - path.first;
  path.first = first + low * range;
  path.last = first + high * range;
  return path;
}

FollowPath followPath(const std::shared_ptr<const SeamTarget>& target, int side, int order) {
  FollowPath path;
  path.path = target->path(side);
  path.order = order;
  path.target = [target, side, order](double s) { return target->at(side, s, order); };
  path.face_on_left = target->seam().sides[side].edge.Orientation() == TopAbs_FORWARD;
  return path;
}

namespace {

/// The tensor in a tangent plane that is least away from those of the views.
class TensorFit {
 public:
  explicit TensorFit(const Eigen::Vector3d& normal)
      : normal_(normal), x_(normal.unitOrthogonal()), y_(normal.cross(x_)) {}

  void add(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double weight) {
    const Eigen::RowVector3d row(a.dot(x_) * b.dot(x_), a.dot(x_) * b.dot(y_) + a.dot(y_) * b.dot(x_),
                                 a.dot(y_) * b.dot(y_));
    matrix_ += weight * row.transpose() * row;
    right_ += weight * a.dot(inPlane(tensor, normal_) * b) * row.transpose();
  }

  void addWhole(const Eigen::Matrix3d& tensor, double weight) {
    add(tensor, x_, x_, weight);
    add(tensor, x_, y_, 2 * weight);
    add(tensor, y_, y_, weight);
  }

  Eigen::Matrix3d tensor() const {
    const Eigen::Vector3d w = matrix_.ldlt().solve(right_);
    return w[0] * x_ * x_.transpose() + w[1] * (x_ * y_.transpose() + y_ * x_.transpose()) +
           w[2] * y_ * y_.transpose();
  }

 private:
  Eigen::Vector3d normal_, x_, y_;
  Eigen::Matrix3d matrix_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
};

/// 1 where there are none: a unit for them.
double longestWay(const std::vector<VertexView>& views) {
  double longest = 0;
  for (const VertexView& view : views)
    for (const Eigen::Vector3d& way : view.ways) longest = std::max(longest, way.norm());
  return longest > 0 ? longest : 1;
}

/// Of what ways leave open.
constexpr double least_weight = 1e-3;

Eigen::Vector3d commonNormal(const std::vector<VertexView>& views) {
  const double longest = longestWay(views);
  Eigen::Matrix3d weights = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const VertexView& view : views) {
    Eigen::Matrix3d weight = (view.ways.size() > 1 ? least_weight : 1) * Eigen::Matrix3d::Identity();
    for (const Eigen::Vector3d& way : view.ways) weight += way * way.transpose() / (longest * longest);
    weights += weight;
    sum += weight * view.shown.normal;
  }
  return weights.ldlt().solve(sum).normalized();
}

/// How the normal changes along what is held there: of the tensor the row and column of that way.
void holdAlong(const VertexView& view, const Eigen::Vector3d& normal, TensorFit& fit) {
  constexpr double beyond_doubt = 1e8;
  if (!view.held_along) return;
  const Eigen::Vector3d way = view.held_along->normalized(), across = normal.cross(way).normalized();
  fit.add(view.shown.curvature, way, way, beyond_doubt);
  fit.add(view.shown.curvature, way, across, beyond_doubt);
}

/// A pole moves a twist by 25 and the bend of a boundary by 10 times as much as itself, in quintic knot spans of length 1.
Eigen::Matrix3d commonTensor(const std::vector<VertexView>& views, const Eigen::Vector3d& normal) {
  constexpr double twist = 0.4 * 0.4;
  const double longest = longestWay(views);
  TensorFit fit(normal);
  for (const VertexView& view : views) {
    for (std::size_t i = 0; i < view.ways.size(); ++i)
      for (std::size_t k = 0; k <= i; ++k)
        fit.add(view.shown.curvature, view.ways[i] / longest, view.ways[k] / longest, i == k ? 1 : twist);
    fit.addWhole(view.shown.curvature, view.ways.size() > 1 ? least_weight : 1);
    holdAlong(view, normal, fit);
  }
  return fit.tensor();
}

}  // namespace

VertexConsensus vertexConsensus(const std::vector<VertexView>& views, int order,
                                const ContinuityTolerance& tolerance) {
  std::vector<VertexView> aligned = views;
  for (VertexView& view : aligned) view.shown = turned(view.shown, views.front().shown.normal);
  const auto deciding = [&](int quantity) {
    std::vector<VertexView> telling, held;
    std::ranges::copy_if(aligned, std::back_inserter(telling), [&](const auto& view) {
      return quantity == 0 || !view.is_pole || (quantity == 1 && view.held >= 1);
    });
    if (telling.empty()) telling = aligned;
    std::ranges::copy_if(telling, std::back_inserter(held),
                         [&](const auto& view) { return view.held >= quantity; });
    return held.empty() ? telling : held;
  };
  VertexConsensus consensus;
  TargetPoint& target = consensus.target;
  target = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()};
  const std::vector<VertexView> points = deciding(0), normals = deciding(1), tensors = deciding(2);
  for (const VertexView& view : points) target.point += view.shown.point / static_cast<double>(points.size());
  target.normal = commonNormal(normals);
  target.curvature = commonTensor(tensors, target.normal);
  for (std::size_t i = 0; i < aligned.size(); ++i)
    for (std::size_t j = i + 1; j < aligned.size(); ++j) {
      const int common = std::min(
          {aligned[i].held, aligned[j].held, order, aligned[i].is_pole || aligned[j].is_pole ? 1 : order});
      if (common < 0 || aligned[i].face == aligned[j].face) continue;
      const PairMeasure pair = measurePair(sideOf(aligned[i].shown), sideOf(aligned[j].shown));
      if (ratioOf(pair, common, tolerance) <= 1) continue;
      std::ostringstream text;
      text << "faces " << aligned[i].face << " and " << aligned[j].face << " can't change at ("
           << target.point.x() << ", " << target.point.y() << ", " << target.point.z() << "), where they are "
           << figuresText(pair, common, tolerance) << " apart";
      consensus.contradiction = text.str();
      return consensus;
    }
  return consensus;
}

namespace {

/// The vertices at an end of a seam; none where a matched stretch ends before its edges do.
std::vector<TopoDS_Vertex> verticesAt(const Seam& seam, int end) {
  std::vector<TopoDS_Vertex> vertices;
  for (const int side : {0, 1}) {
    const TopoDS_Edge edge = TopoDS::Edge(seam.sides[side].edge.Oriented(TopAbs_FORWARD));
    double place = end;
    if (!seam.correspondence.s.empty()) {
      const std::vector<double>& places = side == 0 ? seam.correspondence.a : seam.correspondence.b;
      place = end == 0 ? places.front() : places.back();
    }
    constexpr double near = 1e-6;
    if (place > near && place < 1 - near) continue;
    const TopoDS_Vertex vertex = place < 0.5 ? TopExp::FirstVertex(edge) : TopExp::LastVertex(edge);
    if (!vertex.IsNull()) vertices.push_back(vertex);
  }
  return vertices;
}

bool shareFace(const SeamTarget& a, const SeamTarget& b) {
  for (const FaceUse& one : a.seam().sides)
    for (const FaceUse& other : b.seam().sides)
      if (one.face == other.face) return true;
  return false;
}

}  // namespace

std::vector<std::vector<TargetEnd>> meetingEnds(const std::vector<std::shared_ptr<SeamTarget>>& targets) {
  std::vector<TargetEnd> ends;
  TopTools_IndexedMapOfShape numbers;
  std::map<int, std::vector<std::size_t>> at_vertex;
  for (const auto& target : targets)
    for (const int end : {0, 1}) {
      std::set<int> vertices;
      for (const TopoDS_Vertex& vertex : verticesAt(target->seam(), end))
        vertices.insert(numbers.Add(vertex));
      for (const int vertex : vertices) at_vertex[vertex].push_back(ends.size());
      ends.push_back({target, end});
    }
  std::vector<std::size_t> group(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) group[i] = i;
  const auto leader = [&](std::size_t i) {
    while (group[i] != i) i = group[i];
    return i;
  };
  for (const auto& [vertex, meeting] : at_vertex)
    for (const std::size_t i : meeting)
      for (const std::size_t j : meeting)
        if (i < j && shareFace(*ends[i].target, *ends[j].target)) group[leader(j)] = leader(i);
  std::map<std::size_t, std::vector<TargetEnd>> groups;
  for (std::size_t i = 0; i < ends.size(); ++i) groups[leader(i)].push_back(ends[i]);
  std::vector<std::vector<TargetEnd>> found;
  for (auto& [first, members] : groups) found.push_back(std::move(members));
  return found;
}

namespace {

struct Meeting {
  std::vector<VertexView> views;
  std::set<const SeamTarget*> seams;
  bool any_held = false;
  int order = 0;
};

Meeting meetingOf(const std::vector<TargetEnd>& ends, const std::map<int, int>& held) {
  Meeting meeting;
  for (const TargetEnd& end : ends) {
    meeting.seams.insert(end.target.get());
    meeting.order = std::max(meeting.order, end.target->order());
    for (const int side : {0, 1}) {
      VertexView view{end.target->seam().sides[side].face, end.target->shown(side, end.end), -1,
                      end.target->isPole(side, end.end)};
      if (end.target->stays()[side]) view.held = end.order > 1 ? 2 : 1;
      if (end.target->stays()[side] && end.order == 1) view.held_along = end.target->way(end.end);
      if (const auto there = held.find(view.face); there != held.end()) {
        view.held = std::max(view.held, there->second);
        meeting.any_held = true;
      }
      for (const TargetEnd& other : ends)
        for (const FaceUse& use : other.target->seam().sides)
          if (use.face == view.face) view.ways.push_back(other.target->way(other.end));
      meeting.views.push_back(std::move(view));
    }
  }
  return meeting;
}

/// Indices from 0 to count - 1 in groups of those that are alike, directly or by others.
template <class Alike>
std::vector<std::vector<std::size_t>> groupsOf(std::size_t count, const Alike& alike) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::size_t> joined = {i};
    std::erase_if(groups, [&](const std::vector<std::size_t>& group) {
      if (std::ranges::none_of(group, [&](std::size_t k) { return alike(i, k); })) return false;
      joined.insert(joined.end(), group.begin(), group.end());
      return true;
    });
    groups.push_back(std::move(joined));
  }
  return groups;
}

}  // namespace

std::string agreeAtVertex(const std::vector<TargetEnd>& ends, const std::map<int, int>& held,
                          const ContinuityTolerance& tolerance) {
  const Meeting all = meetingOf(ends, held);
  if (all.seams.size() < 2 && !all.any_held) return {};
  const VertexConsensus place = vertexConsensus(all.views, 0, tolerance);
  if (!place.contradiction.empty()) return place.contradiction;
  std::vector<TargetEnd> smooth;
  std::ranges::copy_if(ends, std::back_inserter(smooth),
                       [](const TargetEnd& end) { return end.target->order() > 0; });
  std::map<int, Eigen::Vector3d> normals;
  for (const auto& group : groupsOf(smooth.size(), [&](std::size_t i, std::size_t k) {
         return shareFace(*smooth[i].target, *smooth[k].target);
       })) {
    std::vector<TargetEnd> members;
    for (const std::size_t k : group) members.push_back(smooth[k]);
    const Meeting meeting = meetingOf(members, held);
    VertexConsensus consensus = vertexConsensus(meeting.views, meeting.order, tolerance);
    if (!consensus.contradiction.empty()) return consensus.contradiction;
    consensus.target.point = place.target.point;
    for (const TargetEnd& end : members) end.target->setEnd(end.end, consensus.target);
    for (const VertexView& view : meeting.views) normals[view.face] = consensus.target.normal;
  }
  for (const TargetEnd& end : ends)
    if (end.target->order() == 0) end.target->setSharpEnd(end.end, place.target.point, normals);
  return {};
}

}  // namespace seamwright::occ
