#include <isocast/base/hash.h>
#include <isocast/apps/reference/reference_cache.h>
#include <isocast/base/cache_folder.h>
#include <isocast/base/error.h>
#include <isocast/base/interrupt.h>
#include <isocast/base/output_file.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <cstring>
#include <fstream>
#include <optional>

namespace isocast::reference {
namespace {
namespace fs = std::filesystem;

// To be counted up whenever a reference gives other answers, or the layout below changes.
constexpr const char* kFormat = "isocast reference 2";

std::string key_of(const RayReference& reference, std::span<const ReferenceRay> rays) {
  Hash hash;
  hash.add(kFormat);
  hash.add(reference.identity());
  hash.add(rays);
  return hash.text();
}

// The key, for each ray its truth, and a hash of all that; in the machine's byte order.
class Writer {
 public:
  template <class T> void put(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put_truth(const RayTruth& truth) {
    put(truth.bits);
    put(truth.roots.size());
    for (const RayRoot& r : truth.roots) {
      for (const double x : {r.lo, r.hi, r.condition, r.distance}) put(x);
      put(std::uint8_t{r.crossing});
      put(std::uint8_t{r.from_above});
      put(r.iso);
    }
    put(truth.doubts.size());
    for (const DoubtfulRange& d : truth.doubts) {
      put(d.lo);
      put(d.hi);
      put(d.doubt);
    }
  }
  [[nodiscard]] std::string finished(const std::string& key) const {
    Hash hash;
    hash.add(bytes_);
    return key + hash.text() + bytes_;
  }

 private:
  std::string bytes_;
};

// Every number is there, or `complete` turns false and zeros are given.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}
  template <class T> T get() {
    T value{};
    complete_ = complete_ && rest_.size() >= sizeof value;
    if (!complete_) return value;
    std::memcpy(&value, rest_.data(), sizeof value);
    rest_.remove_prefix(sizeof value);
    return value;
  }
  RayTruth get_truth() {
    RayTruth truth;
    truth.bits = get<int>();
    for (auto left = get<std::size_t>(); left > 0 && complete_; --left) {
      RayRoot& r = truth.roots.emplace_back();
      for (double* x : {&r.lo, &r.hi, &r.condition, &r.distance}) *x = get<double>();
      r.crossing = get<std::uint8_t>() != 0;
      r.from_above = get<std::uint8_t>() != 0;
      r.iso = get<int>();
    }
    for (auto left = get<std::size_t>(); left > 0 && complete_; --left) {
      DoubtfulRange& d = truth.doubts.emplace_back();
      d.lo = get<double>();
      d.hi = get<double>();
      d.doubt = get<Doubt>();
    }
    return truth;
  }
  [[nodiscard]] bool at_end() const { return complete_ && rest_.empty(); }

 private:
  std::string_view rest_;
  bool complete_ = true;
};

std::optional<std::vector<RayTruth>> read(const fs::path& file, const std::string& key, std::size_t count) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const std::size_t begin = 2 * key.size();
  if (bytes.size() < begin || !bytes.starts_with(key)) return std::nullopt;
  Hash hash;
  hash.add(bytes.substr(begin));
  if (bytes.compare(key.size(), key.size(), hash.text()) != 0) return std::nullopt;
  Reader reader(std::string_view(bytes).substr(begin));
  std::vector<RayTruth> truths(count);
  for (RayTruth& truth : truths) truth = reader.get_truth();
  if (!reader.at_end()) return std::nullopt;
  return truths;
}

void write(const fs::path& file, const std::string& key, std::span<const RayTruth> truths) {
  Writer writer;
  for (const RayTruth& truth : truths) writer.put_truth(truth);
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  try {
    write_text_file(file, writer.finished(key));
  } catch (const InputError&) {}  // a folder that cannot be written: the answers are there all the same
}

}  // namespace

fs::path default_cache_folder() { return cache_folder("reference"); }

std::vector<RayTruth> solve_all(const RayReference& reference, std::span<const ReferenceRay> rays,
                                const fs::path& folder) {
  const std::string key = folder.empty() ? std::string() : key_of(reference, rays);
  const fs::path file = folder / key;
  if (!folder.empty())
    if (std::optional<std::vector<RayTruth>> kept = read(file, key, rays.size())) return std::move(*kept);
  std::vector<RayTruth> truths(rays.size());
  oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, rays.size(), 16),
                            [&](const auto& range) {
                              throw_if_interrupted();
                              for (std::size_t i = range.begin(); i < range.end(); ++i)
                                truths[i] = reference.solve(rays[i].o, rays[i].d, rays[i].t0, rays[i].t1);
                            });
  if (!folder.empty()) write(file, key, truths);
  return truths;
}

}  // namespace isocast::reference
