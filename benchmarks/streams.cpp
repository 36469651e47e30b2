// Copyright the limpet authors. GPL-3.0-or-later.
#include <cstdio>

#include "contestants.hpp"
#include "sections.hpp"

namespace limpet::benchmarks {
namespace {

/// 1, 2, 5, 10, 20, …
std::int64_t next_mark(std::int64_t mark) {
  std::int64_t power = 1;
  while (mark >= 10 * power) power *= 10;
  return mark / power == 2 ? 5 * power : 2 * mark;
}

}  // namespace

StreamOptions stream_of(const std::string& shape, std::int64_t points, std::int64_t first_mark) {
  return {{.shape = shape,
           .order = "sampled",
           .points = points,
           .outliers = 0.01,
           .points_for_resolution = first_mark},
          first_mark};
}

/// Points are made on the fly, so nothing holds the stream. Only the updates are timed.
Json answer_stream(const Json& request) {
  const ScanCase scan_case(request.at("spec").get<CloudSpec>());
  const double before = resident_megabytes();
  model::Model model(scan_case.parameters());
  constexpr std::size_t kSetsAtOnce = 256;
  std::vector<model::SensorPoint> buffer;
  buffer.reserve(kSetsAtOnce * kSet);
  double seconds = 0, seconds_at_last = 0;
  std::int64_t points = 0, points_at_last = 0, mark = request.at("first_mark");
  const CpuWatch all;
  Json marks = Json::array();
  const auto update = [&] {
    const CpuWatch watch;
    for (std::size_t i = 0; i < buffer.size(); i += kSet)
      model.update(std::span(buffer).subspan(i, std::min(kSet, buffer.size() - i)));
    seconds += watch.seconds();
    points += static_cast<std::int64_t>(buffer.size());
    buffer.clear();
    if (points < mark && points < scan_case.spec.points) return;
    const auto counts = model.counts();
    marks.push_back({{"points", points},
                     {"ns_per_point", 1e9 * seconds / static_cast<double>(points)},
                     {"ns_per_point_since_last",
                      1e9 * (seconds - seconds_at_last) / static_cast<double>(points - points_at_last)},
                     {"megabytes", peak_megabytes() - before},
                     {"polygons", counts.polygons},
                     {"point_segments", counts.point_segments}});
    mark = next_mark(mark), seconds_at_last = seconds, points_at_last = points;
  };
  scan_case.scan([&](const simulation::LabelledPoint& p) {
    buffer.push_back(p.point);
    const auto here = points + static_cast<std::int64_t>(buffer.size());
    if (buffer.size() == kSetsAtOnce * kSet || here == mark || here == scan_case.spec.points) update();
  });
  const double other = all.seconds() - seconds;
  const CpuWatch watch;
  model.finish();
  return {{"marks", marks},
          {"generation_ns_per_point", 1e9 * other / static_cast<double>(points)},
          {"finish_seconds", watch.seconds()},
          {"finish_megabytes", peak_megabytes() - before},
          {"finish_polygons", model.counts().polygons},
          {"resolution", scan_case.resolution},
          {"faces", scan_case.faces.size()}};
}

Table measure_streams(const std::vector<StreamOptions>& streams, const Limits& limits) {
  Table table({{"shape"},
               {"true_faces"},
               {"resolution"},
               {"points"},
               {"ns_per_point", 4},
               {"ns_per_point_since_last", 4},
               {"megabytes", 3},
               {"polygons"},
               {"point_segments"},
               {"note"}});
  for (const auto& s : streams) {
    std::fprintf(stderr, "stream of %ld points, %s\n", s.spec.points, s.spec.shape.c_str());
    const Json answer =
        ask_process({{"what", "stream"}, {"spec", s.spec}, {"first_mark", s.first_mark}}, limits.own_seconds);
    if (answer.contains("failed")) {
      table.add({s.spec.shape, {}, {}, s.spec.points, {}, {}, {}, {}, {}, answer["failed"]});
      continue;
    }
    for (const auto& m : answer["marks"])
      table.add({s.spec.shape,
                 answer["faces"],
                 answer["resolution"],
                 m["points"],
                 m["ns_per_point"],
                 m["ns_per_point_since_last"],
                 m["megabytes"],
                 m["polygons"],
                 m["point_segments"],
                 {}});
    table.add({s.spec.shape,
               answer["faces"],
               answer["resolution"],
               answer["marks"].back()["points"],
               {},
               {},
               answer["finish_megabytes"],
               answer["finish_polygons"],
               {},
               "finished"});
  }
  return table;
}

}  // namespace limpet::benchmarks
