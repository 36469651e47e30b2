// Copyright the limpet authors. GPL-3.0-or-later.
//
// The files are read here and not by OpenMesh, whose readers round positions to single precision, stop at a
// comment before an OFF header, take other comments for numbers, and refuse surfaces that are no manifold:
// a world to be scanned may be all of that.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limpet/simulation/mesh.hpp>
#include <string_view>
#include <utility>

namespace limpet::simulation {
namespace {

struct Soup {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::vector<int>> polygons;
};

/// Words of a text, comments (from # to the line's end) left out.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  /// The next word; empty at the end of the text, or of the line if `same_line`.
  std::string_view next(bool same_line = false) {
    while (!rest_.empty()) {
      const char c = rest_.front();
      if (c == '#') {
        rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
      } else if (rest_.starts_with("\\\n") || rest_.starts_with("\\\r\n")) {  // OBJ: the line goes on
        rest_.remove_prefix(rest_.find('\n') + 1);
      } else if (c == '\n' && same_line) {
        return {};
      } else if (std::isspace(static_cast<unsigned char>(c))) {
        rest_.remove_prefix(1);
      } else {
        break;
      }
    }
    std::size_t length = 0;
    while (length < rest_.size() && !std::isspace(static_cast<unsigned char>(rest_[length]))) ++length;
    const std::string_view word = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return word;
  }

  void skip_line() { rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size())); }

 private:
  std::string_view rest_;
};

template <typename Number>
Number number(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  // A value too small for a double is as good as zero, but from_chars calls it an error.
  if (error == std::errc::result_out_of_range && word.find("e-") != std::string_view::npos) return 0;
  if (word.empty() || error != std::errc() || end != word.data() + word.size())
    throw MeshError(word.empty() ? "the file ends too early"
                                 : "not a number: " + std::string(word.substr(0, 40)));
  return value;
}

Eigen::Vector3d position(Words& words) {
  Eigen::Vector3d p;
  for (int k = 0; k < 3; ++k) p[k] = number<double>(words.next());
  return p;
}

/// A count from a file's header, distrusted: memory is taken as the data come, not as the header says.
long count(std::string_view word) {
  const long n = number<long>(word);
  if (n < 0 || n > 1'000'000'000) throw MeshError("no sensible count: " + std::string(word));
  return n;
}

Soup read_off(std::string_view text) {
  Words words(text);
  std::string_view word = words.next();
  if (word.ends_with("OFF")) {
    if (word.find_first_of("4n") != std::string_view::npos)
      throw MeshError("OFF of other than three dimensions");
    word = words.next();
    if (word == "BINARY") throw MeshError("binary OFF cannot be read");
  }
  const long vertices = count(word), polygons = count(words.next());
  words.skip_line();  // the number of edges, which many files leave out
  Soup soup;
  for (long v = 0; v < vertices; ++v) {
    soup.vertices.push_back(position(words));
    words.skip_line();
  }
  for (long f = 0; f < polygons; ++f) {
    std::vector<int>& polygon = soup.polygons.emplace_back();
    for (long corners = count(words.next()); corners > 0; --corners)
      polygon.push_back(number<int>(words.next()));
    words.skip_line();
  }
  return soup;
}

Soup read_obj(std::string_view text) {
  Words words(text);
  Soup soup;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "v") {
      soup.vertices.push_back(position(words));
    } else if (word == "f") {
      std::vector<int>& polygon = soup.polygons.emplace_back();
      for (word = words.next(true); !word.empty(); word = words.next(true)) {
        const int v = number<int>(word.substr(0, word.find('/')));
        polygon.push_back(v < 0 ? static_cast<int>(soup.vertices.size()) + v : v - 1);
      }
    }
    words.skip_line();
  }
  return soup;
}

/// Little-endian bytes, as STL and most PLY files have them.
class Bytes {
 public:
  Bytes(std::string_view bytes, bool swapped) : rest_(bytes), swapped_(swapped) {}

  template <typename Number>
  Number take() {
    if (rest_.size() < sizeof(Number)) throw MeshError("the file ends too early");
    char raw[sizeof(Number)];
    std::memcpy(raw, rest_.data(), sizeof raw);
    if (swapped_) std::reverse(std::begin(raw), std::end(raw));
    rest_.remove_prefix(sizeof raw);
    Number value;
    std::memcpy(&value, raw, sizeof raw);
    return value;
  }

 private:
  std::string_view rest_;
  bool swapped_;
};

Soup read_stl(std::string_view data) {
  Soup soup;
  const auto add_triangle_when_full = [&] {
    const int n = static_cast<int>(soup.vertices.size());
    if (n % 3 == 0) soup.polygons.push_back({n - 3, n - 2, n - 1});
  };
  // Some binary files start with "solid" too, so the size decides.
  std::uint32_t triangles = 0;
  if (data.size() >= 84) triangles = Bytes(data.substr(80), false).take<std::uint32_t>();
  if (data.size() >= 84 && (data.size() == 84 + 50 * std::size_t{triangles} || !data.starts_with("solid"))) {
    Bytes bytes(data.substr(84), false);
    for (std::uint32_t t = 0; t < triangles; ++t) {
      for (int k = 0; k < 3; ++k) bytes.take<float>();  // the normal: told by the corners' order as well
      for (int corner = 0; corner < 3; ++corner) {
        Eigen::Vector3d p;
        for (int k = 0; k < 3; ++k) p[k] = static_cast<double>(bytes.take<float>());
        soup.vertices.push_back(p);
        add_triangle_when_full();
      }
      bytes.take<std::uint16_t>();
    }
    return soup;
  }
  if (!data.starts_with("solid")) throw MeshError("neither text nor binary STL");
  Words words(data);
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "solid" || word == "endsolid") words.skip_line();  // a name may be any word
    if (word != "vertex") continue;
    soup.vertices.push_back(position(words));
    add_triangle_when_full();
  }
  return soup;
}

struct PlyProperty {
  std::string name, type, list_count_type;  ///< the last one empty: not a list
};
struct PlyElement {
  std::string name;
  long count = 0;
  std::vector<PlyProperty> properties;
};

double ply_binary(Bytes& bytes, const std::string& type) {
  if (type == "float" || type == "float32") return static_cast<double>(bytes.take<float>());
  if (type == "double" || type == "float64") return bytes.take<double>();
  if (type == "char" || type == "int8") return bytes.take<std::int8_t>();
  if (type == "uchar" || type == "uint8") return bytes.take<std::uint8_t>();
  if (type == "short" || type == "int16") return bytes.take<std::int16_t>();
  if (type == "ushort" || type == "uint16") return bytes.take<std::uint16_t>();
  if (type == "int" || type == "int32") return bytes.take<std::int32_t>();
  if (type == "uint" || type == "uint32") return bytes.take<std::uint32_t>();
  throw MeshError("unknown PLY type: " + type);
}

std::vector<PlyElement> ply_header(Words words, std::string& format) {
  std::vector<PlyElement> elements;
  const auto word = [&words] { return std::string(words.next(true)); };
  for (std::string_view key = words.next(); key != "end_header"; key = words.next()) {
    if (key.empty()) throw MeshError("the PLY header does not end");
    if (key == "format") {
      format = word();
    } else if (key == "element") {
      std::string name = word();
      elements.push_back({std::move(name), count(words.next(true)), {}});
    } else if (key == "property" && !elements.empty()) {
      PlyProperty property;
      property.type = word();
      if (property.type == "list") {
        property.list_count_type = word();
        property.type = word();
      }
      property.name = word();
      elements.back().properties.push_back(std::move(property));
    }
    words.skip_line();
  }
  return elements;
}

Soup read_ply(std::string_view data) {
  const std::size_t header = data.find("end_header");
  if (!data.starts_with("ply") || header == std::string_view::npos) throw MeshError("no PLY header");
  std::string format;
  const std::vector<PlyElement> elements = ply_header(Words(data), format);
  const std::string_view body = data.substr(std::min(data.find('\n', header), data.size() - 1) + 1);
  const bool text = format == "ascii";
  if (!text && !format.starts_with("binary")) throw MeshError("unknown PLY format: " + format);
  Words words(body);
  Bytes bytes(body, format == "binary_big_endian");
  const auto value = [&](const std::string& type) {
    return text ? number<double>(words.next()) : ply_binary(bytes, type);
  };

  Soup soup;
  for (const PlyElement& element : elements) {
    if (element.properties.empty()) continue;  // takes no room in the file, however many there are
    for (long i = 0; i < element.count; ++i) {
      Eigen::Vector3d p = Eigen::Vector3d::Zero();
      for (const PlyProperty& property : element.properties) {
        const bool is_list = !property.list_count_type.empty();
        const double first = value(is_list ? property.list_count_type : property.type);
        if (!is_list) {
          if (property.name.size() == 1 && property.name >= "x" && property.name <= "z")
            p[property.name.front() - 'x'] = first;
          continue;
        }
        if (!(first >= 0 && first < 1e9)) throw MeshError("no sensible length of a list");
        std::vector<int> list;
        for (long k = 0; k < static_cast<long>(first); ++k) {
          const double v = value(property.type);
          list.push_back(std::abs(v) < 2e9 ? static_cast<int>(v) : -1);
        }
        if (element.name == "face" && property.name.starts_with("vertex_ind"))
          soup.polygons.push_back(std::move(list));
      }
      if (element.name == "vertex") soup.vertices.push_back(p);
    }
  }
  return soup;
}

Soup read(std::string ending, std::string_view data) {
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == "off") return read_off(data);
  if (ending == "stl") return read_stl(data);
  if (ending == "obj") return read_obj(data);
  if (ending == "ply") return read_ply(data);
  throw MeshError("not a mesh file (known: .off, .stl, .obj, .ply)");
}

}  // namespace

Mesh load_mesh(const std::string& path, double planarity, bool keep_inward) {
  try {
    if (std::filesystem::is_directory(path)) throw MeshError("is a folder, not a mesh file");
    std::ifstream file(path, std::ios::binary);
    const std::string data{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (!file) throw MeshError("cannot be read");
    const Soup soup = read(path.substr(path.rfind('.') + 1), data);
    Mesh mesh = make_mesh(soup.vertices, soup.polygons, planarity);
    if (!keep_inward && count_edges(mesh).open == 0 && signed_volume(mesh) < 0)
      for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
  } catch (const MeshError& error) {
    throw MeshError(path + ": " + error.what());
  }
}

}  // namespace limpet::simulation
