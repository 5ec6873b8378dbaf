// Dense files: those that the program writes, and what others make of the same samples.
#include <isocast/data_gen/write.h>

#include "made_file.h"
#include "pack.h"

namespace isocast::hostile {
namespace {

constexpr std::array<std::int64_t, 3> kDims = {13, 9, 11};
// Of a compressed stream's last bytes, those that hold checksums and no samples.
constexpr std::size_t kChecksums = 10;

std::string written(const std::filesystem::path& path, SampleType type) {
  const Field field = [](const SampleGrid&, std::int64_t j, std::int64_t k, std::span<double> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<double>((7 * i + 3 * static_cast<std::size_t>(j * k)) % 23);
  };
  WriteOptions options;
  options.type = type;
  (void)write_field(field, {kDims, {}}, path, options);
  std::string bytes = bytes_of(path);
  std::filesystem::remove(path);
  return bytes;
}

// `samples` in zlib blocks: number, size, size of the last, compressed sizes, blocks.
struct VtiBlocks {
  std::string words, blocks;
};
VtiBlocks vti_blocks(const std::string& samples) {
  constexpr std::size_t kBlock = 1000;
  VtiBlocks packed;
  std::string sizes;
  std::uint32_t count = 0;
  for (std::size_t at = 0; at < samples.size(); at += kBlock, ++count) {
    const std::string block = zlib(samples.substr(at, kBlock));
    sizes += number(static_cast<std::uint32_t>(block.size()));
    packed.blocks += block;
  }
  packed.words = number(count) + number(static_cast<std::uint32_t>(kBlock)) +
                 number(static_cast<std::uint32_t>(samples.size() % kBlock)) + sizes;
  return packed;
}

MadeFile vti(const std::string& name, const std::string& file_attributes, const std::string& array_attributes,
             const std::string& inside, const std::string& encoding, const std::string& appended) {
  std::string bytes = R"(<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt32")" +
                      file_attributes + R"(>
<ImageData WholeExtent="0 12 0 8 0 10" Origin="0 0 0" Spacing="1 1 1">
<Piece Extent="0 12 0 8 0 10"><PointData Scalars="s">
<DataArray type="Int16" Name="s" )" +
                      array_attributes + ">" + inside;
  const std::size_t inline_end = bytes.size();
  bytes += "</DataArray></PointData></Piece></ImageData>";
  if (appended.empty()) return {name, bytes + "</VTKFile>\n", 400, inline_end};
  bytes += "<AppendedData encoding=\"" + encoding + "\">_";
  const std::size_t head = bytes.size() + 16;
  bytes += appended;
  const std::size_t needed = bytes.size() - (file_attributes.empty() ? 0 : kChecksums);
  return {name, bytes + "</AppendedData></VTKFile>\n", head, needed};
}

void add_vti(std::vector<MadeFile>& files, const std::string& samples) {
  const std::string compressor = R"( compressor="vtkZLibDataCompressor")",
                    appended = R"(format="appended" offset="0")",
                    plain = number(static_cast<std::uint32_t>(samples.size())) + samples;
  const VtiBlocks blocks = vti_blocks(samples);
  files.push_back(vti("raw.vti", "", appended, "", "raw", plain));
  files.push_back(vti("zlib.vti", compressor, appended, "", "raw", blocks.words + blocks.blocks));
  files.push_back(vti("base64.vti", "", appended, "", "base64", base64(plain)));
  files.push_back(vti("inline.vti", compressor, R"(format="binary")",
                      base64(blocks.words) + base64(blocks.blocks), "", ""));
  std::string numbers;
  for (std::size_t i = 0; i < samples.size(); i += 2) numbers += std::to_string(int(samples[i])) + " ";
  files.push_back(vti("ascii.vti", "", R"(format="ascii")", numbers, "", ""));
}

}  // namespace

std::vector<MadeFile> make_dense_files(const std::filesystem::path& folder) {
  std::vector<MadeFile> files;
  const auto add = [&](const std::string& name, const std::string& bytes, std::size_t head) {
    files.push_back({name, bytes, head, bytes.size()});
  };
  const auto add_compressed = [&](const std::string& name, const std::string& bytes, std::size_t head) {
    files.push_back({name, bytes, head, bytes.size() - kChecksums});
  };
  const auto add_detached = [&](const std::string& name, const std::string& text) {
    files.push_back({name, text + "\n", text.size(), text.size()});
  };
  const auto beside = [&](const std::string& name, const std::string& bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
  };
  const std::string samples = written(folder / "made.raw", SampleType::i16);
  beside("samples.bin", samples);
  beside("samples.gz", gzip(samples));
  add("made_13x9x11_int16.raw", samples, 0);

  // headers without their samples, which follow as a stream or lie in another file
  const std::string nrrd = written(folder / "made.nrrd", SampleType::i16),
                    nrrd_text = nrrd.substr(0, nrrd.find("\n\n") + 1);
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string nrrd_gzip = with(nrrd_text, "encoding: raw", "encoding: gzip");
  add("plain.nrrd", nrrd, nrrd_text.size());
  add("double.nrrd", written(folder / "made.nrrd", SampleType::f64), nrrd_text.size());
  add_compressed("packed.nrrd", nrrd_gzip + "\n" + gzip(samples), nrrd_text.size());
  add_detached("detached.nhdr", nrrd_text + "byte skip: -1\ndata file: samples.bin");
  add_detached("packed.nhdr", nrrd_gzip + "data file: samples.gz");

  const std::string meta = written(folder / "made.mha", SampleType::i16),
                    meta_text = meta.substr(0, meta.size() - samples.size()),
                    local = "ElementDataFile = LOCAL\n",
                    meta_zlib = with(meta_text, "CompressedData = False", "CompressedData = True");
  add("plain.mha", meta, meta_text.size());
  add_compressed("packed.mha", meta_zlib + zlib(samples), meta_zlib.size());
  add_detached("detached.mhd", with(meta_text, local, "HeaderSize = -1\nElementDataFile = samples.bin"));

  const std::string nifti = written(folder / "made.nii", SampleType::i16);
  add("plain.nii", nifti, 352);
  add("float.nii", written(folder / "made.nii", SampleType::f32), 352);
  add_compressed("packed.nii.gz", gzip(nifti), 64);

  add_vti(files, samples);
  return files;
}

}  // namespace isocast::hostile
