#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/scene/mesh/mesh.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace isocast {
namespace {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
}

}  // namespace

bool has_mesh_extension(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".obj" || extension == ".ply";
}

Mesh read_mesh(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (!has_mesh_extension(path))
    throw InputError(
        fmt::format("{}: its extension is that of no mesh, expected .obj or .ply", path.string()));
  Mesh mesh = extension == ".obj" ? read_obj(path) : read_ply(path);
  if (mesh.triangles.empty()) throw InputError(fmt::format("{}: found no triangle", path.string()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    for (const double x : mesh.positions[i])
      if (!(std::abs(x) < 1e150))
        throw InputError(
            fmt::format("{}: vertex {} lies at {}, expected numbers below 1e150", path.string(), i, x));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const std::uint32_t corner : mesh.triangles[i])
      if (corner >= mesh.positions.size())
        throw InputError(fmt::format("{}: triangle {} has the vertex {}, of {} (counted from 0)",
                                     path.string(), i, corner, mesh.positions.size()));
  return mesh;
}

}  // namespace isocast
