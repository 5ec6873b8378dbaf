// Every instruction set gives the scalar's bits: all methods, options and families, whole chords and parts of
// them.
#include <isocast/apps/bench/cell_families.h>
#include <isocast/apps/bench/judge.h>
#include <isocast/apps/bench/random.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <limits>
#include <vector>

using namespace isocast;
using namespace isocast::bench;

namespace {

struct Variant {
  CellMethod method;
  CellOptions options;
};

// Every combination of the options that a method has.
std::vector<Variant> variants() {
  std::vector<Variant> all = {{CellMethod::midpoint, {}}, {CellMethod::certified, {.adaptive = true}}};
  for (const bool a : {false, true}) {
    all.push_back({CellMethod::linear, {.face = a}});
    all.push_back({CellMethod::schwarze, {.stable = a}});
    for (const bool adaptive : {false, true})
      all.push_back({CellMethod::neubauer, {.iterations = 3, .adaptive = adaptive, .face = a}});
    for (const bool stable : {false, true}) {
      all.push_back({CellMethod::marmitt, {.adaptive = true, .stable = stable, .touch = a}});
      for (const int iterations : {1, 2, 5, 10})
        all.push_back({CellMethod::marmitt, {.iterations = iterations, .stable = stable, .bisection = a}});
    }
  }
  return all;
}

// In every second packet roots are sought behind a point only, with its sign given, given wrongly, or not
// given.
template <class T> void shorten_some(std::vector<CellPacket<T>>& packets, std::uint64_t seed) {
  for (std::size_t i = 0; i < packets.size(); i += 2) {
    Random random(seed, i);
    for (int lane = 0; lane < kPacketSize; ++lane) {
      packets[i].begin[lane] = static_cast<T>(random.below(4) ? random.uniform() : 0);
      const T carries[] = {T(0), -T(0), std::numeric_limits<T>::quiet_NaN()};
      packets[i].carry[lane] = carries[random.below(3)];
    }
    packets[i].active &= static_cast<std::uint32_t>(random.next() | random.next());
  }
}

// Bits of one lane's answer; what a lane without a hit holds means nothing.
template <class T> bool same_bits(const RootPacket<T>& a, const RootPacket<T>& b) {
  if (a.hit != b.hit || a.undecided != b.undecided || (a.sign & a.hit) != (b.sign & b.hit) ||
      a.proved != b.proved)
    return false;
  for (int lane = 0; lane < kPacketSize; ++lane) {
    if (!(a.hit >> lane & 1)) continue;
    const T x[] = {a.s[lane], a.s_lo[lane], a.s_hi[lane]}, y[] = {b.s[lane], b.s_lo[lane], b.s_hi[lane]};
    if (std::memcmp(x, y, sizeof x) != 0) return false;
  }
  return true;
}

}  // namespace

TEMPLATE_TEST_CASE("all instruction sets give the same bits", "[property]", float, double) {
  const std::int64_t per_family =
      test::cases(1'000'000, 10'000'000) / static_cast<std::int64_t>(cell_families().size());
  const std::int64_t slab = std::min<std::int64_t>(per_family, 10'000);
  for (const CellFamily& family : cell_families()) {
    INFO("family " << family.name);
    for (std::int64_t first = 0; first < per_family; first += slab) {
      const auto cells =
          make_cells(family, 11, first, slab, sizeof(TestType) == 4 ? Rounding::to_float : Rounding::none);
      std::vector<CellPacket<TestType>> packets = packets_of<TestType>(cells);
      shorten_some(packets, first);
      for (const Variant& variant : variants()) {
        const auto expected = bench::solve(Isa::scalar, variant.method, variant.options, packets);
        for (const Isa isa : available_isas()) {
          const auto found = bench::solve(isa, variant.method, variant.options, packets);
          std::size_t different = 0;
          for (std::size_t i = 0; i < packets.size(); ++i) different += !same_bits(expected[i], found[i]);
          INFO("method " << int(variant.method) << ", " << name_of(isa) << ", adaptive "
                         << variant.options.adaptive << ", stable " << variant.options.stable
                         << ", iterations " << variant.options.iterations);
          REQUIRE(different == 0);
        }
      }
    }
  }
}
