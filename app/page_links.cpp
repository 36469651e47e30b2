// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/page_links.hpp>

#include <algorithm>
#include <array>
#include <limpet/io/text.hpp>
#include <string_view>
#include <utility>

namespace limpet::app {
namespace {

constexpr std::size_t kMostLinks = 10;  ///< of each kind

std::string escaped(const std::string& path) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  std::string text;
  for (const char c : path) {
    const auto byte = static_cast<std::uint8_t>(c);
    if (byte > ' ' && byte < 0x7f && std::string_view("%#?\"'<>").find(c) == std::string_view::npos)
      text += c;
    else
      text += {'%', kHex[byte >> 4], kHex[byte & 15]};
  }
  return text;
}

/// A line for each of these, but for those beyond the first ones.
template <class Things, class Line>
std::string lines(const Things& things, Line&& line) {
  std::string text;
  for (std::size_t i = 0; i < std::min(things.size(), kMostLinks); ++i) text += line(things[i]) + "\n";
  if (things.size() > kMostLinks)
    text += "  and " + io::grouped(static_cast<std::int64_t>(things.size() - kMostLinks)) + " more\n";
  return text;
}

}  // namespace

std::string page_link(const std::string& page, const std::string& what, std::uint64_t number) {
  return escaped(page) + "#" + what + "=" + std::to_string(number);
}

std::string page_link_to(const std::string& page, const std::string& where) {
  static constexpr std::array<std::pair<std::string_view, const char*>, 2> kNames = {
      {{"segment ", "polygon"}, {"edge ", "edge"}}};
  for (const auto& [prefix, what] : kNames) {
    if (!where.starts_with(prefix)) continue;
    const auto digits = std::string_view(where).substr(prefix.size());
    std::uint64_t number = 0;
    if (io::parse_integer(digits.substr(0, digits.find_first_not_of("0123456789")), number))
      return page_link(page, what, number);
  }
  return {};
}

std::string links_text(const std::string& page, const FollowOutcome& run, const model::Model& finished) {
  const std::string at_end = "&step=" + std::to_string(run.path.size());
  const auto marked = [&](const char* what, const std::string& words) {
    return [=](const auto& id) { return "  " + words + ": " + page_link(page, what, id.value) + at_end; };
  };
  return lines(run.marks.unreachable_segments, marked("polygon", "given up as unreachable")) +
         lines(run.marks.unreachable_edges, marked("edge", "given up as unreachable")) +
         lines(run.marks.unclosable_edges, marked("edge", "given up as unclosable")) +
         lines(finished.open_edges(), [&](const model::OpenEdge& e) {
           return std::string("  open, ") + model::words(e.refusal) + ": " +
                  page_link(page, "edge", e.edge.value);
         });
}

}  // namespace limpet::app
