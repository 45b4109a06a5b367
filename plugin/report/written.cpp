// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <exception>
#include <iterator>
#include <map>
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

std::map<FacePair, int> defectsBetween(const std::vector<occ::SeamResult>& seams) {
  std::map<FacePair, int> counts;
  for (const occ::SeamResult& seam : seams) ++counts[facesOf(seam)];
  return counts;
}

/// Defects beyond those that are known. Between the same faces seams are told apart by their edges no more: reading may number them anew.
std::vector<occ::SeamResult> beyond(std::map<FacePair, int> known,
                                    const std::vector<occ::SeamResult>& seams) {
  std::vector<occ::SeamResult> found;
  for (const occ::SeamResult& seam : seams)
    if (--known[facesOf(seam)] < 0) found.push_back(seam);
  return found;
}

std::vector<occ::SeamResult> onlyInFile(const ModelCounts& file, const ModelCounts& memory) {
  if (file.faces != memory.faces) return {};
  return beyond(defectsBetween(memory.defect_seams), file.defect_seams);
}

std::string namesOf(const std::vector<occ::SeamResult>& seams) {
  constexpr std::size_t most = 8;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < std::min(most, seams.size()); ++k)
    names.push_back(edgesText(seams[k]) + " (faces " + facesText(seams[k]) + ")");
  if (seams.size() > most) names.push_back(std::to_string(seams.size() - most) + " more");
  return listed(names);
}

std::vector<occ::SeamResult> defectSeamsOf(const occ::Report& report) {
  std::vector<occ::SeamResult> defects;
  std::ranges::copy_if(report.seams, std::back_inserter(defects), [](const occ::SeamResult& seam) {
    return seam.verdict.seam_class == SeamClass::Defect;
  });
  return defects;
}

/// A file that does not take its place.
struct Refused : std::exception {};

/// Writing of one model until its file is good enough.
class JudgedWriting {
 public:
  JudgedWriting(const occ::Model& model, const std::filesystem::path& target, occ::WriteOptions how,
                const FileJudge& judge, const FileProgress& progress,
                const std::function<void(const WrittenModel&)>& accepted)
      : model_(model),
        target_(target),
        how_(std::move(how)),
        judge_(judge),
        progress_(progress),
        accepted_(accepted) {}

  JudgedFile run() {
    constexpr double tenth = 0.1;
    const bool has_choice = occ::targetFormat(target_) == occ::Format::Step && !how_.unchanged;
    if (!has_choice) return written(1, false);
    if (tryWriting(1)) return std::move(*file_);
    const WrittenModel first = last_;
    if (tryWriting(tenth)) return noted(std::move(*file_));
    const bool is_better =
        last_.found.defects < first.found.defects && last_.found.open_edges <= first.found.open_edges;
    lookWhatWritingSpoils();
    return is_better ? noted(written(tenth, false)) : written(1, false);
  }

 private:
  bool tryWriting(double share) {
    try {
      file_ = written(share, true);
    } catch (const Refused&) {
      return false;
    }
    return true;
  }

  JudgedFile written(double share, bool only_if_good) {
    how_.share_of_accuracy = share;
    how_.check = [&](const std::filesystem::path& waiting) {
      last_ = readBack(waiting);
      if (only_if_good && !(last_.only_in_file.empty() && last_.isAsGoodAs(judge_.memory))) throw Refused();
      if (accepted_) accepted_(last_);
    };
    const occ::WriteReport report = occ::writeModel(model_, target_, how_, progress_.writing);
    return {report, last_};
  }

  WrittenModel readBack(const std::filesystem::path& waiting) const {
    WrittenModel found{target_, occ::targetFormat(target_), countsIn(waiting), {}, {}, {}};
    found.only_in_file = onlyInFile(found.found, judge_.memory);
    if (found.only_in_file.empty() || !spoilt_) return found;
    found.spoilt_by_writing = countSpoilt(found.only_in_file);
    found.worse = worseThanGiven(found.only_in_file);
    return found;
  }

  ModelCounts countsIn(const std::filesystem::path& waiting) const {
    constexpr double read = 0.5;
    try {
      const occ::Model model = occ::readModel(waiting.string(), occ::partOf(progress_.checking, 0, read));
      return judge_.count(model, occ::partOf(progress_.checking, read, 1));
    } catch (const occ::ModelError& error) {
      throw occ::ModelError(occ::ModelErrc::NotWritten, target_.string(),
                            std::string("can't be read back, so it is not written: ") + error.what());
    }
  }

  /// Writes the model before the change, looks, and leaves nothing of it.
  void lookWhatWritingSpoils() {
    if (judge_.given == nullptr || last_.only_in_file.empty()) return;
    occ::WriteOptions how = how_;
    how.share_of_accuracy = 1;
    ModelCounts found;
    how.check = [&](const std::filesystem::path& waiting) {
      found = countsIn(waiting);
      throw Refused();
    };
    try {
      occ::writeModel(*judge_.given, target_, how, progress_.writing);
    } catch (const Refused&) {
      const ModelCounts given = judge_.count(*judge_.given, progress_.checking);
      spoilt_ = onlyInFile(found, given);
      given_ = given.defect_seams;
    }
  }

  /// Of seams that are defects in the file alone.
  std::vector<occ::SeamResult> worseThanGiven(const std::vector<occ::SeamResult>& only_in_file) const {
    std::map<FacePair, int> known = defectsBetween(given_);
    for (const auto& [faces, count] : defectsBetween(judge_.memory.defect_seams)) known[faces] -= count;
    for (auto& [faces, count] : known) count = std::max(count, 0);
    for (const auto& [faces, count] : defectsBetween(*spoilt_)) known[faces] += count;
    return beyond(std::move(known), only_in_file);
  }

  int countSpoilt(const std::vector<occ::SeamResult>& seams) const {
    const auto isSpoilt = [this](const occ::SeamResult& seam) {
      return std::ranges::any_of(*spoilt_,
                                 [&seam](const occ::SeamResult& other) { return other.faces == seam.faces; });
    };
    return static_cast<int>(std::ranges::count_if(seams, isSpoilt));
  }

  static JudgedFile noted(JudgedFile file) {
    file.report.notes.push_back(
        "states a tenth of the accuracy that its source states: readers join what is nearer than the stated "
        "accuracy, "
        "which would spoil seams");
    return file;
  }

  const occ::Model& model_;
  const std::filesystem::path& target_;
  occ::WriteOptions how_;
  const FileJudge& judge_;
  const FileProgress& progress_;
  const std::function<void(const WrittenModel&)>& accepted_;
  WrittenModel last_;  ///< what was read back last
  std::optional<JudgedFile> file_;
  std::optional<std::vector<occ::SeamResult>> spoilt_;  ///< what writing the model before the change spoils
  std::vector<occ::SeamResult> given_;                  ///< defects of the model before the change
};

}  // namespace

FacePair facesOf(const occ::SeamResult& seam) {
  return std::minmax(seam.faces[0], seam.faces[1]);
}

ModelCounts countsOf(const occ::Report& report, const occ::Model& model) {
  return {.edges = report.model.edges,
          .faces = report.model.faces,
          .open_edges = static_cast<int>(report.open.size()),
          .seams = static_cast<int>(report.seams.size()),
          .defects = summarize(report).defects,
          .without_length = occ::degenerateEdges(model),
          .defect_seams = defectSeamsOf(report)};
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
  std::string text;
  if (!here.empty())
    text = "read back: " + listed(here) + "; the model in memory has " + listed(there) +
           renumbering(found, memory);
  if (only_in_file.empty()) return text;
  text += (text.empty() ? "read back: " : "; ") + std::string("defects in the file alone: ") +
          namesOf(only_in_file);
  if (spoilt_by_writing && *spoilt_by_writing > 0)
    text += "; writing spoils " + std::to_string(*spoilt_by_writing) + " of them in the unchanged model too";
  return text;
}

JudgedFile writeJudged(const occ::Model& model, const std::filesystem::path& target, occ::WriteOptions how,
                       const FileJudge& judge, const FileProgress& progress,
                       const std::function<void(const WrittenModel&)>& accepted) {
  return JudgedWriting(model, target, std::move(how), judge, progress, accepted).run();
}

nlohmann::ordered_json toJson(const std::optional<WrittenModel>& written) {
  if (!written) return nullptr;
  nlohmann::ordered_json only_in_file = nlohmann::ordered_json::array();
  for (const occ::SeamResult& seam : written->only_in_file)
    only_in_file.push_back({{"edges", seam.edges}, {"faces", seam.faces}});
  const auto& spoilt = written->spoilt_by_writing;
  return {{"path", written->path.string()},
          {"format", name(written->format)},
          {"edges", written->found.edges},
          {"faces", written->found.faces},
          {"open_edges", written->found.open_edges},
          {"defects", written->found.defects},
          {"only_in_file", std::move(only_in_file)},
          {"spoilt_by_writing", spoilt ? nlohmann::ordered_json(*spoilt) : nlohmann::ordered_json(nullptr)}};
}

}  // namespace seamwright::report
