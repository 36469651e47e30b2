// Copyright the limpet authors. GPL-3.0-or-later.
//
// A scan in, a model out, as `limpet model SCAN -o MODEL` does it: model_a_scan SCAN MODEL
#include <exception>
#include <iostream>
#include <limpet/io/mesh_writer.hpp>
#include <limpet/model/model.hpp>
#include <limpet/survey/choose.hpp>
#include <limpet/survey/ordered_points.hpp>
#include <vector>

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  limpet::survey::PointStream points(argv[1]);               // a file, or - for standard input
  const auto choice = limpet::survey::choose(points);        // resolution, noise and tolerance, by the scan
  if (!points.has_axes()) points.orient(choice.voxel_edge);  // no normals: which side was it sensed from?
  limpet::model::Model model(choice.parameters);
  limpet::survey::OrderedPoints ordered(points, {.cell = choice.near_resolution});  // along a curve
  std::vector<limpet::model::SensorPoint> set;
  while (ordered.next_set(set)) model.update(set);  // the model is there after every set
  model.finish();
  limpet::io::save_model(argv[2], model.record());
  std::cout << limpet::survey::explanation(choice) << model.counts().polygons << " polygons\n";
  if (points.damage().empty()) return 0;
  std::cerr << points.damage() << "\n";
  return 2;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
