// Meshes from files, good and bad.
#include <input_error.h>
#include <isocast/scene/mesh/mesh.h>
#include <temporary_folder.h>
#include <test_size.h>

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>
#include <random>

using namespace isocast;
using test::says;

namespace {

test::TemporaryFolder& folder() {
  static test::TemporaryFolder one;
  return one;
}
Mesh read(const std::string& name, const std::string& bytes) {
  std::ofstream(folder() / name, std::ios::binary) << bytes;
  return read_mesh(folder() / name);
}
void refuse(const std::string& name, const std::string& bytes, const std::string& sentence) {
  CAPTURE(bytes.substr(0, 200));
  CHECK_THROWS_MATCHES(read(name, bytes), InputError, says(sentence));
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

template <class T> void put(std::string& to, T value, bool big) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  if (big != (std::endian::native == std::endian::big)) std::reverse(bytes, bytes + sizeof(T));
  to.append(bytes, sizeof(T));
}

std::string header(const std::string& format, int vertices, int faces) {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty double y\nproperty uchar red\nproperty short z\nelement edge 1\n"
         "property int a\nelement face " +
         std::to_string(faces) +
         "\nproperty list uchar uint vertex_index\nproperty float quality\nend_header\n";
}

}  // namespace

TEST_CASE("OBJ: faces of any form, numbers from the end, normals of their own") {
  const Mesh square = read("a.obj", "# square\r\n" + kSquare + "f 1 2 3 4\r\ng more\nusemtl x\nf -4 -3 -2\n");
  CHECK(square.positions.size() == 4);
  CHECK(square.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}});
  CHECK(square.normals.empty());

  const Mesh bent = read("b.OBJ", kSquare + "vn 0 0 1\nvn 1 0 0\nf 1//1 2/5/1 3//1\nf 1//2 3//2 4//2\n");
  CHECK(bent.positions.size() == 6);  // the corners of the edge have two normals each
  REQUIRE(bent.normals.size() == 6);
  CHECK(bent.normals[bent.triangles[1][0]] == std::array<float, 3>{1, 0, 0});
  // without a normal somewhere there are none
  CHECK(read("c.obj", kSquare + "vn 0 0 1\nf 1//1 2//1 3//1\nf 1 2 3\n").normals.empty());
}

TEST_CASE("OBJ: what cannot be read is told with its line") {
  refuse("a.obj", kSquare + "f 1 2 9\n", "a.obj:5: found the vertex 9");
  refuse("a.obj", kSquare + "f 1 2 0\n", ":5: found the vertex 0");
  refuse("a.obj", kSquare + "f 1 2 -5\n", ":5: found the vertex -5");
  refuse("a.obj", kSquare + "f 1 2\n", ":5: found a face of 2 corners");
  refuse("a.obj", "v 1 2\n", ":1: found '', expected a number");
  refuse("a.obj", "v 1 2 x\n", ":1: found 'x', expected a number");
  refuse("a.obj", kSquare, "found no triangle");
  refuse("a.obj", "", "found no triangle");
  refuse("a.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "vertex 0 lies at nan");
  refuse("a.obj", "v 1e200 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "expected numbers below 1e150");
  refuse("a.obj", "v 1e999 0 0\n", ":1: found '1e999'");
  refuse("a.stl", "", "extension is that of no mesh");
}

TEST_CASE("PLY: ascii and both byte orders, with properties and elements that mean nothing here") {
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    std::string bytes = header(format, 4, 2);
    if (format == "ascii") bytes += "0 0 7 0\n1 0 7 0\n1 1 7 -3\n0 1 7 0\n 99\n4 0 1 2 3 0.5\n3 0 1 2 0.5\n";
    else {
      const bool big = format == "binary_big_endian";
      const double xy[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
      for (int i = 0; i < 4; ++i) {
        put(bytes, float(xy[i][0]), big), put(bytes, xy[i][1], big), put(bytes, std::uint8_t{7}, big);
        put(bytes, std::int16_t(i == 2 ? -3 : 0), big);
      }
      put(bytes, std::int32_t{99}, big);
      for (const int corners : {4, 3}) {
        put(bytes, std::uint8_t(corners), big);
        for (int k = 0; k < corners; ++k) put(bytes, std::uint32_t(k), big);
        put(bytes, 0.5f, big);
      }
    }
    const Mesh mesh = read("a.ply", bytes);
    CAPTURE(format);
    CHECK(mesh.positions == std::vector<Double3>{{0, 0, 0}, {1, 0, 0}, {1, 1, -3}, {0, 1, 0}});
    CHECK(mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}});
    // cut off anywhere it ends with a sentence
    for (std::size_t length = 0; length + 8 < bytes.size(); length += 7)
      CHECK_THROWS_AS(read("b.ply", bytes.substr(0, length)), InputError);
  }
}

TEST_CASE("PLY: normals come along") {
  const Mesh mesh = read(
      "n.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float nx\nproperty float ny\nproperty float nz\n"
      "property float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 1 0 0 0\n0 1 0 1 0 0\n1 0 0 0 1 0\n3 0 1 2\n");
  REQUIRE(mesh.normals.size() == 3);
  CHECK(mesh.normals[1] == std::array<float, 3>{0, 1, 0});
  CHECK(mesh.positions[2] == Double3{0, 1, 0});
}

TEST_CASE("PLY: lies are told") {
  refuse("a.ply", "pla\n", "found no 'ply'");
  refuse("a.ply", "ply\nformat ascii 1.0\n", "the header does not end");
  refuse("a.ply", "ply\nformat middle_endian 1.0\nend_header\n", "found the format 'middle_endian'");
  refuse("a.ply", "ply\nelement vertex 1\nend_header\n", "names no format");
  refuse("a.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nend_header\n",
         "more than the file has bytes");
  refuse("a.ply", "ply\nformat ascii 1.0\nelement vertex -1\nend_header\n", "found the count '-1'");
  refuse("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\nend_header\n",
         "without a known type");
  refuse("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n",
         "found no x, y and z");
  const std::string start =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
      "float z\nelement face 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
  refuse("a.ply", start + "2 0 1\n", "found a face of 2 corners");
  refuse("a.ply", start + "3 0 1 3\n", "triangle 0 has the vertex 3, of 3");
  refuse("a.ply", start + "3 0 1 -1\n", "found the corner -1");
  refuse("a.ply", start + "3 0 1 1.5\n", "found the corner 1.5");
  refuse("a.ply", start + "-3 0 1 2\n", "found a list of -3");
  refuse("a.ply", start + "2000000000 0 1 2\n", "more than the file has bytes left");
  refuse("a.ply", start + "3 0 x 2\n", "expected a number");
}

TEST_CASE("meshes with mistakes anywhere are read or told, and nothing else", "[property]") {
  std::mt19937_64 random(1);
  std::string binary = header("binary_little_endian", 3, 1);
  for (int i = 0; i < 3; ++i)
    put(binary, float(i == 1), false), put(binary, double(i == 2), false),
        put(binary, std::uint8_t{7}, false), put(binary, std::int16_t{0}, false);
  put(binary, std::int32_t{99}, false), put(binary, std::uint8_t{3}, false);
  for (std::uint32_t k = 0; k < 3; ++k) put(binary, k, false);
  put(binary, 0.5f, false);
  const std::pair<const char*, std::string> files[] = {
      {"m.obj", kSquare + "vn 0 0 1\nf 1//1 2//1 3//1\nf -4 -3 -2 -1\n"},
      {"m.ply",
       header("ascii", 4, 2) + "0 0 7 0\n1 0 7 0\n1 1 7 -3\n0 1 7 0\n 99\n4 0 1 2 3 0.5\n3 0 1 2 0.5\n"},
      {"m.ply", binary}};
  int told = 0;
  for (const auto& [name, good] : files)
    for (std::int64_t n = test::cases(500, 20000); n > 0; --n) {
      std::string bytes = good;
      for (std::uint64_t mistakes = 1 + random() % 3; mistakes > 0 && !bytes.empty(); --mistakes) {
        const std::size_t at = random() % bytes.size();
        if (random() % 3 == 0) bytes.erase(at, 1 + random() % 9);
        else bytes[at] = random() % 2 ? static_cast<char>(random()) : "0123456789 -/\n"[random() % 14];
      }
      try {
        const Mesh mesh = read(name, bytes);
        for (const auto& triangle : mesh.triangles)
          for (const std::uint32_t corner : triangle) CHECK(corner < mesh.positions.size());
      } catch (const InputError&) { ++told; }
    }
  CHECK(told > 300);
}
