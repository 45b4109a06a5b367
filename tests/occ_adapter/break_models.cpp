// SPDX-License-Identifier: LGPL-2.1-or-later
// Breaks smooth models and has them repaired.
//   break_models [--order 1|2] [--strictness FACTOR] [--seeds FIRST LAST] [--noise MM]... [--write
//   FOLDER] [KIND...]
// The tolerances are 0.001 mm, 0.01 degrees and 2 % of curvature, over the factor. One line for
// each kind and noise, then the reasons of what was not repaired. With --write the broken models
// are written instead. No KIND: all.
#include <BRepCheck_Analyzer.hxx>
#include <BRepTools.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <iostream>
#include <optional>

#include "repair_trials.hpp"

namespace {

using namespace seamwright;
using namespace seamwright::test;

struct Job {
  int order = 1;
  double strictness = 1;
  unsigned first = 1, last = 1;
  std::vector<double> noises_mm;
  std::vector<std::string> kinds;
  std::optional<std::string> folder;
};

Job jobOf(const std::vector<std::string>& words) {
  Job job;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto number = [&] { return std::stod(words.at(++i)); };
    if (words[i] == "--order")
      job.order = static_cast<int>(number());
    else if (words[i] == "--strictness")
      job.strictness = number();
    else if (words[i] == "--noise")
      job.noises_mm.push_back(number());
    else if (words[i] == "--write")
      job.folder = words.at(++i);
    else if (words[i] == "--seeds") {
      job.first = static_cast<unsigned>(number());
      job.last = static_cast<unsigned>(number());
    } else {
      job.kinds.push_back(netKind(words[i]).name);
    }
  }
  if (job.noises_mm.empty()) job.noises_mm = {0.001, 0.01, 0.1};
  if (job.kinds.empty())
    for (const NetKind& kind : netKinds()) job.kinds.push_back(kind.name);
  return job;
}

void write(const Job& job) {
  for (const std::string& kind : job.kinds)
    for (const double noise_mm : job.noises_mm)
      for (unsigned seed = job.first; seed <= job.last; ++seed) {
        const TopoDS_Shape shape = brokenModel({kind, noise_mm, seed});
        std::string name =
            kind + "_" + std::to_string(noise_mm) + "_" + std::to_string(seed) + ".brep";
        std::ranges::replace(name, ' ', '_');
        BRepTools::Write(shape, (*job.folder + "/" + name).c_str());
        std::cout << name << (BRepCheck_Analyzer(shape).IsValid() ? "" : " is not valid") << "\n";
      }
}

void count(const Job& job) {
  std::cout << tableHead() << "\n";
  RepairCounts all;
  for (const std::string& kind : job.kinds)
    for (const double noise_mm : job.noises_mm) {
      RepairCounts counts;
      for (unsigned seed = job.first; seed <= job.last; ++seed)
        counts += countsOf(RepairTrial{kind, noise_mm, seed, job.order, job.strictness});
      std::cout << tableLine(kind, noise_mm, counts) << std::endl;
      for (const auto& [why, times] : counts.reasons)
        std::cout << "    " << times << " x " << why << "\n";
      all += counts;
    }
  std::cout << all.repaired << " of " << all.treated << " seams, " << 100 * all.share() << " %\n";
}

}  // namespace

int main(int argc, char** argv) try {
  const Job job = jobOf({argv + 1, argv + argc});
  job.folder ? write(job) : count(job);
} catch (const Standard_Failure& failure) {
  std::cerr << failure << "\n";
  return 2;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
