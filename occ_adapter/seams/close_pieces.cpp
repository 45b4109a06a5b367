// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Bnd_Box.hxx>
#include <NCollection_UBTree.hxx>
#include <NCollection_UBTreeFiller.hxx>
#include <algorithm>
#include <cmath>

#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/seams/close_pieces.hpp>

namespace seamwright::occ {

namespace {

using Tree = NCollection_UBTree<std::size_t, Bnd_Box>;

struct IndexedPiece {
  std::size_t path = 0;
  std::size_t number = 0;
  const PathPiece* piece = nullptr;
  double reach_mm = 0;
  Bnd_Box box;  ///< of the piece, grown by half its reach
};

std::vector<IndexedPiece> indexed(const EdgePaths& paths, double match_mm) {
  std::vector<IndexedPiece> all;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (!paths[i]) continue;
    const std::vector<PathPiece>& pieces = paths[i]->pieces();
    const double reach = reach_mm(*paths[i], match_mm);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      Bnd_Box box;
      box.Add(pointOf(pieces[k].start));
      box.Add(pointOf(pieces[k].end));
      box.SetGap(pieces[k].sagitta_mm + 0.5 * reach);
      all.push_back({i, k, &pieces[k], reach, box});
    }
  }
  return all;
}

/// Least distance of two straight chords.
double chordDistance(const PathPiece& p, const PathPiece& q) {
  // Where they do not cross, an end of one is nearest.
  double least =
      std::min({q.distance(p.start), q.distance(p.end), p.distance(q.start), p.distance(q.end)});
  const Eigen::Vector3d u = p.end - p.start, v = q.end - q.start, w = p.start - q.start;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
  const double area = uu * vv - uv * uv;
  if (!(area > 0)) return least;
  const double s = (uv * v.dot(w) - vv * u.dot(w)) / area;
  const double t = (uu * v.dot(w) - uv * u.dot(w)) / area;
  if (s > 0 && s < 1 && t > 0 && t < 1) least = std::min(least, (w + s * u - t * v).norm());
  return least;
}

/// Whether tangents of the two pieces may be within 45 degrees of one another.
bool mayRunTogether(const PathPiece& p, const PathPiece& q) {
  const Eigen::Vector3d u = p.end - p.start, v = q.end - q.start;
  // Up to this bend no tangent is more than 15 degrees off its chord.
  constexpr double little = 0.05;
  if (p.sagitta_mm > little * u.norm() || q.sagitta_mm > little * v.norm()) return true;
  // 45 degrees between tangents and 15 on either side make 75 between chords; 0.25 is the cosine of
  // 75.5.
  return std::abs(u.dot(v)) >= 0.25 * u.norm() * v.norm();
}

/// Collects the pieces of later paths that are close to one piece.
class CloseTo : public Tree::Selector {
 public:
  CloseTo(const std::vector<IndexedPiece>& all, std::size_t to) : all_(all), to_(all[to]) {}

  Standard_Boolean Reject(const Bnd_Box& box) const override { return box.IsOut(to_.box); }

  Standard_Boolean Accept(const std::size_t& index) override {
    const IndexedPiece& other = all_[index];
    if (other.path <= to_.path || other.box.IsOut(to_.box)) return false;
    const double reach =
        std::min(to_.reach_mm, other.reach_mm) + to_.piece->sagitta_mm + other.piece->sagitta_mm;
    if (!mayRunTogether(*to_.piece, *other.piece) ||
        chordDistance(*to_.piece, *other.piece) > reach)
      return false;
    found.push_back(index);
    return true;
  }

  std::vector<std::size_t> found;

 private:
  const std::vector<IndexedPiece>& all_;
  const IndexedPiece& to_;
};

}  // namespace

std::map<std::pair<std::size_t, std::size_t>, ClosePieces> findClosePieces(
    const EdgePaths& paths, double match_mm, const Progress& progress) {
  const std::vector<IndexedPiece> all = indexed(paths, match_mm);
  Tree tree;
  NCollection_UBTreeFiller<std::size_t, Bnd_Box> filler(tree);
  for (std::size_t i = 0; i < all.size(); ++i) filler.Add(i, all[i].box);
  filler.Fill();
  std::map<std::pair<std::size_t, std::size_t>, ClosePieces> close;
  for (std::size_t i = 0; i < all.size(); ++i) {
    // Seldom enough that asking costs nothing, often enough that a stop is felt at once.
    if (progress && i % 1024 == 0 &&
        !progress(static_cast<double>(i) / static_cast<double>(all.size())))
      throw Cancelled();
    CloseTo selector(all, i);
    tree.Select(selector);
    std::ranges::sort(selector.found);
    for (const std::size_t index : selector.found)
      close[{all[i].path, all[index].path}].emplace_back(all[i].number, all[index].number);
  }
  return close;
}

}  // namespace seamwright::occ
