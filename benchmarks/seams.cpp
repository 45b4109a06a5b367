// SPDX-License-Identifier: LGPL-2.1-or-later
// Times of Seamwright for the seams of a model, beside what its user would call instead.
//   bench_seams MODEL... [--benchmark_...]
// For each model: reading it, finding its seams, analysing them (certified, to certain verdicts
// only, and sampled; on one and on two threads), and the two analyses of OpenCASCADE. Times are
// those of the whole model; divide by the counter "seams" for the time of a seam. Processor time is
// that of all threads of this process, without the reading program that readModel() starts.
#include <benchmark/benchmark.h>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/model/read.hpp>

#include "peers.hpp"
#include "program.hpp"

namespace {

using namespace seamwright;

constexpr int local_analysis_points = 23;

/// A model that several benchmarks share.
struct Subject {
  std::filesystem::path path;
  occ::Model model;
  std::vector<occ::Seam> seams;
  bench::RegularityPeer regularity;

  explicit Subject(const std::filesystem::path& file)
      : path(file),
        model(occ::readModel(file)),
        seams(occ::findSeams(model.shape).seams),
        regularity(model.shape) {}
};
using SubjectPtr = std::shared_ptr<Subject>;

void finish(benchmark::State& state, const Subject& subject) {
  state.counters["seams"] = static_cast<double>(subject.seams.size());
  state.counters["faces"] = subject.model.faceCount();
}

void readOpenCascade(benchmark::State& state, const SubjectPtr& subject) {
  for (auto _ : state) benchmark::DoNotOptimize(bench::readWithOpenCascade(subject->path));
  finish(state, *subject);
}

void readSeamwright(benchmark::State& state, const SubjectPtr& subject) {
  for (auto _ : state) benchmark::DoNotOptimize(occ::readModel(subject->path));
  finish(state, *subject);
}

void find(benchmark::State& state, const SubjectPtr& subject) {
  for (auto _ : state) benchmark::DoNotOptimize(occ::findSeams(subject->model.shape));
  finish(state, *subject);
}

/// Processor time of the calling thread alone.
double threadMicroseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// Counts the processor time of the calling thread as "serial_us": other threads measure the seams.
void analyze(benchmark::State& state, const SubjectPtr& subject,
             const occ::AnalyzeOptions& options) {
  double points = 0;
  const double start_us = threadMicroseconds();
  for (auto _ : state) {
    const occ::Report report = occ::analyze(subject->model, options);
    points = 0;
    for (const occ::SeamResult& seam : report.seams) points += seam.figures.points;
  }
  state.counters["serial_us"] =
      benchmark::Counter(threadMicroseconds() - start_us, benchmark::Counter::kAvgIterations);
  finish(state, *subject);
  state.counters["points"] = points;
}

void localAnalysis(benchmark::State& state, const SubjectPtr& subject) {
  bench::LocalAnalysisSummary summary;
  for (auto _ : state) {
    summary = bench::localAnalysis(subject->seams, local_analysis_points);
    benchmark::DoNotOptimize(summary);
  }
  finish(state, *subject);
  state.counters["points"] = summary.points;
  state.counters["gap_mm"] = summary.gap_mm;
}

void encodeRegularity(benchmark::State& state, const SubjectPtr& subject) {
  const double angle_rad = ContinuityTolerance{}.angle_rad;
  for (auto _ : state) {
    state.PauseTiming();
    subject->regularity.forget();
    state.ResumeTiming();
    subject->regularity.encode(angle_rad);
  }
  finish(state, *subject);
}

void registerModel(const std::filesystem::path& path) {
  const auto subject = std::make_shared<Subject>(path);
  const std::string name = path.filename();
  const auto add = [&](const std::string& what, auto function, auto... arguments) {
    benchmark::RegisterBenchmark((name + "/" + what).c_str(), function, subject, arguments...)
        ->MeasureProcessCPUTime()
        ->UseRealTime()
        ->Unit(benchmark::kMicrosecond);
  };
  add("read_opencascade", readOpenCascade);
  add("read_seamwright", readSeamwright);
  add("find", find);
  for (const int jobs : {1, 2}) {
    const std::string threads = ":" + std::to_string(jobs);
    occ::AnalyzeOptions certified;
    certified.jobs = jobs;
    occ::AnalyzeOptions verdict = certified, sampled = certified;
    verdict.figures = false;
    sampled.certify = false;
    add("certified" + threads, analyze, certified);
    add("verdict" + threads, analyze, verdict);
    add("sampled" + threads, analyze, sampled);
  }
  add("local_analysis", localAnalysis);
  add("encode_regularity", encodeRegularity);
}

}  // namespace

int main(int argc, char** argv) {
  return seamwright::bench::guarded([&] {
    benchmark::Initialize(&argc, argv);
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
    if (argc < 2) {
      std::cerr << "usage: bench_seams MODEL... [--benchmark_...]\n";
      return 2;
    }
    for (int i = 1; i < argc; ++i) registerModel(argv[i]);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
  });
}
