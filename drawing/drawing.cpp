// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limpet/drawing/drawing.hpp>
#include <limpet/drawing/font.hpp>
#include <limpet/drawing/open_edge_color.hpp>
#include <limpet/drawing/projection.hpp>
#include <limpet/drawing/raster.hpp>
#include <limpet/drawing/svg.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/output_file.hpp>
#include <limpet/io/text.hpp>
#include <set>
#include <stdexcept>

namespace limpet::drawing {
namespace {

constexpr std::size_t kMostColumns = 4;

std::string counted(std::int64_t number, const std::string& one, const std::string& many) {
  return io::grouped(number) + " " + (number == 1 ? one : many);
}

/// The counts of a model, for the line under its caption.
std::string summary(const model::ModelRecord& model) {
  std::int64_t shared = 0, open = 0;
  for (const auto& segment : model.polygon_segments) {
    for (const auto& cycle : segment.cycles) {
      for (const model::VertexRecord& vertex : cycle) ++(vertex.partner != 0 ? shared : open);
    }
  }
  const auto polygons = static_cast<std::int64_t>(model.polygon_segments.size());
  const auto loose = static_cast<std::int64_t>(model.point_segments.size());
  std::string text = counted(model.points, "point", "points") + ": " +
                     counted(polygons, "polygon", "polygons") + ", " +
                     counted(shared / 2, "shared edge", "shared edges") + ", " + io::grouped(open) + " open";
  if (loose > 0) text += ", " + counted(loose, "point segment", "point segments");
  return text;
}

/// Puts the parts of a sheet where they belong.
class Layout {
 public:
  Layout(const std::vector<Figure>& figures, const DrawOptions& options)
      : figures_(figures), options_(options) {
    for (const Figure& figure : figures) scenes_.push_back(make_scene(figure, options.loose_points));
    views_ = options.views;
    if (views_.empty()) views_ = choose_views(scenes_);
    if (options.views.empty() && figures.size() > 1) views_.resize(std::min<std::size_t>(views_.size(), 2));
    boxes_.resize(figures.size());
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      for (std::size_t j = 0; j < scenes_.size(); ++j) {
        if (i == j || options.common_frame) boxes_[i].extend(scenes_[j].box);
      }
    }
    if (options.common_frame) share_whole_way();
    sheet_.width = options.width;
    const double columns = static_cast<double>(figures.size() == 1 ? views_.size() : figures_in_row());
    unit_ = std::clamp(options.width / 1600.0, 0.5, 4.0);
    margin_ = 20 * unit_;
    panel_width_ = std::floor((options.width - margin_) / columns - margin_);
  }

  Sheet make() {
    double top = margin_;
    if (figures_.size() == 1) {
      top = caption(0, margin_, options_.width - 2 * margin_, top);
      std::vector<Cell> cells;
      for (std::size_t view = 0; view < views_.size(); ++view) cells.push_back({0, view});
      top = row(cells, top);
    } else {
      for (std::size_t first = 0; first < figures_.size(); first += figures_in_row()) {
        const std::size_t last = std::min(first + figures_in_row(), figures_.size());
        double below = top;
        for (std::size_t i = first; i < last; ++i) {
          below = std::max(below, caption(i, column_left(i - first), panel_width_, top));
        }
        top = below;
        for (std::size_t view = 0; view < views_.size(); ++view) {
          std::vector<Cell> cells;
          for (std::size_t i = first; i < last; ++i) cells.push_back({i, view});
          top = row(cells, top);
        }
      }
    }
    if (options_.legend) top = legend(top);
    sheet_.height = static_cast<int>(std::ceil(top));
    return std::move(sheet_);
  }

 private:
  struct Cell {
    std::size_t figure, view;
  };

  /// Stages of growth show beginnings of one way.
  void share_whole_way() {
    std::size_t whole = 0;
    for (const Scene& scene : scenes_) whole = std::max(whole, scene.way.size());
    for (Scene& scene : scenes_) scene.whole_way = whole;
  }

  std::size_t figures_in_row() const { return std::min(figures_.size(), kMostColumns); }
  double column_left(std::size_t column) const {
    return std::floor(margin_ + static_cast<double>(column) * (panel_width_ + margin_));
  }

  /// A label, made smaller where it does not fit the width; its base lies `size` below `top`.
  void label(const std::string& text, double left, double top, double size, double width,
             const io::Color& color) {
    const double full = text_width(text, size);
    sheet_.labels.push_back({left, top + size, full > width ? size * width / full : size, color, text});
  }

  double caption(std::size_t figure, double left, double width, double top) {
    label(figures_[figure].caption, left, top, 15 * unit_, width, kInk);
    top += 26 * unit_;
    label(summary(figures_[figure].model), left, top, 9.5 * unit_, width, kPale);
    return top + 20 * unit_;
  }

  /// Pixels to a unit that let every view of the figure fit a panel.
  double scale_of(std::size_t figure) const {
    double scale = 0;
    for (const View& view : views_) {
      const Eigen::Vector2d size = projected_size(boxes_[figure], view);
      const double fit = std::min(0.92 * panel_width_ / std::max(size.x(), 1e-300),
                                  0.92 * panel_width_ / std::max(size.y(), 1e-300));
      scale = scale == 0 ? fit : std::min(scale, fit);
    }
    return scale < 1e250 ? scale : 1;
  }

  /// A row of panels.
  double row(const std::vector<Cell>& cells, double top) {
    double height = 0;
    for (const Cell& cell : cells) {
      const double scale = scale_of(cell.figure);
      height = std::max(height, scale * projected_size(boxes_[cell.figure], views_[cell.view]).y());
    }
    height = std::floor(std::max(height + 0.08 * panel_width_, 60 * unit_));
    top = std::floor(top);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      Panel& panel = sheet_.panels.emplace_back();
      panel.left = column_left(i);
      panel.top = top;
      panel.width = panel_width_;
      panel.height = height;
      panel.way_width *= unit_;
      project(scenes_[cells[i].figure], views_[cells[i].view], boxes_[cells[i].figure],
              scale_of(cells[i].figure), panel);
      panel.shared_width *= unit_;
      panel.open_width *= unit_;
      panel.vertex_radius *= options_.vertices ? unit_ : 0;
      panel.loose_radius *= unit_;
      const std::string& name = views_[cells[i].view].name;
      const double size = 9 * unit_;
      const double left = panel.left + std::max(0.0, (panel_width_ - text_width(name, size)) / 2);
      if (!name.empty()) label(name, left, top + height + 4 * unit_, size, panel_width_, kPale);
    }
    return top + height + 30 * unit_;
  }

  /// Of what there is to see of robots.
  template <class Entry>
  void legend_of_robots(const Entry& entry) {
    const auto is_drawn = [&](auto RobotFigure::*part) {
      return std::any_of(scenes_.begin(), scenes_.end(),
                         [&](const Scene& s) { return s.robot && !((*s.robot).*part).empty(); });
    };
    const double line = 26 * unit_;
    if (is_drawn(&RobotFigure::body) || is_drawn(&RobotFigure::bones))
      entry("robot", 10 * unit_, 10 * unit_, kRobot);
    if (is_drawn(&RobotFigure::rays)) entry("reading", line, 1.4 * unit_, kRay);
    if (is_drawn(&RobotFigure::misses)) entry("sensor that met nothing", line, 1 * unit_, kMiss);
    if (is_drawn(&RobotFigure::fields)) entry("switch that sees something", line, 3.2 * unit_, kSeeing);
    if (is_drawn(&RobotFigure::quiet)) entry("switch that does not", 0, 4.4 * unit_, kMiss);
  }

  double legend(double top) {
    const double size = 9.5 * unit_;
    double left = margin_, middle = top + size / 2;
    const auto make_room = [&](double width) {
      if (left == margin_ || left + width <= options_.width - margin_) return;
      left = margin_;
      top += 2 * size;
      middle += 2 * size;
    };
    const auto entry = [&](const std::string& text, double length, double width, const io::Color& color) {
      make_room(length + width + 8 * unit_ + text_width(text, size));
      const double start = left + width / 2;
      sheet_.marks.push_back({{start, middle}, {start + length, middle}, width, color});
      left += length + width + 8 * unit_;
      label(text, left, top, size, 1e9, kPale);
      left += text_width(text, size) + 28 * unit_;
    };
    const double line = 26 * unit_;
    entry("shared edge", line, 2.2 * unit_, kSharedEdge);
    const auto refusals = refusals_drawn();
    if (refusals.empty()) entry("open edge", line, 3.2 * unit_, open_edge_color(model::Refusal::alone));
    for (const model::Refusal refusal : refusals)
      entry(std::string("open: ") + words(refusal), line, 3.2 * unit_, open_edge_color(refusal));
    if (options_.vertices) entry("vertex", 0, 6.4 * unit_, kInk);
    if (options_.loose_points) entry("point segment", 0, 4.4 * unit_, kLoosePoint);
    if (std::any_of(scenes_.begin(), scenes_.end(), [](const Scene& s) { return !s.way.empty(); })) {
      entry("path where it begins", line, 1.8 * unit_, kWayBegins);
      entry("path where it ends; a dot for each set", line, 1.8 * unit_, kWayEnds);
    }
    legend_of_robots(entry);
    entry("back side", 10 * unit_, 10 * unit_, kBackSide);
    const std::string per_segment = "a colour per segment";
    make_room(54 * unit_ + text_width(per_segment, size));
    for (std::uint64_t id = 1; id <= 4; ++id) {
      sheet_.marks.push_back(
          {{left + 5 * unit_, middle}, {left + 5 * unit_, middle}, 10 * unit_, io::segment_color(id)});
      left += 12 * unit_;
    }
    label(per_segment, left + 6 * unit_, top, size, 1e9, kPale);
    return top + size + margin_;
  }

  /// What refused the open edges of all figures.
  std::set<model::Refusal> refusals_drawn() const {
    std::set<model::Refusal> refusals;
    for (const Figure& figure : figures_)
      for (const model::OpenEdge& open : figure.open_edges) refusals.insert(open.refusal);
    return refusals;
  }

  const std::vector<Figure>& figures_;
  const DrawOptions& options_;
  std::vector<Scene> scenes_;
  std::vector<View> views_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  double unit_ = 1, margin_ = 0, panel_width_ = 0;
  Sheet sheet_;
};

void check(const std::vector<Figure>& figures, const DrawOptions& options) {
  if (figures.empty()) throw std::invalid_argument("nothing to draw");
  if (options.width < 200 || options.width > 16384) {
    throw std::invalid_argument("a picture is 200 to 16384 pixels wide, not " +
                                std::to_string(options.width));
  }
  for (const View& view : options.views) {
    const double across = view.toward.normalized().cross(view.up.normalized()).norm();
    if (!(across > 1e-6)) throw std::invalid_argument("a view whose up is along its line of sight");
  }
}

}  // namespace

std::vector<View> default_views(const std::vector<Figure>& figures) {
  std::vector<Scene> scenes;
  for (const Figure& figure : figures) scenes.push_back(make_scene(figure, false));
  std::vector<View> views = choose_views(scenes);
  if (figures.size() > 1) views.resize(2);
  return views;
}

void draw(const std::vector<Figure>& figures, const std::string& path, const DrawOptions& options) {
  check(figures, options);
  const std::string extension = io::extension_of(path);
  if (extension != "png" && extension != "svg") {
    throw io::OutputError(path + ": a picture is written as .png or .svg, not as " +
                          io::in_quotes(extension));
  }
  io::OutputFile file(path);
  const Sheet sheet = Layout(figures, options).make();
  file.write(extension == "png" ? png_bytes(paint(sheet)) : svg_bytes(sheet));
  file.close();
}

}  // namespace limpet::drawing
