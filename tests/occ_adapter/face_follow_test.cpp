// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "follow_seams.hpp"

namespace seamwright::test {
namespace {

using occ::FaceFollow;
using occ::FaceTask;
using occ::followPaths;

Spline copyOf(const Spline& surface) {
  return Spline::DownCast(surface->Copy());
}

handle<Geom2d_BSplineCurve> acrossPath(std::mt19937& generator) {
  const auto height = [&] { return 0.5 + random(generator, 0.2); };
  return curvedPath({{0, height()}, {0.3, height()}, {0.7, height()}, {1, height()}});
}

TEST(FaceFollow, MeetsAnExactAnswerAlongACut) {
  std::mt19937 generator(71);
  int within = 0, cases = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const int order = 1 + trial % 2, count = 12 + trial % 9;
    const Spline truth = sheet(generator, count, count, 3, 3);
    const double noise = logRandom(generator, 0.1, 2);
    const Spline moving = copyOf(truth);
    addNoise(moving, generator, noise);
    const PathOn staying{truth, acrossPath(generator), true}, own{moving, staying.path, false};
    FaceTask task{moving, {pathTo(own, staying, order)}, fine()};
    const auto start = std::chrono::steady_clock::now();
    const FaceFollow follow = followPaths(task);
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const occ::SeamResult after =
        certified(seamBetween(staying, {follow.surface, staying.path, false}), fine(), order);
    ++cases;
    static double sum[3] = {}, refs[3] = {};
    sum[order] += std::log(follow.largest_move_mm / noise);
    refs[order] += follow.refinements;
    if (trial > 97)
      std::printf("order %d mean move %g refine %g\n", order, std::exp(sum[order] / 50), refs[order] / 50);
    within += follow.largest_move_mm <= 3 * noise;
    std::printf(
        "%d order %d noise %.4f move %.4f refined %d poles %d ratio %.3g gap %.2e angle %.2e deg curv %.3g "
        "%s took %.2f\n",
        count, order, noise, follow.largest_move_mm, follow.refinements,
        follow.surface->NbUPoles() * follow.surface->NbVPoles(), follow.ratios[0],
        *after.figures.gap_mm->upper, *after.figures.angle_rad->upper / degree,
        after.figures.curvature_rel ? *after.figures.curvature_rel->upper : -1., follow.failure.c_str(),
        took);
  }
  std::printf("%d of %d\n", within, cases);
}

}  // namespace
}  // namespace seamwright::test
