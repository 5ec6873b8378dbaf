// Frames, shards, names and manifests of jobs.
#include <input_error.h>
#include <isocast/apps/isocast/batch.h>
#include <isocast/apps/isocast/manifest.h>
#include <isocast/base/output_file.h>
#include <temporary_folder.h>

#include <set>

using namespace isocast;
using test::says;
using test::TemporaryFolder;

TEST_CASE("frames are those of a sweep, of a time ramp, of an animation, or one") {
  RenderWords words;
  CHECK(frame_jobs(words).size() == 1);
  words.iso_sweep = "0:1:5";
  std::vector<FrameJob> jobs = frame_jobs(words);
  REQUIRE(jobs.size() == 5);
  CHECK(jobs[1].iso == std::vector<double>{0.25});
  CHECK_FALSE(jobs[1].time);
  words.time = "2:4";
  jobs = frame_jobs(words);
  CHECK(jobs[2].time == 3.0);
  words.frames = "1:2";
  jobs = frame_jobs(words);
  REQUIRE(jobs.size() == 2);
  CHECK(jobs[0].number == 1);
  CHECK(jobs[0].iso == std::vector<double>{0.25});
  CHECK(jobs[0].time == 2.5);
  words.iso_sweep.clear();
  words.frames = "10:12";
  jobs = frame_jobs(words);
  REQUIRE(jobs.size() == 3);
  CHECK(jobs[0].number == 10);
  CHECK(jobs[1].time == 3.0);
  words = {};
  jobs = frame_jobs(words, std::array{3, 7});
  REQUIRE(jobs.size() == 5);
  CHECK(jobs[0].number == 3);
  words.frames = "5:5";
  CHECK(frame_jobs(words, std::array{3, 7}).front().number == 5);
  words.frames = "5:4";
  CHECK_THROWS_MATCHES(frame_jobs(words, std::array{3, 7}), InputError, says("expected FIRST:LAST"));
  words.frames = "0:99999999";
  CHECK_THROWS_MATCHES(frame_jobs(words, std::array{3, 7}), InputError, says("at most"));
}

TEST_CASE("every frame belongs to one shard") {
  std::vector<FrameJob> jobs;
  for (int i = 0; i < 17; ++i) jobs.push_back({.number = i});
  std::multiset<int> all;
  for (const char* const shard : {"1/5", "2/5", "3/5", "4/5", "5/5"})
    for (const FrameJob& job : shard_of(jobs, shard)) all.insert(job.number);
  CHECK(all.size() == 17);
  CHECK(std::set<int>(all.begin(), all.end()).size() == 17);
  CHECK(shard_of(jobs, "").size() == 17);
  CHECK(shard_of(jobs, "20/20").empty());
  for (const char* const wrong : {"0/5", "6/5", "1", "a/b", "1/5/2", "-1/5", "1/"})
    CHECK_THROWS_MATCHES(shard_of(jobs, wrong), InputError, says("expected I/N"));
}

TEST_CASE("names take the frame's number") {
  CHECK(frame_path("a.png", 3, false) == "a.png");
  CHECK(frame_path("d/a.png", 3, true) == "d/a_0003.png");
  CHECK(frame_path("a_%04d.png", 3, true) == "a_0003.png");
  CHECK(frame_path("a_%d.png", 12345, false) == "a_12345.png");
  CHECK(frame_path("%02d/a%%.png", 7, true) == "07/a%.png");
  for (const char* const wrong : {"a%", "a%s.png", "%d%d.png", "%4d.png", "%099999999999d.png", "%0"})
    CHECK_THROWS_MATCHES(frame_path(wrong, 1, true), InputError, says("expected one %d"));
}

TEST_CASE("what decides a picture is in its text, what does not is not") {
  RenderWords words;
  words.input = "x";
  words.output = "a.png";
  const FrameJob job;
  const std::string text = picture_text(words, job);
  RenderWords other = words;
  other.threads = 3, other.isa = "scalar", other.output = "b.png", other.stats = "-", other.shard = "1/2", other.resume = true;
  CHECK(picture_text(other, job) == text);
  std::set<std::string> texts = {text};
  const auto differs = [&](auto change) {
    RenderWords changed = words;
    change(changed);
    CHECK(texts.insert(picture_text(changed, job)).second);
  };
  differs([](RenderWords& w) { w.input = "y"; });
  differs([](RenderWords& w) { w.output = "a.exr"; });
  differs([](RenderWords& w) { w.colors = "#000000"; });
  differs([](RenderWords& w) { w.method = "affine"; });
  differs([](RenderWords& w) { w.set = {"a=1"}; });
  differs([](RenderWords& w) { w.params = {"a=1"}; });
  differs([](RenderWords& w) { w.spp = 4; });
  differs([](RenderWords& w) { w.filter = "gaussian"; });
  differs([](RenderWords& w) { w.ambient_occlusion = 4; });
  differs([](RenderWords& w) { w.shadows = true; });
  differs([](RenderWords& w) { w.precision = "double"; });
  differs([](RenderWords& w) { w.read.skip = 7; });
  differs([](RenderWords& w) { w.position = "1,2,3"; });
  CHECK(texts.insert(picture_text(words, {.number = 1})).second);
  CHECK(texts.insert(picture_text(words, {.iso = {0.1}})).second);
  CHECK(texts.insert(picture_text(words, {.iso = {0.1 + 1e-17, 0}})).second);
  CHECK(texts.insert(picture_text(words, {.time = 2.0})).second);
}

TEST_CASE("a manifest tells later what was done") {
  const TemporaryFolder folder;
  const std::string pattern = (folder / "out_%04d.png").string();
  CHECK(manifest_path(pattern, "") == folder / "out_manifest.json");
  CHECK(manifest_path(pattern, "2/8") == folder / "out_manifest.2-of-8.json");
  CHECK(manifest_path("a.png", "") == "./a_manifest.json");
  write_text_file(folder / "input.txt", "volume");
  write_text_file(folder / "out_0001.png", "picture");
  FileHashes hashes;
  FrameRecord record;
  record.frame = 1, record.job = "abc";
  record.inputs = {{(folder / "input.txt").string(), hashes.of(folder / "input.txt")}};
  record.file = "out_0001.png", record.hash = hashes.of(folder / "out_0001.png"), record.bytes = 7;
  {
    Manifest manifest(manifest_path(pattern, "1/2"), "1");
    manifest.add(record);
    record.frame = 2;
    manifest.add(record);
  }
  write_text_file(folder / "out_manifest.other.json", "{\"format\": 3}");
  write_text_file(folder / "out_manifest.broken.json", "{");
  const auto known = read_manifests(pattern);
  REQUIRE(known.size() == 2);
  const FrameRecord& read = known.find(1)->second;
  CHECK(read.inputs.size() == 1);
  const auto done = [&](const std::string& job, const std::string& file) {
    FileHashes fresh;
    return is_done(read, job, folder / file, fresh);
  };
  CHECK(done("abc", "out_0001.png"));
  CHECK_FALSE(done("abd", "out_0001.png"));
  CHECK_FALSE(done("abc", "out_0002.png"));
  write_text_file(folder / "out_0001.png", "pictUre");
  CHECK_FALSE(done("abc", "out_0001.png"));
  write_text_file(folder / "out_0001.png", "picture");
  CHECK(done("abc", "out_0001.png"));
  write_text_file(folder / "input.txt", "volumes");
  CHECK_FALSE(done("abc", "out_0001.png"));
  std::filesystem::remove(folder / "input.txt");
  CHECK_FALSE(done("abc", "out_0001.png"));

  // records of earlier frames stay
  record.frame = 9;
  Manifest(manifest_path(pattern, "1/2"), "1").add(record);
  CHECK(read_manifests(pattern).size() == 3);
}
