// Copyright the limpet authors. GPL-3.0-or-later.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limpet/simulation/mesh.hpp>
#include <limpet/simulation/shapes.hpp>

#include "../temporary_folder.hpp"

namespace limpet::simulation {
namespace {

class MeshFile : public limpet::testing::TemporaryFolder {
 protected:
  Mesh load(const std::string& name, const std::string& content) const {
    return load_mesh(write(name, content));
  }

  std::string error(const std::string& name, const std::string& content) const {
    try {
      load(name, content);
    } catch (const MeshError& e) {
      return e.what();
    }
    return "no error";
  }
};

const std::string kTetrahedron = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

void expect_tetrahedron(const Mesh& mesh) {
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.face_count, 4);
  EXPECT_EQ(count_edges(mesh).open, 0);
  EXPECT_EQ(count_edges(mesh).crowded, 0);
}

TEST_F(MeshFile, OffWithCommentsColoursAndWithoutEdgeCount) {
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  expect_tetrahedron(load("a.off", "OFF\n4 4 0\n" + kTetrahedron + faces));
  expect_tetrahedron(
      load("b.off", "# made by hand\nOFF # one line\n4 4\n# now\n\n" + kTetrahedron + "# faces\n" + faces));
  expect_tetrahedron(load("c.off", "OFF 4 4 6\n" + kTetrahedron +
                                       "3 0 2 1 255 0 0\n3 0 1 3 1.0 0.5 0.5 1\n3 0 3 2 7\n3 1 2 3\n"));
  expect_tetrahedron(load(
      "d.OFF",
      "COFF\r\n4 4 0\r\n0 0 0 255 0 0 255\r\n1 0 0 9 9 9 255\r\n0 1 0 1 1 1 1\r\n0 0 1 5 5 5 5\r\n" + faces));
  expect_tetrahedron(
      load("e.off", "NOFF\n4 4 0\n0 0 0 0 0 1\n1e0 0 0 0 0 1\n0 +1 0 0 0 1\n0 0 1.0 0 0 1\n" + faces));
}

TEST_F(MeshFile, OffWithPolygons) {
  const Mesh mesh = load("l.off", "OFF\n6 1 0\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n6 0 1 2 3 4 5\n");
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_EQ(mesh.face_count, 1);
  EXPECT_DOUBLE_EQ(faces_of(mesh)[0].area, 3);
}

TEST_F(MeshFile, AClosedMeshThatIsInsideOutIsTurnedUnlessKept) {
  const std::string inward = "OFF\n4 4 0\n" + kTetrahedron + "3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n";
  EXPECT_NEAR(signed_volume(load("in.off", inward)), 1.0 / 6, 1e-12);
  EXPECT_NEAR(signed_volume(load_mesh(path("in.off"), kPlanarity, true)), -1.0 / 6, 1e-12);
  const Mesh sheet = load("sheet.off", "OFF\n3 1 0\n0 0 1\n0 1 1\n1 0 1\n3 0 1 2\n");
  EXPECT_LT(area_vector(sheet, 0).z(), 0) << "an open sheet stays as it is";
}

TEST_F(MeshFile, PositionsKeepDoublePrecision) {
  const Mesh mesh =
      load("p.off", "OFF\n3 1 0\n0.1 0 0\n1.2345678901234567 0 0\n0 1000000.0000000001 0\n3 0 1 2\n");
  EXPECT_EQ(mesh.vertices[0].x(), 0.1);
  EXPECT_EQ(mesh.vertices[1].x(), 1.2345678901234567);
  EXPECT_EQ(mesh.vertices[2].y(), 1000000.0000000001);
}

TEST_F(MeshFile, ObjWithEveryWayToNameAVertex) {
  expect_tetrahedron(
      load("a.obj",
           "# a tetrahedron\nmtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1 1.0\nvt 0 0\nvn 0 0 1\n"
           "usemtl nothing\nf 1 3 2\nf 1/1 2/1 4/1\nf 1//1 4//1 3//1\nf -3/1/1 \\\n -2/1/1 -1/1/1\n"));
}

TEST_F(MeshFile, StlTextAndBinaryAreWelded) {
  const Mesh cube = make_shape("cube");
  std::string text = "solid vertex of a cube\n", binary = "solid";  // as some programs write
  binary.resize(80, ' ');
  const auto append = [&binary](const auto& value) {
    binary.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(static_cast<std::uint32_t>(cube.triangles.size()));
  for (const auto& triangle : cube.triangles) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (int k = 0; k < 3; ++k) append(0.0f);
    for (const int v : triangle) {
      text += "  vertex";
      for (int k = 0; k < 3; ++k) {
        text.append(1, ' ').append(std::to_string(cube.vertices[v][k]));
        append(static_cast<float>(cube.vertices[v][k]));
      }
      text += "\n";
    }
    text += " endloop\nendfacet\n";
    append(std::uint16_t{0});
  }
  text += "endsolid vertex of a cube\n";
  for (const Mesh& mesh : {load("text.stl", text), load("binary.STL", binary)}) {
    EXPECT_EQ(mesh.vertices.size(), 8u);
    EXPECT_EQ(mesh.triangles.size(), 12u);
    EXPECT_EQ(mesh.face_count, 6);
    EXPECT_EQ(count_edges(mesh).open, 0);
  }
  EXPECT_NE(error("cut.stl", binary.substr(0, 200).replace(0, 5, "cube ")).find("too early"),
            std::string::npos);
}

TEST_F(MeshFile, PlyTextAndBothBinaryOrders) {
  const std::string header =
      " 1.0\ncomment a tetrahedron\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
  expect_tetrahedron(
      load("text.ply", "ply\nformat ascii" + header +
                           "0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"));
  const float positions[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::int32_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (const bool big : {false, true}) {
    std::string data;
    const auto append = [&data, big](const auto& value) {
      std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
      if (big) bytes.assign(bytes.rbegin(), bytes.rend());
      data += bytes;
    };
    for (const auto& p : positions) {
      for (const float x : p) append(x);
      data += 'r';
    }
    for (const auto& f : faces) {
      data += '\3';
      for (const std::int32_t v : f) append(v);
    }
    const std::string format = big ? "ply\nformat binary_big_endian" : "ply\nformat binary_little_endian";
    const std::string head = format + header;
    expect_tetrahedron(load("binary.ply", head + data));
    EXPECT_NE(error("cut.ply", head + data.substr(0, 60)).find("too early"), std::string::npos);
  }
}

TEST_F(MeshFile, ErrorsNameTheFileInOneLine) {
  const std::pair<std::string, std::string> bad[] = {
      {"empty.off", ""},
      {"word.off", "OFF\n3 1 0\n0 0 zero\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"short.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n"},
      {"index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"},
      {"huge.off", "OFF\n99999999999 1 0\n"},
      {"negative.off", "OFF\n-3 1 0\n"},
      {"nan.off", "OFF\n3 1 0\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"binary.off", "OFF BINARY\n\1\2\3"},
      {"4d.off", "4OFF\n1 0 0\n1 2 3 4\n"},
      {"noface.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"},
      {"zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"},
      {"what.stl", "nothing of the kind"},
      {"headless.ply", "ply\nformat ascii 1.0\n"},
      {"type.ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty quad x\nend_header\n12345678"},
      {"list.ply",
       "ply\nformat ascii 1.0\nelement face 1\nproperty list float int vertex_indices\nend_header\nnan 1 2 "
       "3\n"},
      {"nothing.ply", "ply\nformat ascii 1.0\nelement vertex 999999999\nend_header\n"},
      {"corners.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n999999999 0 1 2\n"},
      {"mesh.xyz", "0 0 0\n"},
  };
  for (const auto& [name, content] : bad) {
    const std::string message = error(name, content);
    EXPECT_TRUE(message.starts_with(path(name) + ": ")) << name << ": " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << name;
  }
  EXPECT_THROW(load_mesh(path("absent.off")), MeshError);
  EXPECT_THROW(load_mesh(path("")), MeshError);  // the folder
}

}  // namespace
}  // namespace limpet::simulation
