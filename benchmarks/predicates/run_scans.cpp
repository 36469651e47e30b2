// Copyright the limpet authors. GPL-3.0-or-later.
#include "run_scans.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>

#include <limpet/io/scan_writer.hpp>
#include <limpet/simulation/shapes.hpp>

#include "../scan_case.hpp"

namespace limpet::benchmarks {
namespace {

constexpr std::array kRegimes = {"grid", "free", "far"};

/// A million times the extent away.
constexpr double kFar = 1e6;

Eigen::Isometry3d move_of(const std::string& regime, double extent) {
  Eigen::Isometry3d move = Eigen::Isometry3d::Identity();
  if (regime == "free") move.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  if (regime == "far") move.pretranslate(kFar * extent * Eigen::Vector3d(1, -0.7, 0.4));
  return move;
}

std::string shown(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", number);
  return text.data();
}

/// OFF, with all digits.
void write_mesh(const simulation::Mesh& mesh, const Eigen::Isometry3d& move, const std::string& path) {
  std::ofstream file(path);
  file << "OFF\n" << mesh.vertices.size() << ' ' << mesh.triangles.size() << " 0\n";
  for (const auto& v : mesh.vertices) {
    const Eigen::Vector3d p = move * v;
    file << shown(p.x()) << ' ' << shown(p.y()) << ' ' << shown(p.z()) << '\n';
  }
  for (const auto& t : mesh.triangles) file << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

std::vector<io::ScanRecord> read_scan(const std::string& path) {
  std::vector<io::ScanRecord> records;
  const auto scan = io::open_scan(path, {});
  for (io::ScanRecord record; scan->next(record);) records.push_back(record);
  return records;
}

/// Where the sensor of a PCD file stood. From there the noise of its readings is estimated, so it goes along.
std::optional<Eigen::Vector3d> viewpoint_of(const std::string& path) {
  if (!path.ends_with(".pcd")) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line) && !line.starts_with("DATA");) {
    Eigen::Vector3d at;
    if (line.starts_with("VIEWPOINT") &&
        std::sscanf(line.c_str(), "VIEWPOINT %lf %lf %lf", &at.x(), &at.y(), &at.z()) == 3)
      return at;
  }
  return std::nullopt;
}

double extent_of(const std::vector<io::ScanRecord>& records) {
  Eigen::AlignedBox3d box;
  for (const auto& r : records) box.extend(r.point.position);
  return box.sizes().maxCoeff();
}

void write_scan(std::vector<io::ScanRecord> records, bool axes, const Eigen::Isometry3d& move,
                const std::string& path) {
  const auto writer = io::create_scan(path, {.ascii = false, .axes = axes, .labels = false, .comment = ""});
  for (auto& r : records) {
    r.point.position = move * r.point.position;
    r.point.axis = move.linear() * r.point.axis;
    writer->write(r);
  }
  writer->close();
}

struct Shape {
  std::string name;
  std::int64_t points = 100'000;
};

void add_simulated(const Shape& shape, const std::string& order, double noise_ratio,
                   const PredicatesOptions& options, std::vector<RunScan>& scans) {
  const simulation::Mesh mesh = simulation::make_shape(shape.name);
  const double feature = simulation::feature_size(shape.name);
  const double noise = noise_ratio * size_of(shape.name, mesh, feature);
  // λ is not below ten times the noise: what is judged is arithmetic, not what noise does to fine detail.
  const double lambda = std::max(resolution(feature, area_of(mesh), shape.points), 10 * noise);
  const std::string stem = options.scratch + "/simulated";
  const ChildEnd end =
      run_program({model_program(0), "scan", shape.name, "-o", stem + ".ply", "--points",
                   std::to_string(shape.points), "--order", order, "--noise", shown(noise), "-q"},
                  {});
  if (!end.done()) throw std::runtime_error("no scan of " + shape.name + ": " + end.how());
  const auto records = read_scan(stem + ".ply");
  const auto bounds = simulation::bounds_of(mesh);
  for (const char* regime : kRegimes) {
    const auto move = move_of(regime, (bounds.high - bounds.low).maxCoeff());
    RunScan scan{.name = shape.name + ", " + order + (noise > 0 ? ", noise" : ""),
                 .source = "simulated",
                 .regime = regime,
                 .path = stem + std::to_string(scans.size()) + ".ply",
                 .truth = stem + std::to_string(scans.size()) + ".off",
                 .resolution = lambda,
                 .noise = noise};
    write_scan(records, true, move, scan.path);
    write_mesh(mesh, move, scan.truth);
    scans.push_back(scan);
  }
}

}  // namespace

std::vector<std::string> RunScan::arguments() const {
  std::vector<std::string> words{path};
  if (resolution > 0) words.insert(words.end(), {"--resolution", shown(resolution), "--noise", shown(noise)});
  if (!viewpoint.empty()) words.push_back("--viewpoint=" + viewpoint);
  return words;
}

std::vector<RunScan> simulated_scans(const PredicatesOptions& options) {
  std::vector<Shape> shapes{{"cube"}, {"step_hole"}, {"city:25"}};
  if (options.full) shapes.insert(shapes.end(), {{"L"}, {"room", 300'000}, {"city:100", 500'000}});
  std::vector<RunScan> scans;
  for (const Shape& shape : shapes)
    for (const char* order : {"raster", "sampled"})
      for (const double noise : {0.0, 0.002}) add_simulated(shape, order, noise, options, scans);
  return scans;
}

std::vector<RunScan> real_scans(const PredicatesOptions& options) {
  std::vector<const char*> names{"pcl_mOSD/learn0.pcd",        "pcl_mOSD/learn13.pcd",
                                 "synpeb_sample/test_100.pcd", "cgal_points/building.xyz",
                                 "pcl_test/office1.pcd",       "cgal_points/cube.pwn"};
  if (options.full)
    names.insert(names.end(), {"pcl_mOSD/learn17.pcd", "pcl_mOSD/learn20.pcd", "pcl_mOSD/learn24.pcd",
                               "pcl_mOSD/learn28.pcd", "pcl_mOSD/learn33.pcd", "pcl_mOSD/learn4.pcd",
                               "pcl_mOSD/learn9.pcd", "pcl_test/milk_cartoon_all_small_clorox.pcd",
                               "cgal_points/b9.ply", "cgal_points/radar.xyz"});
  std::vector<RunScan> scans;
  for (const char* name : names) {
    const std::string path = options.data + "/" + name;
    if (!std::filesystem::exists(path)) {
      std::fprintf(stderr, "runs: no %s\n", path.c_str());
      continue;
    }
    const auto records = read_scan(path);
    const auto viewpoint = viewpoint_of(path);
    const bool axes = !viewpoint && !records.empty() && records.front().has_axis;
    for (const char* regime : kRegimes) {
      const auto move = move_of(regime, extent_of(records));
      RunScan scan{.name = std::filesystem::path(name).stem(),
                   .source = "real",
                   .regime = regime,
                   .path = options.scratch + "/real" + std::to_string(scans.size()) + ".ply"};
      if (viewpoint) {
        const Eigen::Vector3d at = move * *viewpoint;
        scan.viewpoint = shown(at.x()) + "," + shown(at.y()) + "," + shown(at.z());
      }
      write_scan(records, axes, move, scan.path);
      scans.push_back(scan);
    }
  }
  return scans;
}

std::vector<RunScan> small_scans(const PredicatesOptions& options) {
  std::vector<RunScan> scans;
  PredicatesOptions aside = options;
  aside.scratch += "/small";
  std::filesystem::create_directories(aside.scratch);
  const std::int64_t points = options.full ? 50'000 : 10'000;
  for (const Shape& shape : {Shape{"cube", points}, Shape{"step_hole", points}, Shape{"city:5", points}})
    add_simulated(shape, "raster", 0.002, aside, scans);
  for (RunScan& scan : scans) scan.counted = true;
  return scans;
}

}  // namespace limpet::benchmarks
