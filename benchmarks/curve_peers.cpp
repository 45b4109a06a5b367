// SPDX-License-Identifier: LGPL-2.1-or-later
// FairCurve_MinimalVariation between (0, 0) and (CHORD, 0).
//   bench_curve_peers CHORD_MM START_RAD END_RAD REPETITIONS
// The angles are those of the tangents against the chord. One JSON object goes to standard output:
// degree, flat knots, poles and the least processor time.
#include <FairCurve_MinimalVariation.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <gp_Pnt2d.hxx>
#include <limits>
#include <stdexcept>
#include <string>

#include "program.hpp"

namespace {

struct Ends {
  double chord_mm = 0, start_rad = 0, end_rad = 0;
};

double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Handle(Geom2d_BSplineCurve) fairCurve(const Ends& ends) {
  // With a physical ratio of 0 only the variation of the curvature counts, and the height does not
  // matter.
  FairCurve_MinimalVariation batten(gp_Pnt2d(0, 0), gp_Pnt2d(ends.chord_mm, 0), 1);
  // The tangents alone are given, and the length is free. The second angle counts clockwise.
  batten.SetConstraintOrder1(1);
  batten.SetConstraintOrder2(1);
  batten.SetAngle1(ends.start_rad);
  batten.SetAngle2(-ends.end_rad);
  batten.SetFreeSliding(true);
  constexpr int most_iterations = 1000;
  constexpr double tolerance = 1e-6;
  FairCurve_AnalysisCode code{};
  if (!batten.Compute(code, most_iterations, tolerance))
    throw std::runtime_error("FairCurve_MinimalVariation ends with the code " +
                             std::to_string(static_cast<int>(code)));
  return batten.Curve();
}

void print(const Geom2d_BSplineCurve& curve, double seconds) {
  std::printf("{\"degree\": %d, \"seconds\": %.9g, \"knots\": [", curve.Degree(), seconds);
  const char* between = "";
  for (int i = 1; i <= curve.NbKnots(); ++i)
    for (int k = 0; k < curve.Multiplicity(i); ++k, between = ", ")
      std::printf("%s%.17g", between, curve.Knot(i));
  std::printf("], \"poles\": [");
  for (int i = 1; i <= curve.NbPoles(); ++i)
    std::printf("%s[%.17g, %.17g, 0]", i == 1 ? "" : ", ", curve.Pole(i).X(), curve.Pole(i).Y());
  std::printf("]}\n");
}

int run(char** argv) {
  const Ends ends{.chord_mm = std::atof(argv[1]),
                  .start_rad = std::atof(argv[2]),
                  .end_rad = std::atof(argv[3])};
  double least_s = std::numeric_limits<double>::infinity();
  Handle(Geom2d_BSplineCurve) curve;
  for (int i = 0; i < std::atoi(argv[4]); ++i) {
    const double start_s = processorSeconds();
    curve = fairCurve(ends);
    least_s = std::min(least_s, processorSeconds() - start_s);
  }
  if (curve.IsNull()) throw std::invalid_argument("the repetitions must be at least 1");
  print(*curve, least_s);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "usage: bench_curve_peers CHORD_MM START_RAD END_RAD REPETITIONS\n");
    return 2;
  }
  return seamwright::bench::guarded([&] { return run(argv); });
}
