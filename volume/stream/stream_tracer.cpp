#include <isocast/volume/bricks/brick_masks.h>
#include <isocast/volume/fetch_cells.h>
#include <isocast/volume/ray_slack.h>
#include <isocast/volume/solve_cells.h>
#include <isocast/volume/solve_packet.h>
#include <isocast/volume/stream/stream_tracer.h>

#include <algorithm>

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
std::uint32_t isos_of(const MarchField& field, const std::int32_t (&cell)[3]) {
  std::int32_t brick[3];
  int block = 0, bit = 0;
  for (int a = 2; a >= 0; --a) {
    const std::int32_t at = cell[a] - field.bricks.origin[a];
    brick[a] = at >> kBrickShift;
    block = block * 4 + (at >> 2 & 3);
    bit = bit * 4 + (at & 3);
  }
  const FoundBrick found = find_brick(field.bricks, brick);
  std::uint32_t isos = 0;
  if (found.number == kNoBrick) return isos;
  for (int iso = 0; iso < field.query->iso_count; ++iso)
    isos |= std::uint32_t(mask_of(field, iso, found.number, brick).cells[block] >> bit & 1) << iso;
  return isos;
}

// All that one stream's rays are on their way.
struct Journey {
  WalkingRays rays;
  RayStarts starts;
};

// The cells that up to 16 rays have found, as solve_cells.h asks for them.
class FoundCells {
 public:
  static constexpr int kLanes = kPacketSize;

  FoundCells(const MarchField& field, const StreamKernels& kernels, const RayStream& rays,
             const Journey& journey, const std::uint16_t* slots, int count)
      : query_(*field.query), rays_(rays), journey_(journey), slots_(slots) {
    kernels.chords(journey.rays, slots, count, chords_);
    for (int l = 0; l < count; ++l)
      for (std::uint32_t isos = query_.iso_count == 1 ? 1 : isos_of(field, chords_.cell[l]); isos;
           isos &= isos - 1)
        held_[__builtin_ctz(isos)] |= 1u << l;
  }

  [[nodiscard]] std::uint32_t holding(int iso, std::uint32_t lanes) const { return held_[iso] & lanes; }

  template <class T>
  std::uint32_t fetch(int iso, std::uint32_t lanes, CellPacket<T>& packet, std::uint32_t& doubtful) const {
    std::int32_t cells[kPacketSize][3];
    int lane[kPacketSize], count = 0;
    for (std::uint32_t rest = lanes; rest; rest &= rest - 1, ++count) {
      lane[count] = __builtin_ctz(rest);
      std::ranges::copy(chords_.cell[lane[count]], cells[count]);
    }
    T f[kPacketSize][8];
    FetchedCell states[kPacketSize];
    fetch_cells(query_, iso, cells, count, f, states);
    std::uint32_t fetched = 0;
    for (int n = 0; n < count; ++n) {
      const int l = lane[n];
      if (states[n] == FetchedCell::doubtful) doubtful |= 1u << l;
      if (states[n] != FetchedCell::exists) continue;
      fetched |= 1u << l;
      for (int k = 0; k < 8; ++k) packet.f[k][l] = f[n][k];
      for (int a = 0; a < 3; ++a) {
        packet.entry[a][l] = T(chords_.entry[a][l]);
        packet.exit[a][l] = T(chords_.exit[a][l]);
      }
      const int slot = slots_[l];
      const RayStarts& s = journey_.starts;
      packet.slack[l] = query_.proves ? slack<T>(slot, l) : T(0);
      if (journey_.rays.fresh[slot])
        set_start(packet, l, iso == s.iso_of_hit[slot] ? s.begin_of_iso[slot] : s.begin[slot], s.known[slot],
                  s.sides[slot], iso);
      else set_start(packet, l, 0, false, 0, iso);
    }
    return fetched;
  }

  [[nodiscard]] bool starts(int l) const {
    std::uint32_t sides = 0;
    return chords_.axis_in[l] == kStart && !known_sides(l, sides);
  }
  bool known_sides(int l, std::uint32_t& sides) const {
    sides = journey_.starts.sides[slots_[l]];
    return journey_.rays.fresh[slots_[l]] && journey_.starts.known[slots_[l]];
  }
  [[nodiscard]] CellRoot place(int l) const {
    const std::int32_t(&cell)[3] = chords_.cell[l];
    return {.t_in = chords_.t_in[l], .t_out = chords_.t_out[l], .cell = {cell[0], cell[1], cell[2]}};
  }
  [[nodiscard]] bool doubt(int l) const { return journey_.starts.doubt[slots_[l]]; }

 private:
  template <class T> [[nodiscard]] T slack(int slot, int l) const {
    const double o[3] = {rays_.ox[slot], rays_.oy[slot], rays_.oz[slot]},
                 d[3] = {rays_.dx[slot], rays_.dy[slot], rays_.dz[slot]};
    return chord_slack<T>(ray_slack(query_, o, d), chords_.t_in[l], chords_.t_out[l]);
  }

  const VolumeQuery& query_;
  const RayStream& rays_;
  const Journey& journey_;
  const std::uint16_t* slots_;
  CellChords chords_;
  std::uint32_t held_[kMaxIsos] = {};  // the lanes whose cell holds each iso-value
};

// Solves the cells of `count` rays from `slots` on; those without a root are put back into the queue.
template <class T>
void solve_found(const MarchField& field, const StreamKernels& kernels, const RayStream& rays,
                 const std::uint16_t* slots, int count, Journey& journey, HitStream& hits,
                 TraceCounts& counts) {
  alignas(64) CellPacket<T> packet = {};
  alignas(64) RootPacket<T> roots = {};
  std::uint32_t cost[kPacketSize] = {};
  const VolumeQuery& query = *field.query;
  const FoundCells cells(field, kernels, rays, journey, slots, count);
  const Nearest<T> nearest = solve_cells(query, cells, (1u << count) - 1, cost, packet, roots, counts);
  for (std::uint32_t rest = nearest.unproved; rest; rest &= rest - 1)
    journey.starts.doubt[slots[__builtin_ctz(rest)]] = true;
  std::uint32_t missed = 0;
  for (int l = 0; l < count; ++l) {
    hits.cost[slots[l]] += cost[l];
    if (nearest.hit >> l & 1) record_hit(query, cells, nearest, l, rays, hits, slots[l]);
    else missed |= 1u << l;
  }
  for (; missed; missed &= missed - 1) {
    const std::uint16_t slot = slots[__builtin_ctz(missed)];
    journey.rays.fresh[slot] = false;
    journey.rays.queue[journey.rays.size++] = slot;
  }
}

template <class T>
void trace(const MarchField& field, const StreamKernels& kernels, const RayStream& rays, Journey& journey,
           HitStream& hits, TraceCounts& counts) {
  WalkingRays& walking = journey.rays;
  std::uint16_t started[kStreamSize];
  const int count = walking.size;
  std::copy_n(walking.queue, count, started);
  while (walking.size > 0) {
    kernels.march(field, walking, counts);
    std::uint16_t found[kStreamSize];
    const int size = walking.size;
    std::copy_n(walking.queue, size, found);
    walking.size = 0;
    for (int n = 0; n < size; n += kPacketSize)
      solve_found<T>(field, kernels, rays, found + n, std::min(kPacketSize, size - n), journey, hits, counts);
  }
  for (int n = 0; n < count; ++n) {
    const std::uint16_t slot = started[n];
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
  kernels.enter(field, rays, t_max, journey.rays);
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
  kernels.enter(field, rays, t_max, journey.rays);
  kernels.resume(rays, hits.cell, journey.rays);
  trace(field, kernels, rays, journey, hits, counts);
}

}  // namespace isocast
