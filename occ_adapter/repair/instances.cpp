// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Builder.hxx>
#include <TopExp.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Iterator.hxx>
#include <algorithm>
#include <map>
#include <set>

#include <seamwright/occ_adapter/repair/choose.hpp>
#include <seamwright/occ_adapter/repair/instances.hpp>
#include <seamwright/occ_adapter/repair/reasons.hpp>
#include <seamwright/occ_adapter/topology/own_parts.hpp>

namespace seamwright::occ {

namespace {

/// All instances of a part, in the order of the model.
using PartInstances = std::vector<TopoDS_Shape>;

class RepeatedParts {
 public:
  explicit RepeatedParts(const TopoDS_Shape& shape) {
    addInstances(shape);
    addParents(shape);
    choose(shape);
  }

  const std::map<const TopoDS_TShape*, PartInstances>& parts() const { return chosen_; }

 private:
  void addInstances(const TopoDS_Shape& shape) {
    PartInstances& instances = instances_[shape.TShape().get()];
    const bool is_known = std::ranges::any_of(
        instances, [&shape](const TopoDS_Shape& instance) { return instance.IsSame(shape); });
    if (!is_known) instances.push_back(shape);
    if (shape.ShapeType() != TopAbs_COMPOUND) return;
    for (TopoDS_Iterator it(shape, false, true); it.More(); it.Next()) addInstances(it.Value());
  }

  void addParents(const TopoDS_Shape& shape) {
    if (!seen_.insert(shape.TShape().get()).second) return;
    for (TopoDS_Iterator it(shape); it.More(); it.Next()) {
      parents_[it.Value().TShape().get()].insert(shape.TShape().get());
      addParents(it.Value());
    }
  }

  /// Whether the part shares none of its faces, edges or vertices with anything else.
  bool isSelfContained(const TopoDS_Shape& part) const {
    const std::map<const TopoDS_TShape*, int> inside = instancesIn(part);
    return std::ranges::all_of(inside, [&](const auto& inner) {
      return inner.first == part.TShape().get() ||
             std::ranges::all_of(parents_.at(inner.first), [&inside](const TopoDS_TShape* parent) {
               return inside.contains(parent);
             });
    });
  }

  /// Chooses the smallest self-contained parts. \returns whether the shape contains one.
  bool choose(const TopoDS_Shape& shape) {
    bool has_one = false;
    if (shape.ShapeType() == TopAbs_COMPOUND)
      for (TopoDS_Iterator it(shape, false, true); it.More(); it.Next())
        has_one = choose(it.Value()) || has_one;
    const PartInstances& instances = instances_.at(shape.TShape().get());
    if (has_one || instances.size() < 2) return has_one;
    if (!isSelfContained(instances.front())) return false;
    chosen_.emplace(shape.TShape().get(), instances);
    return true;
  }

  std::map<const TopoDS_TShape*, PartInstances> instances_, chosen_;
  std::map<const TopoDS_TShape*, std::set<const TopoDS_TShape*>> parents_;
  std::set<const TopoDS_TShape*> seen_;
};

TopoDS_Shape withoutLocation(const TopoDS_Shape& shape) {
  return shape.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
}

TopoDS_Shape placedAs(const TopoDS_Shape& instance, const TopoDS_Shape& part) {
  return part.Located(instance.Location()).Oriented(instance.Orientation());
}

/// Replaces parts of an assembly. Rebuilt compounds keep their locations; unchanged ones are
/// shared.
/// \param part the new part, with its location, for a part of the assembly; null: look inside it.
template <class Part>
TopoDS_Shape withParts(const TopoDS_Shape& shape, const Part& part) {
  if (const TopoDS_Shape now = part(shape); !now.IsNull()) return now;
  if (shape.ShapeType() != TopAbs_COMPOUND) return shape;
  TopTools_ListOfShape children;
  bool is_new = false;
  for (TopoDS_Iterator it(shape, false, true); it.More(); it.Next()) {
    children.Append(withParts(it.Value(), part));
    is_new = is_new || !children.Last().IsPartner(it.Value());
  }
  if (!is_new) return shape;
  TopoDS_Shape copy = shape.Oriented(TopAbs_FORWARD).EmptyCopied();
  const BRep_Builder builder;
  for (const TopoDS_Shape& child : children) builder.Add(copy, child);
  return copy.Oriented(shape.Orientation());
}

/// Maps the numbers of faces or edges between the first instance of a part and the others.
class InstanceNumbers {
 public:
  InstanceNumbers(const TopoDS_Shape& shape,
                  const std::map<const TopoDS_TShape*, PartInstances>& parts,
                  TopAbs_ShapeEnum kind) {
    TopTools_IndexedMapOfShape all;
    TopExp::MapShapes(shape, kind, all);
    for (const auto& [part, instances] : parts) {
      std::vector<std::vector<int>> numbers;
      for (const TopoDS_Shape& instance : instances) {
        TopTools_IndexedMapOfShape own;
        TopExp::MapShapes(instance, kind, own);
        numbers.emplace_back();
        for (int i = 1; i <= own.Extent(); ++i) numbers.back().push_back(all.FindIndex(own(i)));
      }
      for (const std::vector<int>& of_instance : numbers)
        for (std::size_t i = 0; i < of_instance.size(); ++i)
          first_[of_instance[i]] = numbers.front()[i];
    }
    for (const auto& [number, first] : first_)
      if (number != first) others_[first].push_back(number);
  }

  /// The number in the first instance; the number itself if it has no instances or is the first.
  int first(int number) const {
    const auto found = first_.find(number);
    return found == first_.end() ? number : found->second;
  }
  std::vector<int> firsts(std::vector<int> numbers) const {
    for (int& number : numbers) number = first(number);
    return numbers;
  }
  bool isRepeat(int number) const { return first(number) != number; }
  /// The numbers in the other instances, by the number in the first one.
  std::vector<int> others(int number) const {
    const auto found = others_.find(number);
    return found == others_.end() ? std::vector<int>{} : found->second;
  }
  std::vector<int> repeats() const {
    std::vector<int> numbers;
    for (const auto& [first, others] : others_)
      numbers.insert(numbers.end(), others.begin(), others.end());
    return numbers;
  }

 private:
  std::map<int, int> first_;
  std::map<int, std::vector<int>> others_;
};

class RepairingOnce {
 public:
  RepairingOnce(const Model& model, const RepairOptions& options,
                const std::map<const TopoDS_TShape*, PartInstances>& parts)
      : model_(model),
        options_(options),
        parts_(parts),
        faces_(model.shape, parts, TopAbs_FACE),
        edges_(model.shape, parts, TopAbs_EDGE) {}

  RepairReport run(const PlainRepair& repair, const Progress& progress) {
    RepairReport report = repair(prepared(), once(), partOf(progress, 0, share_of_repair));
    report.model.shape = everywhere(report.model.shape);
    if (!report.model.shape.IsEqual(model_.shape))
      report.after =
          analyze(report.model, analyzeOptions(options_), partOf(progress, share_of_repair, 1));
    tellSeams(report);
    tellMoves(report);
    return report;
  }

 private:
  /// Of the progress; the rest is the analysis of all instances.
  static constexpr double share_of_repair = 0.9;

  /// The model in which the first instance of each part is an independent copy. All numbers stay.
  Model prepared() {
    Model model = model_;
    model.shape = withParts(model_.shape, [this](const TopoDS_Shape& instance) -> TopoDS_Shape {
      const auto part = parts_.find(instance.TShape().get());
      if (part == parts_.end() || !instance.IsSame(part->second.front())) return {};
      TopoDS_Shape& own = own_[part->first];
      if (own.IsNull()) own = ownCopyOf(withoutLocation(instance));
      return placedAs(instance, own);
    });
    return model;
  }

  RepairOptions once() const {
    RepairOptions options = options_;
    options.edges = edges_.firsts(options.edges);
    options.fixed_faces = faces_.firsts(options.fixed_faces);
    options.held_faces = faces_.firsts(options.held_faces);
    for (const int face : faces_.repeats()) options.fixed_faces.push_back(face);
    return options;
  }

  /// Gives all other instances the change of the first one. Unchanged parts are shared.
  TopoDS_Shape everywhere(const TopoDS_Shape& repaired) {
    std::map<const TopoDS_TShape*, TopoDS_Shape> now;
    addParts(model_.shape, repaired, now);
    return withParts(model_.shape, [&now](const TopoDS_Shape& instance) -> TopoDS_Shape {
      const auto part = now.find(instance.TShape().get());
      return part == now.end() ? TopoDS_Shape() : placedAs(instance, part->second);
    });
  }

  /// Collects the new parts by the old ones.
  void addParts(const TopoDS_Shape& shape, const TopoDS_Shape& repaired,
                std::map<const TopoDS_TShape*, TopoDS_Shape>& now) const {
    const TopoDS_TShape* part = shape.TShape().get();
    if (now.contains(part)) return;
    if (const auto own = own_.find(part); own != own_.end()) {
      now[part] = withoutLocation(repaired.IsPartner(own->second) ? shape : repaired);
    } else if (shape.ShapeType() != TopAbs_COMPOUND) {
      now[part] = withoutLocation(repaired);
    } else {
      TopoDS_Iterator of_repaired(repaired, false, true);
      for (TopoDS_Iterator it(shape, false, true); it.More(); it.Next(), of_repaired.Next())
        addParts(it.Value(), of_repaired.Value(), now);
    }
  }

  void tellSeams(RepairReport& report) const {
    std::map<int, std::size_t> seam_of_edge;
    for (std::size_t i = 0; i < report.seams.size(); ++i)
      for (const int edge : report.seams[i].before.edges) seam_of_edge[edge] = i;
    for (std::size_t i = 0; i < report.seams.size(); ++i) {
      SeamRepair& seam = report.seams[i];
      seam.after = report.after.seams[i];
      const int edge = seam.before.edges.front(), first = edges_.first(edge);
      if (first == edge) continue;
      const SeamRepair& of_first = report.seams[seam_of_edge.at(first)];
      seam.treated = of_first.treated;
      seam.wants_conversion = of_first.wants_conversion;
      if (!of_first.reason.empty()) seam.reason = why::ofInstance(first, of_first.reason);
      if (!of_first.repaired) continue;
      seam.repaired = isAsGood(seam.after.verdict, of_first.after.verdict);
      seam.reason =
          seam.repaired ? RepairReason() : why::ofInstance(first, why::instanceLessCertain());
    }
  }

  /// Whether the verdict is as good as that of the first instance, as far as the target asks. The
  /// same seam may be less certain where coordinates are large.
  bool isAsGood(const Verdict& verdict, const Verdict& of_first) const {
    return verdict.seam_class == of_first.seam_class &&
           verdict.level >= std::min(of_first.level, options_.level());
  }

  void tellMoves(RepairReport& report) const {
    addInstances(report.moves, faces_, &FaceMove::face);
    addInstances(report.converted, faces_, &FaceConversion::face);
    addInstances(report.edge_moves, edges_, &EdgeMove::edge);
  }

  template <class What>
  static void addInstances(std::vector<What>& reported, const InstanceNumbers& numbers,
                           int What::*number) {
    const std::size_t count = reported.size();
    for (std::size_t i = 0; i < count; ++i)
      for (const int other : numbers.others(reported[i].*number)) {
        reported.push_back(reported[i]);
        reported.back().*number = other;
      }
    std::ranges::sort(reported, {}, number);
  }

  const Model& model_;
  const RepairOptions& options_;
  const std::map<const TopoDS_TShape*, PartInstances>& parts_;
  const InstanceNumbers faces_, edges_;
  /// Copies for the first instances, without location.
  std::map<const TopoDS_TShape*, TopoDS_Shape> own_;
};

}  // namespace

RepairReport repairInstances(const Model& model, const RepairOptions& options,
                             const PlainRepair& repair, const Progress& progress) {
  if (options.match_mm > 0 || model.shape.IsNull()) return repair(model, options, progress);
  const RepeatedParts repeated(model.shape);
  if (repeated.parts().empty()) return repair(model, options, progress);
  return RepairingOnce(model, options, repeated.parts()).run(repair, progress);
}

}  // namespace seamwright::occ
