// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdio>
#include <functional>
#include <limpet/app/commands.hpp>
#include <limpet/survey/choose.hpp>

/// How `limpet model` opens a scan, and what it chooses by the scan where its arguments leave that open, in
/// the words of the command line.
namespace limpet::app {

/// Where text for people goes: with --json - standard output is for the summary alone.
std::FILE* for_people(const ModelArguments& args);

/// The scan of these arguments; `stop` as for survey::PointStream. Throws io::InputError.
survey::PointStream open_scan(const ModelArguments& args, const std::function<bool()>& stop = {});

/// Warns of a scan whose axes or normals say nothing.
void warn_of_axes(survey::PointStream& scan);

/// Throws io::InputError when the scan holds no point, or not what --noise asks for.
void require_points(survey::PointStream& scan, const ModelArguments& args);

/// λ, noise and tolerance as given, or else from the scan. Throws io::InputError when that does not tell.
survey::Choice choose(survey::PointStream& scan, const ModelArguments& args);

/// Says which of the parameters were not given, as options to be given.
void say_choice(const ModelArguments& args, const model::Parameters& parameters);

/// Gives a scan that says no axes its axes from its own shape, with the warning that this is a guess.
void orient(survey::PointStream& scan, const ModelArguments& args, double voxel_edge);

}  // namespace limpet::app
