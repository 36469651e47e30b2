// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <cstdint>
#include <limpet/app/outputs.hpp>
#include <limpet/model/model.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace limpet::app {

/// Keeps a few models of a growing one, evenly spaced in points, although the length of the stream is not
/// known: keeps up to twice as many as asked for, and when there are more, drops every other one.
class Stages {
 public:
  /// `count` 0: keeps none.
  explicit Stages(int count) : count_(count) {}
  /// After each set.
  void look(const model::Model& model);
  /// The names of the `count` models that save() writes beside `path`.
  static std::vector<std::string> names(const std::string& path, int count);
  /// Saves `count` models in the native format beside `path`: cube.limpet gives cube.stage1.limpet and so on;
  /// the last is `final_model`.
  void save(const std::string& path, const model::ModelRecord& final_model, Outputs& outputs) const;

  /// What has been kept so far, as text, and the way back. restore() throws io::InputError when the text is
  /// no such state. Precondition of restore(): this object is new, with the same count.
  std::string state() const;
  void restore(std::string_view state);

 private:
  int count_;
  std::int64_t interval_ = 1, next_ = 1;  ///< sets
  std::int64_t sets_ = 0;
  struct Kept {
    std::int64_t points;
    std::string native;  ///< the file
  };
  std::vector<Kept> kept_;
};

}  // namespace limpet::app
