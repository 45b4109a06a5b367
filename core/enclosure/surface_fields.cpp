// SPDX-License-Identifier: LGPL-2.1-or-later
#include <utility>

#include <seamwright/core/enclosure/surface.hpp>

namespace seamwright {

namespace {

/// A basis of the tangent plane with its unit normal.
struct TangentBasis {
  TangentBasis(VectorModel first, VectorModel second) : a(std::move(first)), b(std::move(second)) {
    const VectorModel product = cross(a, b);
    inverse_length = inverseSqrt(dot(product, product));
    normal = inverse_length * product;
  }

  VectorModel a, b, normal;
  ChebyshevModel inverse_length;
};

/// The dual basis of the tangent plane.
struct DualBasis {
  explicit DualBasis(const TangentBasis& basis)
      : a(basis.inverse_length * cross(basis.b, basis.normal)),
        b(basis.inverse_length * cross(basis.normal, basis.a)) {}

  /// The tensor of the second form with the coefficients l, m, k. Entries off the diagonal are the
  /// mean of both orders of the factors, whose radii differ.
  SymmetricModel tensor(const ChebyshevModel& l, const ChebyshevModel& m,
                        const ChebyshevModel& k) const {
    VectorModel of_a, of_b;
    for (int i = 0; i < 3; ++i) {
      of_a[i] = ProductSum().add(l, a[i]).add(m, b[i]).model();
      of_b[i] = ProductSum().add(m, a[i]).add(k, b[i]).model();
    }
    const auto entry = [&](int i, int j) {
      ProductSum sum;
      if (i == j) return sum.add(of_a[i], a[i]).add(of_b[i], b[i]).model();
      sum.add(of_a[i], a[j], 0.5).add(of_a[j], a[i], 0.5);
      return sum.add(of_b[i], b[j], 0.5).add(of_b[j], b[i], 0.5).model();
    };
    return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(2, 0)};
  }

  VectorModel a, b;
};

/// Partial derivatives of a surface in a basis of its tangent plane.
struct PartialDerivatives {
  VectorModel aa, ab, bb, aaa, aab, abb, bbb;
};

/// The change of curvature for the normal n and the tensor K of that normal. In n.(D3X[v, v, v] + 3
/// D2X[v, w]) w is minus the tangential part of D2X[v, v], so n.D2X[v, w] is -K X_v . D2X[v, v].
CubicForm changeOf(const TangentBasis& basis, const DualBasis& dual, const VectorModel& n,
                   const SymmetricModel& tensor, const PartialDerivatives& d) {
  const VectorModel ka = tensor * basis.a, kb = tensor * basis.b;
  const auto pure = [&](const VectorModel& third, const VectorModel& k, const VectorModel& second) {
    ProductSum sum;
    return addDot(addDot(sum, n, third), k, second, -3).model();
  };
  const auto mixed = [&](const VectorModel& third, const VectorModel& k_mixed,
                         const VectorModel& k_pure, const VectorModel& second) {
    ProductSum sum;
    addDot(addDot(sum, n, third), k_mixed, d.ab, -2);
    return addDot(sum, k_pure, second, -1).model();
  };
  return {.first = dual.a,
          .second = dual.b,
          .xxx = pure(d.aaa, ka, d.aa),
          .xxy = mixed(d.aab, ka, kb, d.aa),
          .xyy = mixed(d.abb, kb, ka, d.bb),
          .yyy = pure(d.bbb, kb, d.bb)};
}

}  // namespace

ChebyshevModel CubicForm::operator()(const VectorModel& d) const {
  const ChebyshevModel x = dot(first, d), y = dot(second, d);
  const ChebyshevModel xx = x * x, yy = y * y;
  return ProductSum()
      .add(xx, xxx * x)
      .add(xx, 3 * (xxy * y))
      .add(yy, 3 * (xyy * x))
      .add(yy, yyy * y)
      .model();
}

SurfaceFields fieldsOf(const JetModel& jet, Detail detail) {
  SurfaceFields fields;
  fields.point = jet.p;
  if (detail == Detail::Position) return fields;
  const TangentBasis basis(jet.u, jet.v);
  const VectorModel& n = fields.normal = basis.normal;
  fields.bounds_curvature = true;
  if (detail < Detail::Curvature) return fields;
  const DualBasis dual(basis);
  fields.tensor = dual.tensor(dot(n, jet.uu), dot(n, jet.uv), dot(n, jet.vv));
  if (detail < Detail::CurvatureChange) return fields;
  fields.u = jet.u;
  fields.v = jet.v;
  fields.change = changeOf(basis, dual, n, fields.tensor,
                           {.aa = jet.uu,
                            .ab = jet.uv,
                            .bb = jet.vv,
                            .aaa = jet.uuu,
                            .aab = jet.uuv,
                            .abb = jet.uvv,
                            .bbb = jet.vvv});
  return fields;
}

SurfaceFields collapsedFieldsOf(const CollapsedJetModel& jet, Detail detail) {
  const JetModel& q = jet.quotient;
  const ChebyshevModel& tau = jet.tau;
  SurfaceFields fields;
  fields.point = tau * q.p + constantModel(jet.point);
  if (detail == Detail::Position) return fields;
  // With s along the boundary, X_s = tau Q_s; Q_s and X_tau span the tangent plane.
  const bool along_v = jet.direction == 1;
  const VectorModel& q_s = along_v ? q.u : q.v;
  const VectorModel& q_tau = along_v ? q.v : q.u;
  const TangentBasis basis(q_s, q.p + tau * q_tau);
  // X_u x X_v is tau Q_s x X_tau, or its negative where tau is along u.
  fields.normal = (along_v ? jet.side : -jet.side) * basis.normal;
  const Interval distances = tau.range();
  fields.bounds_curvature = distances.lower > 0 || distances.upper < 0;
  if (detail == Detail::TangentPlane) return fields;
  const VectorModel& n = fields.normal;
  const VectorModel& q_tau_tau = along_v ? q.vv : q.uu;
  // X_ss = tau Q_ss and X_s,tau = Q_s + tau Q_s,tau with n.Q_s = 0. The coefficients of the basis
  // (Q_s, X_tau) are these, divided by tau^2 and by tau.
  const VectorModel& q_ss = along_v ? q.uu : q.vv;
  const DualBasis dual(basis);
  fields.tensor =
      dual.tensor(inverse(tau) * dot(n, q_ss), dot(n, q.uv), dot(n, 2 * q_tau + tau * q_tau_tau));
  if (detail < Detail::CurvatureChange) return fields;
  const VectorModel x_s = tau * q_s;
  fields.u = along_v ? x_s : basis.b;
  fields.v = along_v ? basis.b : x_s;
  // The third derivatives of tau Q, each divided by tau for every s.
  const VectorModel& q_sst = along_v ? q.uuv : q.uvv;
  const VectorModel& q_stt = along_v ? q.uvv : q.uuv;
  const ChebyshevModel by_tau = inverse(tau);
  fields.change = changeOf(basis, dual, n, fields.tensor,
                           {.aa = by_tau * q_ss,
                            .ab = by_tau * q_s + q.uv,
                            .bb = 2 * q_tau + tau * q_tau_tau,
                            .aaa = by_tau * (by_tau * (along_v ? q.uuu : q.vvv)),
                            .aab = by_tau * (by_tau * q_ss + q_sst),
                            .abb = by_tau * (2 * q.uv) + q_stt,
                            .bbb = 3 * q_tau_tau + tau * (along_v ? q.vvv : q.uuu)});
  return fields;
}

}  // namespace seamwright
