// SPDX-License-Identifier: LGPL-2.1-or-later
// Repair beside analysis, for models with growing numbers of seams.
//   bench_repair [--smoke | MODEL...]
// Without files, the models are grids of faces with natural boundaries, grids of trimmed faces, and
// chains of trimmed faces, all broken by noise of 0.01 mm. Times are medians of the processor time
// of three turns in one process with one thread; slow repairs run once. For files, all options have
// their defaults, on two threads; times are the least wall time and processor time of the turns.
// The table goes to standard output.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/repair/repair.hpp>

#include "../tests/occ_adapter/nets.hpp"
#include "program.hpp"

namespace {

using namespace seamwright;

struct Subject {
  std::string name;
  std::vector<int> sizes;
  std::function<test::NetShape(int size)> shape;
};

std::vector<Subject> subjects(bool smoke) {
  const auto grid = [](bool trimmed, int columns, int rows) {
    test::NetShape shape;
    shape.columns = columns;
    shape.rows = rows;
    if (trimmed) {
      shape.bend = 0.12;
      shape.overhang = 0.5;
    }
    return shape;
  };
  const std::vector<int> sides = smoke ? std::vector<int>{2, 3} : std::vector<int>{2, 4, 8, 16, 24};
  const std::vector<int> chain = smoke ? std::vector<int>{2, 4} : std::vector<int>{4, 16, 64, 256};
  return {{"natural faces, n by n", sides, [grid](int n) { return grid(false, n, n); }},
          {"trimmed faces, n by n", sides, [grid](int n) { return grid(true, n, n); }},
          {"trimmed faces, a chain of n", chain, [grid](int n) { return grid(true, n, 1); }}};
}

double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

struct Times {
  int seams = 0;
  int treated = 0;
  int repaired = 0;
  double analyze_s = 0;
  double repair_s = 0;
};

Times timesOf(const test::NetShape& shape) {
  constexpr double noise_mm = 0.01;
  constexpr int turns = 3;
  constexpr double slow_s = 5;
  std::mt19937 random(1);
  test::Net net = test::piecesOfOne(shape, random);
  test::disturb(net, noise_mm, random);
  const occ::Model model = occ::modelFromShape(test::shapeOf(net));
  occ::RepairOptions options;
  options.jobs = 1;
  options.tolerance.gap_mm = 0.001;
  options.tolerance.angle_rad /= 10;
  occ::AnalyzeOptions analyze;
  analyze.jobs = 1;
  analyze.tolerance = options.tolerance;
  Times times;
  std::vector<double> analyses, repairs;
  while (repairs.empty() || (repairs.size() < turns && repairs.front() < slow_s)) {
    const double start = processorSeconds();
    times.seams = static_cast<int>(occ::analyze(model, analyze).seams.size());
    const double between = processorSeconds();
    const occ::RepairReport report = occ::repair(model, options);
    analyses.push_back(between - start);
    repairs.push_back(processorSeconds() - between);
    times.treated =
        static_cast<int>(std::ranges::count(report.seams, true, &occ::SeamRepair::treated));
    times.repaired =
        static_cast<int>(std::ranges::count(report.seams, true, &occ::SeamRepair::repaired));
  }
  times.analyze_s = median(analyses);
  times.repair_s = median(repairs);
  return times;
}

/// The exponent p of time ~ seams^p between two sizes.
double exponent(const Times& less, const Times& more, double Times::*time) {
  return std::log(more.*time / less.*time) / std::log(static_cast<double>(more.seams) / less.seams);
}

void run(const Subject& subject) {
  std::printf(
      "\n%s:\n\n| n | seams | to repair | repaired | analysis, ms | repair, ms | ratio | repair, "
      "ms a seam "
      "|\n"
      "|--:|--:|--:|--:|--:|--:|--:|--:|\n",
      subject.name.c_str());
  std::vector<Times> all;
  for (const int size : subject.sizes) {
    const Times times = timesOf(subject.shape(size));
    std::printf("| %d | %d | %d | %d | %.1f | %.1f | %.1f | %.2f |\n", size, times.seams,
                times.treated, times.repaired, 1e3 * times.analyze_s, 1e3 * times.repair_s,
                times.repair_s / times.analyze_s, 1e3 * times.repair_s / times.seams);
    std::fflush(stdout);
    all.push_back(times);
  }
  const Times &less = all[all.size() - 2], &more = all.back();
  std::printf("\nRepair grows as seams^%.2f, analysis as seams^%.2f.\n",
              exponent(less, more, &Times::repair_s), exponent(less, more, &Times::analyze_s));
}

/// The least of several turns.
struct Least {
  double wall_s = std::numeric_limits<double>::infinity();
  double processor_s = std::numeric_limits<double>::infinity();

  void take(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    const double before_s = processorSeconds();
    work();
    processor_s = std::min(processor_s, processorSeconds() - before_s);
    wall_s = std::min(
        wall_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
};

int defects(const occ::Report& report) {
  return static_cast<int>(std::ranges::count_if(report.seams, [](const occ::SeamResult& seam) {
    return seam.verdict.seam_class == SeamClass::Defect;
  }));
}

void runFile(const std::filesystem::path& path) {
  constexpr int analyses = 5, repairs = 3;
  const occ::Model model = occ::readModel(path);
  occ::RepairOptions options;
  options.jobs = 2;
  occ::RepairReport report;
  Least analysis, repair;
  for (int turn = 0; turn < repairs; ++turn) {
    for (int k = 0; k < analyses; ++k)
      analysis.take([&] { occ::analyze(model, occ::analyzeOptions(options)); });
    repair.take([&] { report = occ::repair(model, options); });
  }
  double largest_mm = 0;
  for (const occ::FaceMove& move : report.moves)
    largest_mm = std::max(largest_mm, move.largest_move_mm);
  std::printf("| %s | %zu | %d | %d | %.3f | %.1f | %.1f | %.1f | %.1f |\n",
              path.filename().c_str(), report.seams.size(), defects(report.before),
              defects(report.after), largest_mm, 1e3 * analysis.wall_s, 1e3 * repair.wall_s,
              repair.wall_s / analysis.wall_s, repair.processor_s / analysis.processor_s);
  std::fflush(stdout);
}

void runFiles(int count, char** paths) {
  std::printf(
      "| model | seams | defects before | after | largest move, mm | analysis, ms | repair, ms | "
      "ratio | of "
      "processor time |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (int i = 0; i < count; ++i) runFile(paths[i]);
}

}  // namespace

int main(int argc, char** argv) {
  return seamwright::bench::guarded([&] {
    if (argc > 1 && argv[1][0] != '-') {
      runFiles(argc - 1, argv + 1);
      return 0;
    }
    const bool smoke = seamwright::bench::isSmoke(argc, argv);
    if (argc > 1 && !smoke) {
      std::fprintf(stderr, "usage: bench_repair [--smoke | MODEL...]\n");
      return 2;
    }
    for (const Subject& subject : subjects(smoke)) run(subject);
    return 0;
  });
}
