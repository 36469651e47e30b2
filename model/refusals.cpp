// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/model/open_edges.hpp>

#include <array>

namespace limpet::model {
namespace {

struct Wording {
  const char *name, *words;
};
constexpr std::array<Wording, kRefusals> kWordings = {{
    {"none", "nothing but its order"},
    {"alone", "no other polygon near"},
    {"angle", "angle below the angular resolution"},
    {"line_far", "line of the planes too far"},
    {"nothing_opposite", "nothing open opposite"},
    {"ring_broken", "ring around the corner broken"},
    {"undecided", "neither convex nor concave"},
    {"short_section", "too short to make neighbours"},
    {"goes_on", "goes on beyond the line"},
    {"inside_shared", "would end inside a shared edge"},
    {"other_pairs", "other shared edges opposite"},
    {"bay", "bay too deep"},
    {"one_sided_end", "end shared on one side only"},
    {"corner_far", "corner too far"},
    {"corner_bay", "bay at the corner too deep"},
    {"corner_turns", "corner would turn an edge"},
    {"perimeter", "perimeter would not be valid"},
}};

}  // namespace

const char* name(Refusal refusal) { return kWordings[static_cast<std::size_t>(refusal)].name; }
const char* words(Refusal refusal) { return kWordings[static_cast<std::size_t>(refusal)].words; }

}  // namespace limpet::model
