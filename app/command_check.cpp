// Copyright the limpet authors. GPL-3.0-or-later.
#include <cstdio>
#include <fstream>
#include <iostream>
#include <limpet/app/arguments.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/app/file_roles.hpp>
#include <limpet/app/outputs.hpp>
#include <limpet/audit/laws.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/text.hpp>
#include <nlohmann/json.hpp>

namespace limpet::app {
namespace {

/// The oracle reads the file itself, with none of the code that wrote it.
audit::Document read_document(const std::string& path) {
  try {
    if (path == "-") return audit::parse_document(std::cin);
    refuse_folder(path);
    std::ifstream file(path, std::ios::binary);
    if (!file) throw io::InputError(path, "there is no such file, or it may not be read");
    return audit::parse_document(file);
  } catch (const audit::DocumentError& error) {
    throw io::InputError(path == "-" ? "standard input" : path,
                         std::string(error.what()) + "; 'limpet check' judges native model files (.limpet)");
  }
}

std::string to_json(const audit::Document& document, const std::vector<audit::Violation>& violations) {
  nlohmann::ordered_json json;
  json["polygons"] = document.polygons.size();
  json["points"] = document.points;
  json["violations"] = violations.size();
  json["broken"] = nlohmann::ordered_json::array();
  for (const auto& v : violations) {
    json["broken"].push_back({{"law", v.law}, {"where", v.where}, {"what", v.what}});
  }
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

int run(const CheckArguments& args) {
  FileRoles files;
  files.reads("MODEL", args.model);
  files.writes("--json", args.json);
  files.require_apart();
  const audit::Document document = read_document(args.model);
  const auto violations = audit::judge(document);
  Outputs outputs;
  if (!args.json.empty())
    outputs.attempt(args.json, [&] { save_text(args.json, to_json(document, violations)); });
  if (args.json != "-") {
    for (const auto& violation : violations) {
      std::printf("%s: %s: %s: %s\n", args.model.c_str(), violation.law.c_str(), violation.where.c_str(),
                  violation.what.c_str());
    }
    if (!args.quiet && violations.empty()) {
      std::printf("%s: nothing is broken (%zu laws, %s polygons, %s point segments)\n", args.model.c_str(),
                  audit::laws().size(),
                  io::grouped(static_cast<std::int64_t>(document.polygons.size())).c_str(),
                  io::grouped(static_cast<std::int64_t>(document.point_segments.size())).c_str());
    } else if (!args.quiet) {
      std::printf("%s: %s broken\n", args.model.c_str(),
                  violations.size() == 1
                      ? "1 law is"
                      : (io::grouped(static_cast<std::int64_t>(violations.size())) + " laws are").c_str());
    }
  }
  outputs.require_all();
  return violations.empty() ? kDone : kFallsShort;
}

}  // namespace limpet::app
