#include <isocast/render/silhouettes.h>
#include <oneapi/tbb/combinable.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace isocast {
namespace {

// Colours that differ by less are not worth an edge.
constexpr float kLeastDifference = 0.03f;
constexpr int kBand = 32;

// Picture, hits and the colours before any blending.
class Silhouettes {
 public:
  Silhouettes(const Frame& frame, const std::vector<PixelHit>& pixels, const std::vector<float>& colors)
      : frame_(frame), pixels_(pixels), colors_(colors), lines_(frame.view.lines()) {}

  // Blends the rows of a band; many edges at once are looked for faster.
  std::int64_t blend_band(int band, Film& film) const {
    std::vector<Candidate> candidates;
    for (int y = band * kBand; y < std::min((band + 1) * kBand, frame_.view.height()); ++y)
      for (int x = 0; x < frame_.view.width(); ++x) find_candidates(x, y, candidates);
    // each object looks at its own; then the best that was found wins
    for (std::size_t object = 0; object < frame_.objects.size(); ++object) ask(object, candidates);
    std::int64_t blended = 0;
    for (auto at = candidates.begin(); at != candidates.end();) {
      const auto end = std::ranges::find_if(at, candidates.end(),
                                            [&](const Candidate& c) { return c.pixel != at->pixel; });
      const Candidate* best = nullptr;
      for (; at != end; ++at)
        if (at->share >= 0 && (!best || at->along_normal > best->along_normal)) best = &*at;
      // the pixel reaches half way to its neighbour
      const float share = best ? best->beyond ? best->share - 0.5f : 0.5f - best->share : 0;
      if (!(share > 0)) continue;
      ++blended;
      float* const color = film.color(best->pixel);
      const float* const other = &colors_[std::size_t(best->neighbour) * 4];
      for (int c = 0; c < 4; ++c) color[c] = (1 - share) * color[c] + share * other[c];
    }
    return blended;
  }

 private:
  // A pixel with a neighbour, one of which sees an object that the other does not, or behind it.
  struct Candidate {
    std::uint32_t pixel, neighbour, nearer;
    bool beyond;  // the neighbour is the nearer one
    double along_normal;
    EdgeStep step;  // from the nearer to the other
    float share;
  };

  void find_candidates(int x, int y, std::vector<Candidate>& candidates) const {
    const int width = frame_.view.width(), height = frame_.view.height();
    const auto pixel = static_cast<std::uint32_t>(x + y * width);
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
      const int nx = x + dx, ny = y + dy;
      if (nx < 0 || ny < 0 || nx >= width || ny >= height) continue;
      const auto neighbour = static_cast<std::uint32_t>(nx + ny * width);
      const bool beyond = pixels_[pixel].depth >= pixels_[neighbour].depth;
      const std::uint32_t nearer = beyond ? neighbour : pixel;
      const PixelHit& hit = pixels_[nearer];
      if (hit.object == kNoObject || !differ(pixel, neighbour) || bend_alike(pixel, neighbour)) continue;
      const double way = beyond ? -1 : 1, u = beyond ? nx : x, v = beyond ? ny : y;
      const double across[2] = {dot_with(hit, true), dot_with(hit, false)},
                   size = std::hypot(across[0], across[1]);
      candidates.push_back({pixel,
                            neighbour,
                            nearer,
                            beyond,
                            size > 0 ? way * (dx * across[0] + dy * across[1]) / size : 0,
                            {u + 0.5, v + 0.5, way * dx, way * dy, hit.depth, hit.iso},
                            kNoEdge});
    }
  }
  // The normal along the picture's axes.
  [[nodiscard]] double dot_with(const PixelHit& hit, bool u) const {
    double sum = 0;
    for (int a = 0; a < 3; ++a)
      sum += double(hit.normal[a]) * (u ? lines_.o_u[a] + lines_.d_u[a] : lines_.o_v[a] + lines_.d_v[a]);
    return sum;
  }
  // Hits of one sheet: no edge lies between.
  [[nodiscard]] bool bend_alike(std::uint32_t a, std::uint32_t b) const {
    const PixelHit &p = pixels_[a], &q = pixels_[b];
    float cosine = 0;
    for (int c = 0; c < 3; ++c) cosine += p.normal[c] * q.normal[c];
    return p.object == q.object && p.iso == q.iso && cosine > 0.97f;
  }
  [[nodiscard]] bool differ(std::uint32_t a, std::uint32_t b) const {
    for (std::size_t c = 0; c < 4; ++c)
      if (std::abs(colors_[a * std::size_t(4) + c] - colors_[b * std::size_t(4) + c]) > kLeastDifference)
        return true;
    return false;
  }
  void ask(std::size_t object, std::vector<Candidate>& candidates) const {
    std::vector<EdgeStep> steps;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (pixels_[candidates[i].nearer].object == object) {
        steps.push_back(candidates[i].step);
        places.push_back(i);
      }
    if (steps.empty()) return;
    std::vector<float> shares(steps.size(), kNoEdge);
    frame_.scene.objects[object].surface->find_edges(lines_, steps, shares);
    for (std::size_t i = 0; i < places.size(); ++i) candidates[places[i]].share = shares[i];
  }

  const Frame& frame_;
  const std::vector<PixelHit>& pixels_;
  const std::vector<float>& colors_;
  PixelLines lines_;
};

}  // namespace

void keep_hits(const Frame& frame, const Wave& wave, std::vector<PixelHit>& pixels) {
  for (int i = 0; i < wave.rays.size; ++i) {
    if (!is_ray(wave.rays, i) || !is_hit(*wave.hits, i)) continue;
    PixelHit& pixel = pixels[wave.rays.id[i]];
    pixel.depth = static_cast<float>(wave.hits->t[i] * dot(direction_of(wave.rays, i), frame.view.forward()));
    for (std::size_t c = 0; c < 3; ++c) pixel.normal[c] = static_cast<float>(wave.dressed.normal[c][i]);
    pixel.object = wave.hits->object[i];
    pixel.iso = wave.hits->iso[i];
  }
}

std::int64_t blend_silhouettes(const Frame& frame, const std::vector<PixelHit>& pixels, Film& film) {
  const std::vector<float> colors = film.color();
  const Silhouettes silhouettes(frame, pixels, colors);
  oneapi::tbb::combinable<std::int64_t> blended([] { return std::int64_t(0); });
  oneapi::tbb::parallel_for(0, (frame.view.height() + kBand - 1) / kBand,
                            [&](int band) { blended.local() += silhouettes.blend_band(band, film); });
  return blended.combine(std::plus<>());
}

}  // namespace isocast
