// Copyright the limpet authors. GPL-3.0-or-later.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <cmath>
#include <cstring>
#include <limpet/io/lifted.hpp>
#include <limpet/io/mesh_writer.hpp>
#include <limpet/io/native.hpp>
#include <limpet/io/polygon_mesh.hpp>
#include <set>
#include <sstream>

#include "files.hpp"
#include "models.hpp"

namespace limpet::io::testing {
namespace {

class MeshWriterTest : public FileTest {};

/// A mesh as any program would read it back.
struct ReadMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::vector<int>> faces;
  std::vector<std::array<int, 3>> colors;
  std::size_t edges = 0;

  double area() const {
    double sum = 0;
    for (const auto& face : faces) {
      Eigen::Vector3d twice = Eigen::Vector3d::Zero();
      for (std::size_t i = 1; i + 1 < face.size(); ++i) {
        twice += (vertices[face[i]] - vertices[face[0]]).cross(vertices[face[i + 1]] - vertices[face[0]]);
      }
      sum += twice.norm() / 2;
    }
    return sum;
  }

  /// Signed volume: right only when every face is anticlockwise from outside.
  double volume() const {
    double sum = 0;
    for (const auto& face : faces) {
      for (std::size_t i = 1; i + 1 < face.size(); ++i) {
        sum += vertices[face[0]].dot(vertices[face[i]].cross(vertices[face[i + 1]])) / 6;
      }
    }
    return sum;
  }

  bool is_closed() const {
    std::set<std::pair<int, int>> halves;
    for (const auto& face : faces) {
      for (std::size_t i = 0; i < face.size(); ++i) halves.insert({face[i], face[(i + 1) % face.size()]});
    }
    for (const auto& [from, to] : halves) {
      if (halves.count({to, from}) == 0) return false;
    }
    return true;
  }
};

ReadMesh read_off_body(std::istream& stream, std::size_t vertices, std::size_t faces) {
  ReadMesh mesh;
  mesh.vertices.resize(vertices);
  for (auto& v : mesh.vertices) stream >> v.x() >> v.y() >> v.z();
  for (std::size_t i = 0; i < faces; ++i) {
    std::size_t size = 0;
    stream >> size;
    mesh.faces.emplace_back(size);
    for (int& vertex : mesh.faces.back()) stream >> vertex;
    mesh.colors.emplace_back();
    for (int& channel : mesh.colors.back()) stream >> channel;
  }
  std::string more;
  EXPECT_TRUE(static_cast<bool>(stream)) << "the file ends early";
  EXPECT_FALSE(stream >> more) << "the file goes on: " << more;
  return mesh;
}

ReadMesh parse_off(const std::string& bytes) {
  std::istringstream stream(bytes);
  std::string magic;
  std::size_t vertices = 0, faces = 0, edges = 0;
  stream >> magic >> vertices >> faces >> edges;
  EXPECT_EQ(magic, "COFF");
  ReadMesh mesh = read_off_body(stream, vertices, faces);
  mesh.edges = edges;
  return mesh;
}

ReadMesh parse_ply(const std::string& bytes) {
  const auto count = [&](const std::string& element) {
    const std::string word = "element " + element + " ";
    return static_cast<std::size_t>(std::stoul(bytes.substr(bytes.find(word) + word.size())));
  };
  std::istringstream stream(bytes.substr(bytes.find("end_header\n") + 11));
  return read_off_body(stream, count("vertex"), count("face"));
}

ReadMesh parse_obj(const std::string& bytes, const std::string& materials) {
  ReadMesh mesh;
  std::istringstream lines(bytes);
  std::array<int, 3> color{};
  for (std::string line, word; std::getline(lines, line);) {
    std::istringstream fields(line);
    fields >> word;
    if (word == "v") {
      auto& v = mesh.vertices.emplace_back();
      fields >> v.x() >> v.y() >> v.z();
    } else if (word == "usemtl") {
      fields >> word;
      const auto at = materials.find("newmtl " + word + "\nKd ");
      EXPECT_NE(at, std::string::npos) << word;
      std::istringstream kd(materials.substr(at + 11 + word.size()));
      for (int& channel : color) {
        double part = 0;
        kd >> part;
        channel = static_cast<int>(std::lround(part * 255));
      }
    } else if (word == "f") {
      auto& face = mesh.faces.emplace_back();
      for (int index = 0; fields >> index;) face.push_back(index - 1);
      mesh.colors.push_back(color);
    } else {
      EXPECT_EQ(word, "mtllib");
    }
  }
  return mesh;
}

ReadMesh parse_stl(const std::string& bytes) {
  ReadMesh mesh;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  EXPECT_EQ(bytes.size(), 84 + std::size_t{50} * count);
  for (std::uint32_t i = 0; i < count; ++i) {
    float numbers[12];
    std::memcpy(numbers, bytes.data() + 84 + 50 * i, sizeof numbers);
    auto& face = mesh.faces.emplace_back();
    for (int k = 1; k < 4; ++k) {
      face.push_back(static_cast<int>(mesh.vertices.size()));
      mesh.vertices.push_back({numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]});
    }
  }
  return mesh;
}

ReadMesh through_openmesh(const std::string& path) {
  OpenMesh::PolyMesh_ArrayKernelT<> mesh;
  EXPECT_TRUE(OpenMesh::IO::read_mesh(mesh, path)) << path;
  ReadMesh read;
  for (const auto v : mesh.vertices()) {
    read.vertices.push_back({mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]});
  }
  for (const auto f : mesh.faces()) {
    auto& face = read.faces.emplace_back();
    for (const auto v : mesh.fv_range(f)) face.push_back(v.idx());
  }
  read.edges = mesh.n_edges();
  return read;
}

struct Body {
  const char* name;
  model::ModelRecord model;
  std::size_t vertices, faces, triangles;
  double area, volume;
};

std::vector<Body> bodies() {
  return {{"cube", cube(), 8, 6, 12, 6, 1},
          {"L", l_block(), 12, 8, 20, 14, 3},
          {"plate", plate(), 24, 40, 52, 18, 1.6875}};
}

TEST_F(MeshWriterTest, ClosedBodiesAreWrittenClosedInEveryFormat) {
  for (const Body& body : bodies()) {
    SCOPED_TRACE(body.name);
    for (const char* extension : {"off", "ply", "obj", "stl"})
      save_mesh(path("m." + std::string(extension)), body.model);
    const ReadMesh off = parse_off(read(path("m.off"))), ply = parse_ply(read(path("m.ply")));
    const ReadMesh obj = parse_obj(read(path("m.obj")), read(path("m.mtl")));
    for (const ReadMesh* mesh : {&off, &ply, &obj}) {
      EXPECT_EQ(mesh->vertices.size(), body.vertices);
      EXPECT_EQ(mesh->faces.size(), body.faces);
      EXPECT_EQ(mesh->area(), body.area);
      EXPECT_NEAR(mesh->volume(), body.volume, 1e-12);
      EXPECT_TRUE(mesh->is_closed());
      EXPECT_EQ(mesh->colors, off.colors);
    }
    const ReadMesh stl = parse_stl(read(path("m.stl")));
    EXPECT_EQ(stl.faces.size(), body.triangles);
    EXPECT_EQ(stl.area(), body.area);
    EXPECT_NEAR(stl.volume(), body.volume, 1e-12);
  }
}

TEST_F(MeshWriterTest, OpenMeshReadsWhatIsWritten) {
  for (const Body& body : bodies()) {
    for (const char* extension : {"off", "ply", "obj", "stl"}) {
      SCOPED_TRACE(std::string(body.name) + "." + extension);
      save_mesh(path("m." + std::string(extension)), body.model);
      const ReadMesh mesh = through_openmesh(path("m." + std::string(extension)));
      EXPECT_EQ(mesh.vertices.size(), body.vertices);
      EXPECT_EQ(mesh.faces.size(), extension == std::string("stl") ? body.triangles : body.faces);
      EXPECT_NEAR(mesh.area(), body.area, 1e-6);
      EXPECT_NEAR(mesh.volume(), body.volume, 1e-6);
    }
  }
}

TEST_F(MeshWriterTest, ColoursTellTheSegmentsApart) {
  save_mesh(path("m.off"), plate());
  const ReadMesh mesh = parse_off(read(path("m.off")));
  std::set<std::array<int, 3>> colors(mesh.colors.begin(), mesh.colors.end());
  EXPECT_EQ(colors.size(), plate().polygon_segments.size());
}

TEST_F(MeshWriterTest, OpenSurfacesKeepTheirOpenEdges) {
  save_mesh(path("m.off"), open_cube());
  const ReadMesh mesh = parse_off(read(path("m.off")));
  EXPECT_EQ(mesh.vertices.size(), 8u);
  EXPECT_EQ(mesh.faces.size(), 5u);
  EXPECT_EQ(mesh.edges, 12u);
  EXPECT_EQ(mesh.area(), 5);
  EXPECT_FALSE(mesh.is_closed());
}

TEST_F(MeshWriterTest, NearFacesThatShareNothingStayApart) {
  ModelMaker maker;
  maker.face({rectangle(0, 0, 1, 1, 0)}).face({rectangle(1, 0, 2, 1, 0)});
  model::ModelRecord model = maker.make();
  for (auto& segment : model.polygon_segments) {
    for (auto& vertex : segment.cycles[0]) vertex.partner = 0;
  }
  save_mesh(path("m.off"), model);
  EXPECT_EQ(parse_off(read(path("m.off"))).vertices.size(), 8u);
}

TEST_F(MeshWriterTest, MapCoordinatesKeepTheirDigits) {
  save_mesh(path("m.off"), cube({4000000.0009765625, 500000.25, 0}));
  const ReadMesh mesh = parse_off(read(path("m.off")));
  EXPECT_EQ(mesh.vertices.size(), 8u);
  EXPECT_EQ(mesh.area(), 6);
  double lowest = mesh.vertices[0].x();
  for (const auto& v : mesh.vertices) lowest = std::min(lowest, v.x());
  EXPECT_EQ(lowest, 4000000.0009765625);
}

/// Three wings that a broken model has sharing one line: no manifold mesh holds them.
TEST_F(MeshWriterTest, WhatIsNotManifoldIsWrittenAllTheSame) {
  ModelMaker maker;
  maker.face({{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  maker.face({{{0, 0, 1}, {0, 0, 0}, {0, 1, 0}, {0, 1, 1}}});
  maker.face({{{0, 0, 1}, {0, 0, 0}, {-1, 0, 0}, {-1, 0, 1}}});
  model::ModelRecord model = maker.make();
  auto& segments = model.polygon_segments;
  segments[1].cycles[0][0].partner = segments[2].cycles[0][0].partner = segments[0].cycles[0][0].edge;
  for (const char* extension : {"off", "stl"}) save_mesh(path("m." + std::string(extension)), model);
  const ReadMesh off = parse_off(read(path("m.off")));
  EXPECT_EQ(off.faces.size(), 3u);
  EXPECT_EQ(off.area(), 3);
  EXPECT_EQ(off.vertices.size(), 10u) << "two faces over six vertices, the third over four of its own";
  EXPECT_EQ(parse_stl(read(path("m.stl"))).area(), 3);
}

TEST_F(MeshWriterTest, TiltedPlanesAreLifted) {
  ModelMaker maker;
  model::ModelRecord model = maker.face({rectangle(0, 0, 2, 1, 0)}).make();
  model.polygon_segments[0].height = {1024, 0.75, 0};  // 1 up, then 3 on 4
  const LiftedPolygon polygon = lift(model)[0];
  EXPECT_EQ(polygon.cycles[0][1].at, Eigen::Vector3d(2, 0, 2.5));
  EXPECT_NEAR((polygon.normal - Eigen::Vector3d(-0.6, 0, 0.8)).norm(), 0, 1e-15);
  EXPECT_NEAR(area(polygon), 2.5, 1e-12);
  save_mesh(path("m.off"), model);
  EXPECT_NEAR(parse_off(read(path("m.off"))).area(), 2.5, 1e-12);
}

TEST_F(MeshWriterTest, EmptyAndDegenerateModelsAreWritten) {
  model::ModelRecord model = ModelMaker().make();
  model.polygon_segments.resize(2);
  model.polygon_segments[0].cycles = {{{0, 0, 1, 0}, {1, 0, 2, 0}}};
  for (const char* extension : {"off", "ply", "obj", "stl"})
    save_mesh(path("m." + std::string(extension)), model);
  EXPECT_EQ(parse_off(read(path("m.off"))).faces.size(), 0u);
  EXPECT_EQ(parse_ply(read(path("m.ply"))).faces.size(), 0u);
  EXPECT_EQ(parse_stl(read(path("m.stl"))).faces.size(), 0u);
}

TEST_F(MeshWriterTest, TheExtensionChoosesTheFormat) {
  save_model(path("m.limpet"), cube());
  EXPECT_EQ(load_native(path("m.limpet")).polygon_segments.size(), 6u);
  save_model(path("m.OFF"), cube());
  EXPECT_EQ(parse_off(read(path("m.OFF"))).faces.size(), 6u);
  EXPECT_THROW(save_model(path("m.step"), cube()), OutputError);
  EXPECT_THROW(save_model(path("no/folder/m.off"), cube()), OutputError);
  EXPECT_EQ(names(), (std::vector<std::string>{"m.OFF", "m.limpet"}));
}

TEST_F(MeshWriterTest, CentroidsOfManyFarPointsAreExact) {
  model::MomentsRecord moments;
  moments.count = 3;
  moments.sum = {model::Int128{3} << 70, -6, 1};
  const Eigen::Vector3d at = centroid(moments, 0.5);
  EXPECT_EQ(at.x(), static_cast<double>(model::Int128{1} << 69));
  EXPECT_EQ(at.y(), -1);
  EXPECT_EQ(at.z(), 1.0 / 6);
}

}  // namespace
}  // namespace limpet::io::testing
