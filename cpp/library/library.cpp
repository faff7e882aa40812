// Reading programs, their check, and the list of controls.
#include "cncsub/dialect/library.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <utility>

#include "cncsub/analysis/check.hpp"
#include "cncsub/control/alias.hpp"
#include "inside.hpp"

namespace cncsub::api {

namespace {

/// Return the name of a program whose text does not name it: that of its file, without folder and
/// ending.
std::string stem_of(const std::string& name) {
  const std::string file(last_of_path(name));
  const std::size_t dot = file.rfind('.');
  return dot == std::string::npos || dot == 0 ? file : file.substr(0, dot);
}

/// Read a file; nothing where that fails, as it does for a folder.
std::optional<std::string> text_of(const std::string& path) {
  constexpr std::size_t kPart = std::size_t{1} << 16;
  std::ifstream file(path, std::ios::binary);
  std::string text, part(kPart, '\0');
  while (file.read(part.data(), static_cast<std::streamsize>(kPart)) || file.gcount() > 0)
    text.append(part, 0, static_cast<std::size_t>(file.gcount()));
  if (!file.eof() || file.bad()) return std::nullopt;
  return text;
}

Finding finding_of(const Code& code, const cncsub::Finding& from) {
  const CheckInfo& rule = info(from.check);
  const cncsub::Alarm there = cncsub::alarm_of(
      code, from.block, {.at = from.place.at, .width = from.place.width, .detail = from.detail});
  Finding finding;
  finding.rule = rule.number;
  finding.name = rule.slug;
  finding.severity = rule.severity;
  finding.message = from.detail.empty() ? std::string(rule.meaning) : from.detail;
  finding.hint = from.hint.empty() ? std::string(rule.hint) : from.hint;
  finding.at = place_of(code, from.block);
  finding.column = there.column;
  finding.word = there.word;
  finding.count = from.again.size() + 1;
  if (from.alarm) finding.alarm = alarm_of(cncsub::alarm_of(code, from.alarm_block, *from.alarm));
  return finding;
}

}  // namespace

Result<const cncsub::Control*> control_named(const std::string& name) {
  if (const cncsub::Control* known = find_control(name)) return known;
  std::string near;
  for (const std::string_view known : names_near(name))
    near.append(near.empty() ? "; did you mean " : ", ").append(known);
  return Error{"control", "there is no control " + name + near +
                              (near.empty() ? "; controls() lists them" : "?")};
}

std::string_view version() { return CNCSUB_VERSION; }

std::vector<Control> controls() {
  std::vector<Control> all;
  for (const cncsub::Control& control : all_controls())
    all.push_back({control.name, control.title});
  return all;
}

Result<Library> Library::read(std::vector<Source> sources, const std::string& control,
                              const std::map<std::string, double>& parameters,
                              const std::function<bool()>& interrupted) {
  const Result<const cncsub::Control*> known = control_named(control);
  if (!known) return known.error();
  auto own = std::make_shared<cncsub::Control>(**known);
  for (const auto& [name, value] : parameters)
    if (const auto wrong = own->set_parameter(name, value)) return Error{"parameters", *wrong};
  std::vector<SourceFile> files;
  bool device = false;
  for (Source& source : sources) {
    device = device || source.external;
    files.push_back({source.name, stem_of(source.name), FileText(source.text), source.external});
  }
  auto code = compile(std::move(own), std::move(files), device, interrupted);
  if (code == nullptr) return Error{"", "the reading was interrupted"};
  return Library(std::make_shared<const Inside>(Inside{std::move(code)}));
}

Result<Library> Library::load(const std::vector<std::string>& paths, const std::string& control,
                              const std::map<std::string, double>& parameters) {
  std::vector<Source> sources;
  for (const std::string& path : paths) {
    std::optional<std::string> text = text_of(path);
    if (!text) return Error{"paths", path + " cannot be read"};
    sources.push_back({path, std::move(*text)});
  }
  return read(std::move(sources), control, parameters);
}

const std::string& Library::control() const { return inside_->code->control->name; }

std::vector<std::string> Library::programs() const {
  const Code& code = *inside_->code;
  std::vector<std::string> names;
  for (const Program& program : code.programs)
    if (is_listed(code, program)) names.push_back(code.name_of(program));
  return names;
}

Result<Machine> Library::machine(const Options& options) const {
  Result<cncsub::Machine> machine = machine_of(inside_->code, options);
  if (!machine) return machine.error();
  return Machine(std::make_shared<Machine::Inside>(std::move(*machine)));
}

Result<Run> Library::run(const Options& options, const std::function<bool()>& interrupted) const {
  Result<cncsub::Machine> machine = machine_of(inside_->code, options);
  if (!machine) return machine.error();
  machine->run(interrupted);
  return Run(std::make_shared<const Run::Inside>(Run::Inside{std::move(*machine)}));
}

std::vector<Finding> Library::check() const {
  const Code& code = *inside_->code;
  std::vector<Finding> all;
  InterruptCheck none;
  for (const cncsub::Finding& finding : cncsub::check(code, {code.main_program(), {}}, "", none))
    all.push_back(finding_of(code, finding));
  return all;
}

}  // namespace cncsub::api
