// Copyright the limpet authors. GPL-3.0-or-later.
#include "report_page.hpp"

#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace limpet::benchmarks {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::string text(32, '\0');
  text.resize(std::strftime(text.data(), text.size(), "%Y-%m-%d", std::gmtime(&now)));
  return text;
}

}  // namespace

ReportPage::ReportPage(std::string folder, const std::string& commit, std::string head,
                       std::vector<std::string> parts)
    : folder_(std::move(folder)), head_(std::move(head)), parts_(std::move(parts)) {
  std::filesystem::create_directories(folder_);
  where_ = "*Commit " + commit + ", " + today() + ", " + processor() + ", " +
           std::to_string(std::thread::hardware_concurrency()) + " cores, g++ " __VERSION__ + ".*";
}

void ReportPage::add(const std::string& title, const std::string& said, const Table& table,
                     const std::string& name, bool has_picture) {
  table.write_csv(folder_ + "/" + name + ".csv");
  write(name + ".md", "## " + title + "\n\n" + said + " " + where_ + "\n\n" + table.markdown() +
                          (has_picture ? "\n![" + title + "](" + name + ".png)\n" : ""));
  std::string all = head_;
  for (const std::string& part : parts_) {
    std::ifstream file(folder_ + "/" + part + ".md");
    if (file) all += "\n" + std::string(std::istreambuf_iterator<char>(file), {});
  }
  write("report.md", all);
}

void ReportPage::write(const std::string& name, const std::string& text) const {
  std::ofstream file(folder_ + "/" + name);
  if (!(file << text).flush()) throw std::runtime_error("cannot write " + folder_ + "/" + name);
}

}  // namespace limpet::benchmarks
