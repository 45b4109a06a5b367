// SPDX-License-Identifier: LGPL-2.1-or-later
// Growth of time and memory of an analysis with the size of the model: a sheet with a pattern of
// rounded pockets, 1,251 to 20,001 faces.
//   bench_growth [POCKETS] [--benchmark_...]
// Memory that one analysis freed is not counted again in the next one. So each size needs a process
// of its own: benchmarks/compare starts one for each value of POCKETS.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

#include <seamwright/occ_adapter/analyze/analyze.hpp>

#include "memory.hpp"
#include "pocketed_sheet.hpp"
#include "program.hpp"

namespace {

using namespace seamwright;

void analyzeSheet(benchmark::State& state, bool certify) {
  const occ::Model model =
      occ::modelFromShape(bench::makePocketedSheet(static_cast<int>(state.range(0))));
  occ::AnalyzeOptions options;
  options.certify = certify;
  options.jobs = 1;
  double added_kB = 0;
  std::size_t seams = 0;
  for (auto _ : state) {
    state.PauseTiming();
    const double before_kB = bench::memoryNow().resident_kB;
    bench::forgetPeak();
    state.ResumeTiming();
    const occ::Report report = occ::analyze(model, options);
    state.PauseTiming();
    added_kB = std::max(added_kB, bench::memoryNow().peak_kB - before_kB);
    seams = report.seams.size();
    state.ResumeTiming();
  }
  if (model.faceCount() != 1 + bench::faces_per_pocket * state.range(0))
    state.SkipWithError("not the sheet it should be");
  state.counters["faces"] = model.faceCount();
  state.counters["seams"] = static_cast<double>(seams);
  state.counters["added_kB"] = added_kB;
}

}  // namespace

int main(int argc, char** argv) {
  return seamwright::bench::guarded([&] {
    benchmark::Initialize(&argc, argv);
    for (const bool certify : {true, false}) {
      benchmark::internal::Benchmark* entry = benchmark::RegisterBenchmark(
          certify ? "sheet/certified" : "sheet/sampled", analyzeSheet, certify);
      entry->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond);
      if (argc > 1)
        entry->Arg(std::stoi(argv[1]));
      else
        entry->RangeMultiplier(2)->Range(50, 800);
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
  });
}
