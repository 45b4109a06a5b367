// SPDX-License-Identifier: LGPL-2.1-or-later
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

}  // namespace

ModelCounts countsOf(const occ::Report& report) {
  return {.edges = report.model.edges,
          .faces = report.model.faces,
          .open_edges = static_cast<int>(report.open.size()),
          .seams = static_cast<int>(report.seams.size()),
          .defects = summarize(report).defects};
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
  const bool renumbered = found.faces != memory.faces || found.edges != memory.edges;
  return "read back: " + listed(here) + "; the model in memory has " + listed(there) +
         (renumbered ? ": numbers of faces and edges differ" : "");
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
