// Copyright the limpet authors. GPL-3.0-or-later.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limpet/app/arguments.hpp>
#include <limpet/app/check_evidence.hpp>
#include <limpet/app/commands.hpp>
#include <limpet/app/file_roles.hpp>
#include <limpet/app/outputs.hpp>
#include <limpet/app/page_links.hpp>
#include <limpet/audit/laws.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/native.hpp>
#include <limpet/io/text.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

namespace limpet::app {
namespace {

std::string name_of_model(const std::string& path) { return path == "-" ? "standard input" : path; }

/// As far as its lines are no longer than the oracle reads them: what has no lines may have no end.
void keep_lines(std::istream& from, std::ostream& to) {
  std::vector<char> piece(1 << 16);
  std::size_t without_line = 0;
  while (without_line <= audit::kLongestLine &&
         (from.read(piece.data(), std::ssize(piece)), from.gcount() > 0)) {
    const std::string_view read(piece.data(), static_cast<std::size_t>(from.gcount()));
    to << read;
    const std::size_t last = read.rfind('\n');
    without_line = last == read.npos ? without_line + read.size() : read.size() - last - 1;
  }
}

/// What can be read only once is kept where it is to be read `twice`: by the oracle, and by the program.
std::unique_ptr<std::istream> open_model(const std::string& path, bool twice) {
  std::unique_ptr<std::istream> file;
  if (path == "-") {
    file = std::make_unique<std::istream>(std::cin.rdbuf());
  } else {
    refuse_folder(path);
    file = std::make_unique<std::ifstream>(path, std::ios::binary);
    if (!*file) throw io::InputError(path, "there is no such file, or it may not be read");
  }
  if (!twice || (path != "-" && std::filesystem::is_regular_file(path))) return file;
  auto kept = std::make_unique<std::stringstream>();
  keep_lines(*file, *kept);
  return kept;
}

/// The oracle reads the file itself, with none of the code that wrote it.
audit::Document read_document(std::istream& file, const std::string& path) {
  try {
    return audit::parse_document(file);
  } catch (const audit::DocumentError& error) {
    throw io::InputError(name_of_model(path),
                         std::string(error.what()) + "; 'limpet check' judges native model files (.limpet)");
  }
}

struct Findings {
  std::size_t polygons = 0, point_segments = 0;
  std::uint64_t points = 0;
  std::vector<audit::Violation> violations;
  std::optional<evaluation::Evidence> evidence;  ///< where there is a scan
  bool good() const { return violations.empty() && (!evidence || evidence->within_bounds()); }
};

Findings judge_model(const CheckArguments& args) {
  const auto file = open_model(args.model, !args.scan.empty());
  const audit::Document document = read_document(*file, args.model);
  Findings found{document.polygons.size(), document.point_segments.size(), document.points,
                 audit::judge(document), std::nullopt};
  if (!args.scan.empty()) {
    file->clear();
    file->seekg(0);
    found.evidence = judge_by_scan(args, io::read_native(*file, name_of_model(args.model)));
  }
  return found;
}

std::string to_json(const Findings& found) {
  nlohmann::ordered_json json;
  json["polygons"] = found.polygons;
  json["points"] = found.points;
  json["violations"] = found.violations.size();
  json["broken"] = nlohmann::ordered_json::array();
  for (const auto& v : found.violations) {
    json["broken"].push_back({{"law", v.law}, {"where", v.where}, {"what", v.what}});
  }
  if (found.evidence) json["evidence"] = evidence_json(*found.evidence);
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void report_laws(const CheckArguments& args, const Findings& found) {
  for (const auto& violation : found.violations) {
    const std::string link = args.page.empty() ? std::string() : page_link_to(args.page, violation.where);
    std::printf("%s: %s: %s: %s%s%s\n", args.model.c_str(), violation.law.c_str(), violation.where.c_str(),
                violation.what.c_str(), link.empty() ? "" : "; see ", link.c_str());
  }
  if (!args.quiet && found.violations.empty()) {
    std::printf("%s: nothing is broken (%zu laws, %s polygons, %s point segments)\n", args.model.c_str(),
                audit::laws().size(), io::grouped(static_cast<std::int64_t>(found.polygons)).c_str(),
                io::grouped(static_cast<std::int64_t>(found.point_segments)).c_str());
  } else if (!args.quiet) {
    std::printf(
        "%s: %s broken\n", args.model.c_str(),
        found.violations.size() == 1
            ? "1 law is"
            : (io::grouped(static_cast<std::int64_t>(found.violations.size())) + " laws are").c_str());
  }
}

}  // namespace

int run(const CheckArguments& args) {
  FileRoles files;
  files.reads("MODEL", args.model);
  files.reads("--scan", args.scan);
  files.writes("--json", args.json);
  files.require_apart();
  const Findings found = judge_model(args);
  Outputs outputs;
  if (!args.json.empty()) outputs.attempt(args.json, [&] { save_text(args.json, to_json(found)); });
  if (args.json != "-") {
    report_laws(args, found);
    if (found.evidence)
      std::fputs(evidence_text(*found.evidence, args.model, args.page, args.quiet).c_str(), stdout);
  }
  outputs.require_all();
  return found.good() ? kDone : kFallsShort;
}

}  // namespace limpet::app
