// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/app/follow_run.hpp>
#include <limpet/model/model.hpp>
#include <string>

namespace limpet::app {

/// A link into a page of `limpet view`: the page opens with this shown. `what`: polygon, edge or step. What
/// has a meaning in links is escaped in the page's name.
std::string page_link(const std::string& page, const std::string& what, std::uint64_t number);

/// The link to what the oracle names, as "segment 12, cycle 0, vertex 3" or "edge 7"; empty where that is no
/// one thing.
std::string page_link_to(const std::string& page, const std::string& where);

/// Links to what a run has left to look at, a line each: what the strategy gave up, at the run's last set,
/// and the first edges that are open in the finished model, with the reason.
std::string links_text(const std::string& page, const FollowOutcome&, const model::Model& finished);

}  // namespace limpet::app
