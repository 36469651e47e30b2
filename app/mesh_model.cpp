// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/mesh_model.hpp>

#include <cstdio>
#include <limpet/io/text.hpp>
#include <limpet/simulation/scene.hpp>
#include <limpet/simulation/shapes.hpp>
#include <stdexcept>

namespace limpet::app {
namespace {

std::vector<model::InitialFace> known_faces(const simulation::Mesh& mesh) {
  std::vector<model::InitialFace> result;
  for (const simulation::Face& face : simulation::faces_of(mesh)) result.push_back({face.loops});
  return result;
}

}  // namespace

std::vector<model::InitialFace> initial_faces(const std::string& path) {
  return known_faces(simulation::load_mesh(path));
}

model::ModelRecord model_of_mesh(const std::string& path) {
  const simulation::Mesh mesh = simulation::make_scene(path).mesh;
  model::Parameters parameters;
  parameters.resolution = simulation::narrowest_place(mesh) / 20;
  parameters.angle_rad = 0.02;
  model::Model model(parameters);
  int left_out = 0;
  for (const model::InitialFace& face : known_faces(mesh)) {
    try {
      model.add_initial({&face, 1});
    } catch (const std::invalid_argument&) {
      ++left_out;
    }
  }
  if (left_out > 0)
    std::fprintf(stderr, "limpet: warning: %s: %d faces are no simple polygons, and are left out\n",
                 path.c_str(), left_out);
  model.finish();
  return model.record();
}

bool is_mesh_name(const std::string& path) {
  if (simulation::is_shape(path)) return true;
  const std::string extension = io::extension_of(path);
  return extension == "off" || extension == "stl" || extension == "obj" || extension == "ply";
}

}  // namespace limpet::app
