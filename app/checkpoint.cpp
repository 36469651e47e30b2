// Copyright the limpet authors. GPL-3.0-or-later.
#include <limpet/app/checkpoint.hpp>

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limpet/geometry/predicates.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/output_file.hpp>
#include <limpet/io/text.hpp>
#include <limpet/model/digest.hpp>
#include <limpet/simulation/initial_faces.hpp>

namespace limpet::app {
namespace {

constexpr std::string_view kMagic = "limpet checkpoint ";
constexpr std::string_view kFormat = "1";
constexpr std::size_t kDigestBytes = 8;

std::string program() { return std::string(LIMPET_VERSION) + " " + geometry::arithmetic(); }

std::string text_of(double x) {
  std::string text;
  io::append(text, x);
  return text;
}

std::string hexadecimal(std::uint64_t word) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(word));
  return text;
}

std::string digest_of_faces(const std::string& mesh) {
  model::Digest digest;
  for (const auto& face : simulation::initial_faces(simulation::load_mesh(mesh))) {
    digest.add(std::uint64_t{face.cycles.size()});
    for (const auto& cycle : face.cycles) {
      digest.add(std::uint64_t{cycle.size()});
      for (const auto& v : cycle) digest.add(v.x()), digest.add(v.y()), digest.add(v.z());
    }
  }
  return "faces " + hexadecimal(digest.value());
}

/// The text before the bytes.
std::string head_of(const Checkpoint& c) {
  std::string head = std::string(kMagic) + std::string(kFormat) + "\nprogram " + program() + "\n";
  const auto line = [&](const char* key, const std::string& value) {
    head += std::string(key) + " " + value + "\n";
  };
  line("options", std::to_string(c.options.size()));
  for (const CheckpointOption& option : c.options) line(option.name.c_str(), option.value);
  line("points", std::to_string(c.points));
  line("sets", std::to_string(c.sets));
  line("digest", hexadecimal(c.digest));
  line("violations", std::to_string(c.violations));
  line("seconds", text_of(c.seconds));
  line("voxel_edge", text_of(c.voxel_edge));
  line("order_cell", text_of(c.order_cell));
  line("stages", std::to_string(c.stages.size()));
  line("model", std::to_string(c.model.size()));
  return head + "\n";
}

std::uint64_t digest_of(std::string_view head, std::string_view stages, std::string_view model) {
  model::Digest digest;
  for (const std::string_view part : {head, stages, model}) digest.add(part);
  return digest.value();
}

std::string bytes_of(std::uint64_t word) {
  std::string bytes;
  for (std::size_t i = 0; i < kDigestBytes; ++i) bytes += static_cast<char>(word >> (8 * i));
  return bytes;
}

/// Takes a checkpoint apart, line by line and then byte by byte.
class CheckpointReader {
 public:
  CheckpointReader(const std::string& path, std::string_view bytes)
      : path_(path), all_(bytes), rest_(bytes) {}

  Checkpoint read() {
    require_version();
    Checkpoint c;
    for (std::int64_t left = integer("options"); left > 0; --left) {
      const std::string_view text = line();
      const auto blank = text.find(' ');
      if (blank == text.npos) refuse();
      c.options.push_back({std::string(text.substr(0, blank)), std::string(text.substr(blank + 1))});
    }
    c.points = integer("points");
    c.sets = integer("sets");
    c.digest = digest("digest");
    c.violations = integer("violations");
    c.seconds = number("seconds");
    c.voxel_edge = number("voxel_edge");
    c.order_cell = number("order_cell");
    const std::int64_t stages = integer("stages"), model = integer("model");
    if (!line().empty()) refuse();
    const std::string_view head = all_.substr(0, all_.size() - rest_.size());
    c.stages = bytes(stages);
    c.model = bytes(model);
    if (rest_ != bytes_of(digest_of(head, c.stages, c.model))) refuse();
    return c;
  }

 private:
  [[noreturn]] void refuse() const {
    throw io::InputError(path_, "the checkpoint is damaged; without --resume the run begins anew");
  }

  void require_version() {
    if (!rest_.starts_with(kMagic)) throw io::InputError(path_, "is no checkpoint of limpet");
    rest_.remove_prefix(kMagic.size());
    const std::string_view format = line(), by = value("program");
    if (format != kFormat || by != program())
      throw io::InputError(path_, "was written by limpet " + io::in_quotes(by) + ", format " +
                                      io::in_quotes(format) + ", and this is '" + program() + "', format '" +
                                      std::string(kFormat) + "'");
  }

  std::string_view line() {
    const auto end = rest_.find('\n');
    if (end == rest_.npos) refuse();
    const std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return text;
  }
  std::string_view value(std::string_view key) {
    std::string_view text = line();
    if (!text.starts_with(key) || text.size() <= key.size() || text[key.size()] != ' ') refuse();
    text.remove_prefix(key.size() + 1);
    return text;
  }
  std::int64_t integer(std::string_view key) {
    std::int64_t x = 0;
    if (!io::parse_integer(value(key), x) || x < 0) refuse();
    return x;
  }
  double number(std::string_view key) {
    double x = 0;
    if (!io::parse_double(value(key), x) || !(x >= 0)) refuse();
    return x;
  }
  std::uint64_t digest(std::string_view key) {
    const std::string text(value(key));
    char* end = nullptr;
    const std::uint64_t word = std::strtoull(text.c_str(), &end, 16);
    if (text.size() != 16 || *end != '\0') refuse();
    return word;
  }
  std::string bytes(std::int64_t size) {
    if (static_cast<std::uint64_t>(size) > rest_.size()) refuse();
    const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(size));
    rest_.remove_prefix(taken.size());
    return std::string(taken);
  }

  std::string path_;
  std::string_view all_, rest_;
};

[[noreturn]] void refuse_unreadable(const std::string& path) {
  throw io::InputError(path, std::string("cannot be read: ") + std::strerror(errno));
}

}  // namespace

std::vector<CheckpointOption> options_of(const ModelArguments& args) {
  const auto flag = [](bool on) { return std::string(on ? "yes" : "no"); };
  const auto length = [](const std::optional<double>& x) { return x ? text_of(*x) : "by the scan"; };
  std::vector<CheckpointOption> options;
  options.push_back({"--resolution", args.resolution ? text_of(args.resolution->fixed) + "," +
                                                           text_of(args.resolution->per_range)
                                                     : "by the scan"});
  options.push_back({"--angle", text_of(args.angle_deg)});
  options.push_back({"--noise", args.noise
                                    ? text_of(args.noise->fixed) + "," + text_of(args.noise->per_range) +
                                          "," + text_of(args.noise->per_range2)
                                    : "by the scan"});
  options.push_back({"--tolerance", length(args.tolerance)});
  options.push_back({"--set-size", std::to_string(args.set_size)});
  options.push_back({"--order", args.in_arrival_order ? "arrival" : "curve"});
  options.push_back({"--viewpoint", args.viewpoint
                                        ? text_of(args.viewpoint->x()) + "," + text_of(args.viewpoint->y()) +
                                              "," + text_of(args.viewpoint->z())
                                        : "none"});
  options.push_back({"--orient", flag(args.orient)});
  options.push_back({"--initial", args.initial.empty() ? "none" : digest_of_faces(args.initial)});
  options.push_back({"--open", flag(args.open)});
  options.push_back({"--redundancy", text_of(args.redundancy.count) + "," + text_of(args.redundancy.ratio)});
  options.push_back({"--rules", args.rules.to_string()});
  options.push_back({"--labels", flag(!args.labels.empty())});
  options.push_back({"--check-every", args.check_every > 0 ? std::to_string(args.check_every) : "none"});
  options.push_back({"--stages", args.stages > 0 ? std::to_string(args.stages) : "none"});
  return options;
}

void save_checkpoint(const std::string& path, const Checkpoint& checkpoint, const std::string& scan) {
  const std::string head = head_of(checkpoint);
  io::OutputFile file(path);
  file.no_more_readable_than(scan);
  file.write(head);
  file.write(checkpoint.stages);
  file.write(checkpoint.model);
  file.write(bytes_of(digest_of(head, checkpoint.stages, checkpoint.model)));
  file.close();
}

std::optional<Checkpoint> load_checkpoint(const std::string& path) {
  struct stat found;
  if (::stat(path.c_str(), &found) != 0) {
    if (errno == ENOENT) return std::nullopt;
    refuse_unreadable(path);
  }
  if (!S_ISREG(found.st_mode)) throw io::InputError(path, "is no file, so no checkpoint to go on from");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse_unreadable(path);
  std::string bytes(static_cast<std::size_t>(found.st_size), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return CheckpointReader(path, bytes).read();
}

bool is_checkpoint(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string start(kMagic.size(), '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == kMagic;
}

void require_same_options(const std::string& path, const Checkpoint& checkpoint,
                          const std::vector<CheckpointOption>& options) {
  const auto damaged = [&] {
    return io::InputError(path, "the checkpoint holds other options than this program's");
  };
  if (checkpoint.options.size() != options.size()) throw damaged();
  for (std::size_t i = 0; i < options.size(); ++i) {
    const CheckpointOption &then = checkpoint.options[i], &now = options[i];
    if (then.name != now.name) throw damaged();
    if (then.value != now.value)
      throw io::InputError(path, "was written with " + then.name + " " + then.value + ", and this run has " +
                                     now.name + " " + now.value + "; give the same, or leave out --resume");
  }
}

}  // namespace limpet::app
