// Copyright the limpet authors. GPL-3.0-or-later.
//
// Meshes nobody here wrote, from the folder named by LIMPET_DATA; skipped where it is absent.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <limpet/evaluation/judgement.hpp>
#include <limpet/simulation/scan.hpp>
#include <limpet/simulation/scene.hpp>
#include <ostream>

#include "../data_folder.hpp"

namespace limpet::evaluation {
namespace {

using limpet::testing::data_folder;

struct DataMesh {
  std::string path;
  int faces;
  int holes;
  bool closed;
};

// NOLINTNEXTLINE(readability-identifier-naming): a name of GoogleTest
void PrintTo(const DataMesh& mesh, std::ostream* out) { *out << mesh.path; }

class DataMeshes : public ::testing::TestWithParam<DataMesh> {
 protected:
  void SetUp() override {
    path_ = data_folder() / GetParam().path;
    if (!std::filesystem::exists(path_)) GTEST_SKIP() << path_ << " is absent";
  }
  std::filesystem::path path_;
};

TEST_P(DataMeshes, HaveTheirFaces) {
  const simulation::Mesh mesh = simulation::load_mesh(path_.string());
  int holes = 0;
  for (const simulation::Face& face : simulation::faces_of(mesh))
    holes += static_cast<int>(face.loops.size()) - 1;
  EXPECT_EQ(mesh.face_count, GetParam().faces);
  EXPECT_EQ(holes, GetParam().holes);
  EXPECT_EQ(simulation::count_edges(mesh).open == 0, GetParam().closed);
}

TEST_P(DataMeshes, AreFaultlessModelsOfThemselves) {
  const simulation::Scene scene = simulation::make_scene(path_.string());
  simulation::ScanOptions options;
  options.points = 40'000;
  options.viewpoints = scene.viewpoints;
  const std::vector<simulation::LabelledPoint> points = simulation::scan(scene.mesh, options);
  EXPECT_NEAR(static_cast<double>(points.size()), 40'000, 2000);
  const std::vector<PlanarFace> model = planar_faces(scene.mesh);
  JudgeOptions judge;
  judge.resolution = 0.02 * simulation::bounds_of(scene.mesh).diagonal();
  const FacesReport report = judge_faces(model, scene.mesh, points, judge);
  EXPECT_EQ(faults(report, model), std::vector<std::string>{});
  EXPECT_GT(report.counted, 3);
  EXPECT_LT(report.max_shortfall, 1e-6 * simulation::bounds_of(scene.mesh).diagonal());
}

INSTANTIATE_TEST_SUITE_P(
    Polyhedra, DataMeshes,
    ::testing::Values(
        DataMesh{"cgal_meshes/cube.off", 6, 0, true}, DataMesh{"cgal_meshes/cube_quad.off", 6, 0, true},
        DataMesh{"cgal_meshes/cube_poly.off", 6, 0, true}, DataMesh{"cgal_meshes/prim.off", 6, 0, true},
        DataMesh{"cgal_meshes/cube-meshed.off", 6, 0, true},
        DataMesh{"cgal_meshes/open_cube.off", 5, 0, false},
        DataMesh{"cgal_meshes/icosahedron.off", 20, 0, true},
        DataMesh{"cgal_meshes/octahedron.off", 8, 0, true},
        DataMesh{"cgal_meshes/tetrahedron.off", 4, 0, true}, DataMesh{"cgal_meshes/pyramid.off", 5, 0, true},
        DataMesh{"cgal_meshes/cross.off", 14, 0, true}, DataMesh{"cgal_meshes/star.off", 24, 0, true},
        DataMesh{"cgal_meshes/beam.off", 6, 0, true}, DataMesh{"cgal_meshes/P.off", 15, 2, true},
        DataMesh{"cgal_meshes/corner.off", 8, 0, true}, DataMesh{"cgal_meshes/cubes.off", 12, 0, true},
        DataMesh{"trimesh_models/unit_cube.STL", 6, 0, true},
        DataMesh{"trimesh_models/large_block.STL", 6, 0, true},
        DataMesh{"trimesh_models/cube_compressed.obj", 6, 0, true},
        DataMesh{"trimesh_models/wallhole.obj", 13, 0, true},
        DataMesh{"trimesh_models/box.STL", 554, 42, true}),
    [](const auto& tested) {
      std::string name = tested.param.path.substr(tested.param.path.find('/') + 1);
      std::replace_if(
          name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
      return name;
    });

TEST(DataFolder, EveryMeshLoadsWithItsAreaInItsFaces) {
  int loaded = 0;
  for (const char* folder : {"cgal_meshes", "trimesh_models", "robot_ur5", "robot_panda"}) {
    if (!std::filesystem::exists(data_folder() / folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(data_folder() / folder)) {
      const std::string ending = entry.path().extension().string();
      if (ending != ".off" && ending != ".obj" && ending != ".ply" && ending != ".stl" && ending != ".STL")
        continue;
      const simulation::Mesh mesh = simulation::load_mesh(entry.path().string());
      double triangles = 0, faces = 0;
      for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
        triangles += simulation::area_vector(mesh, t).norm() / 2;
      for (const simulation::Face& face : simulation::faces_of(mesh)) faces += face.area;
      EXPECT_NEAR(faces, triangles, 1e-5 * triangles) << entry.path();
      ++loaded;
    }
  }
  if (loaded == 0) GTEST_SKIP() << data_folder() << " is absent";
}

}  // namespace
}  // namespace limpet::evaluation
