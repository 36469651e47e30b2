// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/io/color.hpp>
#include <limpet/io/text.hpp>
#include <map>

#include "drawn_model_internal.hpp"
#include "vtp_writer_internal.hpp"

namespace limpet::io::internal {
namespace {

enum class Class : std::uint8_t { point_segment, shared_edge, open_edge, polygon };

/// Cells of one kind, vertices given by index.
struct Cells {
  std::string connectivity, offsets;
  std::int64_t count = 0, ends = 0;
};

class PolyData {
 public:
  explicit PolyData(const model::ModelRecord& record) : model_(drawn(record)) {
    for (const Eigen::Vector3d& vertex : model_.vertices) add_point(vertex);
    for (const auto& segment : record.point_segments) counts_[segment.id] = segment.moments.count;
    for (const auto& segment : record.polygon_segments) counts_[segment.id] = segment.moments.count;
    for (const auto& segment : record.point_segments) {
      const std::uint32_t vertex = add_point(centroid(segment.moments, record.grid_step));
      add(verts_, std::array{vertex}, Class::point_segment, segment.id, 0, 0, segment_color(segment.id));
    }
    add_lines();
    for (std::size_t i = 0; i < model_.polygons.size(); ++i) add_polygon(i);
  }

  std::string text() const {
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
        "byte_order=\"LittleEndian\">\n<PolyData>\n<Piece";
    const auto attribute = [&](const char* name, std::int64_t value) {
      append(text += std::string(" ") + name + "=\"", value);
      text += '"';
    };
    attribute("NumberOfPoints", points_count_);
    attribute("NumberOfVerts", verts_.count);
    attribute("NumberOfLines", lines_.count);
    attribute("NumberOfStrips", 0);
    attribute("NumberOfPolys", polys_.count);
    text += ">\n<CellData>\n";
    text += array("Int64", "segment", 1, segments_) + array("Int64", "points", 1, points_of_);
    text += array("UInt8", "class", 1, classes_) + array("Int64", "edge", 1, edges_);
    text += array("Int64", "partner", 1, partners_) + array("UInt8", "color", 3, colors_);
    text += "</CellData>\n<Points>\n" + array("Float64", "position", 3, points_) + "</Points>\n";
    text += cells("Verts", verts_) + cells("Lines", lines_) + cells("Polys", polys_);
    return text + "</Piece>\n</PolyData>\n</VTKFile>\n";
  }

 private:
  std::uint32_t add_point(const Eigen::Vector3d& p) {
    for (int k = 0; k < 3; ++k) append(points_, p[k]), points_ += k < 2 ? ' ' : '\n';
    return points_count_++;
  }

  template <class Vertices>
  void add(Cells& cells, const Vertices& vertices, Class kind, std::uint64_t segment, std::uint64_t edge,
           std::uint64_t partner, const Color& color) {
    for (const std::uint32_t vertex : vertices)
      append(cells.connectivity, std::uint64_t{vertex}), cells.connectivity += ' ';
    cells.connectivity += '\n';
    cells.ends += static_cast<std::int64_t>(std::size(vertices));
    append(cells.offsets, cells.ends), cells.offsets += '\n';
    ++cells.count;
    append(segments_, segment), segments_ += '\n';
    append(points_of_, std::int64_t{counts_.at(segment)}), points_of_ += '\n';
    append(classes_, static_cast<std::int64_t>(kind)), classes_ += '\n';
    append(edges_, edge), edges_ += '\n';
    append(partners_, partner), partners_ += '\n';
    for (const std::uint8_t channel : color)
      append(colors_, static_cast<std::int64_t>(channel)), colors_ += ' ';
    colors_ += '\n';
  }

  void add_lines() {
    static constexpr Color kDark{20, 20, 20}, kOrange{232, 80, 20};
    for (const DrawnModel::Line& line : model_.lines) {
      const bool shared = line.partner != 0;
      add(lines_, line.ends, shared ? Class::shared_edge : Class::open_edge, line.segment, line.edge,
          line.partner, shared ? kDark : kOrange);
    }
  }

  void add_polygon(std::size_t i) {
    const LiftedPolygon& polygon = model_.polygons[i];
    const Color color = segment_color(polygon.id);
    if (polygon.cycles.size() == 1) {
      std::vector<std::uint32_t> corners;
      for (std::uint32_t k = 0; k < polygon.cycles[0].size(); ++k) corners.push_back(model_.first[i] + k);
      add(polys_, corners, Class::polygon, polygon.id, 0, 0, color);
      return;
    }
    for (const auto& triangle : triangles_of(model_, i))
      add(polys_, triangle, Class::polygon, polygon.id, 0, 0, color);
  }

  static std::string array(const char* type, const char* name, int components, const std::string& numbers) {
    return std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
           std::to_string(components) + "\" format=\"ascii\">\n" + numbers + "</DataArray>\n";
  }
  static std::string cells(const std::string& name, const Cells& cells) {
    return "<" + name + ">\n" + array("Int64", "connectivity", 1, cells.connectivity) +
           array("Int64", "offsets", 1, cells.offsets) + "</" + name + ">\n";
  }

  DrawnModel model_;
  std::map<std::uint64_t, std::int64_t> counts_;  ///< sensor points of each segment
  std::string points_, segments_, points_of_, classes_, edges_, partners_, colors_;
  std::uint32_t points_count_ = 0;
  Cells verts_, lines_, polys_;
};

}  // namespace

std::string vtp_text(const model::ModelRecord& record) { return PolyData(record).text(); }

}  // namespace limpet::io::internal
