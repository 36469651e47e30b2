// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <limpet/app/commands.hpp>
#include <limpet/evaluation/evidence.hpp>
#include <limpet/model/record.hpp>
#include <limpet/model/sensor_point.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

/// `limpet check MODEL --scan SCAN`
namespace limpet::app {

/// Judges a model by the scan of these arguments, which is opened and oriented as `limpet model` does it.
/// Throws io::InputError for a scan that cannot be read to its end, holds no point or more than twenty
/// million, or does not say the ranges that the model's noise grows with.
evaluation::Evidence judge_by_scan(const CheckArguments& args, const model::ModelRecord& model);

/// All figures.
nlohmann::ordered_json evidence_json(const evaluation::Evidence& evidence);

/// A few lines for people, each begun by the model's name; with `quiet` those alone that say what is wrong.
/// Polygons are told with links into `page`, unless it is empty.
std::string evidence_text(const evaluation::Evidence& evidence, const std::string& name,
                          const std::string& page, bool quiet);

}  // namespace limpet::app
