// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/drawing/open_edge_color.hpp>

namespace limpet::drawing {

io::Color open_edge_color(model::Refusal refusal) {
  static constexpr std::array<io::Color, model::kRefusals> kColors = {{
      {0, 200, 255},    // none
      {232, 80, 20},    // alone
      {240, 190, 0},    // angle
      {150, 105, 50},   // line_far
      {214, 20, 50},    // nothing_opposite
      {150, 40, 230},   // ring_broken
      {0, 170, 170},    // undecided
      {0, 160, 80},     // short_section
      {30, 90, 255},    // goes_on
      {255, 0, 200},    // inside_shared
      {120, 0, 60},     // other_pairs
      {130, 200, 0},    // bay
      {255, 120, 150},  // one_sided_end
      {90, 60, 160},    // corner_far
      {0, 110, 60},     // corner_bay
      {190, 120, 230},  // corner_turns
      {255, 0, 0},      // perimeter
  }};
  return kColors[static_cast<std::size_t>(refusal)];
}

}  // namespace limpet::drawing
