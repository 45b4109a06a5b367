// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>

#include <seamwright/core/blend/frame_form.hpp>
#include <seamwright/core/blend/joint_poles.hpp>
#include <seamwright/core/join/curve/beta.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::loft {

namespace {

/// A joint of the shape: between the pole rows of the segments before and after it.
struct JointAt {
  int before, after;  ///< segments
  Eigen::Index pole;  ///< of the joint; at the joint of a closed frame, pole 0
  double length_before, length_after;
  int order;                      ///< n of the joint's G^n
  Eigen::Index first_column = 0;  ///< of its numbers in the joint form
};

std::vector<JointAt> jointsOf(const FrameShape& shape) {
  std::vector<JointAt> result;
  const auto length = [&](int i) { return shape.knots[i + 1] - shape.knots[i]; };
  const int segments = shape.segments();
  for (int i = shape.closed ? 0 : 1; i < segments; ++i) {
    const int before = i > 0 ? i - 1 : segments - 1;
    // Orders are given as measureJoints() has joints: the one that closes a frame is the last.
    const std::size_t at = i > 0 ? i - 1 : segments - 1;
    result.push_back({before, i, static_cast<Eigen::Index>(i) * shape.degree, length(before),
                      length(i),
                      shape.joint_orders.empty() ? shape.order : shape.joint_orders[at]});
  }
  return result;
}

Poles endDerivatives(const BezierSpline& frame, int segment_index, double t, int order) {
  return segment(frame, segment_index).derivatives(t, order);
}

/// The parameter changes of both sides, from the common jet: the speeds have a given sum, and the
/// higher coefficients, divided by powers of the speeds, are opposite.
struct JointChanges {
  Eigen::VectorXd before, after;
};

JointChanges balancedChanges(const Eigen::VectorXd& beta, double sum) {
  const Eigen::Index n = beta.size();
  JointChanges result{Eigen::VectorXd::Zero(n), {}};
  result.before(0) = sum / (1 + beta(0));
  double power = beta(0);
  for (Eigen::Index k = 1; k < n; ++k) {
    power *= beta(0);
    result.before(k) = -composedBeta(beta, result.before)(k) / (2 * power);
  }
  result.after = composedBeta(beta, result.before);
  return result;
}

/// The common jet W_0..W_n from the derivatives of both sides, each gives one.
Poles commonJet(const Poles& before, const Poles& after, const JointChanges& changes) {
  return 0.5 * (betaMatrix(inverseBeta(changes.before)) * before +
                betaMatrix(inverseBeta(changes.after)) * after);
}

class SmoothForm : public FrameForm {
 public:
  explicit SmoothForm(const FrameShape& shape) : shape_(shape) {}

  Row numbers(const BezierSpline& frame) const override {
    return bsplineCurve(frame, shape_.order).poles.reshaped<Eigen::RowMajor>().transpose();
  }
  Row smoothNumbers(const BezierSpline& curve) const override { return numbers(curve); }
  Row smoothDerivatives(const BezierSpline& field) const override {
    HomogeneousPoles poles = bsplineCurve(field, shape_.order).poles;
    poles.col(3).setZero();
    return poles.reshaped<Eigen::RowMajor>().transpose();
  }
  FormPoles poles(const OmegaSpline& spline) const override { return {3, spline.rows, {}}; }
  std::vector<double> knotsAlong() const override {
    std::vector<double> knots(static_cast<std::size_t>(shape_.degree) + 1, shape_.knots.front());
    for (int i = 1; i < shape_.segments(); ++i)
      knots.insert(knots.end(), static_cast<std::size_t>(shape_.degree - shape_.order),
                   shape_.knots[i]);
    knots.insert(knots.end(), static_cast<std::size_t>(shape_.degree) + 1, shape_.knots.back());
    return knots;
  }

 private:
  FrameShape shape_;
};

/// Columns: 3 for every pole that no joint makes, in the order of the poles; then for each joint of
/// order n W_0..W_n, 3 each, and the n coefficients of the change before and of that after it.
class JointForm : public FrameForm {
 public:
  explicit JointForm(const FrameShape& shape) : shape_(shape), joints_(jointsOf(shape)) {
    const Eigen::Index poles = static_cast<Eigen::Index>(shape.segments()) * shape.degree + 1;
    std::vector<bool> made(static_cast<std::size_t>(poles), false);
    for (const JointAt& joint : joints_)
      for (int k = 0; k <= joint.order; ++k) {
        made[poleBefore(joint, k)] = true;
        made[poleAfter(joint, k)] = true;
      }
    for (Eigen::Index i = 0; i < poles; ++i)
      if (!made[i]) free_.push_back(i);
    columns_ = 3 * static_cast<Eigen::Index>(free_.size());
    for (JointAt& joint : joints_) {
      joint.first_column = columns_;
      columns_ += 3 + 5L * joint.order;
    }
  }

  Row numbers(const BezierSpline& frame) const override {
    Row result = freeNumbers(frame);
    for (const JointAt& joint : joints_) jointNumbers(frame, joint, result);
    return result;
  }
  Row smoothNumbers(const BezierSpline& curve) const override { return smoothRow(curve, 1); }
  Row smoothDerivatives(const BezierSpline& field) const override { return smoothRow(field, 0); }

  FormPoles poles(const OmegaSpline& spline) const override {
    const int pieces = static_cast<int>(spline.breaks.size()) - 1;
    const std::vector<bool> constant = constantChanges(spline);
    std::vector<std::vector<Bern>> of_piece;
    FormPoles result;
    for (int i = 0; i < pieces; ++i) {
      bool safe = true;
      of_piece.push_back(piecePoles(spline.rows.middleRows(3L * i, 4), constant, safe));
      if (!safe) result.unsafe.push_back(i);
      for (const Bern& pole : of_piece.back())
        result.degree = std::max(result.degree, static_cast<int>(pole.rows()) - 1);
    }
    const auto count = static_cast<Eigen::Index>(of_piece.front().size());
    result.rows.setOnes(static_cast<Eigen::Index>(pieces) * result.degree + 1, 4 * count);
    for (int i = 0; i < pieces; ++i)
      for (Eigen::Index j = 0; j < count; ++j)
        result.rows.block(static_cast<Eigen::Index>(i) * result.degree, 4 * j, result.degree + 1,
                          3) = raisedTo(of_piece[i][j], result.degree);
    return result;
  }

  std::vector<double> knotsAlong() const override {
    std::vector<double> knots(static_cast<std::size_t>(shape_.degree) + 1, shape_.knots.front());
    for (int i = 1; i < shape_.segments(); ++i)
      knots.insert(knots.end(), static_cast<std::size_t>(shape_.degree), shape_.knots[i]);
    knots.insert(knots.end(), static_cast<std::size_t>(shape_.degree) + 1, shape_.knots.back());
    return knots;
  }

 private:
  Eigen::Index poleBefore(const JointAt& joint, int k) const {
    return static_cast<Eigen::Index>(joint.before + 1) * shape_.degree - k;
  }
  Eigen::Index poleAfter(const JointAt& joint, int k) const { return joint.pole + k; }
  /// The first column of the coefficients of the change before the joint.
  static Eigen::Index changeColumn(const JointAt& joint) {
    return joint.first_column + 3L * (joint.order + 1);
  }

  Row freeNumbers(const BezierSpline& frame) const {
    Row result = Row::Zero(columns_);
    for (std::size_t i = 0; i < free_.size(); ++i)
      result.segment(3 * static_cast<Eigen::Index>(i), 3) = frame.poles.row(free_[i]).head<3>();
    return result;
  }

  static void store(const JointAt& joint, const Poles& jet, const JointChanges& changes,
                    Row& result) {
    const Eigen::Index n = joint.order;
    for (Eigen::Index k = 0; k <= n; ++k)
      result.segment(joint.first_column + 3 * k, 3) = jet.row(k);
    result.segment(changeColumn(joint), n) = changes.before.transpose();
    result.segment(changeColumn(joint) + n, n) = changes.after.transpose();
  }

  static void jointNumbers(const BezierSpline& frame, const JointAt& joint, Row& result) {
    const int n = joint.order;
    if (n == 0) {
      result.segment(joint.first_column, 3) = frame.poles.row(joint.pole).head<3>();
      return;
    }
    const BetaFit fit = fitBeta(segment(frame, joint.before), segment(frame, joint.after), n);
    if (fit.beta.size() != n)
      refuse(fmt::format("joint {}: the tangents of its sides give no positive ratio of speeds",
                         joint.after));
    const JointChanges changes =
        balancedChanges(fit.beta, joint.length_before + joint.length_after);
    Poles jet = commonJet(endDerivatives(frame, joint.before, 1, n),
                          endDerivatives(frame, joint.after, 0, n), changes);
    jet.row(0) = frame.poles.row(joint.pole).head<3>();
    store(joint, jet, changes, result);
  }

  /// \param factor 1 for a curve; 0 for a derivative by omega: the parameter changes are constant
  /// there.
  Row smoothRow(const BezierSpline& curve, double factor) const {
    Row result = freeNumbers(curve);
    for (const JointAt& joint : joints_) {
      const int n = joint.order;
      JointChanges changes{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
      Poles jet = Poles::Zero(n + 1, 3);
      if (n > 0) {
        changes.before(0) = joint.length_before;
        changes.after(0) = joint.length_after;
        jet = commonJet(endDerivatives(curve, joint.before, 1, n),
                        endDerivatives(curve, joint.after, 0, n), changes);
        changes.before *= factor;
        changes.after *= factor;
      }
      jet.row(0) = curve.poles.row(joint.pole).head<3>();
      store(joint, jet, changes, result);
    }
    return result;
  }

  /// Which joints have changes that are constant except for rounding: what their variation can
  /// move is below 2^-36 of the size of the jets, about what the measure of a ratio at a joint of
  /// short tangents rounds.
  std::vector<bool> constantChanges(const OmegaSpline& spline) const {
    std::vector<bool> result;
    const double share = std::ldexp(1, -36);
    for (const JointAt& joint : joints_) {
      const auto changes = spline.rows.middleCols(changeColumn(joint), 2L * joint.order);
      bool constant = true;
      for (Eigen::Index c = 0; c < changes.cols(); ++c) {
        const double spread = changes.col(c).maxCoeff() - changes.col(c).minCoeff();
        const double size = joint.length_before + joint.length_after;
        constant = constant && spread <= share * size;
      }
      result.push_back(constant);
    }
    return result;
  }

  std::vector<Bern> piecePoles(const Eigen::Ref<const Eigen::MatrixXd>& rows,
                               const std::vector<bool>& constant, bool& safe) const {
    std::vector<Bern> poles(static_cast<std::size_t>(shape_.segments()) * shape_.degree + 1);
    for (std::size_t i = 0; i < free_.size(); ++i)
      poles[free_[i]] = rows.middleCols(3 * static_cast<Eigen::Index>(i), 3);
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      const JointAt& joint = joints_[j];
      const int n = joint.order;
      std::vector<Bern> jet, before, after;
      for (int k = 0; k <= n; ++k) jet.push_back(rows.middleCols(joint.first_column + 3L * k, 3));
      const auto change = [&](Eigen::Index column) -> Bern {
        return constant[j] ? Bern(rows.col(column).topRows(1)) : Bern(rows.col(column));
      };
      for (int k = 0; k < n; ++k) {
        before.push_back(change(changeColumn(joint) + k));
        after.push_back(change(changeColumn(joint) + n + k));
      }
      if (n > 0) safe = safe && before[0].minCoeff() > 0 && after[0].minCoeff() > 0;
      const std::vector<Bern> left = jointPoles(jet, before, shape_.degree, true),
                              right = jointPoles(jet, after, shape_.degree, false);
      for (int k = 0; k <= n; ++k) {
        poles[poleBefore(joint, k)] = left[k];
        poles[poleAfter(joint, k)] = right[k];
      }
    }
    return poles;
  }

  FrameShape shape_;
  std::vector<JointAt> joints_;
  std::vector<Eigen::Index> free_;
  Eigen::Index columns_ = 0;
};

}  // namespace

std::unique_ptr<FrameForm> smoothForm(const FrameShape& shape) {
  return std::make_unique<SmoothForm>(shape);
}

std::unique_ptr<FrameForm> jointForm(const FrameShape& shape) {
  return std::make_unique<JointForm>(shape);
}

BezierSpline raised(const BezierSpline& spline, int degree) {
  if (spline.degree >= degree) return spline;
  std::vector<BezierCurve> segments;
  for (int i = 0; i < spline.segments(); ++i) {
    segments.push_back(segment(spline, i));
    while (segments.back().degree() < degree) segments.back() = segments.back().elevated();
  }
  return bezierSpline(segments, spline.knots, spline.closed);
}

}  // namespace seamwright::loft
