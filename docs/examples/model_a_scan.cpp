// Copyright the limpet authors. GPL-3.0-or-later.
//
// A scan in, a model out: model_a_scan SCAN MODEL
#include <iostream>
#include <limpet/io/mesh_writer.hpp>
#include <limpet/io/scan_reader.hpp>
#include <limpet/model/model.hpp>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const limpet::model::Parameters parameters{.resolution = 0.05, .noise = 0.001};
  limpet::model::Model model(parameters);
  const auto scan = limpet::io::open_scan(argv[1], {});
  limpet::io::ScanRecord record;
  while (scan->next(record)) model.update(std::span(&record.point, 1));
  model.finish();
  limpet::io::save_model(argv[2], model.record());
  std::cout << model.counts().polygons << " polygons\n";
}
