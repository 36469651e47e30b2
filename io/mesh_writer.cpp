// Copyright the limpet authors. GPL-3.0-or-later.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <algorithm>
#include <fstream>
#include <limpet/io/error.hpp>
#include <limpet/io/mesh_writer.hpp>
#include <limpet/io/native.hpp>
#include <limpet/io/output_file.hpp>
#include <limpet/io/ply_header.hpp>
#include <limpet/io/polygon_mesh.hpp>
#include <limpet/io/text.hpp>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "gltf_writer_internal.hpp"
#include "vtp_writer_internal.hpp"

namespace limpet::io {
namespace {

struct MeshTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
struct Mesh : OpenMesh::PolyMesh_ArrayKernelT<MeshTraits> {
  std::vector<io::Color> colors;  ///< by face; OpenMesh's own colours do not compile without warnings
};

/// OpenMesh tells the world about every face it refuses; refusing is expected here.
class Hush {
 public:
  Hush() {
    omerr().disable();
    omlog().disable();
  }
  ~Hush() {
    omerr().enable();
    omlog().enable();
  }
  Hush(const Hush&) = delete;
  Hush& operator=(const Hush&) = delete;
};

Mesh::Point point_of(const Eigen::Vector3d& at) { return {at.x(), at.y(), at.z()}; }

Mesh build(const PolygonMesh& faces) {
  Mesh mesh;
  const Hush hush;
  std::vector<Mesh::VertexHandle> vertices;
  for (const Eigen::Vector3d& at : faces.vertices) vertices.push_back(mesh.add_vertex(point_of(at)));
  for (const MeshFace& face : faces.faces) {
    std::vector<Mesh::VertexHandle> corners;
    for (const int vertex : face.vertices) corners.push_back(vertices[vertex]);
    Mesh::FaceHandle added = mesh.add_face(corners);
    if (!added.is_valid()) {  // not manifold here: stands beside its neighbours, over vertices of its own
      for (auto& corner : corners) {
        const Mesh::Point at = mesh.point(corner);  // a copy: the new vertex may move the others
        corner = mesh.add_vertex(at);
      }
      added = mesh.add_face(corners);
    }
    mesh.colors.push_back(segment_color(face.segment));
  }
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  mesh.delete_isolated_vertices();
  mesh.garbage_collection();
  return mesh;
}

// OpenMesh 9 writes the coordinates of OFF, PLY and OBJ as floats, whatever the mesh holds: at map
// coordinates (10⁶ m) that is a grid of 6 cm. These three are text, and written here from its mesh.

void append_point(std::string& text, const Mesh::Point& point) {
  append(text, point[0]);
  append(text += ' ', point[1]);
  append(text += ' ', point[2]);
}

void append_count(std::string& text, std::size_t count) { append(text, static_cast<std::uint64_t>(count)); }

/// The vertices of a face, numbered from `first`, each after a blank.
void append_face(std::string& text, const Mesh& mesh, Mesh::FaceHandle face, int first) {
  for (const auto vertex : mesh.fv_range(face)) append(text += ' ', std::int64_t{vertex.idx()} + first);
}

void append_color(std::string& text, const Color& color) {
  for (const std::uint8_t channel : color) append(text += ' ', static_cast<std::int64_t>(channel));
}

/// The lines OFF and PLY have in common: a point a line, then count, vertices and colour of a face a line.
void append_body(std::string& text, const Mesh& mesh) {
  for (const auto vertex : mesh.vertices()) {
    append_point(text, mesh.point(vertex));
    text += '\n';
  }
  for (const auto face : mesh.faces()) {
    append_count(text, mesh.valence(face));
    append_face(text, mesh, face, 0);
    append_color(text, mesh.colors[face.idx()]);
    text += '\n';
  }
}

/// COFF, as OpenMesh and CGAL call a file with coloured faces: OpenMesh reads colours after "OFF" as further
/// faces.
std::string off_text(const Mesh& mesh) {
  std::string text = "COFF\n";
  append_count(text, mesh.n_vertices());
  append_count(text += ' ', mesh.n_faces());
  append_count(text += ' ', mesh.n_edges());
  text += '\n';
  append_body(text, mesh);
  return text;
}

std::string ply_text(const Mesh& mesh) {
  PlyElement vertex, face;
  vertex.name = "vertex";
  vertex.count = static_cast<std::int64_t>(mesh.n_vertices());
  for (const char* name : {"x", "y", "z"}) vertex.properties.push_back({name, NumberType::kDouble});
  face.name = "face";
  face.count = static_cast<std::int64_t>(mesh.n_faces());
  face.properties.push_back({"vertex_indices", NumberType::kInt32, true, NumberType::kInt32});
  for (const char* name : {"red", "green", "blue"}) face.properties.push_back({name, NumberType::kUint8});
  PlyHeader header;
  header.elements = {std::move(vertex), std::move(face)};
  std::string text = ply_header_text(header);
  append_body(text, mesh);
  return text;
}

const std::string kMaterial = "newmtl ", kColor = "color";

struct ObjTexts {
  std::string faces, materials;
};

ObjTexts obj_texts(const Mesh& mesh, const std::string& material_file) {
  ObjTexts texts;
  texts.faces = "mtllib " + material_file + "\n";
  for (const auto vertex : mesh.vertices()) {
    append_point(texts.faces += "v ", mesh.point(vertex));
    texts.faces += '\n';
  }
  std::map<Color, std::string> known;
  std::string current;
  for (const auto face : mesh.faces()) {
    const Color color = mesh.colors[face.idx()];
    std::string& name = known[color];
    if (name.empty()) {
      name = kColor + std::to_string(known.size());
      texts.materials += kMaterial + name + "\nKd";
      for (const std::uint8_t channel : color) append(texts.materials += ' ', channel / 255.0);
      texts.materials += "\nillum 1\n";
    }
    if (name != current) texts.faces += "usemtl " + (current = name) + "\n";
    append_face(texts.faces += 'f', mesh, face, 1);
    texts.faces += '\n';
  }
  return texts;
}

std::string stl_bytes(const Mesh& mesh) {
  std::ostringstream bytes(std::ios::binary);
  bytes.imbue(std::locale::classic());
  const Hush hush;
  if (!OpenMesh::IO::write_mesh(mesh, bytes, ".stl", OpenMesh::IO::Options::Binary)) {
    throw std::logic_error("OpenMesh refused to write a triangle mesh as STL");
  }
  return bytes.str();
}

void save_bytes(const std::string& path, const std::string& bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.close();
}

void save_obj(const std::string& path, const Mesh& mesh) {
  const std::string material_path = side_file(path);
  const ObjTexts texts = obj_texts(mesh, material_path.substr(material_path.find_last_of('/') + 1));
  OutputFile materials(material_path), faces(path);
  materials.write(texts.materials);
  faces.write(texts.faces);
  materials.close();
  faces.close();
}

}  // namespace

std::string side_file(const std::string& path) {
  return extension_of(path) == "obj" ? path.substr(0, path.size() - 3) + "mtl" : std::string();
}

bool is_foreign_side_file(const std::string& side_file) {
  std::ifstream file(side_file, std::ios::binary);
  const std::string ours = kMaterial + kColor + "1\nKd ";
  std::string start(ours.size(), '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  return file.gcount() > 0 && start != ours;
}

bool is_mesh_extension(const std::string& extension) {
  static constexpr std::string_view kKnown[] = {"off", "ply", "obj", "stl", "glb", "vtp"};
  return std::find(std::begin(kKnown), std::end(kKnown), extension) != std::end(kKnown);
}

void save_mesh(const std::string& path, const model::ModelRecord& model) {
  const std::string extension = extension_of(path);
  if (!is_mesh_extension(extension)) throw std::invalid_argument(path + ": not the name of a mesh file");
  if (extension == "glb") return save_bytes(path, internal::glb_bytes(model));
  if (extension == "vtp") return save_bytes(path, internal::vtp_text(model));
  const double reach = std::max(model.parameters.resolution, 8 * model.grid_step);
  const Mesh mesh = build(make_mesh(lift(model), reach, extension == "stl"));
  if (extension == "off") save_bytes(path, off_text(mesh));
  if (extension == "ply") save_bytes(path, ply_text(mesh));
  if (extension == "stl") save_bytes(path, stl_bytes(mesh));
  if (extension == "obj") save_obj(path, mesh);
}

void save_model(const std::string& path, const model::ModelRecord& model) {
  const std::string extension = extension_of(path);
  if (extension == "limpet") {
    save_native(path, model);
  } else if (is_mesh_extension(extension)) {
    save_mesh(path, model);
  } else {
    throw OutputError(path +
                      ": a model is written as .limpet, .off, .ply, .obj, .stl, .glb or .vtp, not as " +
                      in_quotes(extension));
  }
}

}  // namespace limpet::io
