// Copyright the limpet authors. GPL-3.0-or-later.
//
// glTF and VTK files, as a program that knows these formats reads them.
#include <Eigen/Geometry>
#include <bit>
#include <limpet/io/lifted.hpp>
#include <limpet/io/mesh_writer.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "files.hpp"
#include "models.hpp"

namespace limpet::io::testing {
namespace {

using Eigen::Vector3d;

class DrawnModelTest : public FileTest {};

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i)
    word |= std::uint32_t{static_cast<std::uint8_t>(bytes.at(at + i))} << (8 * i);
  return word;
}

/// A binary glTF file taken apart.
struct Glb {
  nlohmann::json json;
  std::string buffer;

  explicit Glb(const std::string& bytes) {
    EXPECT_EQ(word_at(bytes, 0), 0x46546c67u);
    EXPECT_EQ(word_at(bytes, 4), 2u);
    EXPECT_EQ(word_at(bytes, 8), bytes.size());
    for (std::size_t at = 12; at < bytes.size();) {
      const std::size_t length = word_at(bytes, at);
      EXPECT_EQ(length % 4, 0u);
      const std::string chunk = bytes.substr(at + 8, length);
      if (word_at(bytes, at + 4) == 0x4e4f534a) json = nlohmann::json::parse(chunk);
      if (word_at(bytes, at + 4) == 0x004e4942) buffer = chunk;
      at += 8 + length;
    }
  }

  std::size_t begin_of(int accessor) const {
    return json["bufferViews"][json["accessors"][accessor]["bufferView"].get<int>()]["byteOffset"];
  }
  std::size_t count_of(int accessor) const { return json["accessors"][accessor]["count"]; }
  /// Places and normals as the scene has them: by the node's rotation and translation.
  std::vector<Vector3d> vectors(int accessor, bool places) const {
    const auto& node = json["nodes"][0];
    const auto& q = node["rotation"];
    const Eigen::Quaterniond rotation(q[3].get<double>(), q[0], q[1], q[2]);
    const Vector3d translation(node["translation"][0], node["translation"][1], node["translation"][2]);
    std::vector<Vector3d> result;
    for (std::size_t i = 0; i < count_of(accessor); ++i) {
      Vector3d p;
      for (int k = 0; k < 3; ++k)
        p[k] = std::bit_cast<float>(
            word_at(buffer, begin_of(accessor) + 12 * i + 4 * static_cast<std::size_t>(k)));
      result.push_back(rotation * p + (places ? translation : Vector3d(Vector3d::Zero())));
    }
    return result;
  }
  std::vector<std::uint32_t> indices(const nlohmann::json& primitive) const {
    std::vector<std::uint32_t> result;
    const int accessor = primitive["indices"];
    for (std::size_t i = 0; i < count_of(accessor); ++i)
      result.push_back(word_at(buffer, begin_of(accessor) + 4 * i));
    return result;
  }
  const nlohmann::json& primitives() const { return json["meshes"][0]["primitives"]; }
};

/// In glTF y is up.
Vector3d with_y_up(const Vector3d& p) { return {p.x(), p.z(), -p.y()}; }

TEST_F(DrawnModelTest, GltfHasFacesTurnedOutwardsAndEdgesAsLines) {
  for (const Vector3d& offset : {Vector3d(0, 0, 0), Vector3d(4e6, 5e6, 300)}) {
    save_mesh(path("m.glb"), cube(offset));
    const Glb glb(read(path("m.glb")));
    ASSERT_EQ(glb.primitives().size(), 2u) << "faces and shared edges: there are no open ones";
    const auto& faces = glb.primitives()[0];
    EXPECT_EQ(faces["mode"], 4);
    const auto places = glb.vectors(faces["attributes"]["POSITION"], true);
    const auto normals = glb.vectors(faces["attributes"]["NORMAL"], false);
    const auto corners = glb.indices(faces);
    ASSERT_EQ(corners.size(), 36u);
    double area = 0;
    const Vector3d middle = with_y_up(offset + Vector3d::Constant(0.5));
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      const Vector3d &a = places.at(corners[i]), &b = places.at(corners[i + 1]),
                     &c = places.at(corners[i + 2]);
      const Vector3d twice = (b - a).cross(c - a);
      area += twice.norm() / 2;
      EXPECT_GT(twice.dot(normals.at(corners[i])), 0);
      EXPECT_GT(normals.at(corners[i]).dot(a - middle), 0.4);
    }
    EXPECT_NEAR(area, 6, 1e-5);
    EXPECT_EQ(glb.primitives()[1]["mode"], 1);
    EXPECT_EQ(glb.indices(glb.primitives()[1]).size(), 24u) << "each edge once";
  }
}

TEST_F(DrawnModelTest, GltfTellsOpenEdgesFromSharedOnes) {
  const model::ModelRecord model = open_cube();
  std::map<std::string, std::size_t> edges;
  for (const auto& polygon : lift(model))
    for (const auto& cycle : polygon.cycles)
      for (const auto& vertex : cycle) ++edges[vertex.shared() ? "shared edges" : "open edges"];
  edges["shared edges"] /= 2;
  save_mesh(path("m.glb"), model);
  const Glb glb(read(path("m.glb")));
  ASSERT_EQ(glb.primitives().size(), 3u);
  for (const std::size_t i : {1u, 2u}) {
    const std::string name =
        glb.json["materials"][glb.primitives()[i]["material"].get<std::size_t>()]["name"];
    EXPECT_EQ(glb.indices(glb.primitives()[i]).size(), 2 * edges.at(name)) << name;
  }
}

TEST_F(DrawnModelTest, AnEmptyModelIsASceneOfNothing) {
  model::ModelRecord nothing;
  nothing.grid_step = 1;
  save_mesh(path("m.glb"), nothing);
  const Glb glb(read(path("m.glb")));
  EXPECT_FALSE(glb.json.contains("meshes"));
  EXPECT_TRUE(glb.buffer.empty());
  save_mesh(path("m.vtp"), nothing);
  EXPECT_NE(read(path("m.vtp")).find("NumberOfPolys=\"0\""), std::string::npos);
}

/// The numbers of an array of a .vtp file, by its name; of `cells`, where several arrays have the name.
std::vector<double> numbers(const std::string& text, const std::string& name, const std::string& cells = "") {
  const std::size_t from = cells.empty() ? 0 : text.find("<" + cells + ">");
  const std::size_t array = text.find("Name=\"" + name + "\"", from);
  EXPECT_NE(array, std::string::npos) << name;
  const std::size_t begin = text.find('>', array) + 1;
  std::istringstream stream(text.substr(begin, text.find('<', begin) - begin));
  std::vector<double> result;
  for (double x; stream >> x;) result.push_back(x);
  return result;
}

TEST_F(DrawnModelTest, VtkHasACellForEachEdgeAndPolygon) {
  save_mesh(path("m.vtp"), cube());
  const std::string text = read(path("m.vtp"));
  EXPECT_EQ(numbers(text, "class"),
            (std::vector<double>{1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 3, 3, 3, 3, 3, 3}));
  EXPECT_EQ(numbers(text, "offsets", "Polys"), (std::vector<double>{4, 8, 12, 16, 20, 24}));
  EXPECT_EQ(numbers(text, "position").size(), 72u);
  EXPECT_EQ(numbers(text, "color").size(), 54u);
  for (const double partner : numbers(text, "partner")) EXPECT_GE(partner, 0);
  for (const double vertex : numbers(text, "connectivity", "Lines")) EXPECT_LT(vertex, 24);
}

TEST_F(DrawnModelTest, VtkOfAPlateHasItsHole) {
  save_mesh(path("m.vtp"), plate());
  const std::string text = read(path("m.vtp"));
  const auto position = numbers(text, "position"), corners = numbers(text, "connectivity", "Polys");
  const auto at = [&](double vertex) {
    const auto i = 3 * static_cast<std::size_t>(vertex);
    return Vector3d(position[i], position[i + 1], position[i + 2]);
  };
  double area = 0;
  std::size_t begin = 0;
  for (const double offset : numbers(text, "offsets", "Polys")) {  // triangles, and faces that are convex
    const auto end = static_cast<std::size_t>(offset);
    for (std::size_t i = begin + 1; i + 1 < end; ++i)
      area += (at(corners[i]) - at(corners[begin])).cross(at(corners[i + 1]) - at(corners[begin])).norm() / 2;
    begin = end;
  }
  EXPECT_EQ(begin, corners.size());
  double whole = 0;
  for (const auto& polygon : lift(plate())) whole += limpet::io::area(polygon);
  EXPECT_NEAR(area, whole, 1e-9 * whole);
}

}  // namespace
}  // namespace limpet::io::testing
