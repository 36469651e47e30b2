// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <string>
#include <vector>

#include "contestants.hpp"

/// What all detectors of planes in a whole cloud are told, and how they answer.
namespace limpet::benchmarks {

/// Nearest points that are a point's neighbours.
inline constexpr unsigned kNeighbours = 12;

/// How far a point may be from its plane.
double max_distance(const ScanCase&);

/// The least points of a plane: a quarter of what the smallest face has, but for the least that counts. A
/// gift: who knows that of a real scan?
std::size_t smallest_plane(const ScanCase&);

/// A detector's answer, its planes judged by the points in them (indices into the file at `path`). To be
/// called after the peak of memory was taken: judging needs some, too.
Json answer_of(const ScanCase&, const std::string& path, const std::vector<std::vector<std::size_t>>& planes,
               double seconds, double megabytes);

}  // namespace limpet::benchmarks
