// Copyright the limpet authors. GPL-3.0-or-later.
#include <png.h>

#include <cstring>
#include <limpet/drawing/raster.hpp>
#include <stdexcept>

namespace limpet::drawing {

std::string png_bytes(const Image& image) {
  png_image header;
  std::memset(&header, 0, sizeof header);
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) == 0) {
    throw std::runtime_error(std::string("libpng could not make the picture: ") + header.message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace limpet::drawing
