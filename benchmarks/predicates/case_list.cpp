// Copyright the limpet authors. GPL-3.0-or-later.
#include "case_list.hpp"

#include <fstream>
#include <iterator>

namespace limpet::benchmarks {

std::string load_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(file), {});
  if (!file) throw cases::CaseError(path + ": cannot be read");
  return text;
}

std::vector<cases::PerimeterCase> load_cases(const std::string& path) {
  const std::string text = load_text(path);
  std::vector<cases::PerimeterCase> list;
  for (std::size_t at = text.find(cases::kCaseMagic); at != std::string::npos;) {
    const std::size_t next = text.find(cases::kCaseMagic, at + 1);
    list.push_back(cases::perimeter_case(std::string_view(text).substr(at, next - at)));
    at = next;
  }
  return list;
}

void save_cases(const std::string& path, const std::vector<cases::PerimeterCase>& list) {
  std::ofstream file(path, std::ios::binary);
  for (const auto& c : list) file << to_text(c);
  if (!file.flush()) throw cases::CaseError(path + ": cannot be written");
}

}  // namespace limpet::benchmarks
