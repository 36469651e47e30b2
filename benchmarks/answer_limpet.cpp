// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/evaluation/judgement.hpp>
#include <limpet/evaluation/planar_face.hpp>
#include <limpet/io/mesh_writer.hpp>
#include <limpet/io/scan_writer.hpp>
#include <limpet/survey/choose.hpp>
#include <limpet/survey/ordered_points.hpp>

#include "contestants.hpp"
#include "floor.hpp"

namespace limpet::benchmarks {
namespace {

/// Hands the cloud on, some sets at a time, and times reading apart.
template <class Take>
double read_through(const std::string& path, Take take) {
  CloudReader reader(path);
  std::vector<model::SensorPoint> points;
  double reading = 0;
  for (;;) {
    const CpuWatch watch;
    points.clear();
    for (const auto& p : reader.next(256 * kSet)) points.push_back(p.point);
    reading += watch.seconds();
    if (points.empty()) return reading;
    take(std::span<const model::SensorPoint>(points));
  }
}

Json stages_of(const model::StageTimes& t) {
  return {{"insertion", t.insertion}, {"dissolving", t.dissolving}, {"mergers", t.mergers},
          {"fissures", t.fissures},   {"sharing", t.sharing},       {"rest", t.rest}};
}

void judge(const ScanCase& scan_case, const std::string& path, const model::ModelRecord& record,
           double resolution, Json& answer) {
  Floor floor(record);
  double floor_seconds = 0;
  read_through(path, [&](std::span<const model::SensorPoint> points) {
    const CpuWatch watch;
    floor.add(points);
    floor_seconds += watch.seconds();
  });
  answer["floor_seconds"] = floor_seconds;

  std::vector<simulation::LabelledPoint> labelled;
  CloudReader reader(path);
  for (auto some = reader.next(4096); !some.empty(); some = reader.next(4096))
    labelled.insert(labelled.end(), some.begin(), some.end());
  const auto report = evaluation::judge_faces(evaluation::planar_faces(record), scan_case.scene.mesh,
                                              labelled, {.resolution = resolution, .noise = scan_case.noise});
  int right = 0, extra = 0;
  for (const auto& f : report.faces)
    right += f.counts && f.fate == evaluation::Fate::represented && f.model_holes == f.true_holes;
  for (const auto& p : report.polygons)
    extra += p.extra && (p.face < 0 || report.faces[static_cast<std::size_t>(p.face)].counts);
  answer["faces_counted"] = report.counted;
  answer["faces_right"] = right;
  answer["planes_extra"] = extra;
}

/// What the model has found, and how right it is.
void tell_model(const Json& request, const ScanCase& scan_case, double resolution, const model::Model& model,
                Json& answer) {
  const auto record = model.record();
  std::int64_t in_planes = 0;
  for (const auto& s : record.polygon_segments) in_planes += s.moments.count;
  answer["planes"] = record.polygon_segments.size();
  answer["in_planes"] = in_planes;
  if (request.contains("mesh")) io::save_mesh(request["mesh"], record);
  if (request.value("judge", false)) judge(scan_case, request.at("cloud"), record, resolution, answer);
}

void write_scan(const std::string& cloud, const std::string& path) {
  CloudReader reader(cloud);
  const auto writer = io::create_scan(path, {});
  for (auto some = reader.next(4096); !some.empty(); some = reader.next(4096))
    for (const auto& p : some) {
      io::ScanRecord record;
      record.point = p.point, record.has_axis = true;
      writer->write(record);
    }
  writer->close();
}

}  // namespace

Json answer_limpet(const Json& request) {
  const ScanCase scan_case(request.at("spec").get<CloudSpec>());
  const std::string path = request.at("cloud");
  const double before = resident_megabytes();
  model::Model model(scan_case.parameters());
  const bool by_stage = request.value("stages", false);
  if (by_stage) model.measure_stages();

  double seconds = 0;
  const double reading = read_through(path, [&](std::span<const model::SensorPoint> points) {
    const CpuWatch watch;
    for (std::size_t i = 0; i < points.size(); i += kSet)
      model.update(points.subspan(i, std::min(kSet, points.size() - i)));
    seconds += watch.seconds();
  });
  const Json stages = stages_of(model.stage_times());
  const CpuWatch watch;
  const WallWatch wall_watch;
  model.finish();
  const double finishing = watch.seconds();
  Json answer{{"points", model.counts().points}, {"seconds", seconds + finishing},
              {"finish_seconds", finishing},     {"finish_wall_seconds", wall_watch.seconds()},
              {"reading_seconds", reading},      {"megabytes", peak_megabytes() - before}};
  if (by_stage) answer["stages"] = stages;

  tell_model(request, scan_case, scan_case.resolution, model, answer);
  return answer;
}

Json answer_default(const Json& request) {
  const ScanCase scan_case(request.at("spec").get<CloudSpec>());
  write_scan(request.at("cloud"), request.at("scan"));
  const double before = resident_megabytes();
  const CpuWatch watch;
  survey::PointStream points(request.at("scan"));
  const survey::Choice choice = survey::choose(points);
  const double choosing = watch.seconds();
  model::Model model(choice.parameters);
  std::vector<model::SensorPoint> set;
  if (request.value("arrival", false)) {
    while (points.next_set(set)) model.update(set);
  } else {
    survey::OrderedPoints ordered(points, {.cell = choice.near_resolution});
    while (ordered.next_set(set)) model.update(set);
  }
  const CpuWatch finishing;
  model.finish();
  Json answer{{"points", model.counts().points},        {"seconds", watch.seconds()},
              {"choosing_seconds", choosing},           {"finish_seconds", finishing.seconds()},
              {"megabytes", peak_megabytes() - before}, {"resolution", choice.near_resolution}};
  tell_model(request, scan_case, choice.near_resolution, model, answer);
  return answer;
}

}  // namespace limpet::benchmarks
