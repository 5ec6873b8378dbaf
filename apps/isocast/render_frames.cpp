#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/isocast/batch.h>
#include <isocast/apps/isocast/frame_scene.h>
#include <isocast/apps/isocast/render_frames.h>
#include <isocast/apps/isocast/stats.h>
#include <isocast/apps/scene_build/animation.h>
#include <isocast/base/error.h>
#include <isocast/base/interrupt.h>
#include <isocast/base/mapped_file.h>
#include <isocast/base/output_file.h>
#include <isocast/render/image_file.h>
#include <isocast/render/render.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <algorithm>
#include <chrono>
#include <optional>

namespace isocast {
namespace {
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

bool is_exr(const std::string& output) {
  const std::string extension = fs::path(output).extension().string();
  if (extension != ".exr" && extension != ".png")
    throw InputError(fmt::format("-o {}: expected a name that ends with .png or .exr", output));
  return extension == ".exr";
}

// Volumes that have the frame's number in their names change by themselves, and so do animations.
std::optional<std::array<int, 2>> animation_of(const RenderWords& words, const SceneDescription& scene) {
  const bool numbered = words.input.find('%') != std::string::npos &&
                        std::holds_alternative<VolumeSource>(scene.objects.front().source);
  return scene.animation || numbered ? std::optional(frames_of(scene)) : std::nullopt;
}

class FrameRenderer {
 public:
  FrameRenderer(const RenderWords& words, std::string version)
      : words_(words),
        version_(std::move(version)),
        exr_(is_exr(words.output)),
        layers_(parse_layers(words, exr_)),
        evaluation_(evaluation_of(words)),
        threads_(words.threads > 0 ? words.threads : oneapi::tbb::info::default_concurrency()),
        scene_(words, describe_all(words), evaluation_),
        settings_(settings_of(words, scene_.all().wishes)),
        size_(size_of(words, scene_.all())) {
    const std::vector<FrameJob> all = frame_jobs(words, animation_of(words, scene_.all()));
    several_ = all.size() > 1;
    jobs_ = shard_of(all, words.shard);
    if (several_ || words.resume) manifest_.emplace(manifest_path(words.output, words.shard), version_);
    if (words.resume) known_ = read_manifests(words.output);
    for (const fs::path& input : scene_.inputs())
      if (input == words.input) scene_hash_ = hashes_.of(input);
    // bad names fail before the work
    if (jobs_.empty()) return;
    { const OutputFile writable(path_of(jobs_.front())); }
    if (!words.stats.empty() && words.stats != "-") { const OutputFile writable(stats_path(jobs_.front())); }
  }

  void run() {
    const oneapi::tbb::global_control limit(oneapi::tbb::global_control::max_allowed_parallelism,
                                            static_cast<std::size_t>(threads_));
    std::size_t there = 0;
    for (const FrameJob& job : jobs_) {
      const std::string hash = job_hash(job);
      if (is_there(job, hash)) {
        ++there;
        continue;
      }
      render_one(job, hash);
    }
    if (manifest_) manifest_->write();
    if (words_.resume) fmt::print(stderr, "{} of {} frames were there already\n", there, jobs_.size());
  }

 private:
  [[nodiscard]] fs::path path_of(const FrameJob& job) const {
    return frame_path(words_.output, job.number, several_);
  }
  [[nodiscard]] fs::path stats_path(const FrameJob& job) const {
    return frame_path(words_.stats, job.number, several_);
  }

  [[nodiscard]] std::string job_hash(const FrameJob& job) const {
    Hash hash;
    hash.add(version_ + "\n" + scene_hash_ + "\n" + picture_text(words_, job));
    return hash.text();
  }

  // Whether a frame need not be rendered; then its record goes on.
  bool is_there(const FrameJob& job, const std::string& hash) {
    const auto [begin, end] = known_.equal_range(job.number);
    const auto found = std::find_if(
        begin, end, [&](const auto& known) { return is_done(known.second, hash, path_of(job), hashes_); });
    if (found == end) return false;
    manifest_->add(found->second);
    return true;
  }

  void render_one(const FrameJob& job, const std::string& hash) {
    const Clock::time_point start = Clock::now();
    scene_.go_to(job);
    const BuiltScene& built = scene_.built();
    if (!built.proves() && std::ranges::find(layers_, Layer::certificate) != layers_.end())
      throw InputError(
          fmt::format("--aov certificate: the method {} proves nothing with these options "
                      "('isocast methods' says which do)",
                      built.objects.front().method));
    const auto [width, height] = size_;
    const View view(frame(built.scene.bounds(), scene_.description().camera, double(width) / height), width,
                    height);
    Film film(width, height, layers_);
    const Clock::time_point render_start = Clock::now();
    RenderCounts counts;
    {
      Progress progress("rendering", tile_count(view));
      counts = render(built.scene, view, settings_, film, interrupt_token(), &progress);
    }
    const double render_ms = ms_since(render_start);
    const Clock::time_point write_start = Clock::now();
    write(path_of(job), film, hash);
    const double write_ms = ms_since(write_start);
    if (manifest_) manifest_->add(record_of(job, hash, render_ms + write_ms));
    if (words_.stats.empty()) return;
    const FrameReport report{built,
                             find_features(built.scene, film, settings_),
                             counts,
                             isa_word(evaluation_),
                             words_.precision,
                             threads_,
                             width,
                             height,
                             settings_.spp,
                             render_ms,
                             write_ms,
                             ms_since(start)};
    const std::string text = stats_json(report, version_);
    if (words_.stats == "-") fmt::print("{}", text);
    else write_text_file(stats_path(job), text);
  }

  void write(const fs::path& path, const Film& film, const std::string& hash) const {
    const auto [width, height] = size_;
    if (!exr_) return write_png(path, width, height, film.color().data());
    std::vector<std::string> methods;
    for (const BuiltObject& object : scene_.built().objects)
      if (!object.method.empty() && std::ranges::find(methods, object.method) == methods.end())
        methods.push_back(object.method);
    const ChannelNames names =
        words_.exr_names == "compositor" ? ChannelNames::compositor : ChannelNames::plain;
    write_exr(path, width, height, image_layers(film, true, names),
              {{"isocast:version", version_},
               {"isocast:scene", hash},
               {"isocast:method", fmt::format("{}", fmt::join(methods, ", "))}});
  }

  [[nodiscard]] FrameRecord record_of(const FrameJob& job, const std::string& hash, double ms) {
    FrameRecord record;
    record.frame = job.number;
    record.job = hash;
    for (const fs::path& input : scene_.inputs())
      record.inputs.push_back({input.string(), hashes_.of(input)});
    const fs::path path = path_of(job);
    record.file = path.filename().string();
    record.hash = FileHashes().of(path);
    record.bytes = fs::file_size(path);
    record.ms = ms;
    record.finished =
        std::chrono::duration_cast<std::chrono::seconds>(std::chrono::system_clock::now().time_since_epoch())
            .count();
    return record;
  }

  const RenderWords& words_;
  std::string version_, scene_hash_;  // scene_hash_: of a scene file
  bool exr_, several_ = false;
  std::vector<Layer> layers_;
  EvaluationSettings evaluation_;
  int threads_;
  FrameScene scene_;
  RenderSettings settings_;
  std::array<int, 2> size_;
  std::vector<FrameJob> jobs_;
  std::optional<Manifest> manifest_;
  std::multimap<int, FrameRecord> known_;
  FileHashes hashes_;
};

}  // namespace

void render_frames(const RenderWords& words, const std::string& version) {
  FrameRenderer(words, version).run();
}

}  // namespace isocast
