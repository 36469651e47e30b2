// Copyright the limpet authors. GPL-3.0-or-later.
//
// Asks a model what is near a place, and why edges are open: ask_a_model MODEL.limpet X Y Z
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limpet/io/native.hpp>
#include <limpet/model/model.hpp>
#include <limpet/model/view.hpp>

int main(int argc, char** argv) try {
  if (argc != 5) return 2;
  const limpet::model::Model model(limpet::io::load_native(argv[1]));
  const Eigen::Vector3d place(std::atof(argv[2]), std::atof(argv[3]), std::atof(argv[4]));

  const limpet::model::View view = model.view();  // no copy, and any number of threads may ask
  if (const auto found = view.nearest(place, 1.0))
    std::cout << "segment " << found->segment.value << " is " << found->distance << " away\n";
  if (const auto hit = view.first_hit(place, {0, 0, -1}, 1.0))
    std::cout << "below, segment " << hit->segment.value << " at " << hit->range << "\n";
  const limpet::model::Outcome outcome = model.would_finish();
  std::cout << outcome.edges.size() << " edges are open; finishing would leave " << outcome.open_edges
            << "\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
