// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <seamwright/occ_adapter/match/match_sides.hpp>
#include <seamwright/plugin/cli/match_command.hpp>
#include <seamwright/plugin/cli/output.hpp>
#include <seamwright/plugin/cli/progress_bar.hpp>
#include <seamwright/plugin/cli/read_back.hpp>
#include <seamwright/plugin/report/match_json.hpp>
#include <stdexcept>

namespace seamwright::cli {

namespace {

const std::map<std::string, occ::HeldEdges>& holds() {
  static const std::map<std::string, occ::HeldEdges> names = {
      {"none", occ::HeldEdges::None},
      {"position", occ::HeldEdges::Position},
      {"tangent", occ::HeldEdges::Tangent}};
  return names;
}

std::vector<std::string> divided(const std::string& text, char mark) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t at = 0; at != std::string::npos; from = at + 1) {
    at = text.find(mark, from);
    parts.push_back(text.substr(from, at == std::string::npos ? at : at - from));
  }
  return parts;
}

[[noreturn]] void refuse(const std::string& text) {
  throw std::invalid_argument("--side '" + text +
                              "': EDGE[,EDGE...][:NEIGHBOUR[,NEIGHBOUR...]][@FROM-TO] is needed, "
                              "for example 3,4:9@0.2-0.8");
}

std::vector<int> edgesOf(const std::string& list, const std::string& text) {
  std::vector<int> numbers;
  for (std::string one : divided(list, ',')) {
    one = CLI::detail::trim_copy(one);
    if (one.rfind("Edge", 0) == 0) one = one.substr(4);
    int number = 0;
    if (!CLI::detail::lexical_cast(one, number) || number < 1) refuse(text);
    numbers.push_back(number);
  }
  return numbers;
}

occ::SideMatch sideOf(const std::string& text, std::size_t index, std::size_t count, int order) {
  occ::SideMatch side;
  side.order = order;
  if (count > 1) side.side.name = fmt::format("side {}", index + 1);
  const std::vector<std::string> part = divided(text, '@');
  const std::vector<std::string> edges = divided(part[0], ':');
  if (part.size() > 2 || edges.size() > 2) refuse(text);
  side.side.edges = edgesOf(edges[0], text);
  if (edges.size() == 2) side.neighbours = edgesOf(edges[1], text);
  if (part.size() == 1) return side;
  const std::vector<std::string> ends = divided(part[1], '-');
  if (ends.size() != 2 || !CLI::detail::lexical_cast(ends[0], side.from) ||
      !CLI::detail::lexical_cast(ends[1], side.to))
    refuse(text);
  return side;
}

int orderOf(const std::string& target) {
  return static_cast<int>(*levelFromName(target)) - static_cast<int>(Level::G0);
}

occ::SideMatchOptions optionsOf(const MatchArguments& arguments) {
  occ::SideMatchOptions options;
  options.tolerance = toleranceOf(arguments.measure);
  options.depth_mm = arguments.depth_mm;
  options.hold = holds().at(arguments.hold);
  options.average = arguments.average;
  options.convert = arguments.convert;
  options.max_move_mm = arguments.max_move_mm.value_or(options.max_move_mm);
  options.match_mm = arguments.match_mm;
  options.fairness = arguments.fairness;
  options.jobs = arguments.measure.jobs;
  return options;
}

void addChangeOptions(CLI::App& command, MatchArguments& arguments) {
  command
      .add_option("--depth", arguments.depth_mm,
                  "How far from the sides the face may change, mm; default: as little as needed")
      ->type_name("MM")
      ->check(numberIn(Range::Positive));
  command.add_option("--hold", arguments.hold, "What the other edges of the face keep")
      ->check(CLI::IsMember({"none", "position", "tangent"}))
      ->capture_default_str();
  command.add_flag("--average", arguments.average,
                   "The neighbours move too: all meet in the mean of both sides");
  command.add_flag("--convert", arguments.convert,
                   "Faces without poles become splines if they have to move");
  command.add_option("--max-move", arguments.max_move_mm, "No pole moves further, mm")
      ->type_name("MM")
      ->check(numberIn(Range::NotNegative));
  command
      .add_option("--fairness", arguments.fairness,
                  "By what factor the variation of a moved face's curvature may grow")
      ->type_name("FACTOR")
      ->check(numberIn(Range::Positive))
      ->capture_default_str();
  command
      .add_option("--match", arguments.match_mm, "Free edges no further apart than this meet, mm")
      ->type_name("MM")
      ->check(numberIn(Range::Positive))
      ->capture_default_str();
}

}  // namespace

void addMatchOptions(CLI::App& command, MatchArguments& arguments) {
  command
      .add_option("MODEL", arguments.model, "STEP, IGES or BREP file, recognised by its content")
      ->required();
  command.add_option("--face", arguments.face, "The face that changes")
      ->type_name("N")
      ->transform(numberOf("Face"))
      ->required();
  command
      .add_option("--side", arguments.sides,
                  "A side of the face: an edge or a chain of edges; after ':' the edges that it "
                  "joins, if not all that it meets; after '@' the part of its length. Repeat the "
                  "option for other sides")
      ->type_name("N[,N...][:N,...][@FROM-TO]")
      ->take_all()
      ->required();
  command.add_option("--target", arguments.target, "What the sides have to be")
      ->check(CLI::IsMember({"G0", "G1", "G2"}))
      ->capture_default_str();
  addChangeOptions(command, arguments);
  addToleranceOptions(command, arguments.measure);
  addOutputOptions(command, "matched", arguments.output);
  exitStatus(command, "every seam of the sides has the target, also in OUT",
             "some fall short, or the face would be damaged (OUT is not written)");
}

int runMatch(const MatchArguments& arguments) {
  requireOutputs(arguments.model, arguments.output);
  const int order = orderOf(arguments.target);
  std::vector<occ::SideMatch> sides;
  for (std::size_t i = 0; i < arguments.sides.size(); ++i)
    sides.push_back(sideOf(arguments.sides[i], i, arguments.sides.size(), order));
  const occ::SideMatchOptions options = optionsOf(arguments);
  const occ::Model model = readUnderBar(arguments.model);
  const occ::SideMatchReport match = [&] {
    ProgressBar bar(doing("matching", arguments.model));
    return occ::matchSides(model.shape, arguments.face, sides, options, bar.progress());
  }();
  occ::Model made = model;
  made.shape = match.shape;
  const report::Judge judge = report::judgeOf(arguments.face, order, options);
  const report::ModelCounts memory = judge(made, {});
  const auto json = [&](const std::optional<report::WrittenModel>& output) {
    return report::toJson(match, arguments.face, options, occ::factsOf(model), output);
  };
  const WrittenOutcome written =
      writeOutcome({match.matched ? &made : nullptr, judge, json, match.moves.empty(), memory},
                   arguments.output);
  writeStandardOutput(report::toTable(match, options.tolerance, memory, written.model));
  warn(arguments.model, model.notes);
  warnOf(written, arguments.output, memory);
  return match.matched && written.model->isAsGoodAs(memory) ? 0 : 1;
}

}  // namespace seamwright::cli
