// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <vector>

#include <limpet/model/model.hpp>

#include "property.hpp"

/// Streams of sensor points as no sensor gives them, made of small whole numbers.
namespace limpet::properties {

using Eigen::Vector3d;
using model::Parameters;
using model::SensorPoint;

/// What is read, set by set, and what for.
struct Stream {
  Parameters parameters;
  std::vector<std::vector<SensorPoint>> sets;
};

/// As text that can be put into a test.
inline std::ostream& operator<<(std::ostream& out, const Stream& stream) {
  const Parameters& p = stream.parameters;
  const auto vector = [&](const Vector3d& v) -> std::ostream& {
    return out << '{' << v.x() << ", " << v.y() << ", " << v.z() << '}';
  };
  out << std::setprecision(17) << "{{.resolution = " << p.resolution << ", .angle_rad = " << p.angle_rad
      << ", .noise = " << p.noise << ", .noise_per_range = " << p.noise_per_range
      << ", .tolerance = " << p.tolerance << ", .outlier_patience = " << p.outlier_patience
      << ", .rules = Rules::parse(\"" << p.rules.to_string() << "\")},\n {";
  for (const auto& set : stream.sets) {
    out << "{";
    for (const SensorPoint& point : set) {
      out << "{";
      vector(point.position) << ", ";
      vector(point.axis) << ", " << point.range << "}, ";
    }
    out << "},\n  ";
  }
  return out << "}}";
}

namespace streams_detail {

/// Three whole numbers from 0 to 63, which a kind of piece makes a reading of.
using Sample = std::array<int, 3>;
constexpr int kReach = 64;

inline constexpr int kKinds = 16;

/// A piece of a world, in units of λ; its surface is seen from above.
struct Piece {
  int kind = 0, a = 0, b = 0;  ///< a, b: what varies within a kind, 0 to 15
  int x = 0, y = 0;            ///< its place, in units of λ
  int turn = 0;                ///< anywhere in space; 0: as it is
  std::vector<Sample> samples;
};

/// The reading of a sample. `mu` is the angular resolution.
inline SensorPoint reading(const Piece& piece, const Sample& s, double mu) {
  const double u = s[0] / 16.0, v = s[1] / 16.0, w = s[2] / 16.0;  // up to 4 λ
  const double hair = (1 + piece.a) / 64.0;
  Vector3d p(u, v, 0), axis(0, 0, -1);
  switch (piece.kind) {
    case 0:  // a plate
      break;
    case 1:  // a line
      p = u * Vector3d(1, piece.a - 8, piece.b / 4.0);
      break;
    case 2:  // few places, again and again
      p = Vector3d(s[0] % 3, s[1] % 3, s[2] % 2);
      break;
    case 3: {  // on edges and corners of a box
      const double size = 1 + piece.a / 4.0;
      p = size * Vector3d(s[0] % 2, s[1] % 2, s[2] / 2 % 2);
      if (s[2] % 2) p[s[0] / 2 % 3] = size * s[1] / kReach;
      axis = (Vector3d::Constant(size / 2) - p).normalized();
      break;
    }
    case 4:  // two planes a hair apart, seen from one side or from both
      p.z() = s[2] % 2 ? hair : 0;
      if (piece.b % 2 && p.z() == 0) axis.z() = 1;
      break;
    case 5: {  // a dihedral whose angle is near μ
      const double angle = mu * (1 + (piece.a - 8) / 64.0);
      if (s[2] % 2) p = Vector3d(-u * std::cos(angle), v, u * std::sin(angle));
      break;
    }
    case 6:  // spikes out of a square
      if (s[2] % 3 == 0) p = (1 + w) * Vector3d(1, s[0] % 4, 0);
      break;
    case 7:  // a plate with bursts of outliers
      if (s[2] < 16) p = Vector3d(3 * u, 3 * v, s[2] - 8);
      break;
    case 8:  // a lattice, λ/2 or 1/3 λ or λ apart
      p = Vector3d(s[0] % 16, s[1] % 16, 0) / (1.0 + piece.a % 3);
      break;
    case 9: {  // planes that meet in one line
      const double angle = (1 + piece.a) / 8.0 * (s[2] % 4);
      p = Vector3d(u * std::cos(angle), v, u * std::sin(angle));
      break;
    }
    case 10:  // a strip narrower than λ
      p.y() = hair * v;
      break;
    case 11:  // round a bore
      p -= Vector3d(2, 2, 0);
      if (const double r = p.norm(); r < 1) p *= (r > 0 ? 1.5 / r : 0);
      break;
    case 12: {  // a cylinder
      const double angle = u;
      axis = -Vector3d(std::cos(angle), 0, std::sin(angle));
      p = -(1 + piece.a / 4.0) * axis + Vector3d(0, v, 0);
      break;
    }
    case 13:
    case 14: {  // the faces of a box, from outside or, as a room, from inside
      const double size = 2 + piece.a / 4.0;
      const int face = s[2] % 6;
      p = size * Vector3d(s[0], s[1], face / 3 * kReach) / kReach;
      axis = Vector3d(0, 0, face / 3 ? -1 : 1);
      for (int k = face % 3; k > 0; --k)
        p = Vector3d(p.z(), p.x(), p.y()), axis = Vector3d(axis.z(), axis.x(), axis.y());
      if (piece.kind == 14) axis = -axis;
      break;
    }
    default:  // a comb
      p = s[2] % 4 ? Vector3d((1 + piece.a) / 8.0 * (s[0] % 8), v, 0)
                   : Vector3d((1 + piece.a) / 8.0 * u, 0, 0);
  }
  return {p, axis};
}

/// What holds for the stream as a whole.
struct Whole {
  int resolution = 0, angle = 0, noise = 0, growth = 0, rules = 0;
  int place = 0;     ///< how far from the origin, a power of ten of λ; 0: at it
  int set_size = 0;  ///< sets of 1 to 64 readings
  int order = 0;     ///< piece by piece, or with these steps through all of them
  int spoilt = 0;    ///< every so manieth reading is no point; 0: none
};

inline Eigen::Matrix3d turned(int number) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
  if (number == 0) return m;
  // From a quaternion of small whole numbers.
  const double w = 1 + number % 3, x = number % 5, y = number % 7 - 3, z = number % 4 - 1;
  m << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return m / (w * w + x * x + y * y + z * z);
}

inline Stream stream_of(const std::vector<Piece>& pieces, const Whole& whole) {
  constexpr std::array kResolution = {1.0, 0.05, 3e-7, 1e9, 1e-60, 1e60};
  constexpr std::array kAngle = {0.17453292519943295, 0.02, 0.7, 1.5};
  constexpr std::array kNoise = {0.0, 0.001, 0.01, 0.1, 1.0};
  Stream stream;
  Parameters& p = stream.parameters;
  const double lambda = p.resolution = kResolution[static_cast<std::size_t>(whole.resolution)];
  p.angle_rad = kAngle[static_cast<std::size_t>(whole.angle)];
  p.noise = lambda * kNoise[static_cast<std::size_t>(whole.noise)];
  if (whole.growth % 2) p.noise_per_range = kNoise[static_cast<std::size_t>(whole.noise)];
  if (whole.growth == 3) p.tolerance = 0.5 * lambda;
  if (whole.rules == 1) p.rules = model::Rules::thesis();
  if (whole.rules == 2) p.outlier_patience = 20;
  const Vector3d away =
      whole.place == 0 ? Vector3d::Zero() : Vector3d(std::pow(10, whole.place) * Vector3d(1, -0.5, 0.25));
  std::vector<SensorPoint> points;
  for (const Piece& piece : pieces) {
    const Eigen::Matrix3d turn = turned(piece.turn);
    for (const Sample& s : piece.samples) {
      SensorPoint point = reading(piece, s, p.angle_rad);
      const double noise = kNoise[static_cast<std::size_t>(whole.noise)];
      // Half the noise the model knows of, with growth twice as much towards the end of a piece.
      const double grown = whole.growth == 2 ? 1.0 + 3.0 * s[0] / kReach : 1;
      point.position += noise / 2 * grown * (s[2] - 32) / 32.0 * point.axis;
      point.position = lambda * (turn * (point.position + Vector3d(piece.x, piece.y, 0)) + away);
      point.axis = turn * point.axis;
      point.range = lambda * s[1] / 8.0;
      points.push_back(point);
    }
  }
  if (whole.spoilt > 0)
    for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(4 * whole.spoilt)) {
      if (whole.spoilt % 2)
        points[i].position[0] = std::numeric_limits<double>::quiet_NaN();
      else
        points[i].axis.setZero();
    }
  // With steps through all of them: 0, k, 2k, … then 1, k + 1, …
  std::vector<SensorPoint> ordered;
  const auto step = static_cast<std::size_t>(1 + whole.order);
  for (std::size_t first = 0; first < step; ++first)
    for (std::size_t i = first; i < points.size(); i += step) ordered.push_back(points[i]);
  const auto size = static_cast<std::size_t>(1 + whole.set_size);
  for (std::size_t i = 0; i < ordered.size(); i += size)
    stream.sets.emplace_back(
        ordered.begin() + static_cast<std::ptrdiff_t>(i),
        ordered.begin() + static_cast<std::ptrdiff_t>(std::min(i + size, ordered.size())));
  return stream;
}

inline Piece any_piece() {
  namespace gen = rc::gen;
  Piece piece;
  piece.kind = one_of(kKinds);
  piece.a = one_of(16), piece.b = one_of(16);
  piece.x = one_of(4), piece.y = one_of(4);
  if (one_of(3) == 2) piece.turn = one_of(40);
  const auto part = gen::resize(rc::kNominalSize, gen::inRange(0, kReach));
  // Several samples for each unit of size: surfaces are made of many points.
  piece.samples = *gen::scale(6.0, gen::container<std::vector<Sample>>(gen::container<Sample>(part)));
  return piece;
}

}  // namespace streams_detail

/// Streams of up to about 1200 readings: plates and boxes, lines, lattices, few places, edges and corners of
/// boxes, planes a hair apart, dihedrals about μ, spikes, bursts of outliers, bores, combs, cylinders; any
/// unit, near and far, noise that changes, readings that are none.
inline rc::Gen<Stream> streams() {
  return rc::gen::exec([] {
    using namespace streams_detail;
    std::vector<Piece> pieces;
    const int count = 1 + one_of(3);
    for (int i = 0; i < count; ++i) pieces.push_back(any_piece());
    Whole all;
    all.resolution = one_of(2) ? 0 : one_of(6);
    all.angle = one_of(2) ? 0 : one_of(4), all.noise = one_of(2) ? 0 : one_of(5);
    all.growth = one_of(4), all.rules = one_of(6);
    all.place = one_of(3) == 2 ? one_of(11) : 0;
    all.set_size = one_of(64), all.order = one_of(8);
    all.spoilt = one_of(4) == 3 ? one_of(8) : 0;
    return stream_of(pieces, all);
  });
}

}  // namespace limpet::properties
