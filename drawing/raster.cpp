// Copyright the limpet authors. GPL-3.0-or-later.
#include <algorithm>
#include <cmath>
#include <limits>
#include <limpet/drawing/font.hpp>
#include <limpet/drawing/raster.hpp>

namespace limpet::drawing {
namespace {

constexpr int kSamples = 3;     // a side of a pixel
constexpr int kBandRows = 128;  // rows of pixels in work at a time: memory does not grow with the picture

/// Samples of one band of a panel, with the distance of what they show.
class Band {
 public:
  /// Rows and columns of pixels of the sheet.
  Band(int left, int top, int right, int bottom)
      : left_(left), top_(top), columns_((right - left) * kSamples), rows_((bottom - top) * kSamples) {
    const std::size_t samples = static_cast<std::size_t>(columns_) * rows_;
    depth_.assign(samples, std::numeric_limits<float>::infinity());
    color_.assign(samples, kPaper);
  }

  void triangle(const Eigen::Vector3d& first, const Eigen::Vector3d& second, const Eigen::Vector3d& third,
                io::Color color) {
    const Eigen::Vector3d a = sample(first), b = sample(second), c = sample(third);
    const double twice = cross(a, b, c);
    if (twice == 0) return;
    const auto [top, bottom] = clip(std::min({a.y(), b.y(), c.y()}), std::max({a.y(), b.y(), c.y()}), rows_);
    const auto [left, right] =
        clip(std::min({a.x(), b.x(), c.x()}), std::max({a.x(), b.x(), c.x()}), columns_);
    for (int row = top; row <= bottom; ++row) {
      for (int column = left; column <= right; ++column) {
        const Eigen::Vector3d p(column, row, 0);
        const double u = cross(p, b, c) / twice, v = cross(p, c, a) / twice, w = cross(p, a, b) / twice;
        if (u >= 0 && v >= 0 && w >= 0) put(row, column, u * a.z() + v * b.z() + w * c.z(), color);
      }
    }
  }

  /// A stroke with round ends, drawn `nearer` pixels before where it is, so that the face it bounds does not
  /// hide it.
  void line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double width, double nearer,
            io::Color color) {
    const Eigen::Vector3d a = sample(from), b = sample(to), ab = b - a;
    const double radius = width / 2 * kSamples, squared = ab.head<2>().squaredNorm();
    const auto [top, bottom] = clip(std::min(a.y(), b.y()) - radius, std::max(a.y(), b.y()) + radius, rows_);
    const double reach = radius * std::sqrt(squared);
    for (int row = top; row <= bottom; ++row) {
      double low = std::min(a.x(), b.x()) - radius, high = std::max(a.x(), b.x()) + radius;
      if (std::abs(ab.y()) > 1e-9) {  // only where the endless stroke crosses this row
        const double middle = a.x() + (row - a.y()) * ab.x() / ab.y(), half = reach / std::abs(ab.y());
        low = std::max(low, middle - half - 1);
        high = std::min(high, middle + half + 1);
      }
      const auto [left, right] = clip(low, high, columns_);
      for (int column = left; column <= right; ++column) {
        const Eigen::Vector2d p(column, row);
        const double along = squared > 0 ? (p - a.head<2>()).dot(ab.head<2>()) / squared : 0;
        const double t = std::clamp(along, 0.0, 1.0);
        if ((a.head<2>() + t * ab.head<2>() - p).squaredNorm() > radius * radius) continue;
        put(row, column, a.z() + t * ab.z() - nearer, color);
      }
    }
  }

  /// Averages the samples of every pixel into the image.
  void resolve(Image& image) const {
    for (int y = 0; y < rows_ / kSamples; ++y) {
      for (int x = 0; x < columns_ / kSamples; ++x) {
        std::array<int, 3> sum{};
        for (int i = 0; i < kSamples * kSamples; ++i) {
          const io::Color& color = color_[index(y * kSamples + i / kSamples, x * kSamples + i % kSamples)];
          for (int channel = 0; channel < 3; ++channel) sum[channel] += color[channel];
        }
        std::uint8_t* pixel =
            &image.pixels[(static_cast<std::size_t>(top_ + y) * image.width + left_ + x) * 3];
        constexpr int kAll = kSamples * kSamples;
        for (int channel = 0; channel < 3; ++channel) {
          pixel[channel] = static_cast<std::uint8_t>((sum[channel] + kAll / 2) / kAll);
        }
      }
    }
  }

 private:
  /// From pixels of the sheet to samples of this band, whose centres are whole numbers.
  Eigen::Vector3d sample(const Eigen::Vector3d& p) const {
    return {(p.x() - left_) * kSamples - 0.5, (p.y() - top_) * kSamples - 0.5, p.z()};
  }

  static double cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  }

  static std::pair<int, int> clip(double low, double high, int size) {
    low = std::clamp(low, 0.0, static_cast<double>(size));
    high = std::clamp(high, -1.0, static_cast<double>(size - 1));
    return {static_cast<int>(std::ceil(low)), static_cast<int>(std::floor(high))};
  }

  std::size_t index(int row, int column) const { return static_cast<std::size_t>(row) * columns_ + column; }

  void put(int row, int column, double depth, io::Color color) {
    const std::size_t at = index(row, column);
    const auto z = static_cast<float>(depth);
    if (z > depth_[at]) return;
    depth_[at] = z;
    color_[at] = color;
  }

  int left_, top_, columns_, rows_;
  std::vector<float> depth_;
  std::vector<io::Color> color_;
};

void draw_faces(Band& band, const Panel& panel) {
  std::vector<Eigen::Vector3d> points;
  for (const Patch& patch : panel.patches) {
    points.clear();
    for (const Outline& outline : patch.outlines) {
      points.insert(points.end(), outline.points.begin(), outline.points.end());
    }
    for (const auto& [a, b, c] : patch.triangles) band.triangle(points[a], points[b], points[c], patch.fill);
  }
}

void draw_edges(Band& band, const Panel& panel, bool open) {
  // A stroke is flat where its face is not: it must come forward by more than its own width to stay whole on
  // steep faces. Open edges come forward a little more, to win where they touch shared ones.
  const double width = open ? panel.open_width : panel.shared_width, nearer = 1 + width + (open ? 0.5 : 0);
  for (const Patch& patch : panel.patches) {
    if (patch.round) continue;
    for (const Outline& outline : patch.outlines) {
      for (std::size_t i = 0; i < outline.points.size(); ++i) {
        if (outline.open(i) != open) continue;
        band.line(outline.points[i], outline.points[(i + 1) % outline.points.size()], width, nearer,
                  outline.edges[i]);
      }
    }
  }
}

void draw_dots(Band& band, const Panel& panel) {
  if (panel.vertex_radius > 0) {
    for (const Patch& patch : panel.patches) {
      if (patch.round) continue;
      for (const Outline& outline : patch.outlines) {
        for (const Eigen::Vector3d& p : outline.points) {
          band.line(p, p, 2 * panel.vertex_radius, 2 + 2 * panel.vertex_radius, kInk);
        }
      }
    }
  }
  for (const Eigen::Vector3d& p : panel.loose) band.line(p, p, 2 * panel.loose_radius, 1, kLoosePoint);
}

void draw_lines(Band& band, const Panel& panel) {
  for (const LinePiece& piece : panel.lines) band.line(piece.from, piece.to, piece.width, 1, piece.color);
}

void paint_panel(const Panel& panel, Image& image) {
  const int left = std::max(0, static_cast<int>(panel.left)), top = std::max(0, static_cast<int>(panel.top));
  const int right = std::min(image.width, static_cast<int>(panel.left + panel.width));
  const int bottom = std::min(image.height, static_cast<int>(panel.top + panel.height));
  if (left >= right) return;
  for (int row = top; row < bottom; row += kBandRows) {
    Band band(left, row, right, std::min(row + kBandRows, bottom));
    draw_faces(band, panel);
    draw_edges(band, panel, false);
    draw_edges(band, panel, true);
    draw_dots(band, panel);
    draw_lines(band, panel);
    band.resolve(image);
  }
}

/// Paints a mark over the image, its rim blended by how much of each pixel it covers.
void paint_mark(const Mark& mark, Image& image) {
  const double radius = mark.width / 2;
  const Eigen::Vector2d low = mark.from.cwiseMin(mark.to), high = mark.from.cwiseMax(mark.to),
                        ab = mark.to - mark.from;
  const double squared = ab.squaredNorm();
  const int left = std::max(0, static_cast<int>(low.x() - radius - 1)),
            top = std::max(0, static_cast<int>(low.y() - radius - 1));
  const int right = std::min(image.width - 1, static_cast<int>(high.x() + radius + 1));
  const int bottom = std::min(image.height - 1, static_cast<int>(high.y() + radius + 1));
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      const Eigen::Vector2d p(x + 0.5, y + 0.5);
      const double t = squared > 0 ? std::clamp((p - mark.from).dot(ab) / squared, 0.0, 1.0) : 0;
      const double covered = std::clamp(radius + 0.5 - (mark.from + t * ab - p).norm(), 0.0, 1.0);
      std::uint8_t* pixel = &image.pixels[(static_cast<std::size_t>(y) * image.width + x) * 3];
      for (int channel = 0; channel < 3; ++channel) {
        pixel[channel] = static_cast<std::uint8_t>(
            std::lround(pixel[channel] + covered * (mark.color[channel] - pixel[channel])));
      }
    }
  }
}

}  // namespace

Image paint(const Sheet& sheet) {
  Image image{sheet.width, sheet.height, {}};
  image.pixels.assign(static_cast<std::size_t>(sheet.width) * sheet.height * 3, 255);
  for (const Panel& panel : sheet.panels) paint_panel(panel, image);
  for (const Mark& mark : sheet.marks) paint_mark(mark, image);
  for (const Label& label : sheet.labels) {
    for (const Mark& mark : strokes(label)) paint_mark(mark, image);
  }
  return image;
}

}  // namespace limpet::drawing
