// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/model/write.hpp>

/// Models that are written, and what must be the same when they are read back.
namespace seamwright::test {

using Spline = opencascade::handle<Geom_BSplineSurface>;

/// The surface of a face, without the face's placement: shared with the face.
Spline splineOf(const TopoDS_Shape& shape, int face);
/// Poles, weights and knots.
std::vector<double> numbersOf(const Spline& spline);

/// box() with its edges rounded.
TopoDS_Shape roundedBox();
/// box() with B-spline faces.
TopoDS_Shape splineBox();
TopoDS_Shape copied(const TopoDS_Shape& shape);
/// Lifts the middle of a spline face.
void bend(const TopoDS_Shape& shape, int face);

/// What is read back.
occ::Model written(const occ::Model& model, const std::filesystem::path& path,
                   const occ::WriteOptions& options = {});
/// Throws if it is written.
occ::ModelError errorOfWriting(const occ::Model& model, const std::filesystem::path& path,
                               const occ::WriteOptions& options = {});

std::string attributesOf(const occ::Model& model);
int occurrences(const std::string& text, const std::string& part);

/// Level, class and figures of every seam; figures within \p noise of their size.
void expectSameSeams(const occ::Model& a, const occ::Model& b, double noise);
void expectSameModel(const occ::Model& a, const occ::Model& b, double noise = 1e-6);

}  // namespace seamwright::test
