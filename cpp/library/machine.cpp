// Runs and machines.
#include <array>
#include <utility>

#include "cncsub/machine/values/variables.hpp"
#include "cncsub/motion/query.hpp"
#include "inside.hpp"

namespace cncsub::api {

// ---- values of the engine as values of the header ----

std::string_view to_string(Stop stop) { return cncsub::to_string(static_cast<cncsub::Stop>(stop)); }

Stop stop_of(cncsub::Stop from) { return static_cast<Stop>(from); }
static_assert(static_cast<int>(Stop::Interrupted) == static_cast<int>(cncsub::Stop::Interrupted) &&
              static_cast<int>(Stop::Cycles) == static_cast<int>(cncsub::Stop::Cycles) &&
              static_cast<int>(Stop::Alarm) == static_cast<int>(cncsub::Stop::Alarm));
static_assert(static_cast<int>(Record::Moves) == static_cast<int>(Trace::Depth::Moves) &&
              static_cast<int>(Motion::Dwell) == static_cast<int>(MoveKind::Dwell) &&
              static_cast<int>(Motion::Clockwise) == static_cast<int>(MoveKind::Cw));

std::optional<double> value_of(double value) {
  return is_vacant(value) ? std::nullopt : std::optional(value);
}

namespace {

std::optional<std::int64_t> number_of(std::int64_t n) {
  return n < 0 ? std::nullopt : std::optional(n);
}

Step step_of(const Trace& trace, const Code& code, std::size_t index) {
  const Trace::Step row = trace.steps[index];
  return {place_of(code, row.address), text_at(code, row.address), trace.depth_of(row.call),
          row.failed != 0};
}

std::optional<Alarm> alarm_or_none(const cncsub::Machine& machine) {
  return machine.alarm() ? std::optional(alarm_of(*machine.alarm())) : std::nullopt;
}

}  // namespace

Place place_of(const Code& code, Address address) {
  const Program& program = code.programs[static_cast<std::size_t>(code.program_at(address))];
  const Block& block = code.blocks[address];
  return {code.name_of(program), number_of(block.n), block.line, code.files[program.file].name};
}

std::string text_at(const Code& code, Address address) {
  const Program& program = code.programs[static_cast<std::size_t>(code.program_at(address))];
  return std::string(code.text_of(code.blocks[address], program));
}

Call call_of(const Frame& from) {
  return {{from.program, number_of(from.n), from.line, from.file},
          from.kind,
          from.called,
          from.repeat,
          from.repeats};
}

Alarm alarm_of(const cncsub::Alarm& from) {
  Alarm alarm;
  alarm.number = from.number;
  alarm.text = from.text;
  alarm.cause = info(from.cause).slug;
  alarm.detail = from.detail;
  alarm.cure = info(from.cause).cure;
  alarm.at = {from.program, number_of(from.n), from.line, from.file};
  alarm.word = from.word;
  alarm.column = from.column;
  alarm.shown = message(from);
  for (const Frame& frame : from.frames) alarm.stack.push_back(call_of(frame));
  return alarm;
}

Result<std::optional<double>> read(const cncsub::Machine& machine, std::int64_t number, int level) {
  const int present = machine.state().level;
  if (level > present) return Error{"level", "there is no such level"};
  double value = 0;
  if (const auto fault = machine.read(number, level < 0 ? present : level, value))
    return Error{"number", fault->detail};
  return value_of(value);
}

// ---- a finished run ----

Stop Run::stop() const { return stop_of(inside_->machine.stop()); }
std::string Run::waiting_for() const { return inside_->machine.state().waiting_for; }
std::optional<Alarm> Run::alarm() const { return alarm_or_none(inside_->machine); }
std::int64_t Run::blocks() const { return inside_->machine.blocks(); }
std::size_t Run::steps() const { return inside_->machine.trace().steps.size(); }
std::size_t Run::moves() const { return inside_->machine.trace().moves.size(); }
double Run::length() const { return inside_->machine.trace().moves.length(); }
double Run::time() const { return inside_->machine.trace().moves.time(); }
Step Run::step(std::size_t index) const {
  if (index >= steps()) return {};
  return step_of(inside_->machine.trace(), inside_->machine.code(), index);
}

void Run::write_moves(const MoveColumns& columns) const {
  const Moves& moves = inside_->machine.trace().moves;
  const std::array<std::pair<const char*, double*>, 12> named = {{{"x", columns.x},
                                                                  {"y", columns.y},
                                                                  {"z", columns.z},
                                                                  {"mx", columns.mx},
                                                                  {"my", columns.my},
                                                                  {"mz", columns.mz},
                                                                  {"cx", columns.cx},
                                                                  {"cy", columns.cy},
                                                                  {"cz", columns.cz},
                                                                  {"feed", columns.feed},
                                                                  {"length", columns.length},
                                                                  {"time", columns.time}}};
  std::vector<std::string> names;
  std::vector<double*> out;
  for (const auto& [name, column] : named)
    if (column != nullptr) names.emplace_back(name), out.push_back(column);
  moves.columns(names, out);
  if (columns.kind != nullptr) moves.column("kind", columns.kind);
  if (columns.step != nullptr) moves.column("step", columns.step);
}

std::vector<std::string> Run::messages() const {
  const auto& said = inside_->machine.trace().messages;
  std::vector<std::string> all;
  for (std::size_t i = 0; i < said.size(); ++i) all.push_back(said[i]);
  return all;
}

Result<std::optional<double>> Run::variable(std::int64_t number) const {
  return read(inside_->machine, number, -1);
}

// ---- a machine ----

std::optional<Step> Machine::step() {
  cncsub::Machine& machine = inside_->machine;
  const Address at = machine.state().pc;
  const int depth = machine.depth();
  if (inside_->interrupted.exchange(false)) {
    machine.interrupt();
    return std::nullopt;
  }
  if (!machine.step([this] { return inside_->interrupted.load(); })) {
    inside_->interrupted = false;
    return std::nullopt;
  }
  const Trace& trace = machine.trace();
  if (!trace.steps.empty()) return step_of(trace, machine.code(), trace.steps.size() - 1);
  return Step{place_of(machine.code(), at), text_at(machine.code(), at), depth, false};
}

namespace {

/// Run on as the engine's machine does, unless an interrupt came before.
template <class... How>
void run_on(Machine::Inside& inside, How&&... how) {
  if (inside.interrupted)
    inside.machine.interrupt();
  else
    inside.machine.run([&] { return inside.interrupted.load(); }, std::forward<How>(how)...);
  inside.interrupted = false;
}

}  // namespace

void Machine::run(const std::function<bool(const Machine&)>& pause) {
  if (pause)
    run_on(*inside_, [&](const cncsub::Machine&) { return pause(*this); });
  else
    run_on(*inside_);
}

bool Machine::run_blocks(std::int64_t blocks) {
  run_on(*inside_, blocks);
  return stop() == Stop::Running;
}

Result<bool> Machine::run_to(const std::string& program, std::int64_t n) {
  const Code& code = inside_->machine.code();
  const std::int32_t found = code.find(std::string_view(program));
  if (found == kNoProgram) return Error{"program", "there is no program " + program};
  const Address to = code.first_of(code.programs[static_cast<std::size_t>(found)], n);
  if (to == kNowhere)
    return Error{"n", "there is no block N" + std::to_string(n) + " in " + program};
  run_on(*inside_, std::vector<Breakpoint>{{.kind = Breakpoint::Kind::Block, .blocks = {to}}},
         ExpressionList{});
  return stop() == Stop::Running && inside_->machine.state().pc == to;
}

void Machine::interrupt() { inside_->interrupted = true; }
void Machine::reset() { inside_->machine.reset(); }
Machine Machine::snapshot() const { return Machine(std::make_shared<Inside>(inside_->machine)); }
Stop Machine::stop() const { return stop_of(inside_->machine.stop()); }
std::optional<Alarm> Machine::alarm() const { return alarm_or_none(inside_->machine); }
std::int64_t Machine::blocks() const { return inside_->machine.blocks(); }
Place Machine::next() const {
  return place_of(inside_->machine.code(), inside_->machine.state().pc);
}
std::string Machine::next_text() const {
  return text_at(inside_->machine.code(), inside_->machine.state().pc);
}

std::vector<Call> Machine::stack() const {
  std::vector<Call> calls;
  for (const Frame& frame : inside_->machine.frames()) calls.push_back(call_of(frame));
  return calls;
}

Point Machine::position() const {
  Point point;
  for (const auto& [name, value] : cncsub::position(inside_->machine.motion().view()))
    if (name.size() == 1) point[upper(name[0])] = value;
  return point;
}

std::map<std::string, std::string> Machine::modal() const {
  const auto modes = cncsub::modal(inside_->machine.motion().view());
  return {modes.begin(), modes.end()};
}

Result<std::optional<double>> Machine::variable(std::int64_t number, int level) const {
  return read(inside_->machine, number, level);
}

std::optional<Error> Machine::set_variable(std::int64_t number, std::optional<double> value,
                                           int level) {
  cncsub::Machine& machine = inside_->machine;
  const int present = machine.state().level;
  if (level > present) return Error{"level", "there is no such level"};
  if (const auto fault =
          machine.write(number, level < 0 ? present : level, value.value_or(kVacant)))
    return Error{"number", fault->detail};
  return std::nullopt;
}

std::optional<Error> Machine::set_signal(std::int32_t number, double value) {
  cncsub::Machine& machine = inside_->machine;
  if (!is_signal(machine.code(), number))
    return Error{"number", "#" + std::to_string(number) + " is not a signal"};
  machine.set_from_outside(number, value);
  return std::nullopt;
}

Run Machine::so_far() const {
  return Run(std::make_shared<const Run::Inside>(Run::Inside{inside_->machine}));
}

}  // namespace cncsub::api
