#include <isocast/apps/bench/paper_rows.h>
#include <isocast/apps/bench/papers_reimers_form.h>
#include <isocast/apps/bench/papers_reimers_picture.h>
#include <isocast/apps/bench/picture_reference.h>
#include <isocast/implicit/expression/degree.h>
#include <isocast/implicit/methods.h>
#include <isocast/render/render.h>
#include <oneapi/tbb/task_arena.h>

#include <cassert>
#include <optional>

namespace isocast::bench {
namespace {

constexpr int kSampledRay = 61;

class ReimersPicture {
 public:
  ReimersPicture(const PictureCase& picture, const ReimersWishes& wishes)
      : picture_(picture),
        wishes_(wishes),
        built_(build_scene(with(picture.scene, NormalKind::gradient), {})),
        by_neighbours_(build_scene(with(picture.scene, NormalKind::neighbour), {})),
        view_(frame(surface().bounds(), picture.scene.camera, double(picture.width) / picture.height),
              picture.width, picture.height),
        rays_(primary_rays(picture, surface().bounds())),
        hits_(rays_.size()) {
    use({reference_finder(), true});
    cast_all();
    const auto& f = std::get<FormulaSource>(picture.scene.objects.front().source);
    const DepthRange depths = depths_of(view_, surface().bounds());
    const double scale = largest_coefficient(f, *polynomial_degree(f.expression).degree, view_, depths);
    judge_.emplace(view_, depths, rays_, hits_, scale, wishes.part);
    sample_rays();
    truth_ = solve_picture(picture.scene, built_, sampled_, wishes.cache);
    add_normals(truth_, surface(), sampled_, sampled_hits());
  }

  ReimersFindings run() {
    ways_.push_back({reference_finder(), true});
    ways_.insert(ways_.end(), wishes_.ways.begin(), wishes_.ways.end());
    for (const FinderWay& way : ways_) {
      use(way);
      cast_all();
      findings_.results.push_back({judged(way), judge_->numbers(surface(), hits_)});
    }
    compare_normals();
    time_all();
    return std::move(findings_);
  }

 private:
  static SceneDescription with(SceneDescription scene, NormalKind normals) {
    scene.objects.front().normals = normals;
    return scene;
  }
  [[nodiscard]] const Surface& surface() const { return *built_.scene.objects.front().surface; }
  void use(const FinderWay& way) {
    built_.objects.front().change_method(way.setting.method, way.setting.set, {widest_isa(), way.precise});
  }

  // Every block of the picture; done(bx, by) with its hits in block_.
  template <class Done> void cast(Done done) {
    const std::unique_ptr<PrimaryPass> pass = surface().primary(view_);
    assert(pass);
    TraceCounts counts;
    constexpr int kPixels = kBlockTiles * kTileSize;
    for (int by = 0; by * kPixels < picture_.height; ++by)
      for (int bx = 0; bx * kPixels < picture_.width; ++bx) {
        block_->reset(surface().proves());
        pass->first_hits(bx, by, 0.5, 0.5, *block_, counts);
        done(bx, by);
      }
  }
  void cast_all() {
    const int columns = (picture_.width + kTileSize - 1) / kTileSize,
              rows = (picture_.height + kTileSize - 1) / kTileSize;
    cast([&](int bx, int by) {
      for (int y = by * kBlockTiles; y < std::min(rows, (by + 1) * kBlockTiles); ++y)
        for (int x = bx * kBlockTiles; x < std::min(columns, (bx + 1) * kBlockTiles); ++x)
          hits_[static_cast<std::size_t>(x + y * columns)] =
              block_->tile(x - bx * kBlockTiles, y - by * kBlockTiles);
    });
  }

  // Every 61st ray, numbered anew.
  void sample_rays() {
    each_ray(rays_, [&](std::size_t s, int i) {
      if (rays_[s].id[i] % kSampledRay != 0) return;
      if (places_.size() % kStreamSize == 0) {
        sampled_.emplace_back(rays_[s]).size = 0;
        for (int n = 0; n < kStreamSize; ++n) sampled_.back().t_min[n] = 1, sampled_.back().t_max[n] = 0;
      }
      const RayStream& from = rays_[s];
      RayStream& to = sampled_.back();
      const int n = to.size++;
      to.ox[n] = from.ox[i], to.oy[n] = from.oy[i], to.oz[n] = from.oz[i];
      to.dx[n] = from.dx[i], to.dy[n] = from.dy[i], to.dz[n] = from.dz[i];
      to.t_min[n] = from.t_min[i], to.t_max[n] = from.t_max[i];
      to.id[n] = static_cast<std::uint32_t>(places_.size());
      places_.emplace_back(s, i);
    });
  }
  [[nodiscard]] std::vector<HitStream> sampled_hits() const {
    std::vector<HitStream> hits(sampled_.size());
    clear(hits);
    for (std::size_t n = 0; n < places_.size(); ++n)
      copy_slot(hits_[places_[n].first], places_[n].second, hits[n / kStreamSize],
                static_cast<int>(n % kStreamSize));
    return hits;
  }

  Row judged(const FinderWay& way) const {
    Row row;
    row.suite = picture_.suite, row.case_name = picture_.name;
    row.method = way.setting.method, row.setting = way.setting.text;
    row.isa = name_of(widest_isa()), row.precision = way.precise ? "double" : "float";
    row.proves = way.setting.proves;
    summarize(judge_picture(truth_, surface(), sampled_, sampled_hits()), row);
    row.undecided_reference += picture_.rays() - row.rays;
    row.rays = picture_.rays();
    return row;
  }

  using Normals = std::vector<Double3>;  // of the picture's pixels
  [[nodiscard]] Normals normals(const BuiltScene& scene, const std::vector<HitStream>& hits) const {
    Normals result(static_cast<std::size_t>(picture_.rays()));
    std::vector<DressedHits> looks(rays_.size());
    for (std::size_t s = 0; s < rays_.size(); ++s) dress(scene, hits, s, looks[s]);
    each_ray(rays_, [&](std::size_t s, int i) {
      const auto& normal = looks[s].normal;
      if (is_hit(hits[s], i)) result[rays_[s].id[i]] = {normal[0][i], normal[1][i], normal[2][i]};
    });
    return result;
  }
  void dress(const BuiltScene& scene, const std::vector<HitStream>& hits, std::size_t s,
             DressedHits& looks) const {
    scene.scene.objects.front().surface->dress(rays_[s], hits[s], {.normal = true}, looks);
  }
  // As a renderer does: in one place, and what is dressed is in the cache, where finding it has left it.
  static constexpr int kDressings = 8;
  void dress_all(const BuiltScene& scene, const std::vector<HitStream>& hits) {
    for (std::size_t s = 0; s < rays_.size(); ++s)
      for (int again = 0; again < kDressings; ++again) dress(scene, hits, s, *looks_);
  }

  // Median between two kinds of normal of hits, away from edges, in degrees.
  [[nodiscard]] double angle_between(const Normals& a, const Normals& b) const {
    std::vector<double> angles;
    for (std::size_t pixel = 0; pixel < a.size(); ++pixel)
      if (length(a[pixel]) > 0 && !judge_->is_edge(static_cast<std::uint32_t>(pixel)))
        angles.push_back(angle_in_degrees(a[pixel], b[pixel]));
    return quantile(angles, 0.5);
  }
  void compare_normals() {
    const std::vector<HitStream>& hits = judge_->reference();
    each_ray(rays_, [&](std::size_t s, int i) { findings_.shading.hits += is_hit(hits[s], i); });
    findings_.shading.angle = angle_between(normals(built_, hits), normals(by_neighbours_, hits));
    use(form_);
    cast_all();
    const Normals form = normals(built_, hits_);
    use(lr_);
    findings_.shading.form_angle = angle_between(normals(built_, hits_), form);
  }

  void render_frame(bool silhouettes, int samples) {
    Film film(picture_.width, picture_.height, {});
    (void)render(built_.scene, view_, {.spp = samples, .silhouettes = silhouettes}, film);
  }

  void time_all() {
    std::vector<std::function<void()>> candidates(ways_.size(), [this] { cast([](int, int) {}); });
    candidates.emplace_back(candidates.front());
    candidates.emplace_back([this] { dress_all(built_, hits_); });
    const std::size_t passes = ways_.size(), forms = candidates.size();
    candidates.emplace_back(candidates.front());
    candidates.emplace_back([this] { dress_all(built_, judge_->reference()); });
    candidates.emplace_back([this] { dress_all(by_neighbours_, judge_->reference()); });
    for (const auto& [silhouettes, samples] : {std::pair{false, 1}, {true, 1}, {false, 4}})
      candidates.emplace_back([this, silhouettes, samples] { render_frame(silhouettes, samples); });
    const auto prepare = [&](std::size_t c) { use(c < passes ? ways_[c] : c < forms ? form_ : lr_); };
    std::vector<Timing> timings;
    oneapi::tbb::task_arena alone(1);
    alone.execute(
        [&] { timings = time_interleaved(candidates, wishes_.repetitions, Clock::thread, prepare); });
    for (std::size_t c = 0; c < passes; ++c) set_timing(findings_.results[c].row, timings[c]);
    ShadingNumbers& shading = findings_.shading;
    double by_lr = 0, by_form = 0;
    double* const seconds[] = {&by_form,
                               &shading.form,
                               &by_lr,
                               &shading.gradients,
                               &shading.neighbours,
                               &shading.frame,
                               &shading.silhouettes,
                               &shading.four_samples};
    for (std::size_t k = 0; k < std::size(seconds); ++k) *seconds[k] = timings[passes + k].seconds;
    for (double* const dressing : {&shading.form, &shading.gradients, &shading.neighbours})
      *dressing /= kDressings;
    shading.form += by_form - by_lr;
  }

  const FinderWay lr_ = {finder("frustum-lr")}, form_ = {finder("frustum-lr", {{"gradient", "form"}})};
  const PictureCase& picture_;
  const ReimersWishes& wishes_;
  BuiltScene built_, by_neighbours_;
  View view_;
  std::vector<RayStream> rays_, sampled_;
  std::vector<HitStream> hits_;
  std::unique_ptr<DressedHits> looks_ = std::make_unique<DressedHits>();
  std::optional<SearchJudge> judge_;
  std::vector<std::pair<std::size_t, int>> places_;  // of the sampled rays
  std::unique_ptr<BlockHits> block_ = std::make_unique<BlockHits>();
  PictureTruth truth_;
  std::vector<FinderWay> ways_;
  ReimersFindings findings_;
};

}  // namespace

MethodSetting finder(const std::string& method, std::map<std::string, std::string> set) {
  set.emplace("eps", "0.0005");
  return paper_setting(formula_methods(), method, set);
}

MethodSetting reference_finder() { return finder("frustum-mr", {{"eps", "1e-08"}}); }

ReimersFindings run_finders(const PictureCase& picture, const ReimersWishes& wishes) {
  return ReimersPicture(picture, wishes).run();
}

}  // namespace isocast::bench
