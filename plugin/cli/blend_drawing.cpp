// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <seamwright/core/planar/plane_frame.hpp>
#include <seamwright/plugin/cli/blend_drawing.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

std::string samplesCsv(const std::vector<BezierSpline>& frames, const std::vector<double>& omegas) {
  constexpr int samples = 16;  // of a segment
  std::string text = "omega,x,y,z\n";
  for (std::size_t k = 0; k < frames.size(); ++k)
    for (int i = 0; i < frames[k].segments(); ++i) {
      const BezierCurve one = segment(frames[k], i);
      const int last = i + 1 < frames[k].segments() ? samples - 1 : samples;
      for (int j = 0; j <= last; ++j) {
        const Eigen::Vector3d p = one.point(static_cast<double>(j) / samples);
        text += fmt::format("{},{},{},{}\n", omegas[k], p.x(), p.y(), p.z());
      }
    }
  return text;
}

Poles polesOf(const std::vector<BezierSpline>& frames) {
  Eigen::Index rows = 0;
  for (const BezierSpline& frame : frames) rows += frame.poles.rows();
  Poles poles(rows, 3);
  rows = 0;
  for (const BezierSpline& frame : frames) {
    poles.middleRows(rows, frame.poles.rows()) =
        frame.poles.leftCols<3>().array().colwise() / frame.poles.col(3).array();
    rows += frame.poles.rows();
  }
  return poles;
}

/// The frame in the coordinates of the plane.
MadeCurve planarFrame(const BezierSpline& frame, const PlaneFrame& plane) {
  BezierSpline flat = frame;
  const Poles poles = polesOf({frame});
  const PlanarPoints coordinates = coordinatesIn(plane, poles);
  flat.poles.leftCols<2>() = coordinates.array().colwise() * frame.poles.col(3).array();
  flat.poles.col(2).setZero();
  MadeCurve made;
  made.record.plane = plane;
  made.record.closed = frame.closed;
  made.record.after.length_mm =
      (poles.bottomRows(poles.rows() - 1) - poles.topRows(poles.rows() - 1)).rowwise().norm().sum();
  made.chain.closed = frame.closed;
  made.chain.curves = {bsplineCurve(flat, 0)};
  return made;
}

}  // namespace

CurveText framesText(CurveFormat format, const std::vector<BezierSpline>& frames,
                     const std::vector<double>& omegas, double tolerance_mm) {
  if (format == CurveFormat::Csv) return {.text = samplesCsv(frames, omegas)};
  const FittedPlane plane = fitPlane(polesOf(frames));
  if (plane.distance_mm > tolerance_mm)
    throw std::runtime_error(
        fmt::format("a drawing has one plane, and the frames are up to {:.3g} mm from the nearest "
                    "one: write .step, .brep or .csv",
                    plane.distance_mm));
  std::vector<MadeCurve> curves;
  for (const BezierSpline& frame : frames) curves.push_back(planarFrame(frame, plane.frame));
  constexpr double share = 0.1;
  return curveText(format, "blend", curves, share * tolerance_mm, {});
}

}  // namespace seamwright::cli
