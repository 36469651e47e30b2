// Copyright the limpet authors. GPL-3.0-or-later.
//
// How good are the models? Simulated scans of known shapes are modelled and judged by the truth.
//
//     limpet_quality --shapes cube,L,MESH.off --points 10000,100000 --noise 0,0.002,0.005 --orders
//     raster,shuffled
//                    --outliers 0,0.01 --seeds 10 [--rules limpet] [--csv FILE] [--audit-every N]
//                    [--keep DIR] [--curve]
//
// Orders: raster (each viewpoint's rays row by row), shuffled (the same readings in random order) and sampled
// (evenly over the surface, in random order). λ = max(feature/20, 2.2·√(area/points)); a case counts when λ ≤
// feature/5 and noise ≤ λ/10. One line a run in the CSV, one line a case on standard output.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <tuple>

#include <CLI/CLI.hpp>

#include <limpet/audit/document.hpp>
#include <limpet/audit/laws.hpp>
#include <limpet/evaluation/judgement.hpp>
#include <limpet/evaluation/nearest.hpp>
#include <limpet/evaluation/planar_face.hpp>
#include <limpet/evaluation/topology.hpp>
#include <limpet/io/native.hpp>
#include <limpet/model/model.hpp>
#include <limpet/simulation/scan.hpp>
#include <limpet/simulation/scene.hpp>
#include <limpet/simulation/shapes.hpp>
#include <limpet/survey/ordered_points.hpp>

#include "scan_case.hpp"

namespace {

using namespace limpet;

struct Arguments {
  std::vector<std::string> shapes{"cube"}, orders{"shuffled"};
  std::vector<std::int64_t> points{10000};
  std::vector<double> noise{0}, outliers{0};
  int seeds = 1, first_seed = 1;
  std::size_t set_size = 26;
  std::int64_t audit_every = 0;
  double resolution = 0, tolerance = 0, move = 0, scale = 1;
  bool curve = false;
  std::string rules = "limpet", csv, keep;
};

struct Case {
  std::string shape, order;
  std::int64_t points;
  double noise_ratio, outliers;
  simulation::Scene scene{};
  double noise = 0, resolution = 0, min_width = 0;
  std::string skipped{};  ///< why, or empty
};

struct Run {
  bool right = false;  ///< as many polygons as faces, with their holes
  bool complete =
      false;  ///< all faces were scanned so that they count: the model should be closed as the truth is
  int counted = 0, represented = 0, extra = 0, wrong_holes = 0;
  double worst_angle_deg = 0, overshoot = 0, shortfall = 0;  ///< in λ, the two last
  int bad_angles = 0;
  double loose = 0, seconds = 0;
  double outliers_kept_out = 1;      ///< of all
  double far_outliers_kept_out = 1;  ///< of those more than 3σ from the surface: no readings of it
  std::size_t points = 0, violations = 0, polygons = 0;
  bool closed = false, isomorphic = false;
  int true_shared = 0, shared = 0, false_shared = 0;
  double vertex_distance = 0;  ///< λ
  std::string faults;
};

std::size_t count_violations(const model::ModelRecord& record, std::string& what) {
  std::stringstream text;
  io::write_native(text, record);
  const auto violations = audit::judge(audit::parse_document(text));
  if (!violations.empty())
    what += violations[0].law + " " + violations[0].where + " " + violations[0].what + "; ";
  return violations.size();
}

evaluation::NearestSurface nearest_to(const simulation::Mesh& mesh) {
  std::vector<evaluation::Triangle3> triangles;
  for (const auto& face : evaluation::planar_faces(mesh))
    for (const auto& triangle : evaluation::triangulated(face)) triangles.push_back(triangle);
  return evaluation::NearestSurface(triangles);
}

/// What refused the open edges of each face a neighbour: "face 3 beside 5: bay 7; ".
std::string refusals(const model::Model& model, const model::ModelRecord& record,
                     const evaluation::FacesReport& report) {
  std::map<std::uint64_t, int> face_of;
  for (std::size_t i = 0; i < record.polygon_segments.size(); ++i)
    face_of[record.polygon_segments[i].id] = report.polygons[i].face;
  std::map<std::tuple<int, int, std::string>, int> count;
  for (const auto& open : model.open_edges())
    ++count[{face_of[open.segment.value], open.other ? face_of[open.other.value] : -1, name(open.refusal)}];
  std::string text;
  for (const auto& [what, edges] : count) {
    const auto& [face, beside, refusal] = what;
    text += "face " + std::to_string(face) + " beside " + std::to_string(beside) + ": " + refusal + " " +
            std::to_string(edges) + "; ";
  }
  return text;
}

/// `name` is a shape; a thin plate without its thickness is one whose two sides are λ/2 apart.
Case make_case(const Arguments& args, const std::string& name, std::int64_t points, double noise_ratio,
               const std::string& order, double outliers) {
  const bool thin = name == "thin_plate";
  Case c{thin ? "thin_plate:0.01" : name, order, points, noise_ratio, outliers};
  c.scene = simulation::make_scene(c.shape);
  if (thin) c.scene.feature = 1;
  c.noise = noise_ratio * benchmarks::size_of(name, c.scene.mesh, c.scene.feature);
  c.resolution = args.resolution > 0
                     ? args.resolution
                     : benchmarks::resolution(c.scene.feature, benchmarks::area_of(c.scene.mesh), points);
  if (thin) {
    c.shape = "thin_plate:" + std::to_string(c.resolution / 2);
    c.scene.mesh = simulation::make_scene(c.shape).mesh;
    c.min_width = c.resolution;
  }
  c.shape = std::filesystem::path(c.shape).stem().string();  // of a mesh file
  if (args.resolution > 0) return c;
  if (c.resolution > c.scene.feature / 5)
    c.skipped = "resolution above feature/5";
  else if (c.noise > c.resolution / 10)
    c.skipped = "noise above resolution/10";
  return c;
}

/// The points, and their labels with them, in the order in which `limpet model` takes a scan.
void put_in_order(double resolution, std::vector<model::SensorPoint>& points,
                  std::vector<simulation::LabelledPoint>& labelled) {
  std::size_t next = 0;
  survey::OrderedPoints ordered(
      [&](survey::Reading& reading) {
        if (next == points.size()) return false;
        reading = {points[next++]};
        return true;
      },
      {resolution});
  std::vector<model::SensorPoint> points_in_order;
  std::vector<simulation::LabelledPoint> labelled_in_order;
  for (survey::Reading reading; ordered.next(reading);) {
    points_in_order.push_back(reading.point);
    labelled_in_order.push_back(labelled[static_cast<std::size_t>(reading.place)]);
  }
  points = std::move(points_in_order);
  labelled = std::move(labelled_in_order);
}

Run run(const Arguments& args, const Case& c, int seed) {
  const simulation::Scene& scene = c.scene;
  simulation::ScanOptions options;
  options.points = c.points;
  options.order = c.order == "raster"    ? simulation::ScanOptions::Order::raster
                  : c.order == "sampled" ? simulation::ScanOptions::Order::sampled
                                         : simulation::ScanOptions::Order::shuffled;
  options.noise = c.noise;
  options.outliers = c.outliers;
  options.seed = static_cast<std::uint64_t>(seed);
  options.viewpoints = scene.viewpoints;
  auto labelled = simulation::scan(scene.mesh, options);
  const Eigen::Vector3d shift = args.move * Eigen::Vector3d(1e6, -1e6, 1e3);
  std::vector<model::SensorPoint> points;
  for (const auto& p : labelled)
    points.push_back({args.scale * p.point.position + shift, p.point.axis, args.scale * p.point.range});

  if (args.curve) put_in_order(args.scale * c.resolution, points, labelled);
  model::Parameters parameters;
  parameters.resolution = args.scale * c.resolution;
  parameters.noise = args.scale * c.noise;
  parameters.tolerance = args.tolerance * parameters.resolution;
  parameters.rules = model::Rules::parse(args.rules);
  model::Model model(parameters);
  model.keep_labels();
  Run r;
  const auto start = std::chrono::steady_clock::now();
  std::int64_t sets = 0;
  for (std::size_t i = 0; i < points.size(); i += args.set_size) {
    model.update(std::span(points).subspan(i, std::min(args.set_size, points.size() - i)));
    if (args.audit_every > 0 && ++sets % args.audit_every == 0)
      r.violations += count_violations(model.record(), r.faults);
  }
  model.finish();
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto record = model.record();
  r.violations += count_violations(record, r.faults);
  if (!args.keep.empty()) {
    std::ofstream file(args.keep + "/" + c.shape + "_" + std::to_string(c.points) + "_" +
                       std::to_string(c.noise_ratio) + "_" + c.order + "_" + std::to_string(c.outliers) +
                       "_" + std::to_string(seed) + ".limpet");
    io::write_native(file, record);
  }

  auto faces = evaluation::planar_faces(record);
  for (auto& f : faces)
    for (auto& cycle : f.cycles)
      for (auto& v : cycle) v = (v - shift) / args.scale;
  const auto report = evaluation::judge_faces(
      faces, scene.mesh, labelled, {.resolution = c.resolution, .noise = c.noise, .min_width = c.min_width});
  r.points = points.size();
  r.polygons = faces.size();
  r.counted = report.counted;
  r.represented = report.represented - report.split;
  // On a face scanned too thinly to count, fragments are what there is to find.
  for (const auto& p : report.polygons)
    r.extra += p.extra && (p.face < 0 || report.faces[static_cast<std::size_t>(p.face)].counts);
  r.wrong_holes = report.wrong_holes;
  r.right = r.represented == r.counted && r.extra == 0 && r.wrong_holes == 0;
  r.complete = static_cast<std::size_t>(report.counted) == report.faces.size();
  r.worst_angle_deg = report.max_angle * 180 / M_PI;
  for (const auto& p : report.polygons) {
    const bool counts = p.face >= 0 && report.faces[static_cast<std::size_t>(p.face)].counts;
    if (!counts || p.extra) continue;
    if (p.angle > std::max(3 * p.standard_error, 0.25 * M_PI / 180)) ++r.bad_angles;
  }
  r.overshoot = report.max_overshoot / c.resolution;
  r.shortfall = report.max_shortfall / c.resolution;
  const auto topology = evaluation::judge_topology(record, scene.mesh, report);
  r.closed = topology.closed, r.isomorphic = topology.isomorphic;
  r.true_shared = topology.true_shared, r.shared = topology.shared, r.false_shared = topology.false_shared;
  r.vertex_distance = topology.vertex_distance / c.resolution;
  if (!r.isomorphic) r.faults += refusals(model, record, report);
  const auto labels = model.labels();
  std::map<std::uint64_t, bool> is_polygon;
  for (const auto& p : record.polygon_segments) is_polygon[p.id] = true;
  const evaluation::NearestSurface surface = nearest_to(scene.mesh);
  std::int64_t on_faces = 0, loose = 0, outliers = 0, kept_out = 0, far = 0, far_kept_out = 0;
  for (std::size_t i = 0; i < labelled.size(); ++i) {
    const bool in_polygon = is_polygon.count(labels[i].value) > 0;
    if (labelled[i].face < 0) {
      const bool is_far = surface.distance(labelled[i].point.position) > 3 * c.noise;
      ++outliers, kept_out += !in_polygon;
      far += is_far, far_kept_out += is_far && !in_polygon;
    } else if (report.faces[static_cast<std::size_t>(labelled[i].face)].counts)
      ++on_faces, loose += !in_polygon;
  }
  r.loose = on_faces ? static_cast<double>(loose) / static_cast<double>(on_faces) : 0;
  r.outliers_kept_out = outliers ? static_cast<double>(kept_out) / static_cast<double>(outliers) : 1;
  r.far_outliers_kept_out = far ? static_cast<double>(far_kept_out) / static_cast<double>(far) : 1;
  if (!r.right)
    for (const auto& fault : evaluation::faults(report, faces)) r.faults += fault + "; ";
  return r;
}

void report_case(const Case& c, const std::vector<Run>& runs) {
  if (!c.skipped.empty()) {
    std::printf("%-10s %8ld noise %.3f %-8s outliers %.2f  skipped: %s\n", c.shape.c_str(), c.points,
                c.noise_ratio, c.order.c_str(), c.outliers, c.skipped.c_str());
    return;
  }
  Run worst;
  int right = 0, counted = 0, represented = 0, extra = 0, bad_angles = 0, closed = 0, isomorphic = 0,
      complete = 0;
  double seconds = 0, points = 0;
  for (const Run& r : runs) {
    right += r.right, counted += r.counted, represented += r.represented, extra += r.extra,
        bad_angles += r.bad_angles;
    seconds += r.seconds, points += static_cast<double>(r.points);
    worst.worst_angle_deg = std::max(worst.worst_angle_deg, r.worst_angle_deg);
    worst.overshoot = std::max(worst.overshoot, r.overshoot);
    worst.shortfall = std::max(worst.shortfall, r.shortfall);
    closed += r.closed, isomorphic += r.isomorphic, complete += r.complete;
    worst.true_shared += r.true_shared, worst.shared += r.shared, worst.false_shared += r.false_shared;
    worst.vertex_distance = std::max(worst.vertex_distance, r.vertex_distance);
    worst.loose = std::max(worst.loose, r.loose);
    worst.outliers_kept_out = std::min(worst.outliers_kept_out, r.outliers_kept_out);
    worst.far_outliers_kept_out = std::min(worst.far_outliers_kept_out, r.far_outliers_kept_out);
    worst.violations += r.violations;
  }
  std::printf(
      "%-10s %8ld noise %.3f %-8s outliers %.2f  right %d/%zu  closed %d same topology %d/%d "
      "(vertices within %.2fλ; shared %d of %d, false %d)  faces %d/%d extra %d  angle %.2f° (bad %d)  "
      "outside %.2fλ inside %.2fλ  loose %.2f%%  kept out %.1f%% (of far ones %.1f%%)  violations %zu  %.2f "
      "µs/point\n",
      c.shape.c_str(), c.points, c.noise_ratio, c.order.c_str(), c.outliers, right, runs.size(), closed,
      isomorphic, complete, worst.vertex_distance, worst.shared, worst.true_shared, worst.false_shared,
      represented, counted, extra, worst.worst_angle_deg, bad_angles, worst.overshoot, worst.shortfall,
      100 * worst.loose, 100 * worst.outliers_kept_out, 100 * worst.far_outliers_kept_out, worst.violations,
      1e6 * seconds / points);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  Arguments args;
  CLI::App app{"Models simulated scans of known shapes and judges them by the truth"};
  app.add_option("--shapes", args.shapes)->delimiter(',');
  app.add_option("--points", args.points)->delimiter(',');
  app.add_option("--noise", args.noise, "as a fraction of the object's size")->delimiter(',');
  app.add_option("--orders", args.orders)->delimiter(',');
  app.add_option("--outliers", args.outliers)->delimiter(',');
  app.add_option("--seeds", args.seeds);
  app.add_option("--first-seed", args.first_seed);
  app.add_option("--set-size", args.set_size);
  app.add_flag("--curve", args.curve, "put in order along a curve first, as limpet model does");
  app.add_option("--rules", args.rules);
  app.add_option("--csv", args.csv);
  app.add_option("--keep", args.keep, "folder for the models");
  app.add_option("--audit-every", args.audit_every, "the oracle after every Nth set (and always at the end)");
  app.add_option("--resolution", args.resolution, "instead of the rule above; all cases then count");
  app.add_option("--tolerance", args.tolerance, "as a fraction of the resolution; 0: by noise");
  app.add_option("--move", args.move, "by this many times (10^6, -10^6, 10^3)");
  app.add_option("--scale", args.scale);
  CLI11_PARSE(app, argc, argv);

  std::ofstream csv;
  if (!args.csv.empty()) {
    csv.open(args.csv);
    csv << "shape,points,noise,order,outliers,seed,right,counted,represented,extra,wrong_holes,angle_deg,bad_"
           "angles,"
           "overshoot,shortfall,loose,kept_out,far_kept_out,closed,isomorphic,vertex_distance,violations,"
           "seconds,"
           "faults\n";
  }
  int all = 0, right = 0, same = 0, complete = 0;
  for (const auto& shape : args.shapes) {
    for (const auto points : args.points)
      for (const double noise : args.noise)
        for (const auto& order : args.orders)
          for (const double outliers : args.outliers) {
            const Case c = make_case(args, shape, points, noise, order, outliers);
            std::vector<Run> runs;
            for (int seed = args.first_seed; c.skipped.empty() && seed < args.first_seed + args.seeds;
                 ++seed) {
              runs.push_back(run(args, c, seed));
              const Run& r = runs.back();
              ++all, right += r.right, same += r.complete && r.isomorphic, complete += r.complete;
              if (!r.right || !r.isomorphic || r.violations)
                std::printf("  seed %d: %s\n", seed, r.faults.c_str());
              csv << shape << ',' << points << ',' << noise << ',' << order << ',' << outliers << ',' << seed
                  << ',' << r.right << ',' << r.counted << ',' << r.represented << ',' << r.extra << ','
                  << r.wrong_holes << ',' << r.worst_angle_deg << ',' << r.bad_angles << ',' << r.overshoot
                  << ',' << r.shortfall << ',' << r.loose << ',' << r.outliers_kept_out << ','
                  << r.far_outliers_kept_out << ',' << r.closed << ',' << r.isomorphic << ','
                  << r.vertex_distance << ',' << r.violations << ',' << r.seconds << ",\"" << r.faults
                  << "\"\n";
            }
            report_case(c, runs);
          }
  }
  std::printf("right %d of %d; same topology %d of %d with all faces scanned\n", right, all, same, complete);
  return 0;
}
