// Copyright the limpet authors. GPL-3.0-or-later.
#include <console_bridge/console.h>
#include <tinyxml.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <limpet/kinematics/urdf.hpp>
#include <mutex>

#include "urdf_document_internal.hpp"

namespace limpet::kinematics::internal {
namespace {

constexpr int kDeepest = 100;  // elements in elements; a URDF has five or so, and the parser calls itself

std::string in_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
}

/// Keeps the errors of what urdfdom says while it lives: first what is wrong, then in which link or joint.
/// The handler of messages is one for the whole program, so that one reads at a time.
class Messages : private console_bridge::OutputHandler {
 public:
  Messages() { console_bridge::useOutputHandler(this); }
  ~Messages() override { console_bridge::restorePreviousOutputHandler(); }
  Messages(const Messages&) = delete;
  Messages& operator=(const Messages&) = delete;

  const std::string& text() const { return text_; }

 private:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    const bool tells_nothing = text.find("is not initialized correctly") != text.npos;
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR || tells_nothing) return;
    text_ += (text_.empty() ? "" : "; ") + in_one_line(text);
  }

  const std::lock_guard<std::mutex> alone_{mutex()};
  std::string text_;

  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }
};

/// At most how deep elements are in each other: what could open one, less what closes one.
int depth_of(const std::string& text) {
  int depth = 0, deepest = 0;
  for (std::size_t i = 0; i + 1 < text.size(); ++i) {
    if (text[i] == '<' && text[i + 1] != '/' && text[i + 1] != '!' && text[i + 1] != '?')
      deepest = std::max(deepest, ++depth);
    if ((text[i] == '<' && text[i + 1] == '/') || (text[i] == '/' && text[i + 1] == '>')) --depth;
  }
  return deepest;
}

/// Takes away what says nothing about where the robot is, and makes of each `<capsule>`, which urdfdom does
/// not know, the cylinder that becomes the same capsule.
void reduce(TiXmlElement& robot) {
  for (TiXmlElement* link = robot.FirstChildElement("link"); link; link = link->NextSiblingElement("link")) {
    for (const char* name : {"visual", "inertial"})
      while (TiXmlElement* found = link->FirstChildElement(name)) link->RemoveChild(found);
    for (TiXmlElement* part = link->FirstChildElement("collision"); part;
         part = part->NextSiblingElement("collision")) {
      TiXmlElement* geometry = part->FirstChildElement("geometry");
      TiXmlElement* capsule = geometry ? geometry->FirstChildElement("capsule") : nullptr;
      if (capsule) capsule->SetValue("cylinder");
    }
  }
  for (const char* name : {"material", "gazebo", "transmission"})
    while (TiXmlElement* found = robot.FirstChildElement(name)) robot.RemoveChild(found);
}

std::string reduced(const std::string& text, const std::string& path) {
  if (depth_of(text) > kDeepest)
    throw RobotError(path + ": its elements are too deep in each other; this is no URDF");
  TiXmlDocument document;
  document.Parse(text.c_str());
  if (document.Error())
    throw RobotError(path + ":" + std::to_string(std::max(1, document.ErrorRow())) +
                     ": is damaged as XML: " + in_one_line(document.ErrorDesc()));
  TiXmlElement* robot = document.FirstChildElement("robot");
  if (!robot)
    throw RobotError(path + ": is no URDF: it has no <robot>; a .xacro file must be expanded first");
  reduce(*robot);
  TiXmlPrinter printer;
  document.Accept(&printer);
  return printer.CStr();
}

}  // namespace

urdf::ModelInterfaceSharedPtr parse_document(const std::string& text, const std::string& path) {
  const std::string xml = reduced(text, path);
  const Messages said;
  urdf::ModelInterfaceSharedPtr model;
  std::string what;
  try {
    model = urdf::parseURDF(xml);
  } catch (const std::exception& error) {
    what = error.what();
  }
  if (model && said.text().empty()) return model;
  if (!said.text().empty()) what = said.text();
  throw RobotError(path + ": is no sound URDF: " + in_one_line(what.empty() ? "no more is known" : what));
}

}  // namespace limpet::kinematics::internal
