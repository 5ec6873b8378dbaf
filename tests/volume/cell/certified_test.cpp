// certified against the exact reference: no proof is ever contradicted, and little stays unproved.
#include <isocast/apps/bench/cell_families.h>
#include <isocast/apps/bench/judge.h>
#include <test_size.h>

#include <bit>
#include <catch2/catch.hpp>
#include <limits>
#include <map>
#include <random>

using namespace isocast;
using namespace isocast::bench;
using reference::CellChord;
using reference::CellReference;

namespace {

constexpr CellOptions kOptions = {.adaptive = true};

template <class T> RootPacket<T> answer(const CellPacket<T>& packet) {
  return solve(widest_isa(), CellMethod::certified, kOptions, std::vector{packet}).front();
}
bool bit(std::uint32_t bits, std::size_t lane) { return (bits >> lane & 1) != 0; }

// What a proof says, held against all roots: none but between s_lo and s_hi, where there is one crossing, up
// to there.
template <class T>
void require_true(const CellReference& truth, const RootPacket<T>& roots, std::size_t lane) {
  const bool hit = bit(roots.hit, lane);
  const double lo = roots.s_lo[lane], hi = roots.s_hi[lane];
  int inside = 0;
  REQUIRE_FALSE(truth.zero);
  for (int i = 0; i < truth.root_count; ++i) {
    const double s = static_cast<double>(truth.roots[i].s);
    REQUIRE((hit && s >= lo));
    if (s > hi) continue;
    ++inside;
    REQUIRE(truth.roots[i].crossing);
    REQUIRE(truth.roots[i].negative_behind == bit(roots.sign, lane));
  }
  REQUIRE(inside == (hit ? 1 : 0));
  if (hit) REQUIRE(hi - lo <= 0x1p-7);
}

}  // namespace

TEMPLATE_TEST_CASE("no proof about a cell is contradicted, in any family", "[property]", float, double) {
  std::map<std::string_view, double> unproved;
  const auto count = static_cast<std::uint64_t>(test::cases(5000, 500000));
  for (const CellFamily& family : cell_families()) {
    INFO(family.name);
    constexpr std::uint64_t kBatch = 5000;
    std::int64_t open = 0;
    for (std::uint64_t first = 0; first < count; first += kBatch) {
      const std::vector<CellChord> chords =
          make_cells(family, 3, first, kBatch, sizeof(TestType) == 4 ? Rounding::to_float : Rounding::none);
      const std::vector<CellReference> truth = reference::solve(chords);
      const auto packets = packets_of<TestType>(chords);
      const auto roots = solve(widest_isa(), CellMethod::certified, kOptions, packets);
      for (std::size_t n = 0; n < chords.size(); ++n) {
        const RootPacket<TestType>& packet = roots[n / kPacketSize];
        if (bit(packet.proved, n % kPacketSize)) require_true(truth[n], packet, n % kPacketSize);
        else ++open;
      }
    }
    unproved[family.name] = static_cast<double>(open) / static_cast<double>(count);
  }
  // where nothing is hidden by roundings next to nothing may stay open
  for (const char* name : {"random", "smooth", "mc-1-corner", "mc-2-face"}) {
    INFO(name << " " << unproved[name]);
    REQUIRE(unproved.contains(name));
    CHECK(unproved[name] < (sizeof(TestType) == 4 ? 1e-3 : 1e-4));
  }
}

TEMPLATE_TEST_CASE("proofs of a chord hold for every chord within its slack", "[property]", float, double) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> part(-1, 1);
  const double slack = sizeof(TestType) == 4 ? 0x1p-18 : 0x1p-30;
  std::int64_t proved = 0;
  for (const char* name : {"random", "smooth", "close-roots", "thin"}) {
    const auto chords = make_cells(cell_family(name), 4, 0,
                                   static_cast<std::uint64_t>(test::cases(4000, 200000)), Rounding::to_float);
    auto packets = packets_of<TestType>(chords);
    for (auto& packet : packets)
      for (TestType& s : packet.slack) s = static_cast<TestType>(slack);
    const auto roots = solve(widest_isa(), CellMethod::certified, kOptions, packets);
    for (std::size_t n = 0; n < chords.size(); ++n) {
      const RootPacket<TestType>& packet = roots[n / kPacketSize];
      if (!bit(packet.proved, n % kPacketSize)) continue;
      ++proved;
      CellChord moved = chords[n];
      for (int a = 0; a < 3; ++a) {
        moved.entry[a] = std::clamp(moved.entry[a] + slack * part(random), 0.0, 1.0);
        moved.exit[a] = std::clamp(moved.exit[a] + slack * part(random), 0.0, 1.0);
      }
      require_true(reference::solve(moved), packet, n % kPacketSize);
    }
  }
  CHECK(proved > 10000);
}

TEMPLATE_TEST_CASE("behind a proved root the next one is proved, to the last", "", float, double) {
  const auto chords = make_cells(cell_family("random"), 6, 0, 20000, Rounding::to_float);
  int seconds = 0;
  for (std::size_t first = 0; first < chords.size(); first += kPacketSize) {
    CellPacket<TestType> packet = packets_of<TestType>(std::span(chords).subspan(first, kPacketSize)).front();
    RootPacket<TestType> roots = answer(packet);
    std::uint32_t asked = roots.hit & roots.proved;
    std::vector<CellReference> truth(kPacketSize);
    for (std::size_t l = 0; l < kPacketSize; ++l) truth[l] = reference::solve(chords[first + l]);
    std::vector<int> seen(kPacketSize, 0);
    while (asked != 0) {
      for (std::size_t l = 0; l < kPacketSize; ++l) {
        if (!bit(asked, l)) continue;
        ++seen[l];
        packet.begin[l] = roots.s_hi[l];
        packet.carry[l] = bit(roots.sign, l) ? TestType(-0.0) : TestType(0);
      }
      packet.active = asked;
      roots = answer(packet);
      for (std::size_t l = 0; l < kPacketSize; ++l)
        if (bit(asked & roots.proved & ~roots.hit, l)) CHECK(seen[l] == truth[l].root_count);
      seconds += std::popcount(asked & roots.proved & roots.hit);
      asked &= roots.proved & roots.hit;
    }
  }
  CHECK(seconds > 100);
}

TEST_CASE("nothing is proved where sums of corners overflow, whatever the other lanes hold") {
  CellPacket<float> packet = {};
  for (int l = 0; l < kPacketSize; ++l) {
    for (int k = 0; k < 8; ++k) packet.f[k][l] = k == 7 ? -3e38f : static_cast<float>(5 + k);
    const float entry[3] = {0.77f, 0.47f, 0}, exit[3] = {0.79f, 1, 0.43f};
    for (int a = 0; a < 3; ++a) {
      packet.entry[a][l] = entry[a];
      packet.exit[a][l] = exit[a];
    }
    packet.carry[l] = std::numeric_limits<float>::quiet_NaN();
  }
  packet.active = 0xffff;
  const RootPacket<float> alone = answer(packet);
  CHECK(alone.proved == 0);
  for (int l = 1; l < kPacketSize; ++l) packet.f[7][l] = -5;  // cells with a root
  const RootPacket<float> among = answer(packet);
  CHECK_FALSE(bit(among.proved, 0));
  CHECK(bit(among.hit, 0) == bit(alone.hit, 0));
}
