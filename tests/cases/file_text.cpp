// Copyright the limpet authors. GPL-3.0-or-later.
//
// File cases as text: the file's lines between "bytes" and the end, each with a bar before it; what is no
// plain character is escaped as in C. A line that ends without a line break ends in "\c".
#include <algorithm>
#include <array>

#include "file_case.hpp"

namespace limpet::cases {
namespace {

constexpr std::array kFormats = {"ply", "pcd", "xyz",      "pwn",    "off",
                                 "stl", "obj", "mesh-ply", "labels", "limpet"};

std::string escaped(std::string_view line) {
  std::string text;
  for (const char c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\\') {
      text += "\\\\";
    } else if (byte >= ' ' && byte < 0x7f) {
      text += c;
    } else {
      constexpr char kDigits[] = "0123456789abcdef";
      text += "\\x";
      text += kDigits[byte >> 4];
      text += kDigits[byte & 15];
    }
  }
  return text;
}

int digit(char c) { return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1; }

std::string unescaped(std::string_view text) {
  std::string line;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\') {
      line += text[i];
    } else if (text.substr(i, 2) == "\\c") {
      return line;
    } else if (text.substr(i, 2) == "\\\\") {
      line += text[i++];
    } else if (i + 3 < text.size() && text[i + 1] == 'x' && digit(text[i + 2]) >= 0 &&
               digit(text[i + 3]) >= 0) {
      line += static_cast<char>(16 * digit(text[i + 2]) + digit(text[i + 3]));
      i += 3;
    } else {
      throw CaseError("an escape is not known: " + std::string(text.substr(i, 4)));
    }
  }
  return line + "\n";
}

}  // namespace

std::string to_text(const FileCase& c) {
  std::string text = std::string(kCaseMagic) + FileCase::kKind + "\n";
  if (!c.law.empty()) text += "law " + c.law + "\n";
  text += "format " + c.format + "\nbytes\n";
  for (std::string_view rest = c.bytes; !rest.empty();) {
    const auto end = rest.find('\n');
    text += "|" + escaped(rest.substr(0, end)) + (end == std::string_view::npos ? "\\c\n" : "\n");
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  return text;
}

FileCase file_case(std::string_view text) {
  FileCase c;
  CaseLines lines(text.substr(0, text.find("\nbytes\n") + 1));
  if (!lines.next() || !lines.is("limpet") || lines.word(2) != FileCase::kKind) lines.fail("no file case");
  while (lines.next()) {
    if (lines.is("law")) c.law = lines.word(1);
    if (lines.is("format")) c.format = lines.word(1);
  }
  if (std::find(kFormats.begin(), kFormats.end(), c.format) == kFormats.end())
    lines.fail("'" + c.format + "' is no format");
  const auto begin = text.find("\nbytes\n");
  if (begin == std::string_view::npos) lines.fail("the bytes are missing");
  for (std::string_view rest = text.substr(begin + 7); !rest.empty();) {
    const auto end = rest.find('\n');
    const auto line = rest.substr(0, end);
    if (line.starts_with('|')) c.bytes += unescaped(line.substr(1));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  return c;
}

std::vector<FileCase> reductions(const FileCase& c) {
  std::vector<FileCase> smaller;
  const auto add_without = [&](std::size_t from, std::size_t n) {
    smaller.emplace_back(c).bytes.erase(from, n);
  };
  std::vector<std::size_t> lines{0};
  for (std::size_t i = 0; i < c.bytes.size(); ++i)
    if (c.bytes[i] == '\n') lines.push_back(i + 1);
  if (lines.back() != c.bytes.size()) lines.push_back(c.bytes.size());
  for (std::size_t n = lines.size() - 1; n >= 1; n /= 2)
    for (std::size_t i = 0; i + n < lines.size(); i += n) add_without(lines[i], lines[i + n] - lines[i]);
  for (std::size_t n = std::min<std::size_t>(c.bytes.size() / 2, 512); n >= 1; n /= 2)
    for (std::size_t i = 0; i + n <= c.bytes.size(); i += n) add_without(i, n);
  return smaller;
}

}  // namespace limpet::cases
