// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <optional>
#include <seamwright/plugin/python/report_state.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace py = pybind11;

namespace seamwright::python {

namespace {

// The members of each struct, for writing and reading alike.

template <class Archive>
void members(Archive& archive, Figure& figure) {
  archive(figure.lower, figure.upper, figure.at);
}

template <class Archive>
void members(Archive& archive, Interval& interval) {
  archive(interval.lower, interval.upper);
}

template <class Archive>
void members(Archive& archive, LeftOut& left_out) {
  archive(left_out.intervals, left_out.upper, left_out.longest_mm);
}

template <class Archive>
void members(Archive& archive, DegeneratePoint& point) {
  archive(point.at, point.side_a, point.side_b);
}

template <class Archive>
void members(Archive& archive, SeamFigures& f) {
  archive(f.gap_mm, f.angle_rad, f.curvature_per_mm, f.curvature_rel, f.curvature_change_per_mm2,
          f.curvature_change_rel, f.angle_left_out, f.curvature_left_out, f.fold_at,
          f.below_crease_share, f.plane_share, f.shares_known, f.certified, f.uncertified,
          f.settled, f.degenerate, f.points);
}

template <class Archive>
void members(Archive& archive, Verdict& verdict) {
  archive(verdict.level, verdict.seam_class, verdict.certain);
}

template <class Archive>
void members(Archive& archive, occ::WorstPoint& worst) {
  archive(worst.quantity, worst.at, worst.point.x(), worst.point.y(), worst.point.z());
}

template <class Archive>
void members(Archive& archive, occ::SeamResult& seam) {
  archive(seam.id, seam.kind, seam.edges, seam.faces[0], seam.faces[1], seam.length_mm,
          seam.figures, seam.verdict, seam.worst, seam.note);
}

template <class Archive>
void members(Archive& archive, occ::NonSeamEdge& edge) {
  archive(edge.edge, edge.faces);
}

template <class Archive>
void members(Archive& archive, occ::ModelFacts& model) {
  archive(model.path, model.format, model.length_unit, model.faces, model.edges, model.notes);
}

template <class Archive>
void members(Archive& archive, ContinuityTolerance& tolerance) {
  archive(tolerance.gap_mm, tolerance.angle_rad, tolerance.curvature_rel, tolerance.flat_radius_mm,
          tolerance.crease_rad);
}

template <class Archive>
void members(Archive& archive, occ::Report& report) {
  archive(report.model, report.tolerance, report.level, report.seams, report.open,
          report.non_manifold, report.read_s, report.analyze_s);
}

class Writer {
 public:
  template <class... Values>
  void operator()(Values&... values) {
    (write(values), ...);
  }
  const py::list& list() const { return list_; }

 private:
  template <class Value>
  void write(Value& value) {
    if constexpr (std::is_enum_v<Value>)
      list_.append(static_cast<int>(value));
    else if constexpr (std::is_arithmetic_v<Value>)
      list_.append(value);
    else
      members(*this, value);
  }
  // Bytes, since the names of files may be no UTF-8.
  void write(std::string& text) { list_.append(py::bytes(text)); }
  template <class Value>
  void write(std::optional<Value>& value) {
    list_.append(value.has_value());
    if (value) write(*value);
  }
  template <class Value>
  void write(std::vector<Value>& values) {
    list_.append(values.size());
    for (Value& value : values) write(value);
  }

  py::list list_;
};

class Reader {
 public:
  explicit Reader(py::list list) : list_(std::move(list)) {}

  template <class... Values>
  void operator()(Values&... values) {
    (read(values), ...);
  }
  bool isAtEnd() const { return next_ == list_.size(); }

 private:
  template <class Value>
  Value take() {
    if (isAtEnd()) throw py::value_error("state of a Report is too short");
    return list_[next_++].cast<Value>();
  }
  template <class Value>
  void read(Value& value) {
    if constexpr (std::is_enum_v<Value>)
      value = static_cast<Value>(take<int>());
    else if constexpr (std::is_arithmetic_v<Value>)
      value = take<Value>();
    else
      members(*this, value);
  }
  void read(std::string& text) { text = take<std::string>(); }
  template <class Value>
  void read(std::optional<Value>& value) {
    value.reset();
    if (take<bool>()) read(value.emplace());
  }
  template <class Value>
  void read(std::vector<Value>& values) {
    values.resize(take<std::size_t>());
    for (Value& value : values) read(value);
  }

  py::list list_;
  std::size_t next_ = 0;
};

}  // namespace

py::list stateOf(occ::Report report) {
  Writer writer;
  members(writer, report);
  return writer.list();
}

occ::Report reportFrom(const py::list& state) {
  Reader reader(state);
  occ::Report report;
  members(reader, report);
  if (!reader.isAtEnd()) throw py::value_error("state of a Report is too long");
  return report;
}

}  // namespace seamwright::python
