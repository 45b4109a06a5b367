// SPDX-License-Identifier: LGPL-2.1-or-later
#include <CLI/CLI.hpp>
#include <functional>
#include <regex>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/plugin/cli/output.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <seamwright/plugin/cli/read_back.hpp>
#include <seamwright/plugin/cli/surface_command.hpp>
#include <seamwright/plugin/report/blend_surface_json.hpp>
#include <set>
#include <sstream>

namespace seamwright::cli {

namespace {

int orderOf(const std::string& level) {
  return static_cast<int>(*levelFromName(level)) - static_cast<int>(Level::G0);
}

occ::BlendEnd endOf(const SideArguments& side) {
  return {.side = {.edges = side.edges, .faces = side.faces},
          .order = orderOf(side.order),
          .tension = side.tension};
}

CLI::Option* addEdges(CLI::App& command, const std::string& option, SideArguments& side) {
  return addList(command, option, side.edges, "The side: an edge, or the edges of a chain",
                 numberOf("Edge"))
      ->type_name("N[,N...]")
      ->required();
}

void addFaces(CLI::App& command, const std::string& option, SideArguments& side) {
  addList(command, option, side.faces, "The faces to continue, for edges that bound two faces",
          numberOf("Face"))
      ->type_name("N[,N...]");
}

void addOrder(CLI::App& command, const std::string& option, SideArguments& side,
              const std::vector<std::string>& orders) {
  command.add_option(option, side.order, "How the surface joins the side")
      ->check(CLI::IsMember(orders))
      ->capture_default_str();
}

/// A part of what --lateral-order is given: an edge of a boundary, and its order.
const std::regex edge_and_order("(?:Edge)?([1-9][0-9]{0,8})=(G[0-2])");

std::string checkLateralOrder(const std::string& text) {
  static const std::regex one("G[0-2]");
  if (std::regex_match(text, one)) return "";
  std::istringstream parts(text);
  std::set<int> edges;
  std::smatch match;
  for (std::string part; std::getline(parts, part, ',');) {
    if (!std::regex_match(part, match, edge_and_order))
      return "'" + part + "' is neither G0, G1 or G2 nor EDGE=ORDER";
    if (!edges.insert(std::stoi(match[1])).second)
      return "edge " + match[1].str() + " has two orders";
  }
  return edges.empty() ? "an order is needed: G0, G1 or G2, or EDGE=ORDER,..." : "";
}

occ::LateralChoice lateralOf(const BlendSurfaceArguments& arguments) {
  occ::LateralChoice lateral{.edges = arguments.lateral.edges, .faces = arguments.lateral.faces};
  const std::string& order = arguments.lateral_order;
  if (order.find('=') == std::string::npos) {
    lateral.order = orderOf(order);
    return lateral;
  }
  for (std::sregex_iterator part(order.begin(), order.end(), edge_and_order), end; part != end;
       ++part)
    lateral.orders[std::stoi((*part)[1])] = orderOf((*part)[2]);
  return lateral;
}

void addLateral(CLI::App& command, BlendSurfaceArguments& arguments) {
  SideArguments& lateral = arguments.lateral;
  addList(
      command, "--lateral", lateral.edges,
      "Edges that the lateral boundaries run along: one or two chains, from an end of the start "
      "to an end of the end",
      numberOf("Edge"))
      ->type_name("N[,N...]");
  addList(command, "--lateral-faces", lateral.faces,
          "The faces beside lateral boundaries, for edges that bound two faces", numberOf("Face"))
      ->type_name("N[,N...]");
  command
      .add_option("--lateral-order", arguments.lateral_order,
                  "How the surface joins the faces beside lateral boundaries: G0, G1 or G2, or "
                  "of each boundary by one of its edges, as 8=G1,20=G2")
      ->type_name("ORDER|EDGE=ORDER[,EDGE=ORDER]")
      ->check(CLI::Validator(&checkLateralOrder, ""))
      ->capture_default_str();
}

void addModel(CLI::App& command, SurfaceArguments& arguments) {
  command
      .add_option("MODEL", arguments.model, "STEP, IGES or BREP file, recognised by its content")
      ->required();
}

void addCommonOptions(CLI::App& command, SurfaceArguments& arguments) {
  command.add_flag("--keep-anyway", arguments.keep_anyway,
                   "Write OUT even if the new seams fall short");
  addToleranceOptions(command, arguments.measure);
  addOutputOptions(command, "extended", arguments.output);
  exitStatus(command, "every seam of the new face has the level of its end, also in OUT",
             "some fall short (OUT is written only with --keep-anyway)");
}

/// Makes the surface, judges it and writes the model with it.
using Construction = std::function<occ::BlendSurfaceReport(
    const occ::Model& model, const occ::BlendSurfaceOptions& options, const occ::Progress&)>;

int run(const SurfaceArguments& arguments, const Construction& construct) {
  requireOutputs(arguments.model, arguments.output);
  const occ::Model model = readUnderBar(arguments.model);
  occ::BlendSurfaceOptions options;
  options.tolerance = toleranceOf(arguments.measure);
  const occ::BlendSurfaceReport blend = [&] {
    ProgressBar bar(doing("making a surface in", arguments.model));
    return construct(model, options, bar.progress());
  }();
  const occ::Model made = occ::modelFromShape(blend.shape);
  const report::Judge judge = report::judgeOf(blend, options.tolerance, made.faceCount());
  const report::ModelCounts memory = judge(made, {});
  const auto json = [&](const std::optional<report::WrittenModel>& output) {
    return report::toJson(blend, options.tolerance, occ::factsOf(model), output);
  };
  const bool kept = blend.reached || arguments.keep_anyway;
  const WrittenOutcome written =
      writeOutcome({kept ? &made : nullptr, judge, json, false, memory}, arguments.output);
  writeStandardOutput(report::toTable(blend, options.tolerance, memory, written.model));
  warn(arguments.model, model.notes);
  warnOf(written, arguments.output, memory);
  return blend.reached && written.model->isAsGoodAs(memory) ? 0 : 1;
}

}  // namespace

void addBlendSurfaceOptions(CLI::App& command, BlendSurfaceArguments& arguments) {
  addModel(command, arguments.surface);
  const auto add_side = [&](const std::string& name, SideArguments& side) {
    addEdges(command, "--" + name, side);
    addFaces(command, "--" + name + "-faces", side);
    addOrder(command, "--" + name + "-order", side, {"G0", "G1", "G2", "G3"});
    command
        .add_option("--" + name + "-tension", side.tension,
                    "How long the surface keeps its direction, a multiple of the distance between "
                    "the sides")
        ->type_name("FACTOR")
        ->check(numberIn(Range::Positive))
        ->capture_default_str();
  };
  add_side("start", arguments.start);
  add_side("end", arguments.end);
  command.add_flag("--flip", arguments.flip,
                   "The end runs in the other direction than that in which the surface is less "
                   "twisted");
  addLateral(command, arguments);
  addCommonOptions(command, arguments.surface);
}

void addExtendSurfaceOptions(CLI::App& command, ExtendSurfaceArguments& arguments) {
  addModel(command, arguments.surface);
  addEdges(command, "--edge", arguments.side);
  addFaces(command, "--faces", arguments.side);
  addOrder(command, "--order", arguments.side, {"G1", "G2", "G3"});
  CLI::Option_group& end = *command.add_option_group("End");
  end.add_option("--length", arguments.length_mm, "Length of the extension, mm")
      ->type_name("MM")
      ->check(numberIn(Range::Positive));
  end.add_option("--to", arguments.to_face, "Extend up to this face, which trims the extension")
      ->type_name("N")
      ->transform(numberOf("Face"));
  end.require_option(1);
  addCommonOptions(command, arguments.surface);
}

int runBlendSurface(const BlendSurfaceArguments& arguments) {
  return run(arguments.surface,
             [&](const occ::Model& model, const occ::BlendSurfaceOptions& options,
                 const occ::Progress& progress) {
               occ::BlendSurfaceOptions chosen = options;
               chosen.flip = arguments.flip;
               chosen.lateral = lateralOf(arguments);
               return occ::blendSurface(model.shape, endOf(arguments.start), endOf(arguments.end),
                                        chosen, progress);
             });
}

int runExtendSurface(const ExtendSurfaceArguments& arguments) {
  return run(
      arguments.surface, [&](const occ::Model& model, const occ::BlendSurfaceOptions& options,
                             const occ::Progress& progress) {
        const occ::BlendEnd side = endOf(arguments.side);
        return arguments.to_face > 0
                   ? occ::extendSurfaceTo(model.shape, side, arguments.to_face, options, progress)
                   : occ::extendSurface(model.shape, side, arguments.length_mm, options, progress);
      });
}

}  // namespace seamwright::cli
