// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <seamwright/occ_adapter/model/degenerate_edges.hpp>

namespace seamwright::occ {

std::vector<int> degenerateEdges(const Model& model) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(model.shape, TopAbs_EDGE, edges);
  std::vector<int> numbers;
  for (int i = 1; i <= edges.Extent(); ++i)
    if (BRep_Tool::Degenerated(TopoDS::Edge(edges(i)))) numbers.push_back(i);
  return numbers;
}

}  // namespace seamwright::occ
