// Copyright the limpet authors. GPL-3.0-or-later.
#include "any_case.hpp"

namespace limpet::cases {

std::optional<BrokenLaw> broken_law_of_bytes(const std::string& kind, std::span<const std::uint8_t> bytes,
                                             const std::function<void(const std::string& text)>& told) {
  const auto of_case = [&](const auto& c) {
    told(to_text(c));
    return broken_law(c);
  };
  const std::string all(bytes.begin(), bytes.end());
  if (all.starts_with(kCaseMagic)) {
    try {
      return with_case(all, of_case);
    } catch (const CaseError&) {
      return std::nullopt;
    }
  }
  if (kind == "stream") return of_case(stream_of(bytes));
  if (kind == "scan") return of_case(file_of(bytes, kScanFormats));
  if (kind == "mesh") return of_case(file_of(bytes, kMeshFormats));
  if (kind == "native") return of_case(FileCase{"limpet", all, {}});
  if (kind == "labels") return of_case(FileCase{"labels", all, {}});
  if (kind != "perimeter") throw CaseError("there are no inputs of kind '" + kind + "'");
  PerimeterCase c;
  return broken_law_of_script(bytes, c, [&](const PerimeterCase& so_far) { told(to_text(so_far)); });
}

}  // namespace limpet::cases
