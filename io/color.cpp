// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/io/color.hpp>

namespace limpet::io {

Color segment_color(std::uint64_t id) {
  // Twelve hues told apart at a glance; every further dozen is a shade lighter or darker.
  static constexpr Color kHues[12] = {{78, 140, 201},  {240, 160, 70}, {92, 170, 96},   {214, 96, 96},
                                      {150, 120, 196}, {226, 200, 84}, {72, 176, 176},  {224, 130, 176},
                                      {158, 124, 98},  {160, 196, 92}, {112, 124, 180}, {196, 164, 128}};
  static constexpr int kShades[5] = {0, 26, -26, 13, -13};  // percent towards white or black
  Color color = kHues[id % 12];
  const int shade = kShades[id / 12 % 5];
  for (std::uint8_t& channel : color) {
    const int limit = shade > 0 ? 255 : 0, part = shade > 0 ? shade : -shade;
    channel = static_cast<std::uint8_t>(channel + (limit - channel) * part / 100);
  }
  return color;
}

Color open_edge_color(model::Refusal refusal) {
  static constexpr std::array<Color, model::kRefusals> kColors = {{
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

}  // namespace limpet::io
