// .raw files: description from options or name, byte order, alignment, mapping.
#include "volume_files.h"

using namespace isocast;
using namespace isocast::test;
using Catch::Contains;

TEMPLATE_TEST_CASE("a .raw file is read in every type and byte order", "[io][raw]", ISO_FILE_SAMPLE_TYPES) {
  const TemporaryFolder folder;
  const std::vector<TestType> values = pattern<TestType>(2 * 3 * 4);
  const bool big_endian = GENERATE(false, true);
  const std::uint64_t skip = GENERATE(0, 16, 3);
  const auto path = folder.write("v.raw", std::string(skip, '#') + bytes_of(values, big_endian) + "surplus");
  const Volume volume = read_volume(path, {{{2, 3, 4}}, kTypeOf<TestType>, big_endian, skip});
  CHECK(volume.dims == std::array<std::int64_t, 3>{2, 3, 4});
  CHECK(volume.type == kTypeOf<TestType>);
  CHECK(volume.format == "raw");
  CHECK(samples_of<TestType>(volume) == values);

  // in place exactly where order and alignment allow it
  const bool native = !big_endian || sizeof(TestType) == 1;
  CHECK(volume.mapped == (native && skip % sizeof(TestType) == 0));
  CHECK(reinterpret_cast<std::uintptr_t>(volume.samples) % sizeof(TestType) == 0);
}

TEST_CASE("half floats keep their bits", "[io][raw]") {
  const TemporaryFolder folder;
  const std::vector<std::uint16_t> bits = {0x3c00, 0xfbff, 0x0001, 0x7e00, 0x8000, 0x7c00, 0x1234, 0x4248};
  const Volume volume =
      read_volume(folder.write("h_2x2x2_half.raw", bytes_of(bits, true)), {{}, {}, true, 0});
  CHECK(volume.type == SampleType::f16);
  CHECK(samples_of<std::uint16_t>(volume) == bits);
}

TEST_CASE("a .raw file's name tells what options leave open", "[io][raw]") {
  const TemporaryFolder folder;
  const std::string content(64, '\1');
  const auto type_of = [&](const char* name, const ReadOptions& options = {}) {
    return read_volume(folder.write(name, content), options).type;
  };
  CHECK(type_of("a_2x4x1_uint8.raw") == SampleType::u8);
  CHECK(type_of("a_2x4x1_U8.RAW") == SampleType::u8);
  CHECK(type_of("some.thing-2x4x1-int16.raw") == SampleType::i16);
  CHECK(type_of("2x4x1_float32.raw") == SampleType::f32);
  CHECK(type_of("a_2x4x1_float.raw") == SampleType::f32);
  CHECK(type_of("a_2x4x1_float64.raw") == SampleType::f64);
  CHECK(type_of("a_2x4x1_f16.raw") == SampleType::f16);
  CHECK(type_of("a_2x4x1.raw", {{}, SampleType::i32}) == SampleType::i32);
  CHECK(type_of("a_2x4x1_uint8.raw", {{}, SampleType::i8}) == SampleType::i8);
  const Volume volume = read_volume(folder.write("b_2x4x1_uint8.raw", content), {{{4, 4, 4}}, {}});
  CHECK(volume.dims == std::array<std::int64_t, 3>{4, 4, 4});
}

TEST_CASE("bad .raw files are told", "[io][raw]") {
  const TemporaryFolder folder;
  const auto message = [&](const char* name, const std::string& content, const ReadOptions& options = {}) {
    return error_of(folder.write(name, content), options);
  };
  CHECK_THAT(message("plain.raw", "x"), Contains("--dims X,Y,Z"));
  CHECK_THAT(message("a_2x2x2.raw", "x"), Contains("--type u8"));
  CHECK_THAT(message("a_2x2x2_copy.raw", "x"),
             Contains("unknown sample type 'copy'") && Contains("a_2x2x2_copy.raw"));
  CHECK_THAT(message("a_2x2x2_int64.raw", "x"),
             Contains("'int64' is not possible") && Contains("nearest that is possible is f64"));
  CHECK_THAT(message("a_2x2x2_uint16.raw", "123456789"),
             Contains("expected 16 bytes for 2 x 2 x 2 samples of type u16, found 9"));
  CHECK_THAT(message("a_2x2x2_uint8.raw", ""), Contains("expected 8 bytes") && Contains("found 0"));
  CHECK_THAT(message("a_2x2x2_uint8.raw", "12345678", {{}, {}, false, 1}),
             Contains("expected 8 bytes") && Contains("found 7"));
  CHECK_THAT(message("a_2x2x2_uint8.raw", "12345678", {{}, {}, false, ~0ull}), Contains("found 0"));
  CHECK_THAT(message("a_0x2x2_uint8.raw", "x"),
             Contains("0 x 2 x 2") && Contains("between 1 and 1073741824"));
  CHECK_THAT(message("a_9999999999x2x2_uint8.raw", "x"),
             Contains("9999999999 x 2 x 2") && Contains("between 1 and"));
  CHECK_THAT(message("a_1073741824x1073741824x1073741824_uint8.raw", "x"),
             Contains("more than 64-bit sizes can count"));
  CHECK_THAT(message("a_100000x100000x1000_float.raw", "x"),
             Contains("expected 40000000000000 bytes") && Contains("found 1"));
}
