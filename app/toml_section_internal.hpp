// Copyright the limpet authors. GPL-3.0-or-later.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace limpet::app {

/// Which numbers a key takes.
enum class Numbers { any, not_negative, positive, fraction };

/// A table of a TOML file that knows where it is. Whoever asks for a key that has another kind of value gets
/// io::InputError with file, line and what the key takes.
class TomlSection {
 public:
  /// The whole of a file. `path` is for messages and for files named in it. Throws io::InputError when the
  /// text is no TOML.
  static TomlSection parse(const std::string& text, const std::string& path);
  ~TomlSection();
  TomlSection(TomlSection&&) noexcept;

  /// Throws io::InputError when there is a key that is none of these.
  void allow(const std::vector<std::string>& known) const;

  bool has(const std::string& key) const;
  bool is_text(const std::string& key) const;
  bool is_list(const std::string& key) const;
  /// The table of this name, with no other keys than these.
  std::optional<TomlSection> section(const std::string& key, const std::vector<std::string>& known) const;
  /// The same with whatever keys: those of names that the file's author chose.
  std::optional<TomlSection> table(const std::string& key) const;
  /// Its keys, in alphabetical order.
  std::vector<std::string> keys() const;
  /// Each table of an array of tables.
  void each(const std::string& key, const std::vector<std::string>& known,
            const std::function<void(const TomlSection&)>& take) const;

  std::optional<double> number(const std::string& key, Numbers) const;
  std::optional<std::int64_t> whole(const std::string& key, std::int64_t least, std::int64_t most) const;
  bool flag(const std::string& key) const;  ///< false when it is not there
  std::optional<std::string> text(const std::string& key) const;
  /// A text, or a list of texts.
  std::optional<std::vector<std::string>> texts(const std::string& key) const;
  /// What a name in this file means, as seen from here.
  std::string beside(const std::string& name) const;
  /// A file that is there; as its name is seen from here.
  std::optional<std::string> file(const std::string& key) const;
  /// So many numbers, from `least` to `most` of them.
  std::optional<std::vector<double>> numbers(const std::string& key, std::size_t least, std::size_t most,
                                             Numbers) const;
  std::optional<std::vector<int>> indices(const std::string& key) const;
  std::optional<Eigen::Vector3d> vector(const std::string& key) const;

  /// At most one of these keys is there; exactly one when `needed`.
  void require_one(const std::vector<std::string>& keys, bool needed) const;
  /// Throws io::InputError: this file, the line of the key (or of the table where it is not there), and what.
  [[noreturn]] void fail(const std::string& key, const std::string& what) const;
  /// "'key' in [section]"
  std::string called(const std::string& key) const;

 private:
  struct Inside;
  std::string name_of(const std::string& key) const;  ///< of a table in this one
  explicit TomlSection(std::unique_ptr<Inside>);
  std::unique_ptr<Inside> inside_;
};

}  // namespace limpet::app
