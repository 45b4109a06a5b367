// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include <seamwright/core/enclosure/surface.hpp>

namespace seamwright {

namespace {

VectorModel vectorModel(const ChebyshevModel& x, const ChebyshevModel& y, const ChebyshevModel& z) {
  return {x, y, z};
}

/// The matrix M K M^T.
SymmetricModel turned(const Eigen::Matrix3d& m, const SymmetricModel& k) {
  const VectorModel columns[] = {m * VectorModel{k[0], k[3], k[5]},
                                 m * VectorModel{k[3], k[1], k[4]},
                                 m * VectorModel{k[5], k[4], k[2]}};
  const auto entry = [&](int i, int j) {
    return combination({m(j, 0), m(j, 1), m(j, 2)},
                       {&columns[0][i], &columns[1][i], &columns[2][i]});
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(2, 0)};
}

SurfaceFields placed(const SurfaceFields& local, const Placement& placement, Detail detail) {
  const double side = placement.orthogonal.determinant() < 0 ? -1 : 1;
  SurfaceFields fields;
  fields.point =
      placement.scale * (placement.orthogonal * local.point) + constantModel(placement.translation);
  if (detail >= Detail::TangentPlane) fields.normal = side * (placement.orthogonal * local.normal);
  fields.bounds_curvature = local.bounds_curvature;
  if (detail >= Detail::Curvature)
    fields.tensor = (side / placement.scale) * turned(placement.orthogonal, local.tensor);
  if (detail < Detail::CurvatureChange) return fields;
  fields.u = placement.scale * (placement.orthogonal * local.u);
  fields.v = placement.scale * (placement.orthogonal * local.v);
  // Two factors, because the product with a number covers one rounding of the number.
  const double by_scale = 1 / placement.scale;
  const auto scaled = [&](const ChebyshevModel& coefficient) {
    return (side * by_scale) * (by_scale * coefficient);
  };
  const CubicForm& form = local.change;
  fields.change = {.first = placement.orthogonal * form.first,
                   .second = placement.orthogonal * form.second,
                   .xxx = scaled(form.xxx),
                   .xxy = scaled(form.xxy),
                   .xyy = scaled(form.xyy),
                   .yyy = scaled(form.yyy)};
  return fields;
}

SurfaceFields unknownPlane(SurfaceFields fields) {
  fields.normal.fill(ChebyshevModel::unknown());
  fields.tensor.fill(ChebyshevModel::unknown());
  for (VectorModel* field : {&fields.u, &fields.v, &fields.change.first})
    field->fill(ChebyshevModel::unknown());
  return fields;
}

/// The sign of the model, -1 or 1; 0 if both signs may occur.
int signOf(const ChebyshevModel& model) {
  const Interval range = model.range();
  if (range.lower > 0) return 1;
  return range.upper < 0 ? -1 : 0;
}

/// The sign of the distance from the axis of a surface of the given size. A path meets an apex only
/// up to rounding; there the sign is that of the surface next to the apex.
int sideOfAxis(const ChebyshevModel& rho, double size) {
  const double rounding = 0x1p-36 * std::abs(size);
  const Interval range = rho.range();
  if (range.lower <= 0 && range.lower >= -rounding && range.upper > -2 * range.lower) return 1;
  if (range.upper >= 0 && range.upper <= rounding && range.lower < -2 * range.upper) return -1;
  return signOf(rho);
}

class Plane : public SurfaceEvaluator {
 public:
  bool isRegular() const override { return true; }
  SurfaceFields fields(const ChebyshevModel& u, const ChebyshevModel& v, double, double,
                       Detail) const override {
    const ChebyshevModel zero(0), one(1);
    return {.point = vectorModel(u, v, zero),
            .normal = vectorModel(zero, zero, one),
            .tensor = {},
            .bounds_curvature = true,
            .u = vectorModel(one, zero, zero),
            .v = vectorModel(zero, one, zero)};
  }
};

/// A curve (rho(v), height(v)) turned about the z axis, with normal (outward(v), axial(v)) and
/// principal curvatures along the circle and along the curve. The curvature along the curve is
/// constant.
struct Profile {
  ChebyshevModel rho, height;
  ChebyshevModel outward, axial;
  ChebyshevModel circle_curvature, curve_curvature;
  double speed = 1;  ///< X_v is speed (-axial e(u) + outward z)
};

/// The fields of a turned profile. e(u) and its derivative span the plane of the circle.
/// \param circle_change returns the derivative of circle_curvature by the arc length of the curve.
template <class Change>
SurfaceFields turnedFields(const ChebyshevModel& u, const Profile& profile, Detail detail,
                           const Change& circle_change) {
  const auto [cosine, sine] = cosSin(u);
  const ChebyshevModel zero(0);
  SurfaceFields fields;
  fields.point = vectorModel(profile.rho * cosine, profile.rho * sine, profile.height);
  if (detail >= Detail::TangentPlane)
    fields.normal = vectorModel(profile.outward * cosine, profile.outward * sine, profile.axial);
  fields.bounds_curvature = profile.circle_curvature.isKnown();
  if (detail >= Detail::Curvature) {
    const VectorModel around = vectorModel(-sine, cosine, zero);
    const VectorModel along =
        vectorModel(-(profile.axial * cosine), -(profile.axial * sine), profile.outward);
    fields.tensor = profile.circle_curvature * symmetricProduct(around, around) +
                    profile.curve_curvature * symmetricProduct(along, along);
    if (detail >= Detail::CurvatureChange) {
      fields.u = profile.rho * around;
      fields.v = profile.speed * along;
      // Meridians are geodesics, and the direction of the circle is parallel along them. So the
      // derivative of the second form along the curve has the derivatives of both curvatures; by
      // symmetry nothing else remains.
      fields.change = {.first = around,
                       .second = along,
                       .xxx = zero,
                       .xxy = circle_change(),
                       .xyy = zero,
                       .yyy = zero};
    }
  }
  return fields;
}

class Cylinder : public SurfaceEvaluator {
 public:
  explicit Cylinder(double radius) : radius_(radius) {}
  bool isRegular() const override { return std::isnormal(1 / radius_); }
  SurfaceFields fields(const ChebyshevModel& u, const ChebyshevModel& v, double, double,
                       Detail detail) const override {
    return turnedFields(u,
                        {ChebyshevModel(radius_), v, ChebyshevModel(1), ChebyshevModel(0),
                         -inverse(ChebyshevModel(radius_)), ChebyshevModel(0)},
                        detail, [] { return ChebyshevModel(0); });
  }

 private:
  double radius_;
};

class Cone : public SurfaceEvaluator {
 public:
  Cone(double radius, double half_angle_rad) : radius_(radius) {
    const auto [cosine, sine] = cosSin(ChebyshevModel(half_angle_rad));
    cosine_ = cosine;
    sine_ = sine;
  }
  SurfaceFields fields(const ChebyshevModel& u, const ChebyshevModel& v, double, double,
                       Detail detail) const override {
    const ChebyshevModel rho = ChebyshevModel(radius_) + v * sine_;
    const double side = sideOfAxis(rho, std::abs(radius_) + v.magnitude());
    const SurfaceFields fields =
        turnedFields(u,
                     {rho, v * cosine_, side * cosine_, -side * sine_,
                      -side * (cosine_ * inverse(rho)), ChebyshevModel(0), side},
                     detail, [&] {
                       const ChebyshevModel by_rho = inverse(rho);
                       return cosine_ * sine_ * (by_rho * by_rho);
                     });
    return side == 0 ? unknownPlane(fields) : fields;
  }

 private:
  double radius_;
  ChebyshevModel cosine_, sine_;
};

class Torus : public SurfaceEvaluator {
 public:
  Torus(double major, double minor) : major_(major), minor_(minor) {}
  SurfaceFields fields(const ChebyshevModel& u, const ChebyshevModel& v, double, double,
                       Detail detail) const override {
    const auto [cosine, sine] = cosSin(v);
    const ChebyshevModel rho = ChebyshevModel(major_) + minor_ * cosine;
    const double side = sideOfAxis(rho, minor_);
    const SurfaceFields fields = turnedFields(
        u,
        {rho, minor_ * sine, side * cosine, side * sine, -side * (cosine * inverse(rho)),
         -side * inverse(ChebyshevModel(minor_)), side * minor_},
        detail, [&, &sine = sine] {
          const ChebyshevModel by_rho = inverse(rho);
          return inverse(ChebyshevModel(minor_)) * (major_ * (sine * (by_rho * by_rho)));
        });
    return side == 0 ? unknownPlane(fields) : fields;
  }

 private:
  double major_;
  double minor_;
};

class Sphere : public SurfaceEvaluator {
 public:
  explicit Sphere(double radius) : radius_(radius) {}
  SurfaceFields fields(const ChebyshevModel& u, const ChebyshevModel& v, double, double,
                       Detail detail) const override {
    const auto [cosine, sine] = cosSin(v);
    // Beyond a pole X_u x X_v points inward. At the pole itself the parametrisation has no normal,
    // but the sphere has a tangent plane.
    constexpr double rounding = 0x1p-36;
    const Interval height = cosine.range();
    const double side = height.lower >= -rounding ? 1 : height.upper <= rounding ? -1 : 0;
    const ChebyshevModel curvature = -side * inverse(ChebyshevModel(radius_));
    const SurfaceFields fields = turnedFields(u,
                                              {radius_ * cosine, radius_ * sine, side * cosine,
                                               side * sine, curvature, curvature, side * radius_},
                                              detail, [] { return ChebyshevModel(0); });
    return side == 0 ? unknownPlane(fields) : fields;
  }

 private:
  double radius_;
};

class Spline : public SurfaceEvaluator {
 public:
  explicit Spline(std::shared_ptr<const SplineEvaluator> spline) : spline_(std::move(spline)) {}
  std::vector<double> knotsInside(int direction, const Interval& range) const override {
    return spline_->knotsInside(direction, range);
  }
  double parameterSize(int direction) const override { return spline_->parameterSize(direction); }
  SurfaceFields fields(const ChebyshevModel& u, const ChebyshevModel& v, double hint_u,
                       double hint_v, Detail detail) const override {
    const int order = static_cast<int>(detail);
    if (detail != Detail::Position)
      if (const auto collapsed = spline_->collapsedJet(u, v, hint_u, hint_v, order))
        return collapsedFieldsOf(*collapsed, detail);
    return fieldsOf(detail == Detail::Curvature ? spline_->curvatureJet(u, v, hint_u, hint_v)
                                                : spline_->jet(u, v, hint_u, hint_v, order),
                    detail);
  }

 private:
  std::shared_ptr<const SplineEvaluator> spline_;
};

class Extrusion : public SurfaceEvaluator {
 public:
  Extrusion(CurveEvaluator curve, const Eigen::Vector3d& direction)
      : curve_(std::move(curve)), direction_(constantModel(direction)) {}
  std::vector<double> knotsInside(int direction, const Interval& range) const override {
    return direction == 0 ? curve_.knotsInside(range) : std::vector<double>();
  }
  double parameterSize(int direction) const override {
    return direction == 0 ? curve_.parameterSize() : 0;
  }
  SurfaceFields fields(const ChebyshevModel& u, const ChebyshevModel& v, double hint_u, double,
                       Detail detail) const override {
    const CurveJetModel curve = curve_.jet(u, hint_u, static_cast<int>(detail));
    return fieldsOf(
        {curve.p + v * direction_, curve.d1, direction_, curve.d2, {}, {}, curve.d3, {}, {}, {}},
        detail);
  }

 private:
  CurveEvaluator curve_;
  VectorModel direction_;
};

class Revolution : public SurfaceEvaluator {
 public:
  Revolution(const Frame& frame, CurveEvaluator curve) : frame_(frame), curve_(std::move(curve)) {}
  std::vector<double> knotsInside(int direction, const Interval& range) const override {
    return direction == 1 ? curve_.knotsInside(range) : std::vector<double>();
  }
  double parameterSize(int direction) const override {
    return direction == 1 ? curve_.parameterSize() : 0;
  }
  SurfaceFields fields(const ChebyshevModel& u, const ChebyshevModel& v, double, double hint_v,
                       Detail detail) const override {
    const CurveJetModel curve = curve_.jet(v, hint_v, static_cast<int>(detail));
    const Eigen::Matrix3d into_frame = frame_.axes.transpose();
    const VectorModel p = into_frame * (curve.p - constantModel(frame_.origin));
    const VectorModel d1 = into_frame * curve.d1;
    const VectorModel d2 = into_frame * curve.d2;
    const ChebyshevModel zero(0);
    // The jet at u = 0. A turn about z moves (x, y, z) by (-y, x, 0) per radian.
    JetModel jet{p,
                 vectorModel(-p[1], p[0], zero),
                 d1,
                 vectorModel(-p[0], -p[1], zero),
                 vectorModel(-d1[1], d1[0], zero),
                 d2};
    if (detail >= Detail::CurvatureChange) {
      jet.uuu = vectorModel(p[1], -p[0], zero);
      jet.uuv = vectorModel(-d1[0], -d1[1], zero);
      jet.uvv = vectorModel(-d2[1], d2[0], zero);
      jet.vvv = into_frame * curve.d3;
    }
    return turn(fieldsOf(jet, detail), u, detail);
  }

 private:
  static SurfaceFields turn(const SurfaceFields& start, const ChebyshevModel& u, Detail detail) {
    const std::pair<ChebyshevModel, ChebyshevModel> rotation = cosSin(u);
    const auto turn = [&](const VectorModel& a) {
      const auto& [cosine, sine] = rotation;
      return vectorModel(ProductSum().add(cosine, a[0]).add(sine, a[1], -1).model(),
                         ProductSum().add(sine, a[0]).add(cosine, a[1]).model(), a[2]);
    };
    SurfaceFields fields;
    fields.point = turn(start.point);
    if (detail >= Detail::TangentPlane) fields.normal = turn(start.normal);
    fields.bounds_curvature = start.bounds_curvature;
    if (detail >= Detail::Curvature) {
      const SymmetricModel& k = start.tensor;
      const VectorModel x =
          turn({k[0], k[3], k[5]});  // the rows of the matrix, with columns turned
      const VectorModel y = turn({k[3], k[1], k[4]});
      const VectorModel z = turn({k[5], k[4], k[2]});
      const VectorModel first = turn({x[0], y[0], z[0]});
      const VectorModel second = turn({x[1], y[1], z[1]});
      fields.tensor = {first[0], second[1], z[2], first[1], z[1], z[0]};
    }
    if (detail >= Detail::CurvatureChange) {
      fields.u = turn(start.u);
      fields.v = turn(start.v);
      fields.change = start.change;
      fields.change.first = turn(start.change.first);
      fields.change.second = turn(start.change.second);
    }
    return fields;
  }

  Frame frame_;
  CurveEvaluator curve_;
};

class Offset : public SurfaceEvaluator {
 public:
  Offset(std::unique_ptr<SurfaceEvaluator> basis, double distance)
      : basis_(std::move(basis)), distance_(distance) {}
  std::vector<double> knotsInside(int direction, const Interval& range) const override {
    return basis_->knotsInside(direction, range);
  }
  double parameterSize(int direction) const override { return basis_->parameterSize(direction); }
  SurfaceFields fields(const ChebyshevModel& u, const ChebyshevModel& v, double hint_u,
                       double hint_v, Detail detail) const override {
    const SurfaceFields basis =
        basis_->fields(u, v, hint_u, hint_v, std::max(detail, Detail::Curvature));
    SurfaceFields fields;
    fields.point = basis.point + distance_ * basis.normal;
    if (detail == Detail::Position) return fields;
    // Let S be the Weingarten map of the basis. X_u becomes (I - d S) X_u, and the map becomes S (I
    // - d S)^-1. As S has rank 2, that is (S - d K P) / (1 - d tr S + d^2 K), with K the Gauss
    // curvature and P the projection onto the tangent plane.
    // The denominator is the determinant of I - d S, the factor of areas.
    const ChebyshevModel mean = trace(basis.tensor);
    const ChebyshevModel gauss = 0.5 * (mean * mean - contraction(basis.tensor, basis.tensor));
    const ChebyshevModel area_factor =
        ChebyshevModel(1) - distance_ * mean + (distance_ * distance_) * gauss;
    const double side = signOf(area_factor);
    if (side == 0) return unknownPlane(fields);
    fields.normal = side * basis.normal;
    fields.bounds_curvature = basis.bounds_curvature;
    if (detail >= Detail::Curvature) {
      SymmetricModel projection = -symmetricProduct(basis.normal, basis.normal);
      for (int i = 0; i < 3; ++i) projection[i] += ChebyshevModel(1);
      fields.tensor =
          (side * inverse(area_factor)) * (basis.tensor - (distance_ * gauss) * projection);
    }
    if (detail < Detail::CurvatureChange) return fields;
    // As a form of parameter vectors the change is that of the basis. X_u becomes (I - d S) X_u, so
    // first and second become (I - d S)^-1 times themselves, which is ((1 - d tr S) I + d S) /
    // det(I - d S) in the tangent plane.
    const ChebyshevModel inverse_factor = inverse(area_factor);
    const auto moved = [&](const VectorModel& tangent) {
      return tangent - distance_ * (basis.tensor * tangent);
    };
    const auto dual = [&](const VectorModel& tangent) {
      return inverse_factor * ((ChebyshevModel(1) - distance_ * mean) * tangent +
                               distance_ * (basis.tensor * tangent));
    };
    fields.u = moved(basis.u);
    fields.v = moved(basis.v);
    const CubicForm& form = basis.change;
    fields.change = {.first = dual(form.first),
                     .second = dual(form.second),
                     .xxx = side * form.xxx,
                     .xxy = side * form.xxy,
                     .xyy = side * form.xyy,
                     .yyy = side * form.yyy};
    return fields;
  }

 private:
  std::unique_ptr<SurfaceEvaluator> basis_;
  double distance_;
};

class Placed : public SurfaceEvaluator {
 public:
  Placed(std::unique_ptr<SurfaceEvaluator> basis, const Placement& placement)
      : basis_(std::move(basis)), placement_(placement) {}
  std::vector<double> knotsInside(int direction, const Interval& range) const override {
    return basis_->knotsInside(direction, range);
  }
  double parameterSize(int direction) const override { return basis_->parameterSize(direction); }
  bool isRegular() const override { return basis_->isRegular(); }
  SurfaceFields fields(const ChebyshevModel& u, const ChebyshevModel& v, double hint_u,
                       double hint_v, Detail detail) const override {
    return placed(basis_->fields(u, v, hint_u, hint_v, detail), placement_, detail);
  }

 private:
  std::unique_ptr<SurfaceEvaluator> basis_;
  Placement placement_;
};

template <class Local, class... Arguments>
std::unique_ptr<SurfaceEvaluator> inFrame(const Frame& frame, Arguments&&... arguments) {
  return placedEvaluator(std::make_unique<Local>(std::forward<Arguments>(arguments)...),
                         {1, frame.axes, frame.origin});
}

}  // namespace

std::unique_ptr<SurfaceEvaluator> planeEvaluator(const Frame& frame) {
  return inFrame<Plane>(frame);
}

std::unique_ptr<SurfaceEvaluator> cylinderEvaluator(const Frame& frame, double radius) {
  return inFrame<Cylinder>(frame, radius);
}

std::unique_ptr<SurfaceEvaluator> coneEvaluator(const Frame& frame, double radius,
                                                double half_angle_rad) {
  return inFrame<Cone>(frame, radius, half_angle_rad);
}

std::unique_ptr<SurfaceEvaluator> sphereEvaluator(const Frame& frame, double radius) {
  return inFrame<Sphere>(frame, radius);
}

std::unique_ptr<SurfaceEvaluator> torusEvaluator(const Frame& frame, double major, double minor) {
  return inFrame<Torus>(frame, major, minor);
}

std::unique_ptr<SurfaceEvaluator> splineEvaluator(std::shared_ptr<const SplineEvaluator> spline) {
  return std::make_unique<Spline>(std::move(spline));
}

std::unique_ptr<SurfaceEvaluator> revolutionEvaluator(const Frame& frame, CurveEvaluator curve) {
  return inFrame<Revolution>(frame, frame, std::move(curve));
}

std::unique_ptr<SurfaceEvaluator> extrusionEvaluator(CurveEvaluator curve,
                                                     const Eigen::Vector3d& direction) {
  return std::make_unique<Extrusion>(std::move(curve), direction);
}

std::unique_ptr<SurfaceEvaluator> offsetEvaluator(std::unique_ptr<SurfaceEvaluator> basis,
                                                  double distance) {
  return std::make_unique<Offset>(std::move(basis), distance);
}

std::unique_ptr<SurfaceEvaluator> placedEvaluator(std::unique_ptr<SurfaceEvaluator> basis,
                                                  const Placement& placement) {
  return std::make_unique<Placed>(std::move(basis), placement);
}

}  // namespace seamwright
