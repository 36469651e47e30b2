// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/drawing/page_data.hpp>

#include <bit>
#include <nlohmann/json.hpp>

namespace limpet::drawing {
namespace {

constexpr std::size_t kAlignment = 8;
constexpr const char* kMagic = "LIMPAGE1";

/// The bytes of whole numbers, the low ones first, whatever the machine.
template <class Unsigned>
void append_number(std::string& bytes, Unsigned value) {
  for (std::size_t i = 0; i < sizeof value; ++i)
    bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xff));
}

template <class Number>
std::string bytes_of(std::span<const Number> numbers) {
  std::string bytes;
  bytes.reserve(numbers.size() * sizeof(Number));
  for (const Number x : numbers) append_number(bytes, x);
  return bytes;
}

std::size_t aligned(std::size_t n) { return (n + kAlignment - 1) / kAlignment * kAlignment; }

}  // namespace

void PageData::put_bytes(const std::string& name, const std::string& type, std::string bytes,
                         std::size_t size) {
  const std::size_t length = bytes.size() / size;
  arrays_.push_back({name, type, std::move(bytes), length});
}

void PageData::put(const std::string& name, std::span<const std::uint8_t> numbers) {
  put_bytes(name, "u8", std::string(numbers.begin(), numbers.end()), 1);
}

void PageData::put(const std::string& name, std::span<const std::uint16_t> numbers) {
  put_bytes(name, "u16", bytes_of(numbers), 2);
}

void PageData::put(const std::string& name, std::span<const std::uint32_t> numbers) {
  put_bytes(name, "u32", bytes_of(numbers), 4);
}

void PageData::put(const std::string& name, std::span<const float> numbers) {
  std::string bytes;
  for (const float x : numbers) append_number(bytes, std::bit_cast<std::uint32_t>(x));
  put_bytes(name, "f32", std::move(bytes), 4);
}

/// The head, with where each array stands when the first one stands at `offset`.
std::string PageData::head_with_arrays(const std::string& head, std::size_t offset) const {
  auto json = nlohmann::json::parse(head);
  auto& directory = json["arrays"] = nlohmann::json::object();
  for (const Array& array : arrays_) {
    directory[array.name] = {{"type", array.type}, {"offset", offset}, {"length", array.length}};
    offset += aligned(array.bytes.size());
  }
  return json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

std::string PageData::bytes(const std::string& head) const {
  // Where the arrays begin goes with the length of the head, which says where they are: larger offsets only
  // make it longer, so this comes to an end.
  std::string text;
  for (std::size_t begin = 0, before = 1; begin != before;) {
    before = begin;
    text = head_with_arrays(head, begin);
    begin = aligned(std::char_traits<char>::length(kMagic) + sizeof(std::uint32_t) + text.size());
  }
  std::string bytes = kMagic;
  append_number(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
  bytes.resize(aligned(bytes.size()), '\0');
  for (const Array& array : arrays_) {
    bytes += array.bytes;
    bytes.resize(aligned(bytes.size()), '\0');
  }
  return bytes;
}

void append(std::vector<float>& numbers, const Eigen::Vector3d& p) {
  for (int k = 0; k < 3; ++k) numbers.push_back(static_cast<float>(p[k]));
}

}  // namespace limpet::drawing
