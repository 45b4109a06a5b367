// SPDX-License-Identifier: LGPL-2.1-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/plugin/cli/corner_command.hpp>
#include <seamwright/plugin/cli/output.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <seamwright/plugin/cli/read_back.hpp>
#include <seamwright/plugin/report/corner_json.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

/// The edges at the vertex, counter-clockwise seen from outside, starting with the smallest number.
std::vector<int> edgesOf(const occ::Model& model, int vertex) {
  std::vector<int> edges = occ::cornerEdges(model, vertex);
  std::rotate(edges.begin(), std::ranges::min_element(edges), edges.end());
  return edges;
}

/// One length for all edges, or one for each edge.
std::map<int, double> byEdge(const std::string& option, const std::vector<double>& lengths_mm,
                             const std::vector<int>& edges) {
  std::map<int, double> result;
  if (lengths_mm.empty()) return result;
  if (lengths_mm.size() != 1 && lengths_mm.size() != edges.size()) {
    std::string names;
    for (const int edge : edges)
      names += (names.empty() ? "Edge" : ", Edge") + std::to_string(edge);
    throw std::runtime_error(option + " has " + std::to_string(lengths_mm.size()) +
                             " lengths: one for all edges is needed, or one for each of " + names +
                             ", in this order");
  }
  for (std::size_t k = 0; k < edges.size(); ++k)
    result[edges[k]] = lengths_mm[lengths_mm.size() == 1 ? 0 : k];
  return result;
}

occ::CornerFilletOptions optionsOf(const CornerArguments& arguments,
                                   const std::vector<int>& edges) {
  occ::CornerFilletOptions options;
  options.radii_mm = byEdge("--radius", arguments.radii_mm, edges);
  options.setbacks_mm = byEdge("--setback", arguments.setbacks_mm, edges);
  options.patches_only = arguments.patches_only;
  options.tolerance = toleranceOf(arguments.measure);
  options.tolerance.crease_rad =
      std::max(options.tolerance.crease_rad, options.tolerance.angle_rad);
  options.jobs = arguments.measure.jobs;
  options.validate();
  return options;
}

occ::CornerFillet rounded(const occ::Model& model, const CornerArguments& arguments,
                          const occ::CornerFilletOptions& options) {
  ProgressBar bar(doing("rounding", arguments.model));
  return occ::cornerFillet(model, arguments.vertex, options, bar.progress());
}

void addLengths(CLI::App& command, const std::string& name, std::vector<double>& lengths_mm,
                const std::string& help, Range range, bool required) {
  addList(command, name, lengths_mm, help, numberIn(range))
      ->type_name("MM[,MM...]")
      ->required(required);
}

}  // namespace

void addCornerOptions(CLI::App& command, CornerArguments& arguments) {
  command
      .add_option("MODEL", arguments.model, "STEP, IGES or BREP file, recognised by its content")
      ->required();
  command.add_option("--vertex", arguments.vertex, "Number of the vertex, as 6 or Vertex6")
      ->type_name("N")
      ->required()
      ->transform(numberOf("Vertex"));
  addLengths(
      command, "--radius", arguments.radii_mm,
      "One radius for all edges at the vertex, or one for each edge, counter-clockwise as seen "
      "from outside, starting with the edge that has the smallest number",
      Range::Positive, true);
  addLengths(
      command, "--setback", arguments.setbacks_mm,
      "Distance from the vertex, along the edges, at which the fillets end: one for all edges "
      "or one for each, as for --radius; 0 or not given: chosen by the program",
      Range::NotNegative, false);
  command.add_flag(
      "--patches-only", arguments.patches_only,
      "Refuse corners that patches can't fill, instead of filling them by OpenCASCADE");
  command.add_flag("--keep-anyway", arguments.keep_anyway,
                   "Write OUT even if the new seams fall short");
  addG1Options(command, arguments.measure);
  addOutputOptions(command, "rounded", arguments.output);
  exitStatus(command, "the new seams meet the tolerances, also in OUT",
             "some fall short (OUT is written only with --keep-anyway)");
}

int runCorner(const CornerArguments& arguments) {
  requireOutputs(arguments.model, arguments.output);
  const occ::Model model = readUnderBar(arguments.model);
  const occ::CornerFilletOptions options = optionsOf(arguments, edgesOf(model, arguments.vertex));
  const occ::CornerFillet fillet = rounded(model, arguments, options);
  const report::Judge judge = report::judgeOf(fillet, options);
  const auto json = [&](const std::optional<report::WrittenModel>& output) {
    return report::toJson(fillet, options.tolerance, arguments.vertex, occ::factsOf(model), output);
  };
  const bool kept = fillet.met() || arguments.keep_anyway;
  const report::ModelCounts memory = judge(fillet.model, {});
  const WrittenOutcome written =
      writeOutcome({kept ? &fillet.model : nullptr, judge, json, false, memory}, arguments.output);
  writeStandardOutput(report::toTable(fillet, memory, written.model));
  warn(arguments.model, model.notes);
  warnOf(written, arguments.output, memory);
  return fillet.met() && written.model->isAsGoodAs(memory) ? 0 : 1;
}

}  // namespace seamwright::cli
