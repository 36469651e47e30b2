// Copyright the limpet authors. GPL-3.0-or-later.
#include "file_case.hpp"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <limpet/audit/document.hpp>
#include <limpet/audit/laws.hpp>
#include <limpet/io/error.hpp>
#include <limpet/io/label_source.hpp>
#include <limpet/io/native.hpp>
#include <limpet/io/scan_reader.hpp>
#include <limpet/model/model.hpp>
#include <limpet/simulation/mesh.hpp>

namespace limpet::cases {

namespace {
/// Of the program, not of the copies of it that trials are made in one after the other: when one crashes, its
/// file is the next one's.
const pid_t kProgram = ::getpid();
}  // namespace

FileInMemory::FileInMemory(const std::string& bytes, const std::string& extension) {
  const std::filesystem::path memory = "/dev/shm";
  const auto folder = std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
  path_ = (folder / ("limpet-case-" + std::to_string(kProgram) + "." + extension)).string();
  std::ofstream file(path_, std::ios::binary);
  file << bytes;
  if (!file.flush()) throw std::runtime_error(path_ + ": cannot be written");
}

FileInMemory::~FileInMemory() { ::unlink(path_.c_str()); }

namespace {

/// What goes on for longer than this is told by its beginning.
constexpr int kMostRecords = 100'000;
/// Judging takes longer than linear time.
constexpr std::size_t kMostJudgedVertices = 500;

using Broken = std::optional<BrokenLaw>;

bool one_line(const std::string& message) {
  return !message.empty() && message.find('\n') == std::string::npos;
}

Broken judge_refusal(const std::string& message) {
  if (one_line(message)) return std::nullopt;
  return BrokenLaw{"refusal", "the message is not one line: " + message};
}

std::string record_text(const io::ScanRecord& r) {
  std::ostringstream text;
  text << r.point.position.transpose() << ' ' << r.point.axis.transpose() << ' ' << r.point.range << ' '
       << r.label;
  return text.str();
}

Broken judge_record(const io::ScanRecord& r) {
  if (!r.point.position.allFinite()) return BrokenLaw{"promise", "a point is not finite: " + record_text(r)};
  if (r.has_axis && !(std::abs(r.point.axis.norm() - 1) < 1e-6))
    return BrokenLaw{"promise", "an axis is not of length 1: " + record_text(r)};
  if (!std::isfinite(r.point.range)) return BrokenLaw{"promise", "a range is not finite: " + record_text(r)};
  return std::nullopt;
}

/// All records, one a line, and how it ended.
std::string read_scan(const FileInMemory& file, const io::ScanOptions& options, Broken& broken) {
  std::string all;
  try {
    const auto reader = io::open_scan(file.path(), options);
    io::ScanRecord record;
    for (int i = 0; i < kMostRecords && reader->next(record); ++i) {
      if (!broken) broken = judge_record(record);
      all += record_text(record) + "\n";
    }
    all += std::to_string(reader->skipped());
  } catch (const io::InputError& error) {
    if (!broken) broken = judge_refusal(error.what());
    all += error.what();
  }
  return all;
}

Broken judge_scan(const FileCase& c) {
  const FileInMemory file(c.bytes, c.format);
  io::ScanOptions options;
  options.format = c.format;
  Broken broken;
  const std::string first = read_scan(file, options, broken);
  if (broken) return broken;
  if (read_scan(file, options, broken) != first)
    return BrokenLaw{"promise", "read again it says something else"};
  options.viewpoint = Eigen::Vector3d(0.5, -1, 2);  // some readers take another way with it
  read_scan(file, options, broken);
  return broken;
}

Broken judge_mesh(const FileCase& c) {
  const FileInMemory file(c.bytes, c.format == "mesh-ply" ? "ply" : c.format);
  try {
    const simulation::Mesh mesh = simulation::load_mesh(file.path());
    if (mesh.face_of_triangle.size() != mesh.triangles.size() || mesh.triangles.empty())
      return BrokenLaw{"promise", "a triangle has no face"};
    for (const auto& p : mesh.vertices)
      if (!p.allFinite()) return BrokenLaw{"promise", "a vertex is not finite"};
    for (const auto& t : mesh.triangles)
      for (const int i : t)
        if (i < 0 || static_cast<std::size_t>(i) >= mesh.vertices.size())
          return BrokenLaw{"promise", "an index is out of range"};
    for (const int f : mesh.face_of_triangle)
      if (f < 0 || f >= mesh.face_count) return BrokenLaw{"promise", "a face is out of range"};
  } catch (const simulation::MeshError& error) {
    return judge_refusal(error.what());
  }
  return std::nullopt;
}

std::int64_t lines_without_comments(const std::string& bytes) {
  std::istringstream text(bytes);
  std::int64_t count = 0;
  for (std::string line; std::getline(text, line);) count += !line.starts_with('#');
  return count;
}

Broken judge_labels(const FileCase& c) {
  const FileInMemory file(c.bytes, "txt");
  try {
    io::LabelSource labels(file.path(), "");
    std::int64_t label = 0, count = 0;
    while (count < kMostRecords && labels.next(label)) ++count;
    if (labels.is_list() && count < kMostRecords && count != lines_without_comments(c.bytes))
      return BrokenLaw{"promise", std::to_string(count) + " labels are not one for every line"};
  } catch (const io::InputError& error) {
    return judge_refusal(error.what());
  }
  return std::nullopt;
}

std::string native_text(const model::ModelRecord& record) {
  std::ostringstream text;
  io::write_native(text, record);
  return text.str();
}

enum class Judged { refused, broken, sound };

Judged verdict_of_audit(const std::string& text) {
  try {
    return audit::judge(audit::parse_document(text)).empty() ? Judged::sound : Judged::broken;
  } catch (const audit::DocumentError&) {
    return Judged::refused;
  }
}

/// Of what the oracle does not judge: which rules there are, whether the last line has its end, and whole
/// numbers that 64 bits hold but not the fields of a record.
bool concerns_form_alone(const std::string& refusal) {
  for (const char* form : {": the rules '", ": the file ends within a line", "that fits here", "too often"})
    if (refusal.find(form) != std::string::npos) return true;
  return false;
}

std::size_t vertices_of(const model::ModelRecord& record) {
  std::size_t n = 0;
  for (const auto& s : record.polygon_segments)
    for (const auto& cycle : s.cycles) n += cycle.size();
  return n;
}

Broken judge_sound_model(const model::ModelRecord& record) {
  std::optional<model::Model> model;
  try {
    model.emplace(record);
  } catch (const std::invalid_argument& error) {
    if (record.grid_step != model::Model(record.parameters).record().grid_step) return std::nullopt;
    return BrokenLaw{"native", std::string("no model can be made of it: ") + error.what()};
  }
  std::vector<model::SensorPoint> set;
  for (const auto& s : record.polygon_segments)
    for (int i = 0; i < 4; ++i)
      set.push_back(
          {s.chart_origin + record.parameters.resolution * (0.3 * i * s.chart_u), -s.chart_normal, 0});
  model->update(set);
  model->finish();
  const auto violations = audit::judge(audit::parse_document(native_text(model->record())));
  if (violations.empty()) return std::nullopt;
  return BrokenLaw{"audit", violations[0].law + ", " + violations[0].where + ": " + violations[0].what};
}

Broken judge_native(const FileCase& c) {
  std::istringstream stream(c.bytes);
  model::ModelRecord record;
  try {
    record = io::read_native(stream, "file");
  } catch (const io::InputError& error) {
    if (verdict_of_audit(c.bytes) == Judged::sound && !concerns_form_alone(error.what()))
      return BrokenLaw{"grammar", std::string("a sound model is refused: ") + error.what()};
    return judge_refusal(error.what());
  }
  const bool is_long = vertices_of(record) > kMostJudgedVertices;
  const Judged verdict = is_long ? Judged::broken : verdict_of_audit(c.bytes);
  if (verdict == Judged::refused) return BrokenLaw{"grammar", "refused by the oracle's reader alone"};
  const std::string text = native_text(record);
  std::istringstream again(text);
  if (native_text(io::read_native(again, "file")) != text)
    return BrokenLaw{"native", "it reads back to other bytes"};
  if (record.arithmetic != "exact" || verdict != Judged::sound) return std::nullopt;
  return judge_sound_model(record);
}

}  // namespace

std::optional<BrokenLaw> broken_law(const FileCase& c) {
  try {
    if (c.format == "limpet") return judge_native(c);
    if (c.format == "labels") return judge_labels(c);
    if (c.format == "off" || c.format == "stl" || c.format == "obj" || c.format == "mesh-ply")
      return judge_mesh(c);
    return judge_scan(c);
  } catch (const std::exception& error) {
    return BrokenLaw{"exception", error.what()};
  }
}

}  // namespace limpet::cases
