// Copyright the limpet authors. GPL-3.0-or-later.
#include <cmath>
#include <limpet/drawing/depth_order.hpp>
#include <limpet/drawing/svg.hpp>
#include <limpet/drawing/way.hpp>
#include <limpet/io/text.hpp>
#include <set>

namespace limpet::drawing {
namespace {

/// A number with two decimals at most: a hundredth of a pixel is enough for any eye.
void append_rounded(std::string& text, double value) {
  const double rounded = std::floor(value * 100 + 0.5) / 100;
  io::append(text, rounded == 0 ? 0.0 : rounded);
}

std::string number(double value) {
  std::string text;
  append_rounded(text, value);
  return text;
}

std::string hex(const io::Color& color) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t channel : color) {
    text += kDigits[channel / 16];
    text += kDigits[channel % 16];
  }
  return text;
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '&':
        safe += "&amp;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c >= ' ' && c <= '~' ? c : '?';
    }
  }
  return safe;
}

void append_point(std::string& text, char command, const Eigen::Vector3d& p) {
  text += command;
  append_rounded(text, p.x());
  text += ' ';
  append_rounded(text, p.y());
}

/// All edges of one colour as one path; neighbours stay joined.
std::string edges_path(const Patch& patch, const io::Color& color) {
  std::string path;
  for (const Outline& outline : patch.outlines) {
    bool joined = false;
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
      if (outline.edges[i] == color) {
        if (!joined) append_point(path, 'M', outline.points[i]);
        append_point(path, 'L', outline.points[(i + 1) % outline.points.size()]);
      }
      joined = outline.edges[i] == color;
    }
  }
  return path;
}

void append_edges(std::string& text, const Patch& patch, const Panel& panel) {
  std::set<io::Color> colors;
  for (const Outline& outline : patch.outlines) colors.insert(outline.edges.begin(), outline.edges.end());
  for (const io::Color& color : colors) {
    text += "<path d=\"" + edges_path(patch, color) + "\" fill=\"none\" stroke=\"" + hex(color) +
            "\" stroke-width=\"" + number(color == kSharedEdge ? panel.shared_width : panel.open_width) +
            "\"/>\n";
  }
}

void append_dot(std::string& text, double x, double y, double radius, const io::Color& color) {
  text += "<circle cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"" + number(radius) + "\" fill=\"" +
          hex(color) + "\"/>\n";
}

void append_patch(std::string& text, const Panel& panel, const Patch& patch) {
  std::string path;
  for (const Outline& outline : patch.outlines) {
    char command = 'M';
    for (const Eigen::Vector3d& p : outline.points) {
      append_point(path, command, p);
      command = 'L';
    }
    path += 'Z';
  }
  text += "<path d=\"" + path + "\" fill=\"" + hex(patch.fill) + "\" fill-rule=\"evenodd\"";
  if (patch.round) {  // what is behind would shine through between facets
    text += " stroke=\"" + hex(patch.fill) + "\" stroke-width=\"0.6\"/>\n";
    return;
  }
  text += "/>\n";
  append_edges(text, patch, panel);
  if (panel.vertex_radius <= 0) return;
  for (const Outline& outline : patch.outlines) {
    for (const Eigen::Vector3d& p : outline.points) append_dot(text, p.x(), p.y(), panel.vertex_radius, kInk);
  }
}

/// What faces do not hide of lines: a path for what follows each other in one colour and width.
void append_lines(std::string& text, const Panel& panel) {
  const Hiding hiding(panel);
  const LinePiece* before = nullptr;
  const auto finish = [&] {
    if (before)
      text += "\" stroke=\"" + hex(before->color) + "\" stroke-width=\"" + number(before->width) + "\"/>\n";
  };
  for (const LinePiece& piece : panel.lines) {
    if (hiding.hides((piece.from + piece.to) / 2)) continue;
    const bool same = before && before->color == piece.color && before->width == piece.width;
    if (!same) {
      finish();
      text += "<path fill=\"none\" d=\"";
    }
    if (!same || before->to != piece.from) append_point(text, 'M', piece.from);
    append_point(text, 'L', piece.to);
    before = &piece;
  }
  finish();
}

void append_panel(std::string& text, const Panel& panel, std::size_t index) {
  const std::string clip = "panel" + std::to_string(index);
  text += "<clipPath id=\"" + clip + "\"><rect x=\"" + number(panel.left) + "\" y=\"" + number(panel.top) +
          "\" width=\"" + number(panel.width) + "\" height=\"" + number(panel.height) + "\"/></clipPath>\n";
  text += "<g clip-path=\"url(#" + clip + ")\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
  for (const int i : depth_order(panel.patches)) append_patch(text, panel, panel.patches[i]);
  for (const Eigen::Vector3d& p : panel.loose)
    append_dot(text, p.x(), p.y(), panel.loose_radius, kLoosePoint);
  append_lines(text, panel);
  text += "</g>\n";
}

}  // namespace

std::string svg_bytes(const Sheet& sheet) {
  const std::string width = std::to_string(sheet.width), height = std::to_string(sheet.height);
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
                     "\" viewBox=\"0 0 " + width + " " + height + "\">\n";
  text += "<rect width=\"" + width + "\" height=\"" + height + "\" fill=\"" + hex(kPaper) + "\"/>\n";
  for (std::size_t i = 0; i < sheet.panels.size(); ++i) append_panel(text, sheet.panels[i], i);
  for (const Mark& mark : sheet.marks) {
    text += "<path d=\"M" + number(mark.from.x()) + " " + number(mark.from.y()) + "L" + number(mark.to.x()) +
            " " + number(mark.to.y()) + "\" stroke=\"" + hex(mark.color) + "\" stroke-width=\"" +
            number(mark.width) + "\" stroke-linecap=\"round\"/>\n";
  }
  constexpr double kCapitals = 0.72;  // of the size of a usual font
  for (const Label& label : sheet.labels) {
    text += "<text x=\"" + number(label.left) + "\" y=\"" + number(label.base) + "\" font-size=\"" +
            number(label.size / kCapitals) + "\" font-family=\"Helvetica, Arial, sans-serif\" fill=\"" +
            hex(label.color) + "\">" + escaped(label.text) + "</text>\n";
  }
  return text + "</svg>\n";
}

}  // namespace limpet::drawing
