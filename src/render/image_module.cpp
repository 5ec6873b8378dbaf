// The module `image`: the only code that knows OpenImageIO.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <isocast/base/error.h>
#include <isocast/base/module.h>
#include <isocast/render/image_module.h>

#include <algorithm>

namespace isocast {
namespace {

constexpr int kMaxSide = 1 << 15, kMaxChannels = 64;  // of a picture that is read
constexpr int kRows = 16;                             // read at once: a block of ZIP

[[noreturn]] void fail(const char* what, const std::string& path, std::string why) {
  // the library's messages may have several lines
  std::replace(why.begin(), why.end(), '\n', ' ');
  throw InputError(std::string("cannot ") + what + " " + path + ": " +
                   (why.empty() ? "unknown reason" : why));
}

// Encodes a picture in memory. Nothing but the spec goes into the file's header.
std::string encode(const std::string& target, const char* format, const OIIO::ImageSpec& spec,
                   const void* pixels) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create(format);
  if (!output) fail("write", target, OIIO::geterror());
  if (!output->set_ioproxy(&memory) || !output->open(target, spec) ||
      !output->write_image(spec.format, pixels) || !output->close())
    fail("write", target, output->geterror());
  return {bytes.begin(), bytes.end()};
}

std::string encode_png(const std::string& target, int width, int height, const std::uint8_t* rgb) {
  OIIO::ImageSpec spec(width, height, 3, OIIO::TypeUInt8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  return encode(target, "png", spec, rgb);
}

std::string encode_exr(const std::string& target, int width, int height,
                       const std::vector<ImageLayer>& layers, const ImageNotes& notes) {
  OIIO::ImageSpec spec(width, height, 0, OIIO::TypeFloat);
  spec.channelnames.clear();
  for (const ImageLayer& layer : layers)
    spec.channelnames.insert(spec.channelnames.end(), layer.channels.begin(), layer.channels.end());
  spec.nchannels = static_cast<int>(spec.channelnames.size());
  spec.attribute("compression", "zip");
  for (const auto& [name, text] : notes) spec.attribute(name, text);
  spec.attribute("DateTime", "");  // else the library enters the time of day

  // Interleave the layers' channels.
  const std::size_t count = std::size_t(width) * std::size_t(height), stride = spec.channelnames.size();
  std::vector<float> pixels(count * stride);
  std::size_t first = 0;
  for (const ImageLayer& layer : layers) {
    const std::size_t channels = layer.channels.size();
    for (std::size_t i = 0; i < count; ++i)
      std::copy_n(layer.data + i * channels, channels, &pixels[i * stride + first]);
    first += channels;
  }
  return encode(target, "openexr", spec, pixels.data());
}

Image read(const char* format, const std::string& path, std::int64_t most_pixels) {
  const auto input = OIIO::ImageInput::create(format);
  if (!input) fail("read", path, OIIO::geterror());
  OIIO::ImageSpec spec;
  if (!input->open(path, spec)) fail("read", path, input->geterror());
  if (spec.deep || spec.tile_width > 0)
    fail("read", path, "it is a deep or tiled image, a flat one in scan lines was expected");
  if (spec.width > kMaxSide || spec.height > kMaxSide || spec.nchannels > kMaxChannels)
    fail("read", path,
         "it has " + std::to_string(spec.width) + "x" + std::to_string(spec.height) + " pixels of " +
             std::to_string(spec.nchannels) + " channels, at most 32768x32768 of 64 were expected");
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1 ||
      std::int64_t(spec.width) * spec.height > most_pixels)
    fail("read", path,
         "it has " + std::to_string(spec.width) + "x" + std::to_string(spec.height) + " pixels, 1 to " +
             std::to_string(most_pixels) + " in one plane were expected");

  // Memory grows with the rows that are really there, not with the header's word.
  Image image{spec.width, spec.height, spec.channelnames, {}};
  const std::size_t row = std::size_t(spec.width) * spec.nchannels;
  for (int done = 0; done < spec.height; done += kRows) {
    const int rows = std::min(kRows, spec.height - done), top = spec.y + done;
    image.pixels.resize(row * (done + rows));
    float* const to = &image.pixels[row * done];
    if (!input->read_scanlines(0, 0, top, top + rows, 0, 0, spec.nchannels, OIIO::TypeFloat, to))
      fail("read", path, input->geterror());
  }
  return image;
}

constexpr ImageModule kTable = {encode_png, encode_exr, read};

}  // namespace
}  // namespace isocast

ISO_EXPORT_MODULE(isocast::kTable)
