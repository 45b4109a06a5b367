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
#include <set>
#include <vector>

namespace seamwright::report {

namespace {

/// "1 defect, 57 edges" in the order of the counts.
std::string listed(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
  return text;
}

/// Says which numbers of faces and edges differ in the file, and names edges without length that a
/// reader added.
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

/// The figure that keeps a defect from the next level.
const std::optional<Figure>& missingFigure(const occ::SeamResult& seam) {
  switch (seam.verdict.level) {
    case Level::None:
      return seam.figures.gap_mm;
    case Level::G0:
      return seam.figures.angle_rad;
    default:
      return seam.figures.curvature_rel;
  }
}

/// Whether the level is lower, or the level is the same and the figure is certainly larger by more
/// than a tenth.
bool isWorse(const occ::SeamResult& seam, const occ::SeamResult& other) {
  constexpr double more = 1.1;
  if (seam.verdict.level != other.verdict.level) return seam.verdict.level < other.verdict.level;
  const auto &is = missingFigure(seam), &was = missingFigure(other);
  return is && was && was->upper && is->lower > more * *was->upper;
}

std::map<FacePair, std::vector<occ::SeamResult>> byFaces(
    const std::vector<occ::SeamResult>& seams) {
  std::map<FacePair, std::vector<occ::SeamResult>> sorted;
  for (const occ::SeamResult& seam : seams) sorted[facesOf(seam)].push_back(seam);
  for (auto& [faces, defects] : sorted)
    std::ranges::stable_sort(defects, [](const occ::SeamResult& a, const occ::SeamResult& b) {
      const auto lower = [](const occ::SeamResult& seam) {
        return missingFigure(seam) ? missingFigure(seam)->lower : 0;
      };
      return std::pair(a.verdict.level, -lower(a)) < std::pair(b.verdict.level, -lower(b));
    });
  return sorted;
}

/// Defects that are not known, or worse than the known ones. Between the same faces the worst
/// defect is compared with the worst known one, and so on. Edges cannot identify seams, because
/// reading may renumber them.
std::vector<occ::SeamResult> beyond(const std::vector<occ::SeamResult>& known,
                                    const std::vector<occ::SeamResult>& seams) {
  const auto known_by_faces = byFaces(known);
  std::vector<occ::SeamResult> found;
  for (const auto& [faces, defects] : byFaces(seams)) {
    const auto at = known_by_faces.find(faces);
    const std::size_t count = at == known_by_faces.end() ? 0 : at->second.size();
    for (std::size_t k = 0; k < defects.size(); ++k)
      if (k >= count || isWorse(defects[k], at->second[k])) found.push_back(defects[k]);
  }
  return found;
}

/// Whether faces have the same numbers in the file: their number is the same, and 90 % of the pairs
/// of neighbours are.
bool hasSameFaces(const ModelCounts& file, const ModelCounts& memory) {
  // A choice: a repair may change a few neighbours, a new numbering changes most.
  constexpr double nearly_all = 0.9;
  if (file.faces != memory.faces) return false;
  const auto same = std::ranges::count_if(memory.neighbours, [&file](const FacePair& faces) {
    return file.neighbours.contains(faces);
  });
  return static_cast<double>(same) >= nearly_all * static_cast<double>(memory.neighbours.size());
}

std::vector<occ::SeamResult> onlyInFile(const ModelCounts& file, const ModelCounts& memory) {
  if (!hasSameFaces(file, memory)) return {};
  return beyond(memory.defect_seams, file.defect_seams);
}

std::string namesOf(const std::vector<occ::SeamResult>& seams) {
  // A choice: a note of some lines.
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

std::set<FacePair> neighboursOf(const occ::Report& report) {
  std::set<FacePair> neighbours;
  for (const occ::SeamResult& seam : report.seams)
    if (seam.kind != occ::SeamKind::Matched) neighbours.insert(facesOf(seam));
  return neighbours;
}

/// Thrown to keep a file from replacing its target.
struct Refused : std::exception {};

/// Writes one model until its file is good enough.
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
    // Of the accuracy that the file states: readers join what is nearer than that.
    constexpr double tenth = 0.1;
    const bool has_choice = occ::targetFormat(target_) == occ::Format::Step && !how_.unchanged;
    if (!has_choice) return written(1, false);
    if (tryWriting(1)) return std::move(*file_);
    const WrittenModel first = last_;
    if (tryWriting(tenth)) return noted(std::move(*file_));
    const bool is_better = last_.found.defects < first.found.defects &&
                           last_.found.open_edges <= first.found.open_edges;
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
      if (only_if_good && !(last_.only_in_file.empty() && last_.isAsGoodAs(judge_.memory)))
        throw Refused();
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
    found.worse = worseThanGiven(found);
    return found;
  }

  ModelCounts countsIn(const std::filesystem::path& waiting) const {
    constexpr double read = 0.5;  // of the progress bar
    try {
      const occ::Model model =
          occ::readModel(waiting.string(), occ::partOf(progress_.checking, 0, read));
      return judge_.count(model, occ::partOf(progress_.checking, read, 1));
    } catch (const occ::ModelError& error) {
      throw occ::ModelError(
          occ::ModelErrc::NotWritten, target_.string(),
          std::string("can't be read back, so it is not written: ") + error.what());
    }
  }

  /// Writes the model before the change, counts the defects in that file and discards it.
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
      given_in_file_ = found.defect_seams;
    }
  }

  /// Those seams of \p written.only_in_file that are also worse than in the given model, in memory
  /// and in its file.
  std::vector<occ::SeamResult> worseThanGiven(const WrittenModel& written) const {
    const auto edgesOf = [](const std::vector<occ::SeamResult>& seams) {
      std::set<std::vector<int>> edges;
      for (const occ::SeamResult& seam : seams) edges.insert(seam.edges);
      return edges;
    };
    const auto than_given = edgesOf(beyond(given_, written.found.defect_seams)),
               than_its_file = edgesOf(beyond(given_in_file_, written.found.defect_seams));
    std::vector<occ::SeamResult> worse = written.only_in_file;
    std::erase_if(worse, [&](const occ::SeamResult& seam) {
      return !than_given.contains(seam.edges) || !than_its_file.contains(seam.edges);
    });
    return worse;
  }

  int countSpoilt(const std::vector<occ::SeamResult>& seams) const {
    const auto isSpoilt = [this](const occ::SeamResult& seam) {
      return std::ranges::any_of(
          *spoilt_, [&seam](const occ::SeamResult& other) { return other.faces == seam.faces; });
    };
    return static_cast<int>(std::ranges::count_if(seams, isSpoilt));
  }

  static JudgedFile noted(JudgedFile file) {
    file.report.notes.push_back(
        "states a tenth of the accuracy that its source states: readers join what is nearer than "
        "the stated "
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
  WrittenModel last_;  ///< the file that was read back last
  std::optional<JudgedFile> file_;
  std::optional<std::vector<occ::SeamResult>>
      spoilt_;  ///< defects that writing causes in the model before the change
  std::vector<occ::SeamResult> given_, given_in_file_;  ///< defects of the model before the change
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
          .defect_seams = defectSeamsOf(report),
          .neighbours = neighboursOf(report)};
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
  compare(&ModelCounts::open_edges, "free edge");
  compare(&ModelCounts::seams, "seam");
  std::string text;
  if (!here.empty())
    text = "read back: " + listed(here) + "; the model in memory has " + listed(there) +
           renumbering(found, memory);
  if (found.faces == memory.faces && !hasSameFaces(found, memory))
    text +=
        (text.empty() ? "read back: " : "; ") + std::string("numbers of faces and edges differ");
  if (only_in_file.empty()) return text;
  text += (text.empty() ? "read back: " : "; ") + std::string("defects in the file alone: ") +
          namesOf(only_in_file);
  if (spoilt_by_writing && *spoilt_by_writing > 0)
    text += "; writing spoils " + std::to_string(*spoilt_by_writing) +
            " of them in the unchanged model too";
  return text;
}

JudgedFile writeJudged(const occ::Model& model, const std::filesystem::path& target,
                       occ::WriteOptions how, const FileJudge& judge, const FileProgress& progress,
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
          {"spoilt_by_writing",
           spoilt ? nlohmann::ordered_json(*spoilt) : nlohmann::ordered_json(nullptr)}};
}

}  // namespace seamwright::report
