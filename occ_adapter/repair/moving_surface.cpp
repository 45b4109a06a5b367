// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Precision.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>

#include <seamwright/occ_adapter/convert/closed_spline.hpp>
#include <seamwright/occ_adapter/repair/moving_surface.hpp>

namespace seamwright::occ {

namespace {

using Surface = opencascade::handle<Geom_BSplineSurface>;

Surface copyOf(const Surface& surface) {
  return Surface::DownCast(surface->Copy());
}

std::array<double, 2> spacingOf(const SurfaceBasis& basis) {
  return {meanSpacing(basis.u()), meanSpacing(basis.v())};
}

Surface withKnots(const Surface& surface, const std::array<std::set<double>, 2>& all) {
  const Surface refined = copyOf(surface);
  for (const int k : {0, 1}) {
    if (all[k].empty()) continue;
    TColStd_Array1OfReal knots(1, static_cast<int>(all[k].size()));
    std::ranges::copy(all[k], knots.begin());
    TColStd_Array1OfInteger multiplicities(1, knots.Length());
    multiplicities.Init(1);
    if (k == 0)
      refined->InsertUKnots(knots, multiplicities);
    else
      refined->InsertVKnots(knots, multiplicities);
  }
  return refined;
}

bool isPeriodic(const Geom_BSplineSurface& surface) {
  return surface.IsUPeriodic() || surface.IsVPeriodic();
}

bool isClamped(const Geom_BSplineSurface& surface) {
  const int u = surface.UDegree() + 1, v = surface.VDegree() + 1;
  return surface.UMultiplicity(1) == u && surface.UMultiplicity(surface.NbUKnots()) == u &&
         surface.VMultiplicity(1) == v && surface.VMultiplicity(surface.NbVKnots()) == v;
}

/// Periodic where it ends at itself, and as smooth there as it was; clamped if it is not periodic, so that its outermost
/// poles are those of its boundaries.
Surface closed(const Surface& given) {
  const double exactly_mm = Precision::Confusion() / 1000;
  const Surface surface = copyOf(given);
  if (isPeriodic(*given)) return surface;
  for (const Direction direction : {Direction::U, Direction::V})
    if (endsAtItself(*surface, direction, exactly_mm)) makePeriodic(*surface, direction, exactly_mm);
  if (!isPeriodic(*surface) && !isClamped(*surface)) makeClamped(*surface);
  return surface;
}

/// Scattered poles of a side would leave its tangent plane at the point to the scatter: they become their mean.
/// \returns the largest move of a pole.
double collapse(const Surface& surface, double near_mm) {
  const SurfaceBasis basis(*surface);
  const PointRows given = polesOf(*surface);
  PointRows poles = given;
  for (const std::vector<int>& side : collapsedSides(basis, given, near_mm)) {
    const Eigen::RowVector3d mean = given(side, Eigen::indexing::all).colwise().mean();
    for (const int pole : side) poles.row(pole) = mean;
  }
  setPoles(*surface, poles);
  return (poles - given).rowwise().norm().maxCoeff();
}

}  // namespace

MovingSurface::MovingSurface(const Surface& given, double near_mm)
    : near_mm_(near_mm),
      given_periodic_(isPeriodic(*given)),
      before_(closed(given)),
      collapse_mm_(collapse(before_, near_mm)),
      basis_(*before_),
      poles_(polesOf(*before_)),
      original_(poles_),
      given_spacing_(spacingOf(basis_)) {}

Surface MovingSurface::now() const {
  const Surface surface = copyOf(before_);
  occ::setPoles(*surface, poles_);
  return surface;
}

Surface MovingSurface::moved() const {
  const Surface surface = now();
  if (isPeriodic(*surface) && !given_periodic_) makeClamped(*surface);
  return surface;
}

double MovingSurface::largestMove_mm() const {
  const double moved_mm = (poles_ - original_).rowwise().norm().maxCoeff();
  return moved_mm > 0 ? moved_mm + collapse_mm_ : 0;
}

bool MovingSurface::raiseDegrees(int least) {
  if (basis_.u().degree >= least && basis_.v().degree >= least) return false;
  const Surface raised = copyOf(before_);
  raised->IncreaseDegree(std::max(basis_.u().degree, least), std::max(basis_.v().degree, least));
  const double collapse_mm = collapse_mm_;
  *this = MovingSurface(raised, near_mm_);
  collapse_mm_ += collapse_mm;
  return true;
}

void MovingSurface::touch(const std::vector<bool>& poles) {
  TColgp_Array2OfPnt marks(1, before_->NbUPoles(), 1, before_->NbVPoles());
  for (int i = 0; i < basis_.u().poles; ++i)
    for (int j = 0; j < basis_.v().poles; ++j)
      if (poles[basis_.pole(i, j)]) marks(i + 1, j + 1).SetX(1);
  TColStd_Array1OfReal knots_u(1, before_->NbUKnots()), knots_v(1, before_->NbVKnots());
  TColStd_Array1OfInteger multiplicities_u(1, before_->NbUKnots()), multiplicities_v(1, before_->NbVKnots());
  before_->UKnots(knots_u);
  before_->VKnots(knots_v);
  before_->UMultiplicities(multiplicities_u);
  before_->VMultiplicities(multiplicities_v);
  touched_ =
      new Geom_BSplineSurface(marks, knots_u, knots_v, multiplicities_u, multiplicities_v, before_->UDegree(),
                              before_->VDegree(), before_->IsUPeriodic(), before_->IsVPeriodic());
  settled_.assign(poles.size(), false);
}

void MovingSurface::insert(const std::array<std::set<double>, 2>& knots,
                           const std::vector<Eigen::Vector2d>& places, bool near_alone) {
  poles_ = polesOf(*withKnots(now(), knots));
  before_ = withKnots(before_, knots);
  touched_ = withKnots(touched_, knots);
  basis_ = SurfaceBasis(*before_);
  original_ = polesOf(*before_);
  settled_.assign(static_cast<std::size_t>(poles_.rows()), near_alone);
  for (const Eigen::Vector2d& uv : places) {
    const std::vector<int> near_u = basis_.u().polesNear(uv[0]), near_v = basis_.v().polesNear(uv[1]);
    for (const int i : near_u)
      for (const int j : near_v) settled_[basis_.pole(i, j)] = false;
  }
}

bool MovingSurface::isCollapsed() const {
  return !collapsedSides(basis_, original_, near_mm_).empty();
}

MoveNumbers MovingSurface::numbers() const {
  const PointRows touched = polesOf(*touched_);
  MoveNumbers numbers{std::vector<int>(touched.rows(), -1)};
  const auto moves = [&](int pole) { return touched(pole, 0) > 1e-12 && !settled_[pole]; };
  for (const std::vector<int>& side : collapsedSides(basis_, original_, near_mm_))
    if (std::ranges::any_of(side, moves)) {
      for (const int pole : side) numbers.of_pole[pole] = numbers.count;
      ++numbers.count;
    }
  for (int pole = 0; pole < touched.rows(); ++pole)
    if (moves(pole) && numbers.of_pole[pole] < 0) numbers.of_pole[pole] = numbers.count++;
  return numbers;
}

}  // namespace seamwright::occ
