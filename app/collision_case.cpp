// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/collision_case.hpp>

#include <algorithm>
#include <filesystem>
#include <limpet/app/scene_text.hpp>

namespace limpet::app {
namespace {

namespace fs = std::filesystem;

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code none;
  return fs::absolute(a, none).lexically_normal() == fs::absolute(b, none).lexically_normal() ||
         fs::equivalent(a, b, none);
}

std::string one_line_of(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; }, ' ');
  return text;
}

}  // namespace

std::string case_path(const std::string& model, const std::vector<std::string>& taken) {
  const fs::path beside = fs::path(model).parent_path();
  const std::string stem = fs::path(model).stem().string() + "-collision";
  for (int i = 1;; ++i) {
    const fs::path path = beside / (stem + (i == 1 ? "" : "-" + std::to_string(i)) + ".toml");
    const auto is_it = [&](const std::string& other) { return !other.empty() && is_same_file(path, other); };
    if (std::none_of(taken.begin(), taken.end(), is_it)) return path.string();
  }
}

std::string case_text(SceneFile scene, const Collision& collision, const std::string& path) {
  scene.max_sets = collision.set + 1;
  return "# " + one_line_of(text_of(collision)) + ": `limpet follow " +
         one_line_of(fs::path(path).filename().string()) + " -o MODEL` comes to it again.\n" +
         scene_text(scene, fs::path(path).parent_path().string());
}

}  // namespace limpet::app
