// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cstdio>

#include "cloud_file.hpp"
#include "contestants.hpp"

namespace limpet::benchmarks {
namespace {

/// At 20,000 points in a shape of so many faces all of them are seen well.
constexpr std::int64_t kFacesOfFewPoints = 16;

CloudSpec spec_of(const std::string& shape, std::int64_t points) {
  // Holes make faces narrow: σ ≤ λ/10.
  const bool has_holes = shape == "step_hole" || shape == "plate3";
  const std::int64_t faces = simulation::make_scene(shape).mesh.face_count;
  return {.shape = shape,
          .points = points * std::max(faces, kFacesOfFewPoints) / kFacesOfFewPoints,
          .noise_ratio = has_holes ? 0.0005 : 0.002};
}

/// The answer and what the truth says of the mesh, if there is one.
Json ask(const std::string& contestant, const CloudSpec& spec, const CloudFile& cloud, const Limits& limits) {
  const NamedFile mesh(limits, ".off");
  Json request{{"what", contestant}, {"spec", spec}, {"cloud", cloud.path()}, {"mesh", mesh.path()}};
  Json answer = ask_process(request, contestant == "limpet" ? limits.own_seconds : limits.peer_seconds);
  if (answer.contains("failed")) {
    Json known = answer.value("so_far", Json());
    if (known.is_null()) known = Json::object();
    known["note"] = answer["failed"];
    known.erase("seconds");  // of an answer that is none
    return known;
  }
  if (!answer.contains("faces")) answer["faces"] = answer["planes"];
  if (answer["faces"] == 0) {
    answer["note"] = "nothing";
    return answer;
  }
  request["what"] = "judgement";
  const Json judgement = ask_process(request, limits.own_seconds);
  if (judgement.contains("failed")) answer["note"] = "not judged: " + judgement["failed"].get<std::string>();
  answer.update(judgement);
  return answer;
}

Json yes_or_no(const Json& answer, const char* key) {
  if (!answer.contains(key)) return {};
  return answer[key].get<bool>() ? "yes" : "no";
}

}  // namespace

Table polyhedra_table() {
  return Table({{"shape"},
                {"true_faces"},
                {"points"},
                {"resolution"},
                {"contestant"},
                {"faces"},
                {"merged_faces"},
                {"closed"},
                {"outward"},
                {"model_to_truth"},
                {"truth_to_model"},
                {"seconds"},
                {"detecting"},
                {"generating"},
                {"solving"},
                {"candidates"},
                {"megabytes"},
                {"note"}});
}

void measure_polyhedra(const PolyhedraOptions& options, const Limits& limits, Table& table) {
  for (const auto& shape : options.shapes)
    for (const auto points : options.points) {
      const CloudSpec spec = spec_of(shape, points);
      std::fprintf(stderr, "%s, %ld points: cloud", shape.c_str(), spec.points);
      const CloudFile cloud(spec, limits);
      for (const auto& contestant : options.contestants) {
        std::fprintf(stderr, ", %s", contestant.c_str());
        const Json a = ask(contestant, spec, cloud, limits);
        std::vector<Json> row{shape, cloud.answer()["faces"], cloud.answer()["points"],
                              cloud.answer()["resolution"], contestant};
        const auto add = [&](const char* key) { row.push_back(a.contains(key) ? a[key] : Json()); };
        add("faces");
        add("merged_faces");
        row.push_back(yes_or_no(a, "closed"));
        row.push_back(yes_or_no(a, "outward"));
        for (const char* key : {"model_to_truth", "truth_to_model", "seconds", "detecting_seconds",
                                "generating_seconds", "solving_seconds", "candidates", "megabytes", "note"})
          add(key);
        table.add(row);
      }
      std::fprintf(stderr, "\n");
    }
}

}  // namespace limpet::benchmarks
