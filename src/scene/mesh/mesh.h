// Triangles.
#pragma once

#include <isocast/math/transform.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace isocast {

/// Corners of triangles by number, counterclockwise as seen from outside. normals: one for each position, any
/// length, or none at all.
struct Mesh {
  std::vector<Double3> positions;
  std::vector<std::array<float, 3>> normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

inline constexpr std::size_t kMostVertices = 0xfffffff0, kMostTriangles = std::size_t{1} << 31;

/// Reads .obj (v, vn, f; everything else is passed over) or .ply (ascii, binary of both byte orders; vertex
/// with x y z and perhaps nx ny nz, face with a list of vertex_indices). Faces of more than three corners
/// become fans. Throws InputError with the line or byte for what cannot be read, for corners that are not
/// there, for positions that are not finite, and for a mesh without triangles.
[[nodiscard]] Mesh read_mesh(const std::filesystem::path& path);
[[nodiscard]] Mesh read_obj(const std::filesystem::path& path);
[[nodiscard]] Mesh read_ply(const std::filesystem::path& path);

/// Whether a name ends like that of a mesh; capitals count alike.
[[nodiscard]] bool has_mesh_extension(const std::filesystem::path& path);

}  // namespace isocast
