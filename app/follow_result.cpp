// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/follow_result.hpp>

#include <cstdio>
#include <limpet/app/arguments.hpp>
#include <limpet/app/page_links.hpp>
#include <limpet/io/mesh_writer.hpp>
#include <limpet/io/text.hpp>
#include <utility>

namespace limpet::app {

FileRoles outputs_of(const FollowArguments& args) {
  FileRoles files;
  for (const std::string& path : args.models) files.writes_model("-o", path);
  files.writes("--json", args.json);
  files.writes("--record", args.record);
  return files;
}

void RunJudge::judge_model(const model::Model& model, std::int64_t sets) {
  constexpr std::int64_t kMostTold = 20;
  for (const auto& violation : judge(model.record()))
    if (violations_++ < kMostTold)
      std::fprintf(stderr, "limpet: broken after set %lld: %s, %s: %s\n", static_cast<long long>(sets),
                   violation.law.c_str(), violation.where.c_str(), violation.what.c_str());
}

void save_models(const FollowArguments& args, const model::Model& model, bool interrupted, std::int64_t sets,
                 Outputs& outputs) {
  const model::ModelRecord record = model.record();
  for (const std::string& path : args.models) outputs.attempt(path, [&] { io::save_model(path, record); });
  if (interrupted)
    std::fprintf(stderr, "limpet: interrupted after %s sets; the model so far is written\n",
                 io::grouped(sets).c_str());
}

int save_result(const FollowArguments& args, FollowSummary summary, const model::Model& model,
                const RunJudge& judge, Outputs& outputs) {
  const bool was_interrupted = summary.run.ended == "interrupted";
  summary.model =
      summarise(model.record(), was_interrupted ? std::vector<model::OpenEdge>() : model.open_edges());
  summary.model.violations = judge.violations();
  summary.model.seconds = summary.seconds;
  if (!args.json.empty()) outputs.attempt(args.json, [&] { save_text(args.json, to_json(summary)); });
  if (!args.quiet) std::fprintf(args.json == "-" ? stderr : stdout, "%s", to_text(summary).c_str());
  if (!args.quiet && !args.page.empty() && !was_interrupted)
    std::fprintf(args.json == "-" ? stderr : stdout, "%s", links_text(args.page, summary.run, model).c_str());
  outputs.require_all();
  return judge.violations() > 0 || summary.run.ended != "complete" ? kFallsShort : kDone;
}

}  // namespace limpet::app
