#include <fmt/format.h>
#include <isocast/apps/isocast/batch.h>
#include <isocast/apps/isocast/manifest.h>
#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/base/output_file.h>

#include <nlohmann/json.hpp>

namespace isocast {
namespace {
namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

constexpr const char* kFormat = "isocast manifest 1";

// "out_" of "out_%04d.png", "out" of "out.png"
std::string stem_of(const std::string& pattern) {
  const std::string stem = fs::path(pattern).stem().string();
  return stem.substr(0, stem.find('%'));
}
std::string manifest_stem(const std::string& pattern) {
  const std::string stem = stem_of(pattern);
  return stem + (stem.empty() || stem.back() == '_' || stem.back() == '-' || stem.back() == '.' ? "" : "_") +
         "manifest";
}
fs::path folder_of(const std::string& pattern) {
  const fs::path folder = fs::path(pattern).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

json json_of(const FrameRecord& record) {
  json inputs = json::array();
  for (const HashedFile& input : record.inputs)
    inputs.push_back({{"file", input.file}, {"hash", input.hash}});
  return {{"frame", record.frame}, {"file", record.file},        {"job", record.job},
          {"inputs", inputs},      {"hash", record.hash},        {"bytes", record.bytes},
          {"ms", record.ms},       {"finished", record.finished}};
}
FrameRecord record_of(const nlohmann::json& value) {
  FrameRecord record;
  record.frame = value.at("frame").get<int>();
  record.file = value.at("file").get<std::string>();
  record.job = value.at("job").get<std::string>();
  for (const auto& input : value.at("inputs"))
    record.inputs.push_back({input.at("file").get<std::string>(), input.at("hash").get<std::string>()});
  record.hash = value.at("hash").get<std::string>();
  record.bytes = value.at("bytes").get<std::uint64_t>();
  record.ms = value.at("ms").get<double>();
  record.finished = value.at("finished").get<std::int64_t>();
  return record;
}

std::vector<FrameRecord> records_in(const fs::path& path) try {
  const MappedFile file = map_file(path);
  const auto* const text = reinterpret_cast<const char*>(file.bytes.data());
  const nlohmann::json value = nlohmann::json::parse(text, text + file.bytes.size());
  std::vector<FrameRecord> records;
  if (value.at("format") == kFormat)
    for (const auto& one : value.at("frames")) records.push_back(record_of(one));
  return records;
} catch (const nlohmann::json::exception&) {  // someone else's file
  return {};
}

}  // namespace

const std::string& FileHashes::of(const fs::path& file) {
  const auto [entry, added] = known_.try_emplace(file);
  if (added) {
    Hash hash;
    hash.add_bytes(map_file(file).bytes);
    check_mapped_files();
    entry->second = hash.text();
  }
  return entry->second;
}

Manifest::Manifest(fs::path path, std::string version)
    : path_(std::move(path)), version_(std::move(version)) {
  std::error_code ignored;
  if (fs::is_regular_file(path_, ignored))
    for (FrameRecord& record : records_in(path_)) records_[record.frame] = std::move(record);
}

Manifest::~Manifest() {
  try {
    write();
  } catch (const InputError&) {}  // whoever wants to know calls write()
}

void Manifest::add(FrameRecord record) {
  const int frame = record.frame;
  records_[frame] = std::move(record);
  changed_ = true;
  if (std::chrono::steady_clock::now() - written_ > std::chrono::seconds(1)) write();
}

void Manifest::write() {
  if (!changed_) return;
  json frames = json::array();
  for (const auto& [frame, record] : records_) frames.push_back(json_of(record));
  write_text_file(path_, json{{"format", kFormat}, {"version", version_}, {"frames", frames}}.dump(1) + "\n");
  changed_ = false;
  written_ = std::chrono::steady_clock::now();
}

fs::path manifest_path(const std::string& pattern, const std::string& shard) {
  std::string part = shard.empty() ? "" : fmt::format(".{}", shard);
  if (const std::size_t slash = part.find('/'); slash != std::string::npos) part.replace(slash, 1, "-of-");
  return folder_of(pattern) / (manifest_stem(pattern) + part + ".json");
}

std::multimap<int, FrameRecord> read_manifests(const std::string& pattern) {
  std::multimap<int, FrameRecord> records;
  const std::string stem = manifest_stem(pattern) + ".";
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(pattern), ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(stem) || !name.ends_with(".json") || !entry.is_regular_file(ignored)) continue;
    for (FrameRecord& record : records_in(entry.path())) records.emplace(record.frame, std::move(record));
  }
  return records;
}

bool is_done(const FrameRecord& record, const std::string& job, const fs::path& file,
             FileHashes& hashes) try {
  std::error_code error;
  if (record.job != job || record.file != file.filename() || fs::file_size(file, error) != record.bytes ||
      error)
    return false;
  for (const HashedFile& input : record.inputs)
    if (hashes.of(input.file) != input.hash) return false;
  return hashes.of(file) == record.hash;
} catch (const InputError&) {  // a file that is gone is not what it was
  return false;
}

}  // namespace isocast
