// Copyright the limpet authors. GPL-3.0-or-later.
#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <limpet/io/color.hpp>
#include <limpet/io/polygon_mesh.hpp>
#include <nlohmann/json.hpp>

#include "drawn_model_internal.hpp"
#include "gltf_writer_internal.hpp"

namespace limpet::io::internal {
namespace {

using nlohmann::json;

// Numbers that glTF 2.0 gives these things.
constexpr int kUnsignedByte = 5121, kUnsignedInt = 5125, kFloat = 5126;
constexpr int kArrayBuffer = 34962, kElementBuffer = 34963;
constexpr int kLines = 1, kTriangles = 4;
constexpr std::uint32_t kMagic = 0x46546c67, kVersion = 2, kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;

void append_word(std::string& bytes, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>(word >> (8 * i) & 0xff));
}

void append_floats(std::string& bytes, const Eigen::Vector3f& p) {
  for (int k = 0; k < 3; ++k) append_word(bytes, std::bit_cast<std::uint32_t>(p[k]));
}

void append_chunk(std::string& bytes, std::uint32_t type, std::string chunk, char filler) {
  chunk.resize((chunk.size() + 3) / 4 * 4, filler);
  append_word(bytes, static_cast<std::uint32_t>(chunk.size()));
  append_word(bytes, type);
  bytes += chunk;
}

/// Collects the buffer, its views and its accessors.
class Buffer {
 public:
  /// Returns the accessor's number.
  int add(const std::string& bytes, int target, int component, const char* type, std::size_t count,
          const json& more) {
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}, {"target", target}});
    json accessor = {
        {"bufferView", views_.size() - 1}, {"componentType", component}, {"type", type}, {"count", count}};
    accessor.update(more);
    accessors_.push_back(std::move(accessor));
    bytes_ += bytes;  // of whole words: the next view is aligned
    return static_cast<int>(accessors_.size()) - 1;
  }
  int add_indices(const std::vector<std::uint32_t>& indices) {
    std::string bytes;
    for (const std::uint32_t i : indices) append_word(bytes, i);
    return add(bytes, kElementBuffer, kUnsignedInt, "SCALAR", indices.size(), json::object());
  }
  const std::string& bytes() const { return bytes_; }
  void describe(json& gltf) const {
    gltf["buffers"] = {{{"byteLength", bytes_.size()}}};
    gltf["bufferViews"] = views_;
    gltf["accessors"] = accessors_;
  }

 private:
  std::string bytes_;
  json views_ = json::array(), accessors_ = json::array();
};

int add_positions(Buffer& buffer, const DrawnModel& model, const Eigen::Vector3d& middle) {
  std::string bytes;
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3d& vertex : model.vertices) {
    const Eigen::Vector3f at = (vertex - middle).cast<float>();
    append_floats(bytes, at);
    box.extend(at);
  }
  const auto three = [](const Eigen::Vector3f& p) { return json{p.x(), p.y(), p.z()}; };
  return buffer.add(bytes, kArrayBuffer, kFloat, "VEC3", model.vertices.size(),
                    {{"min", three(box.min())}, {"max", three(box.max())}});
}

/// Calls f(polygon) for each vertex.
template <class F>
void for_each_vertex(const DrawnModel& model, F&& f) {
  for (const LiftedPolygon& polygon : model.polygons)
    for (const LiftedCycle& cycle : polygon.cycles)
      for (std::size_t i = 0; i < cycle.size(); ++i) f(polygon);
}

int add_normals(Buffer& buffer, const DrawnModel& model) {
  std::string bytes;
  for_each_vertex(model,
                  [&](const LiftedPolygon& p) { append_floats(bytes, p.normal.cast<float>().normalized()); });
  return buffer.add(bytes, kArrayBuffer, kFloat, "VEC3", model.vertices.size(), json::object());
}

/// Colours of vertices are light intensities, not what a screen is told.
int add_colors(Buffer& buffer, const DrawnModel& model) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return static_cast<char>(
        std::lround(255 * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4))));
  };
  std::string bytes;
  for_each_vertex(model, [&](const LiftedPolygon& p) {
    for (const std::uint8_t channel : segment_color(p.id)) bytes.push_back(linear(channel));
    bytes.push_back(static_cast<char>(0xff));
  });
  return buffer.add(bytes, kArrayBuffer, kUnsignedByte, "VEC4", model.vertices.size(),
                    {{"normalized", true}});
}

std::vector<std::uint32_t> face_indices(const DrawnModel& model) {
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < model.polygons.size(); ++i)
    for (const auto& triangle : triangles_of(model, i))
      indices.insert(indices.end(), triangle.begin(), triangle.end());
  return indices;
}

std::vector<std::uint32_t> line_indices(const DrawnModel& model, bool shared) {
  std::vector<std::uint32_t> indices;
  for (const DrawnModel::Line& line : model.lines)
    if ((line.partner != 0) == shared) indices.insert(indices.end(), line.ends.begin(), line.ends.end());
  return indices;
}

json lit_white() {
  return {{"name", "faces"},
          {"doubleSided", true},
          {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.9}}}};
}

json unlit(const char* name, const json& color) {
  return {{"name", name},
          {"pbrMetallicRoughness", {{"baseColorFactor", color}, {"metallicFactor", 0}}},
          {"extensions", {{"KHR_materials_unlit", json::object()}}}};
}

/// What the mesh is drawn of; what would be empty is left out.
void add_primitives(const DrawnModel& model, const Eigen::Vector3d& middle, Buffer& buffer, json& gltf) {
  json primitives = json::array(), materials = json::array();
  const auto add = [&](int mode, const std::vector<std::uint32_t>& indices, json attributes, json material) {
    primitives.push_back({{"mode", mode},
                          {"material", materials.size()},
                          {"indices", buffer.add_indices(indices)},
                          {"attributes", std::move(attributes)}});
    materials.push_back(std::move(material));
  };
  const int positions = add_positions(buffer, model, middle);
  if (const auto indices = face_indices(model); !indices.empty()) {
    const int normals = add_normals(buffer, model), colors = add_colors(buffer, model);
    add(kTriangles, indices, {{"POSITION", positions}, {"NORMAL", normals}, {"COLOR_0", colors}},
        lit_white());
  }
  if (const auto indices = line_indices(model, true); !indices.empty())
    add(kLines, indices, {{"POSITION", positions}}, unlit("shared edges", {0.01, 0.01, 0.01, 1}));
  if (const auto indices = line_indices(model, false); !indices.empty())
    add(kLines, indices, {{"POSITION", positions}}, unlit("open edges", {0.9, 0.1, 0.01, 1}));
  gltf["meshes"] = {{{"name", "model"}, {"primitives", std::move(primitives)}}};
  gltf["materials"] = std::move(materials);
}

}  // namespace

std::string glb_bytes(const model::ModelRecord& record) {
  const DrawnModel model = drawn(record);
  json gltf = {
      {"asset", {{"version", "2.0"}, {"generator", "limpet"}}}, {"scene", 0}, {"scenes", {json::object()}}};
  Buffer buffer;
  if (!model.vertices.empty()) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& vertex : model.vertices) box.extend(vertex);
    const Eigen::Vector3d middle = box.center();
    const double half = std::sqrt(0.5);
    gltf["extensionsUsed"] = {"KHR_materials_unlit"};
    gltf["scenes"][0]["nodes"] = {0};
    gltf["nodes"] = {{{"name", "model"},
                      {"mesh", 0},
                      {"rotation", {-half, 0, 0, half}},
                      {"translation", {middle.x(), middle.z(), -middle.y()}}}};
    add_primitives(model, middle, buffer, gltf);
    buffer.describe(gltf);
  }
  std::string chunks;
  append_chunk(chunks, kJsonChunk, gltf.dump(), ' ');
  if (!buffer.bytes().empty()) append_chunk(chunks, kBinaryChunk, buffer.bytes(), '\0');
  std::string bytes;
  constexpr std::uint32_t kHeader = 12;
  for (const std::uint32_t word : {kMagic, kVersion, kHeader + static_cast<std::uint32_t>(chunks.size())})
    append_word(bytes, word);
  return bytes + chunks;
}

}  // namespace limpet::io::internal
