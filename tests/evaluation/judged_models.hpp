// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/evaluation/judgement.hpp>
#include <limpet/simulation/shapes.hpp>
#include <vector>

namespace limpet::evaluation {

/// A truth, its readings, and a model that is perfect until a test spoils it.
struct Judged {
  simulation::Mesh truth;
  std::vector<simulation::LabelledPoint> points;
  std::vector<PlanarFace> model;
  JudgeOptions options;

  explicit Judged(const std::string& shape, std::int64_t count = 20'000, double noise = 0)
      : truth(simulation::make_shape(shape)), model(planar_faces(truth)) {
    simulation::ScanOptions scan_options;
    scan_options.points = count;
    scan_options.order = simulation::ScanOptions::Order::sampled;
    scan_options.noise = noise;
    points = simulation::scan(truth, scan_options);
    options.resolution = 0.1;
    options.noise = noise;
  }

  FacesReport report() const { return judge_faces(model, truth, points, options); }
  std::vector<std::string> faults() const { return evaluation::faults(report(), model); }

  /// The index of the face that looks this way, the largest if there are several.
  int facing(const Eigen::Vector3d& normal) const {
    const std::vector<simulation::Face> faces = simulation::faces_of(truth);
    int found = -1;
    for (int f = 0; f < static_cast<int>(faces.size()); ++f)
      if (faces[f].normal.dot(normal) > 0.99 && (found < 0 || faces[f].area > faces[found].area)) found = f;
    return found;
  }
};

}  // namespace limpet::evaluation
