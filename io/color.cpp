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

}  // namespace limpet::io
