#include <isocast/apps/reference/chord_cubic.h>

#include <utility>

namespace isocast::reference {

ChordCubic cubic_along(const ExactChord& chord) {
  const auto lerp = [&](const mpz_class& a, const mpz_class& b, const mpz_class& t) {
    return mpz_class(a * (chord.one - t) + b * t);
  };

  // the field is affine in each coordinate: f at (x of P or Q, y of P or Q, z of P or Q), index by bits, x
  // lowest
  mpz_class blossom[8];
  for (int x = 0; x < 2; ++x) {
    const mpz_class(&px)[3] = x == 0 ? chord.entry : chord.exit;
    mpz_class edges[4];
    for (int e = 0; e < 4; ++e) edges[e] = lerp(chord.f[2 * e], chord.f[2 * e + 1], px[0]);
    for (int y = 0; y < 2; ++y) {
      const mpz_class& py = (y == 0 ? chord.entry : chord.exit)[1];
      const mpz_class near = lerp(edges[0], edges[1], py), far = lerp(edges[2], edges[3], py);
      for (int z = 0; z < 2; ++z)
        blossom[x + 2 * y + 4 * z] = lerp(near, far, (z == 0 ? chord.entry : chord.exit)[2]);
    }
  }
  const ExactCubic b = {blossom[0], blossom[1] + blossom[2] + blossom[4],
                        blossom[3] + blossom[5] + blossom[6], blossom[7]};
  return {b, {b[0], b[1] - 3 * b[0], 3 * b[0] - 2 * b[1] + b[2], b[3] - b[2] + b[1] - b[0]}};
}

// Walks over the roots with the sign of f, which turns at odd ones.
std::vector<SidedRoot> sided_roots(const ExactCubic& p) {
  int sign = 0;
  for (std::size_t i = 0; sign == 0; ++i) sign = sgn(p[i]);
  std::vector<SidedRoot> roots;
  for (ExactRoot& s : roots_in_unit_interval(p)) {
    const bool at_entry = s.exact && s.numerator == 0, at_exit = s.exact && s.numerator == mpz_class(1)
                                                                                               << s.bits;
    const bool negative_before = !at_entry && sign < 0;
    if (!at_entry && s.multiplicity % 2 == 1) sign = -sign;
    roots.push_back({std::move(s), at_entry, at_exit, negative_before, !at_exit && sign < 0});
  }
  return roots;
}

}  // namespace isocast::reference
