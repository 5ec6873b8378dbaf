#include <isocast/volume/bricks/brick_masks.h>
#include <isocast/volume/fetch_cells.h>
#include <isocast/volume/ray_slack.h>
#include <isocast/volume/solve_cells.h>
#include <isocast/volume/solve_packet.h>
#include <isocast/volume/stream/stream_tracer.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace isocast {
namespace {

// What is known of the rays of a stream where they start. known: the signs there, which are `sides`; roots
// are sought behind `begin`, and behind `begin_of_iso` for the iso-value that was hit. doubt: of methods that
// prove, something before the ray's cell was not proved.
struct RayStarts {
  double begin[kStreamSize], begin_of_iso[kStreamSize];
  std::uint32_t sides[kStreamSize];
  std::int8_t iso_of_hit[kStreamSize];
  bool known[kStreamSize], doubt[kStreamSize];
};

// The iso-values that a cell holds, as bits.
std::uint32_t isos_of(const MarchField& field, const std::array<std::int32_t, 3>& cell) {
  std::int32_t brick[3];
  int block = 0, bit = 0;
  for (int a = 2; a >= 0; --a) {
    const std::int32_t at = cell[a] - field.bricks.origin[a];
    brick[a] = at >> kBrickShift;
    block = block * 4 + (at >> 2 & 3);
    bit = bit * 4 + (at & 3);
  }
  const std::size_t found = find_brick(field.bricks, brick);
  std::uint32_t isos = 0;
  if (found == kNoBrick) return isos;
  for (int iso = 0; iso < field.query->iso_count; ++iso)
    isos |= std::uint32_t(mask_of(field, iso, found, brick).cells[block] >> bit & 1) << iso;
  return isos;
}

// All that one stream's rays are on their way.
struct Journey {
  WalkingRays rays;
  RayStarts starts;
};

void find_chords(const StreamKernels& kernels, const WalkingRays& rays, const CellQueue& queue, int count,
                 CellChords<float>& chords) {
  kernels.chords_float(rays, queue, count, chords);
}
void find_chords(const StreamKernels& kernels, const WalkingRays& rays, const CellQueue& queue, int count,
                 CellChords<double>& chords) {
  kernels.chords_double(rays, queue, count, chords);
}

// The first cells of a queue, as solve_cells.h asks for them.
template <class T> class FoundCells {
 public:
  static constexpr int kLanes = kPacketSize;

  FoundCells(const MarchField& field, const StreamKernels& kernels, const RayStream& rays,
             const Journey& journey, const CellQueue& queue, int count)
      : query_(*field.query), rays_(rays), starts_(journey.starts), queue_(queue) {
    find_chords(kernels, journey.rays, queue, count, chords_);
    for (std::uint32_t rest = chords_.crossed; rest; rest &= rest - 1) {
      const int l = std::countr_zero(rest);
      for (std::uint32_t isos = query_.iso_count == 1 ? 1 : isos_of(field, cell(l)); isos; isos &= isos - 1)
        held_[std::countr_zero(isos)] |= 1u << l;
    }
  }

  /// Lanes whose ray does cross its cell.
  [[nodiscard]] std::uint32_t crossed() const { return chords_.crossed; }

  [[nodiscard]] std::uint32_t holding(int iso, std::uint32_t lanes) const { return held_[iso] & lanes; }

  std::uint32_t fetch(int iso, std::uint32_t lanes, CellPacket<T>& packet, std::uint32_t& doubtful) const {
    const FetchedLanes fetched =
        fetch_cells(query_, iso, {queue_.cell[0], queue_.cell[1], queue_.cell[2]}, lanes, packet.f);
    std::memcpy(packet.entry, chords_.entry, sizeof packet.entry);
    std::memcpy(packet.exit, chords_.exit, sizeof packet.exit);
    for (int l = 0; l < kPacketSize; ++l) {
      packet.slack[l] = 0;
      set_start(packet, l, 0, false, 0, iso);
    }
    for (std::uint32_t rest = lanes & chords_.first; rest; rest &= rest - 1) {
      const int l = std::countr_zero(rest), slot = queue_.slot[l];
      set_start(packet, l, iso == starts_.iso_of_hit[slot] ? starts_.begin_of_iso[slot] : starts_.begin[slot],
                starts_.known[slot], starts_.sides[slot], iso);
    }
    for (std::uint32_t rest = query_.proves ? lanes : 0; rest; rest &= rest - 1) {
      const int l = std::countr_zero(rest);
      packet.slack[l] = slack(queue_.slot[l], l);
    }
    doubtful |= fetched.doubtful;
    return fetched.exists;
  }

  [[nodiscard]] bool starts(int l) const {
    std::uint32_t sides = 0;
    return chords_.axis_in[l] == kStart && !known_sides(l, sides);
  }
  bool known_sides(int l, std::uint32_t& sides) const {
    sides = starts_.sides[queue_.slot[l]];
    return is_first(l) && starts_.known[queue_.slot[l]];
  }
  [[nodiscard]] CellRoot place(int l) const {
    return {.t_in = chords_.t_in[l],
            .t_out = chords_.t_out[l],
            .cell = {queue_.cell[0][l], queue_.cell[1][l], queue_.cell[2][l]}};
  }
  [[nodiscard]] bool doubt(int l) const { return starts_.doubt[queue_.slot[l]]; }

 private:
  [[nodiscard]] bool is_first(int l) const { return chords_.first >> l & 1; }
  [[nodiscard]] std::array<std::int32_t, 3> cell(int l) const {
    return {queue_.cell[0][l], queue_.cell[1][l], queue_.cell[2][l]};
  }
  [[nodiscard]] T slack(int slot, int l) const {
    const double o[3] = {rays_.ox[slot], rays_.oy[slot], rays_.oz[slot]},
                 d[3] = {rays_.dx[slot], rays_.dy[slot], rays_.dz[slot]};
    return chord_slack<T>(ray_slack(query_, o, d), chords_.t_in[l], chords_.t_out[l]);
  }

  const VolumeQuery& query_;
  const RayStream& rays_;
  const RayStarts& starts_;
  const CellQueue& queue_;
  CellChords<T> chords_;
  std::uint32_t held_[kMaxIsos] = {};  // the lanes whose cell holds each iso-value
};

// The queue without its first `count` cells and without those of rays that have ended.
void drop_cells(const WalkingRays& rays, int count, CellQueue& queue) {
  int size = 0;
  for (int n = count; n < queue.size; ++n) {
    if (rays.ended[queue.slot[n]]) continue;
    for (auto& cell : queue.cell) cell[size] = cell[n];
    queue.tested[size] = queue.tested[n];
    queue.slot[size++] = queue.slot[n];
  }
  queue.size = size;
}

// Finds the roots of one stream's rays.
template <class T> class Solver final : public CellSolver {
 public:
  Solver(const MarchField& field, const StreamKernels& kernels, const RayStream& rays, Journey& journey,
         HitStream& hits, TraceCounts& counts)
      : field_(field), kernels_(kernels), rays_(rays), journey_(journey), hits_(hits), counts_(counts) {}

  void solve(CellQueue& queue) override {
    const int count = std::min(queue.size, kPacketSize);
    alignas(64) CellPacket<T> packet = {};
    alignas(64) RootPacket<T> roots = {};
    std::uint32_t cost[kPacketSize] = {};
    const VolumeQuery& query = *field_.query;
    const FoundCells<T> cells(field_, kernels_, rays_, journey_, queue, count);
    const Nearest<T> nearest = solve_cells(query, cells, cells.crossed(), cost, packet, roots, counts_);
    for (int l = 0; l < count; ++l) {
      const int slot = queue.slot[l];
      if (journey_.rays.ended[slot]) continue;
      hits_.cost[slot] += cost[l];
      if (nearest.unproved >> l & 1) journey_.starts.doubt[slot] = true;
      if (!(nearest.hit >> l & 1)) continue;
      record_hit(query, cells, nearest, l, rays_, hits_, slot);
      journey_.rays.ended[slot] = true;
      journey_.rays.tested[slot] = queue.tested[l];
    }
    drop_cells(journey_.rays, count, queue);
  }

 private:
  const MarchField& field_;
  const StreamKernels& kernels_;
  const RayStream& rays_;
  Journey& journey_;
  HitStream& hits_;
  TraceCounts& counts_;
};

template <class T>
void trace(const MarchField& field, const StreamKernels& kernels, const RayStream& rays, Journey& journey,
           HitStream& hits, TraceCounts& counts) {
  WalkingRays& walking = journey.rays;
  Solver<T> solver(field, kernels, rays, journey, hits, counts);
  kernels.march(field, walking, solver, counts);
  for (int n = 0; n < walking.size; ++n) {
    const std::uint16_t slot = walking.queue[n];
    hits.cost[slot] += walking.tested[slot];
    if (field.query->proves && journey.starts.doubt[slot]) hits.certificate[slot] = Certificate::undecided;
  }
}

void trace(const MarchField& field, const StreamKernels& kernels, const RayStream& rays, Journey& journey,
           HitStream& hits, TraceCounts& counts) {
  if (field.query->double_precision) trace<double>(field, kernels, rays, journey, hits, counts);
  else trace<float>(field, kernels, rays, journey, hits, counts);
}

}  // namespace

const BrickMask& new_mask_of_all(const MarchField& field, std::size_t brick, const std::int32_t (&at)[3]) {
  if (!field.united) return new_mask(field, 0, brick, at);
  return field.united->of(brick, [&] {
    auto all = std::make_unique<BrickMask>();
    for (int iso = 0; iso < field.query->iso_count; ++iso) {
      const BrickMask& mask = mask_of(field, iso, brick, at);
      all->blocks |= mask.blocks;
      for (int b = 0; b < 64; ++b) all->cells[b] |= mask.cells[b];
    }
    return all->blocks ? std::move(all) : nullptr;
  });
}

const BrickMask& new_mask(const MarchField& field, int iso, std::size_t brick, const std::int32_t (&at)[3]) {
  std::int32_t first[3];
  for (int a = 0; a < 3; ++a) first[a] = field.bricks.origin[a] + at[a] * kBrickSize;
  return field.masks[iso]->of(*field.query, iso, brick, first);
}

void trace_first_hits(const MarchField& field, const StreamKernels& kernels, const RayStream& rays,
                      HitStream& hits, TraceCounts& counts) {
  Journey journey;
  double t_max[kStreamSize];
  for (int i = 0; i < rays.size; ++i) t_max[i] = std::min(hits.t[i], rays.t_max[i]);
  kernels.enter(field, rays, t_max, nullptr, journey.rays);
  for (int n = 0; n < journey.rays.size; ++n) {
    const int i = journey.rays.queue[n];
    RayStarts& starts = journey.starts;
    starts.known[i] = rays.start_object[i] == field.query->object;
    starts.sides[i] = rays.start_sides[i];
    starts.begin[i] = 0;
    starts.iso_of_hit[i] = -1;
    starts.doubt[i] = false;
  }
  trace(field, kernels, rays, journey, hits, counts);
}

// A ray goes on behind its hit, which is cleared.
void trace_next_hits(const MarchField& field, const StreamKernels& kernels, const RayStream& rays,
                     HitStream& hits, TraceCounts& counts) {
  Journey journey;
  double t_max[kStreamSize];
  for (int i = 0; i < rays.size; ++i) {
    const bool asked = hits.object[i] == field.query->object && is_hit(hits, i);
    t_max[i] = asked ? rays.t_max[i] : -__builtin_inf();
    if (!asked) continue;
    hits.t[i] = hits.t_lo[i] = hits.t_hi[i] = __builtin_inf();
    RayStarts& starts = journey.starts;
    starts.known[i] = true;
    starts.sides[i] = sides_behind(hits, i);
    starts.begin[i] = hits.s[i];
    starts.begin_of_iso[i] = hits.s_hi[i];
    starts.iso_of_hit[i] = static_cast<std::int8_t>(hits.iso[i]);
    starts.doubt[i] = false;
  }
  kernels.enter(field, rays, t_max, hits.cell, journey.rays);
  trace(field, kernels, rays, journey, hits, counts);
}

}  // namespace isocast
