// Copyright the limpet authors. GPL-3.0-or-later.
//
// How fast are points modelled, beside what one point costs at least and beside CGAL's region growing?
//
//     limpet_throughput --shapes cube,city:100 --points 1000000 [--orders shuffled,raster] [--runs 3]
//                       [--noise 0.002] [--sets 26] [--no-cgal] [--csv FILE]
//
// All contestants see the same cloud, take turns within one process, and the best of their runs counts.
//   limpet             the model, sets and finish
//   floor              what no incremental planar model can do without, on limpet's final model: per point a
//                      query of an R-tree of boxes fattened by λ, an exact containment in the polygon of
//                      the nearest plane, an addition to its moments
//   cgal, true         CGAL's region growing (12 nearest, or a sphere of about 15) with the true normals
//   cgal, estimated    the same with normals estimated from the 12 nearest points, that cost included
//
// λ = max(feature/20, 2.2·√(area/points)). Memory is what a contestant's run adds to the process at its peak.
#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>
#include <string>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing_on_point_set.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>
#include <CLI/CLI.hpp>

#include <limpet/geometry/polygon.hpp>
#include <limpet/geometry/predicates.hpp>
#include <limpet/model/model.hpp>
#include <limpet/model/moments.hpp>
#include <limpet/model/spatial_index.hpp>
#include <limpet/simulation/scan.hpp>
#include <limpet/simulation/scene.hpp>

#include "scan_case.hpp"

namespace {

using namespace limpet;
using Eigen::Vector3d;

struct Arguments {
  std::vector<std::string> shapes{"cube", "city:100"}, orders{"shuffled", "raster"};
  std::vector<std::int64_t> points{1'000'000};
  double noise = 0.002;
  std::size_t set_size = 26;
  int runs = 3;
  bool no_cgal = false;
  std::string csv;
};

struct Cloud {
  std::string shape, order;
  double resolution = 0, noise = 0;
  double spacing = 0;  ///< 2.2·√(area/points): a sphere of this radius holds about 15 points
  std::vector<model::SensorPoint> points;
  std::vector<Vector3d> true_normals;
  int faces = 0;
};

Cloud make_cloud(const Arguments& args, const std::string& shape, const std::string& order,
                 std::int64_t count) {
  const auto scene = simulation::make_scene(shape);
  const auto faces = simulation::faces_of(scene.mesh);
  Cloud cloud;
  cloud.shape = shape, cloud.order = order;
  cloud.faces = static_cast<int>(faces.size());
  const double area = benchmarks::area_of(scene.mesh);
  cloud.noise = args.noise * benchmarks::size_of(shape, scene.mesh, scene.feature);
  cloud.spacing = benchmarks::spacing(area, count);
  cloud.resolution = benchmarks::resolution(scene.feature, area, count);
  simulation::ScanOptions options;
  options.points = count;
  options.order =
      order == "raster" ? simulation::ScanOptions::Order::raster : simulation::ScanOptions::Order::shuffled;
  options.noise = cloud.noise;
  options.viewpoints = scene.viewpoints;
  simulation::scan(scene.mesh, options, [&](const simulation::LabelledPoint& p) {
    cloud.points.push_back(p.point);
    cloud.true_normals.push_back(faces[static_cast<std::size_t>(p.face)].normal);
  });
  return cloud;
}

// ---- What is measured --------------------------------------------------------------------------

/// One contestant's run: planes found, points in them.
struct Outcome {
  std::int64_t planes = 0, points = 0;
};
struct Contestant {
  std::string name;
  std::function<Outcome()> run;
  Outcome outcome{};
  double seconds = std::numeric_limits<double>::infinity();
  double megabytes = 0;
};

/// Largest resident size of the process since reset_peak(), in MB.
double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// Resident size becomes the new peak; what is free goes back first. Where the system cannot, the peak stays
/// and memory reads too small.
void reset_peak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
}

void measure(Contestant& c) {
  reset_peak();
  const double before = peak_megabytes();
  const auto start = std::chrono::steady_clock::now();
  c.outcome = c.run();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  c.seconds = std::min(c.seconds, seconds);
  c.megabytes = std::max(c.megabytes, peak_megabytes() - before);
}

// ---- limpet, and the floor ---------------------------------------------------------------------

model::ModelRecord modelled(const Cloud& cloud, std::size_t set_size) {
  model::Parameters parameters;
  parameters.resolution = cloud.resolution;
  parameters.noise = cloud.noise;
  model::Model model(parameters);
  for (std::size_t i = 0; i < cloud.points.size(); i += set_size)
    model.update(std::span(cloud.points).subspan(i, std::min(set_size, cloud.points.size() - i)));
  model.finish();
  return model.record();
}

Outcome outcome_of(const model::ModelRecord& record) {
  Outcome outcome;
  outcome.planes = static_cast<std::int64_t>(record.polygon_segments.size());
  for (const auto& s : record.polygon_segments) outcome.points += s.moments.count;
  return outcome;
}

/// The polygons of a finished model, ready to be asked.
struct Frozen {
  geometry::Chart chart;
  geometry::Plane plane;
  geometry::Polygon polygon;
  model::Moments moments;
};

class Floor {
 public:
  Floor(const model::ModelRecord& record, double resolution)
      : resolution_(resolution), step_(record.grid_step) {
    geometry::EdgeIds ids;
    for (const auto& s : record.polygon_segments) {
      Frozen f;
      f.chart = geometry::Chart(s.chart_origin, s.chart_u, s.chart_v, s.chart_normal, step_);
      geometry::Lift lift;
      lift.h0 = s.height[0], lift.hx = s.height[1], lift.hy = s.height[2];
      f.plane = lift.plane(f.chart);
      model::Box3 box;
      std::vector<std::vector<geometry::NewVertex>> cycles;
      for (const auto& cycle : s.cycles) {
        auto& vertices = cycles.emplace_back();
        for (const auto& v : cycle) {
          vertices.push_back({{v.x, v.y}});
          box.extend(f.chart.at({v.x, v.y}, lift({v.x, v.y})));
        }
      }
      f.polygon = *geometry::Polygon::from_cycles(cycles, ids);
      const Vector3d reach = Vector3d::Constant(resolution);
      index_.insert({box.min() - reach, box.max() + reach}, static_cast<std::uint32_t>(frozen_.size()));
      frozen_.push_back(std::move(f));
    }
  }

  Outcome run(const std::vector<model::SensorPoint>& points) {
    for (auto& f : frozen_) f.moments = {};
    Outcome outcome;
    for (const auto& p : points) outcome.points += add(p);
    outcome.planes = static_cast<std::int64_t>(frozen_.size());
    return outcome;
  }

 private:
  bool add(const model::SensorPoint& reading) {
    const Vector3d& p = reading.position;
    index_.query({p, p}, found_);
    Frozen* best = nullptr;
    double nearest = resolution_;
    for (const std::uint32_t i : found_) {
      const double height = std::abs(frozen_[i].plane.height_of(p));
      if (height < nearest && reading.axis.dot(frozen_[i].plane.normal) < 0)
        nearest = height, best = &frozen_[i];
    }
    if (!best) return false;
    const auto q = geometry::round_to_grid(best->chart.project(p));
    const bool inside = best->polygon.locate(q) != geometry::Polygon::Side::outside;
    model::GridPoint at{};
    for (int i = 0; i < 3; ++i)
      at[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(std::floor(p[i] / step_ + 0.5));
    best->moments.add(at);
    return inside;
  }

  double resolution_, step_;
  model::SpatialIndex index_;
  std::vector<Frozen> frozen_;
  std::vector<std::uint32_t> found_;
};

// ---- CGAL ----------------------------------------------------------------------------------------

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using PointMap = CGAL::First_of_pair_property_map<Oriented>;
using NormalMap = CGAL::Second_of_pair_property_map<Oriented>;
using Range = std::vector<Oriented>;
namespace growing = CGAL::Shape_detection::Point_set;
using NearestQuery = growing::K_neighbor_query<Kernel, Range, PointMap>;
using SphereQuery = growing::Sphere_neighbor_query<Kernel, Range, PointMap>;
using PlaneRegion = growing::Least_squares_plane_fit_region<Kernel, Range, PointMap, NormalMap>;

constexpr unsigned kNeighbours = 12;
constexpr std::size_t kSmallestRegion = 50;
constexpr double kMaxAngleDeg = 25;

template <class Query>
Outcome grow(const Range& range, Query& query, double max_distance) {
  PlaneRegion region(range, max_distance, kMaxAngleDeg, kSmallestRegion);
  CGAL::Shape_detection::Region_growing<Range, Query, PlaneRegion> growing_regions(range, query, region);
  std::vector<std::vector<std::size_t>> regions;
  growing_regions.detect(std::back_inserter(regions));
  Outcome outcome;
  outcome.planes = static_cast<std::int64_t>(regions.size());
  for (const auto& r : regions) outcome.points += static_cast<std::int64_t>(r.size());
  return outcome;
}

Outcome region_growing(const Cloud& cloud, bool estimate, bool sphere) {
  Range range;
  range.reserve(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Vector3d &p = cloud.points[i].position, &n = cloud.true_normals[i];
    range.emplace_back(Kernel::Point_3(p.x(), p.y(), p.z()), Kernel::Vector_3(n.x(), n.y(), n.z()));
  }
  if (estimate)
    CGAL::pca_estimate_normals<CGAL::Sequential_tag>(
        range, kNeighbours, CGAL::parameters::point_map(PointMap()).normal_map(NormalMap()));
  const double max_distance = std::max(3 * cloud.noise, cloud.resolution / 20);
  if (sphere) {
    SphereQuery query(range, cloud.spacing);
    return grow(range, query, max_distance);
  }
  NearestQuery query(range, kNeighbours);
  return grow(range, query, max_distance);
}

// ---- The table -------------------------------------------------------------------------------------

void compare(const Arguments& args, const Cloud& cloud, std::ostream* csv) {
  Floor floor(modelled(cloud, args.set_size), cloud.resolution);
  std::vector<Contestant> contestants;
  const auto enter = [&](const char* name, std::function<Outcome()> run) {
    contestants.push_back({name, std::move(run)});
  };
  enter("floor", [&] { return floor.run(cloud.points); });
  enter("limpet", [&] { return outcome_of(modelled(cloud, args.set_size)); });
  if (!args.no_cgal) {
    enter("cgal k=12, true normals", [&] { return region_growing(cloud, false, false); });
    enter("cgal sphere, true normals", [&] { return region_growing(cloud, false, true); });
    enter("cgal k=12, estimated", [&] { return region_growing(cloud, true, false); });
    enter("cgal sphere, estimated", [&] { return region_growing(cloud, true, true); });
  }
  for (int run = 0; run < args.runs; ++run)
    for (auto& c : contestants) measure(c);

  const auto count = static_cast<double>(cloud.points.size());
  std::printf("%s, %.0f points, %s, noise %g, resolution %.4g, %d true faces\n", cloud.shape.c_str(), count,
              cloud.order.c_str(), cloud.noise, cloud.resolution, cloud.faces);
  std::printf("  %-26s %10s %12s %8s %8s %10s %8s\n", "", "ns/point", "points/s", "x floor", "planes",
              "in planes", "MB");
  for (const auto& c : contestants) {
    const double nanoseconds = 1e9 * c.seconds / count, ratio = c.seconds / contestants[0].seconds;
    const double share = 100 * static_cast<double>(c.outcome.points) / count;
    std::printf("  %-26s %10.0f %12.0f %8.2f %8ld %9.2f%% %8.1f\n", c.name.c_str(), nanoseconds,
                count / c.seconds, ratio, static_cast<long>(c.outcome.planes), share, c.megabytes);
    if (csv)
      *csv << cloud.shape << ',' << cloud.points.size() << ',' << cloud.order << ',' << cloud.noise << ','
           << cloud.resolution << ",\"" << c.name << "\"," << nanoseconds << ',' << ratio << ','
           << c.outcome.planes << ',' << cloud.faces << ',' << share << ',' << c.megabytes << '\n';
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  Arguments args;
  CLI::App app{"Measures how fast points are modelled"};
  app.add_option("--shapes", args.shapes)->delimiter(',');
  app.add_option("--orders", args.orders, "shuffled, raster")->delimiter(',');
  app.add_option("--points", args.points)->delimiter(',');
  app.add_option("--noise", args.noise, "as a fraction of the size of a box");
  app.add_option("--sets", args.set_size, "sensor points in a set")->check(CLI::PositiveNumber);
  app.add_option("--runs", args.runs, "the best of so many counts")->check(CLI::PositiveNumber);
  app.add_flag("--no-cgal", args.no_cgal);
  app.add_option("--csv", args.csv);
  CLI11_PARSE(app, argc, argv);

  std::ofstream csv;
  if (!args.csv.empty()) {
    csv.open(args.csv);
    csv << "shape,points,order,noise,resolution,contestant,ns_per_point,ratio_to_floor,planes,true_faces,"
           "percent_in_planes,peak_megabytes\n";
  }
  for (const auto& shape : args.shapes)
    for (const auto points : args.points)
      for (const auto& order : args.orders)
        compare(args, make_cloud(args, shape, order, points), csv.is_open() ? &csv : nullptr);
  return 0;
}
