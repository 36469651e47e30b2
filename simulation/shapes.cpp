// Copyright the limpet authors. GPL-3.0-or-later.
#include <charconv>
#include <functional>
#include <limpet/simulation/box_world.hpp>
#include <limpet/simulation/shapes.hpp>
#include <limpet/simulation/shapes_internal.hpp>

namespace limpet::simulation {
namespace {

using Eigen::Vector3d;
using Parameters = std::vector<std::string>;

template <typename Number>
Number parameter(const std::string& text, Number low, Number high) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= low && value <= high))
    throw MeshError("not a possible shape parameter: " + text);
  return value;
}

std::uint64_t seed(const Parameters& parameters, std::size_t at) {
  return parameters.size() > at ? parameter<std::uint64_t>(parameters[at], 0, ~std::uint64_t{0}) : 1;
}

double thickness(const Parameters& parameters) {
  const double t = parameters.empty() ? 0.125 : parameter<double>(parameters[0], 0, 1);
  if (t <= 0) throw MeshError("a plate needs a thickness");
  return t;
}

int facets(const Parameters& parameters) {
  const int count = parameters.empty() ? 64 : parameter<int>(parameters[0], 8, 1024);
  if (count % 4 != 0) throw MeshError("not a multiple of 4: " + parameters[0]);
  return count;
}

int boxes(const Parameters& parameters) {
  return parameters.empty() ? 9 : parameter<int>(parameters[0], 1, 100'000);
}

int cells(const Parameters& parameters) {
  return parameters.empty() ? 12 : parameter<int>(parameters[0], 1, 1000);
}

/// Cells along one side of a room.
int cells_along(const Parameters& parameters, std::size_t at, int usual) {
  return parameters.size() > at ? parameter<int>(parameters[at], 1, 100) : usual;
}

Mesh room(const Parameters& parameters) {
  return make_room(seed(parameters, 0), cells_along(parameters, 1, 6), cells_along(parameters, 2, 4));
}

Mesh box(const Vector3d& size) {
  BoxWorld world;
  world.add(Vector3d::Zero(), size);
  return world.surface();
}

Mesh l_block() {
  BoxWorld world;
  world.add({0, 0, 0}, {1, 1, 1});
  world.carve({0.5, 0, 0.5}, {1, 1, 1});
  return world.surface();
}

Mesh step_hole() {
  BoxWorld world;
  world.add({0, 0, 0}, {2, 1, 0.5});
  world.add({0, 0, 0.5}, {0.75, 1, 1});
  world.carve({1.125, 0.25, 0}, {1.625, 0.75, 0.5});
  return world.surface();
}

Mesh plate3() {
  BoxWorld world;
  world.add({0, 0, 0}, {3, 1, 0.25});
  for (const double x : {0.25, 1.25, 2.25}) world.carve({x, 0.25, 0}, {x + 0.5, 0.75, 0.25});
  return world.surface();
}

Mesh open_box() {
  BoxWorld world;
  world.add({0, 0, 0}, {1, 1, 1});
  return world.surface([](const Vector3d&, const Vector3d& normal) { return normal.z() <= 0; });
}

Mesh pyramid() {
  return make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}},
                   {{3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
}

Mesh octahedron() {
  return make_mesh({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                   {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
}

struct Shape {
  std::string name, example;
  std::size_t parameters;  ///< at most
  std::function<Mesh(const Parameters&)> make;
  std::function<double(const Parameters&)> feature;
};

template <typename Make>
Shape plain(const std::string& name, double feature, Make make) {
  return {name, name, 0, [make](const Parameters&) { return make(); },
          [feature](const Parameters&) { return feature; }};
}

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{
      plain("cube", 1,
            [] {
              return box({1, 1, 1});
            }),
      plain("L", 0.5, l_block),
      plain("step_hole", 0.25, step_hole),
      plain("plate3", 0.25, plate3),
      plain("open_box", 1, open_box),
      plain("pyramid", 1, pyramid),
      plain("octahedron", 1.224744871391589, octahedron),
      plain("icosahedron", 0.8660254037844386, make_icosahedron),
      plain("box", 0.5, make_slab),
      plain("step", 0.5, make_staircase),
      plain("notch", 0.5, make_notch),
      plain("cross", 0.5, make_cross),
      {"sphere", "sphere:32", 1, [](const Parameters& p) { return make_sphere(facets(p)); },
       [](const Parameters& p) { return facets(p), 1.0; }},
      {"drum", "drum:32", 1, [](const Parameters& p) { return make_drum(facets(p)); },
       [](const Parameters& p) { return facets(p), 0.1875; }},
      {"thin_plate", "thin_plate:0.125", 1,
       [](const Parameters& p) {
         return box({1, 1, thickness(p)});
       },
       thickness},
      {"cells", "cells:12", 2, [](const Parameters& p) { return make_cells(cells(p), seed(p, 1)); },
       [](const Parameters& p) { return cells(p), seed(p, 1), 0.75; }},
      {"room", "room:1", 3, room,
       [](const Parameters& p) { return seed(p, 0), cells_along(p, 1, 6), cells_along(p, 2, 4), 0.25; }},
      {"city", "city:9", 2, [](const Parameters& p) { return make_city(boxes(p), seed(p, 1)); },
       [](const Parameters& p) { return boxes(p), seed(p, 1), 0.5; }}};
  return all;
}

const Shape* find(const std::string& name, Parameters* parameters) {
  Parameters parts;
  for (std::size_t at = 0;;) {
    const std::size_t colon = name.find(':', at);
    parts.push_back(name.substr(at, colon - at));
    if (colon == std::string::npos) break;
    at = colon + 1;
  }
  for (const Shape& shape : shapes()) {
    if (shape.name != parts[0]) continue;
    if (parameters) parameters->assign(parts.begin() + 1, parts.end());
    return &shape;
  }
  return nullptr;
}

const Shape& known(const std::string& name, Parameters& parameters) {
  const Shape* shape = find(name, &parameters);
  if (!shape) throw MeshError("no such shape: " + name);
  if (parameters.size() > shape->parameters) throw MeshError("too many shape parameters: " + name);
  return *shape;
}

}  // namespace

Mesh make_shape(const std::string& name) {
  Parameters parameters;
  return known(name, parameters).make(parameters);
}

double feature_size(const std::string& name) {
  Parameters parameters;
  return known(name, parameters).feature(parameters);
}

bool is_shape(const std::string& name) { return find(name, nullptr) != nullptr; }

std::vector<std::string> shape_names() {
  std::vector<std::string> names;
  for (const Shape& shape : shapes()) names.push_back(shape.example);
  return names;
}

}  // namespace limpet::simulation
