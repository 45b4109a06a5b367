// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include <seamwright/occ_adapter/repair/reasons.hpp>
#include <seamwright/occ_adapter/repair/repair_stages.hpp>

namespace seamwright::occ {

namespace {

/// Progress at the ends of the stages. Most of the time is spent while all faces move together.
constexpr double share_of_paths = 0.1, share_of_moves = 0.6, share_of_g1 = 0.7;

/// Shares of the time limit after which a stage is stopped. They leave time for the stages that
/// repair single seams, each of which is quick.
constexpr double time_of_paths = 0.5, time_of_g2 = 0.6, time_of_moves = 0.9, time_of_single = 1;

RepairTask taskOf(const RepairContext& context, const RepairState& state, std::vector<int> orders,
                  bool neighbours_help = false) {
  return {.shape = state.shape,
          .seams = state.seams,
          .to_keep = state.to_keep,
          .before = state.after.seams,
          .faces = context.faces,
          .sharp = context.sharp,
          .options = context.options,
          .unusable = context.unusable,
          .needed = context.needed,
          .limits_mm = context.limits_mm,
          .given = context.model.shape,
          .moved_mm = state.moves,
          .orders = std::move(orders),
          .neighbours_help = neighbours_help};
}

/// Runs a stage and keeps its result.
/// \param asked order that the stage tries, by seam. \param share share of the time limit after
/// which the stage is stopped, without effect.
template <class Stage>
void keepInTime(const RepairContext& context, const std::vector<int>& asked, double share,
                const Progress& progress, const Stage& stage, RepairState& state) {
  std::optional<Improvement> done = context.time.within(share, progress, stage);
  if (done)
    state.keep(asked, context.options, context.sharp, std::move(*done));
  else
    state.out_of_time = true;
}

bool hasLevel(const RepairContext& context, const RepairState& state, std::size_t seam,
              Level level) {
  return isRepaired(state.after.seams[seam], context.sharp[seam], context.options.tolerance, level);
}

/// Chooses seams whose moving faces are distinct and do not meet, from the smallest angle on.
std::vector<std::size_t> apart(const RepairState& state, const std::set<std::size_t>& seams,
                               bool neighbours_help) {
  std::vector<std::size_t> order(seams.begin(), seams.end());
  const auto angle = [&state](std::size_t i) {
    const auto& figure = state.after.seams[i].figures.angle_rad;
    return figure ? figure->lower : 0;
  };
  std::ranges::stable_sort(order, {}, angle);
  const FacesAtVertices around(state.shape);
  std::map<int, std::set<int>> beside;
  for (const Seam& seam : state.seams) {
    beside[seam.sides[0].face].insert(seam.sides[1].face);
    beside[seam.sides[1].face].insert(seam.sides[0].face);
  }
  std::set<int> taken;
  std::vector<std::size_t> chosen;
  for (const std::size_t i : order) {
    const auto& sides = state.seams[i].sides;
    const std::set<int> moving =
        neighbours_help ? around.of(state.seams[i]) : std::set<int>{sides[0].face, sides[1].face};
    if (std::ranges::any_of(moving, [&taken](int face) { return taken.count(face) > 0; })) continue;
    chosen.push_back(i);
    for (const int face : moving) {
      taken.insert(face);
      taken.insert(beside[face].begin(), beside[face].end());
    }
  }
  return chosen;
}

/// The seams that still miss their target and have a face that can move, with their orders. Others
/// get a reason.
std::vector<int> ordersToMove(const RepairContext& context, std::vector<int> orders, Level target,
                              RepairState& state) {
  for (std::size_t i = 0; i < orders.size(); ++i) {
    if (hasLevel(context, state, i, target)) orders[i] = 0;
    if (orders[i] == 0) continue;
    const RepairReason obstacle = whyNoneMoves(state.after.seams[i].faces, context.faces);
    if (obstacle.empty()) {
      state.reasons[i] = {};
      continue;
    }
    RepairReason& reason = state.reasons[i].target;
    reason = why::joined(obstacle, reason.empty() && state.out_of_time ? why::timeLimit() : reason);
    orders[i] = 0;
  }
  return orders;
}

/// The seams that still miss G1, with order 1.
std::vector<int> ordersForG1(const RepairContext& context, std::vector<int> orders,
                             const RepairState& state) {
  for (std::size_t i = 0; i < orders.size(); ++i)
    orders[i] = hasLevel(context, state, i, Level::G1) ? 0 : std::min(orders[i], 1);
  return orders;
}

/// Repairs several seams at a time, as long as no face of one is next to a face of another.
void repairInBatches(const RepairContext& context, const std::vector<int>& orders, Level level,
                     bool neighbours_help, const Progress& progress, RepairState& state) {
  // Bounds the time. In most models every seam is in one of the first few batches.
  constexpr int most_batches = 8;
  std::set<std::size_t> left;
  for (std::size_t i = 0; i < orders.size(); ++i)
    if (orders[i] > 0 && !hasLevel(context, state, i, level)) left.insert(i);
  for (int batch = 0; batch < most_batches && !left.empty(); ++batch) {
    std::vector<int> of_batch(orders.size(), 0);
    for (const std::size_t i : apart(state, left, neighbours_help)) {
      of_batch[i] = orders[i];
      left.erase(i);
    }
    const auto move = [&](const Progress& part) {
      return improveByMoves(taskOf(context, state, of_batch, neighbours_help), part);
    };
    keepInTime(
        context, of_batch, time_of_single,
        partOf(progress, static_cast<double>(batch) / most_batches, (batch + 1.0) / most_batches),
        move, state);
  }
}

/// Repairs seams that are still below the level one by one, from the smallest angle on. They may
/// have failed only because of seams that were solved together with them. Seams that fail again are
/// tried once more, with the faces around their ends moving too.
void repairAlone(const RepairContext& context, const std::vector<int>& orders, Level level,
                 const Progress& progress, RepairState& state) {
  repairInBatches(context, orders, level, false, partOf(progress, 0, 0.5), state);
  repairInBatches(context, orders, level, true, partOf(progress, 0.5, 1), state);
}

}  // namespace

RepairState repairInStages(const RepairContext& context, RepairState state,
                           const std::vector<bool>& wanted, const Progress& progress) {
  const int order = anyCurvatureDoes(context.options.tolerance) ? 1 : context.options.order;
  std::vector<int> treated(wanted.size());
  std::ranges::transform(wanted, treated.begin(),
                         [order](bool is_wanted) { return is_wanted ? order : 0; });
  keepInTime(
      context, treated, time_of_paths, partOf(progress, 0, share_of_paths),
      [&](const Progress& part) { return improveByPaths(taskOf(context, state, treated), part); },
      state);
  const std::vector<int> to_move = ordersToMove(context, treated, levelOf(order), state);
  keepInTime(
      context, to_move, order > 1 ? time_of_g2 : time_of_moves,
      partOf(progress, share_of_paths, share_of_moves),
      [&](const Progress& part) { return improveByMoves(taskOf(context, state, to_move), part); },
      state);
  const std::vector<int> to_g1 = ordersForG1(context, to_move, state);
  if (order > 1)
    keepInTime(
        context, to_g1, time_of_moves, partOf(progress, share_of_moves, share_of_g1),
        [&](const Progress& part) { return improveByMoves(taskOf(context, state, to_g1), part); },
        state);
  const double alone = order > 1 ? (share_of_g1 + 1) / 2 : 1;
  repairAlone(context, to_g1, Level::G1, partOf(progress, share_of_g1, alone), state);
  if (order > 1) repairAlone(context, to_move, Level::G2, partOf(progress, alone, 1), state);
  return state;
}

}  // namespace seamwright::occ
