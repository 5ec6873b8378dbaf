#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/isocast/batch.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/base/error.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace isocast {
namespace {

constexpr int kMostFrames = 1'000'000;

std::optional<int> whole_number(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && !text.empty() ? std::optional(number)
                                                                                   : std::nullopt;
}

// "A:B" as whole numbers, A not above B.
std::array<int, 2> parse_frame_range(const std::string& text) {
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() == 2) {
    const std::optional<int> first = whole_number(parts[0]), last = whole_number(parts[1]);
    if (first && last && *first >= 0 && *first <= *last && *last - *first < kMostFrames)
      return {*first, *last};
  }
  throw InputError(fmt::format("--frames {}: expected FIRST:LAST, whole numbers from 0 on, at most {} frames",
                               text, kMostFrames));
}

std::vector<FrameJob> sweep_jobs(const std::string& text) {
  const std::vector<std::string> parts = split(text, ':');
  const double n = parts.size() == 3 ? parse_number(parts[2], "--iso-sweep") : 0;
  if (!(n >= 1 && n <= kMostFrames && n == std::floor(n)))
    throw InputError(fmt::format("--iso-sweep {}: expected FROM:TO:COUNT", text));
  const double from = parse_number(parts[0], "--iso-sweep"), to = parse_number(parts[1], "--iso-sweep");
  std::vector<FrameJob> jobs;
  for (int i = 0; i < n; ++i) jobs.push_back({i, {n == 1 ? from : from + (to - from) * i / (n - 1)}, {}});
  return jobs;
}

bool is_ramp(const std::string& time) { return time.find(':') != std::string::npos; }

void set_times(std::vector<FrameJob>& jobs, const std::string& text) {
  const std::vector<std::string> parts = split(text, ':');
  if (parts.size() != 2)
    throw InputError(fmt::format("--time {}: expected T, or FROM:TO over the frames", text));
  const double from = parse_number(parts[0], "--time"), to = parse_number(parts[1], "--time");
  const double last = static_cast<double>(jobs.size()) - 1;
  for (std::size_t i = 0; i < jobs.size(); ++i)
    jobs[i].time = last > 0 ? from + (to - from) * static_cast<double>(i) / last : from;
}

}  // namespace

std::vector<FrameJob> frame_jobs(const RenderWords& words, std::optional<std::array<int, 2>> animation) {
  const bool ramp = is_ramp(words.time);
  std::vector<FrameJob> jobs;
  if (!words.iso_sweep.empty()) {
    if (!words.iso.empty()) throw InputError("--iso and --iso-sweep exclude each other");
    jobs = sweep_jobs(words.iso_sweep);
  } else {
    std::array<int, 2> range = animation.value_or(std::array{0, 0});
    if (!words.frames.empty()) {
      if (!ramp && !animation)
        throw InputError(
            fmt::format("--frames {}: nothing changes from frame to frame; expected a scene with an "
                        "animation, --iso-sweep or --time FROM:TO",
                        words.frames));
      range = parse_frame_range(words.frames);
    } else if (ramp && !animation)
      throw InputError(
          fmt::format("--time {}: expected --frames or --iso-sweep to say how many frames", words.time));
    const std::vector<double> iso =
        words.iso.empty() ? std::vector<double>{} : parse_numbers(words.iso, "--iso");
    for (int number = range[0]; number <= range[1]; ++number) jobs.push_back({number, iso, {}});
  }
  if (ramp) set_times(jobs, words.time);
  else if (!words.time.empty())
    for (FrameJob& job : jobs) job.time = parse_number(words.time, "--time");
  if (!words.iso_sweep.empty() && !words.frames.empty()) {
    const std::array<int, 2> range = parse_frame_range(words.frames);
    if (range[1] >= std::ssize(jobs))
      throw InputError(fmt::format("--frames {}: --iso-sweep {} has the frames 0 to {}", words.frames,
                                   words.iso_sweep, jobs.size() - 1));
    jobs = {jobs.begin() + range[0], jobs.begin() + range[1] + 1};
  }
  return jobs;
}

std::vector<FrameJob> shard_of(std::vector<FrameJob> jobs, const std::string& shard) {
  if (shard.empty()) return jobs;
  const std::vector<std::string> parts = split(shard, '/');
  const std::optional<int> index = parts.size() == 2 ? whole_number(parts[0]) : std::nullopt,
                           count = parts.size() == 2 ? whole_number(parts[1]) : std::nullopt;
  if (!index || !count || *index < 1 || *index > *count)
    throw InputError(fmt::format("--shard {}: expected I/N, the I-th of N parts, I from 1 to N", shard));
  std::vector<FrameJob> own;
  for (std::size_t i = static_cast<std::size_t>(*index) - 1; i < jobs.size();
       i += static_cast<std::size_t>(*count))
    own.push_back(std::move(jobs[i]));
  return own;
}

std::string picture_text(const RenderWords& w, const FrameJob& job) {
  const std::string extension = std::filesystem::path(w.output).extension().string();
  std::string text = fmt::format("frame {} iso {} time {}\n", job.number, job.iso, job.time.value_or(0));
  for (const std::string& word : {w.input,       w.colors,    w.method, w.size,    w.precision,
                                  w.position,    w.target,    w.up,     w.fov,     w.ortho,
                                  w.normals,     w.aov,       w.domain, w.opacity, w.reflectivity,
                                  w.environment, w.aa,        w.camera, w.filter,  w.ambient_occlusion_radius,
                                  w.read.grid,   w.exr_names, extension})
    text += word + "\n";
  for (const auto* const list : {&w.set, &w.params, &w.lights, &w.clips})
    text += fmt::format("{}\n", fmt::join(*list, " | "));
  text += fmt::format("{} {} {} {} {} {}\n", w.shadows, w.by_component, w.spp.value_or(-1),
                      w.transparency_depth.value_or(-1), w.reflections.value_or(-1), w.ambient_occlusion);
  if (w.read.dims) text += fmt::format("{}\n", fmt::join(*w.read.dims, " "));
  return text + fmt::format("{} {} {}\n", w.read.type ? static_cast<int>(*w.read.type) : -1,
                            w.read.big_endian, w.read.skip);
}

std::filesystem::path frame_path(const std::string& pattern, int number, bool several) {
  std::string name;
  bool numbered = false;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] != '%') {
      name += pattern[i];
      continue;
    }
    if (++i < pattern.size() && pattern[i] == '%') {
      name += '%';
      continue;
    }
    // %d or %0Nd
    std::size_t width = 0;
    const bool zeros = i < pattern.size() && pattern[i] == '0';
    for (; i < pattern.size() && pattern[i] >= '0' && pattern[i] <= '9' && width < 10; ++i)
      width = 10 * width + static_cast<std::size_t>(pattern[i] - '0');
    if (numbered || i >= pattern.size() || pattern[i] != 'd' || (width > 0 && !zeros) || width > 10)
      throw InputError(fmt::format(
          "the name {}: expected one %d or %04d for the frame's number, and %% for a percent sign", pattern));
    name += fmt::format("{:0{}}", number, width);
    numbered = true;
  }
  const std::filesystem::path path = name;
  if (numbered || !several) return path;
  return path.parent_path() /
         fmt::format("{}_{:04}{}", path.stem().string(), number, path.extension().string());
}

}  // namespace isocast
