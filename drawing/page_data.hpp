// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace limpet::drawing {

/// What a page shows: a head in JSON, and arrays of numbers by name (docs/page_format.md).
class PageData {
 public:
  void put(const std::string& name, const std::string& bytes) { put_bytes(name, "u8", bytes, 1); }
  void put(const std::string& name, std::span<const std::uint8_t>);
  void put(const std::string& name, std::span<const std::uint16_t>);
  void put(const std::string& name, std::span<const std::uint32_t>);
  void put(const std::string& name, std::span<const float>);

  /// The container. `head`: a JSON object without the member "arrays", which is added.
  std::string bytes(const std::string& head) const;

 private:
  struct Array {
    std::string name, type, bytes;
    std::size_t length = 0;
  };
  std::string head_with_arrays(const std::string& head, std::size_t offset) const;
  void put_bytes(const std::string& name, const std::string& type, std::string bytes, std::size_t size);

  std::vector<Array> arrays_;
};

/// Appends three floats.
void append(std::vector<float>& numbers, const Eigen::Vector3d& p);

}  // namespace limpet::drawing
