// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <seamwright/core/bezier/stopped_ends.hpp>
#include <seamwright/core/fair/fair_curve.hpp>
#include <seamwright/plugin/cli/curve_figures.hpp>
#include <seamwright/plugin/cli/fair_splines.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

bool isPolynomial(const BSplineCurve& curve) {
  return (curve.poles.col(3).array() == curve.poles(0, 3)).all();
}

bool noLessFair(const ChainFigures& one, const ChainFigures& other) {
  // Energies that agree to this are the same.
  constexpr double same = 1 + 1e-9;
  return one.extrema <= other.extrema && one.inflections <= other.inflections &&
         one.energy_per_mm <= same * other.energy_per_mm;
}

/// The spline made fair, if its curvature is fair too: the least integral of the squared third
/// derivative can cost extrema where the parameters are uneven. Smaller moves cost fewer.
std::optional<FairedCurve> fairerSpline(const BSplineCurve& spline, double tolerance_mm,
                                        const CurveFairingOptions& options,
                                        const Progress& progress) {
  const auto figures = [](const BSplineCurve& curve) {
    return figuresOf({.curves = {curve}, .closed = false});
  };
  const ChainFigures before = figures(spline);
  for (const double share : {1.0, 0x1p-2, 0x1p-4}) {
    const FairedCurve faired = fairCurve(spline, share * tolerance_mm, options, progress);
    try {
      if (noLessFair(figures(faired.curve), before)) return faired;
    } catch (const std::domain_error&) {  // it may stop within
      continue;
    }
  }
  return std::nullopt;
}

/// How many poles keep the tangents at both ends: the first two that differ, and those before them.
std::optional<HeldEnds> heldTangent(const BSplineCurve& spline) {
  const std::vector<BezierCurve> spans = bezierCurves(spline);
  const int stops = std::max(stoppedEnds(spans.front()).start, stoppedEnds(spans.back()).end);
  if (stops > 1) return std::nullopt;
  return stops == 1 ? HeldEnds::Curvature : HeldEnds::Tangent;
}

void noteKept(report::CurveRecord& record, int kept, int not_fairer) {
  record.with_reservations = not_fairer > 0;
  if (kept > 0)
    record.notes.push_back(fmt::format(
        "{} curve{} as given: only polynomial B-splines of degree 2 and more are faired", kept,
        kept == 1 ? " stays" : "s stay"));
  if (not_fairer > 0)
    record.notes.push_back(
        fmt::format("{} curve{} as given: moves of poles, by a sixteenth of the tolerance or more, "
                    "would cost extrema, inflections or energy",
                    not_fairer, not_fairer == 1 ? " stays" : "s stay"));
}

}  // namespace

MadeCurve madeFairSplines(const GivenCurve& given, const CurveTask& task) {
  MadeCurve made{.record = given.record};
  const ChainFigures before = figuresOf(given.chain, partOf(task.progress, 0, 0));
  made.record.before = figuresFrom(before);
  made.chain.closed = given.chain.closed;
  const auto whole = static_cast<double>(given.chain.curves.size());
  double moved_mm = 0;
  int kept = 0, not_fairer = 0;
  // Neighbours meet in position and tangent, and so do the ends of a closed chain.
  const bool joins = given.chain.closed || given.chain.curves.size() > 1;
  for (const ChainCurve& curve : given.chain.curves) {
    const double done = static_cast<double>(made.chain.curves.size()) / whole;
    const auto* spline = std::get_if<BSplineCurve>(&curve);
    if (!spline || spline->degree < 2 || !isPolynomial(*spline)) {
      made.chain.curves.push_back(curve);
      ++kept;
      continue;
    }
    const std::optional<HeldEnds> ends = joins ? heldTangent(*spline) : HeldEnds::Position;
    std::optional<FairedCurve> faired;
    if (ends)
      faired = fairerSpline(*spline, task.tolerance_mm, {.ends = *ends},
                            partOf(task.progress, done, done));
    if (!faired) {
      made.chain.curves.push_back(curve);
      ++not_fairer;
      continue;
    }
    moved_mm = std::max(moved_mm, faired->moved_mm);
    made.chain.curves.emplace_back(faired->curve);
    made.record.pieces += bezierSpline(faired->curve).segments();
  }
  const ChainFigures after = figuresOf(made.chain, partOf(task.progress, 1, 1));
  made.record.after = figuresFrom(after);
  if (!noLessFair(after, before)) {  // at joints, where neighbours are fair by themselves
    made.chain = given.chain;
    made.record.after = made.record.before;
    made.record.pieces = 0;
    moved_mm = 0;
    not_fairer = static_cast<int>(given.chain.curves.size()) - kept;
  }
  made.record.distance_mm = made.record.moved_mm = moved_mm;
  noteKept(made.record, kept, not_fairer);
  return made;
}

}  // namespace seamwright::cli
