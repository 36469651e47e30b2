// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdio>
#include <limpet/app/commands.hpp>
#include <limpet/survey/choose.hpp>

/// What `limpet model` chooses by the scan where its arguments leave that open, in the words of the command
/// line.
namespace limpet::app {

/// Where text for people goes: with --json - standard output is for the summary alone.
std::FILE* for_people(const ModelArguments& args);

/// Throws io::InputError when the scan holds no point, or not what --noise asks for.
void require_points(survey::PointStream& scan, const ModelArguments& args);

/// λ, noise and tolerance as given, or else from the scan. Throws io::InputError when that does not tell.
survey::Choice choose(survey::PointStream& scan, const ModelArguments& args);

/// Says which of the parameters were not given, as options to be given.
void say_choice(const ModelArguments& args, const model::Parameters& parameters);

/// Gives a scan that says no axes its axes from its own shape, with the warning that this is a guess.
void orient(survey::PointStream& scan, const ModelArguments& args, double voxel_edge);

}  // namespace limpet::app
