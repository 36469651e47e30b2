// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <initializer_list>
#include <limpet/io/error.hpp>
#include <limpet/io/scan_formats.hpp>
#include <limpet/io/text.hpp>

namespace limpet::io {
namespace {

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> list) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

bool starts_with_word(std::string_view head, std::string_view word) {
  return head.starts_with(word) &&
         (head.size() == word.size() || static_cast<unsigned char>(head[word.size()]) <= ' ');
}

bool looks_like_table(std::string_view head) {
  const auto first = head.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ||
         std::string_view("+-.0123456789#/nN\"xX").find(head[first]) != head.npos;
}

/// A PCD header may begin with any comments.
bool looks_like_pcd(std::string_view head) {
  while (head.starts_with('#')) {
    const auto end = head.find_first_of("\r\n");
    if (head.substr(0, end).find(".PCD v") != head.npos) return true;
    if (end == head.npos) return false;
    head.remove_prefix(std::min(head.find_first_not_of("\r\n", end), head.size()));
  }
  return starts_with_word(head, "VERSION") || starts_with_word(head, "FIELDS");
}

/// The format by the first bytes, which do not lie as names do, then by the extension; empty when neither
/// tells.
std::string guess_format(ByteSource& source, const std::string& path) {
  const std::string_view head = source.peek(4096);
  std::string extension = extension_of(path);
  if (starts_with_word(head, "ply")) return "ply";
  if (looks_like_pcd(head)) return "pcd";
  if (is_one_of(extension, {"off", "stl", "obj", "glb", "gltf", "dae", "om", "3mf"})) return "mesh";
  for (const std::string_view word : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "solid"}) {
    if (starts_with_word(head, word)) return "mesh";
  }
  if (is_one_of(extension, {"ply", "pcd", "xyz", "pwn"})) return extension;
  const bool is_text = is_one_of(extension, {"txt", "csv", "asc"}) || looks_like_table(head);
  return is_text ? "xyz" : "";
}

}  // namespace

void refuse_mesh(const ByteSource& source, const std::string& where, const std::string& what) {
  throw InputError(where,
                   what + ", not a scan; 'limpet scan " + source.name() + " -o SCAN' makes a scan of it");
}

std::unique_ptr<ScanReader> open_scan(const std::string& path, const ScanOptions& options) {
  return open_scan(std::make_unique<ByteSource>(path, options.stop), path, options);
}

std::unique_ptr<ScanReader> open_scan(SourcePtr source, const std::string& path, const ScanOptions& options) {
  source->skip_byte_order_mark();
  if (source->at_end()) throw InputError(source->name(), "the file is empty");
  const std::string format = options.format.empty() ? guess_format(*source, path) : options.format;
  if (format == "ply") return open_ply(std::move(source), options);
  if (format == "pcd") return open_pcd(std::move(source), options);
  if (format == "xyz" || format == "pwn") return open_table(std::move(source), options);
  if (format == "mesh") refuse_mesh(*source, source->name(), "is a mesh");
  if (!options.format.empty()) {
    throw InputError(source->name(),
                     "the format " + in_quotes(format) + " is not known; give ply, pcd, xyz or pwn");
  }
  throw InputError(source->name(), "begins like no known scan; known are PLY, PCD, XYZ and PWN");
}

}  // namespace limpet::io
