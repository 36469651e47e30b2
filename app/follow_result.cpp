// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/follow_result.hpp>

#include <cstdio>
#include <limpet/app/arguments.hpp>
#include <limpet/io/mesh_writer.hpp>
#include <utility>

namespace limpet::app {

void require_outputs(const FollowArguments& args) {
  for (const std::string& path : args.models) {
    require_model_name(path);
    require_writable(path);
  }
  if (!args.json.empty() && args.json != "-") require_writable(args.json);
  if (!args.record.empty()) require_writable(args.record);
}

void RunJudge::judge_model(const model::Model& model, std::int64_t sets) {
  constexpr std::int64_t kMostTold = 20;
  for (const auto& violation : judge(model.record()))
    if (violations_++ < kMostTold)
      std::fprintf(stderr, "limpet: broken after set %lld: %s, %s: %s\n", static_cast<long long>(sets),
                   violation.law.c_str(), violation.where.c_str(), violation.what.c_str());
}

int save_result(const FollowArguments& args, FollowSummary summary, const model::Model& model,
                const RunJudge& judge) {
  const model::ModelRecord record = model.record();
  summary.model = summarise(record, model.open_edges());
  summary.model.violations = judge.violations();
  summary.model.seconds = summary.seconds;
  for (const std::string& path : args.models) io::save_model(path, record);
  if (!args.json.empty()) save_text(args.json, to_json(summary));
  if (!args.quiet) std::fprintf(args.json == "-" ? stderr : stdout, "%s", to_text(summary).c_str());
  return judge.violations() > 0 || summary.run.ended != "complete" ? kFallsShort : kDone;
}

}  // namespace limpet::app
