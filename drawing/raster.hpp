// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/drawing/sheet.hpp>
#include <string>
#include <vector>

namespace limpet::drawing {

/// Red, green and blue bytes, row by row from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
  io::Color at(int x, int y) const {
    const std::uint8_t* p = &pixels[(static_cast<std::size_t>(y) * width + x) * 3];
    return {p[0], p[1], p[2]};
  }
};

/// Paints a sheet with a depth buffer, nine samples a pixel.
Image paint(const Sheet& sheet);

/// The image as a PNG file's bytes.
std::string png_bytes(const Image& image);

}  // namespace limpet::drawing
