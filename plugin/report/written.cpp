// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <seamwright/occ_adapter/model/degenerate_edges.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/plugin/report/numbers.hpp>
#include <seamwright/plugin/report/text.hpp>
#include <seamwright/plugin/report/written.hpp>
#include <vector>

namespace seamwright::report {

namespace {

/// "1 defect, 57 edges" in the order of the counts.
std::string listed(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
  return text;
}

/// Which numbers of faces and edges are others in the file. Edges without length that a reader adds are named.
std::string renumbering(const ModelCounts& file, const ModelCounts& memory) {
  if (file.faces == memory.faces && file.edges == memory.edges) return {};
  const std::vector<int>&now = file.without_length, &before = memory.without_length;
  const bool only_added = file.faces == memory.faces && now.size() > before.size() &&
                          file.edges - memory.edges == std::ssize(now) - std::ssize(before);
  if (!only_added) return ": numbers of faces and edges differ";
  const std::size_t count = now.size() - before.size();
  const int first = *std::ranges::mismatch(now, before).in1;
  return ": " + counted(count, "edge") + " without length " + (count == 1 ? "was" : "were") +
         " added by reading; numbers of edges differ from Edge" + std::to_string(first) + " on";
}

}  // namespace

ModelCounts countsOf(const occ::Report& report, const occ::Model& model) {
  return {.edges = report.model.edges,
          .faces = report.model.faces,
          .open_edges = static_cast<int>(report.open.size()),
          .seams = static_cast<int>(report.seams.size()),
          .defects = summarize(report).defects,
          .without_length = occ::degenerateEdges(model)};
}

std::string WrittenModel::differences(const ModelCounts& memory) const {
  std::vector<std::string> here, there;
  const auto compare = [&](int ModelCounts::*count, const char* noun) {
    if (found.*count == memory.*count) return;
    here.push_back(counted(static_cast<std::size_t>(found.*count), noun));
    there.push_back(std::to_string(memory.*count));
  };
  compare(&ModelCounts::defects, "defect");
  compare(&ModelCounts::faces, "face");
  compare(&ModelCounts::edges, "edge");
  compare(&ModelCounts::open_edges, "open edge");
  compare(&ModelCounts::seams, "seam");
  if (here.empty()) return {};
  return "read back: " + listed(here) + "; the model in memory has " + listed(there) +
         renumbering(found, memory);
}

WrittenModel readBack(const std::filesystem::path& waiting, const std::filesystem::path& output,
                      const Judge& judge, const occ::Progress& progress) {
  constexpr double read = 0.5;
  try {
    const occ::Model model = occ::readModel(waiting.string(), occ::partOf(progress, 0, read));
    return {output, occ::targetFormat(output), judge(model, occ::partOf(progress, read, 1))};
  } catch (const occ::ModelError& error) {
    throw occ::ModelError(occ::ModelErrc::NotWritten, output.string(),
                          std::string("can't be read back, so it is not written: ") + error.what());
  }
}

nlohmann::ordered_json toJson(const std::optional<WrittenModel>& written) {
  if (!written) return nullptr;
  return {{"path", written->path.string()},          {"format", name(written->format)},
          {"edges", written->found.edges},           {"faces", written->found.faces},
          {"open_edges", written->found.open_edges}, {"defects", written->found.defects}};
}

}  // namespace seamwright::report
