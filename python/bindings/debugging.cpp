// Breakpoints, the way back, and expressions that stand in no program.
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "cncsub/control/variable_table.hpp"
#include "cncsub/dialect/library.hpp"
#include "cncsub/flat/numbers.hpp"
#include "cncsub/text/axis_names.hpp"
#include "gil.hpp"
#include "live.hpp"
#include "options.hpp"
#include "rows.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

constexpr std::size_t kLook = 1 << 8;  // the work between two questions, in bytes

Breakpoint::Kind kind_of(const std::string& name) {
  using enum Breakpoint::Kind;
  static const std::pair<const char*, Breakpoint::Kind> kKinds[] = {
      {"block", Block}, {"depth", Depth}, {"call", Call}, {"return", Return}, {"alarm", Alarm},
      {"code", Code},   {"value", Value}, {"axis", Axis}, {"mode", Mode}};
  for (const auto& [known, kind] : kKinds)
    if (name == known) return kind;
  throw py::value_error("no such kind of breakpoint: " + name);
}

/// Return a breakpoint from the facts of one; those that are not given are left as they are.
Breakpoint breakpoint_of(const py::dict& from, const Code& code,
                         const ExpressionList& expressions) {
  Breakpoint of;
  of.kind = kind_of(from["kind"].cast<std::string>());
  const auto take = [&from](const char* name, auto& value) {
    if (from.contains(name)) value = from[name].cast<std::decay_t<decltype(value)>>();
  };
  take("blocks", of.blocks);
  take("number", of.number);
  take("letter", of.letter);
  take("value", of.value);
  take("name", of.name);
  take("expression", of.expression);
  take("condition", of.condition);
  take("hits", of.hits);
  for (const Address block : of.blocks)
    if (block >= code.blocks.size()) throw py::index_error("no such block");
  for (const std::uint32_t one : {of.expression, of.condition})
    if (one != Breakpoint::kNone && one >= expressions.list.size())
      throw py::index_error("no such expression");
  return of;
}

std::vector<Breakpoint> breakpoints_of(const py::list& given, const Code& code,
                                       const ExpressionList& expressions) {
  std::vector<Breakpoint> list;
  for (const py::handle one : given)
    list.push_back(breakpoint_of(one.cast<py::dict>(), code, expressions));
  return list;
}

/// Run to one of the breakpoints. Return which were reached, the fault of one that could not be
/// evaluated, and whether another thread wanted a pause.
py::tuple run_to(Live& live, const py::list& given, const ExpressionList& expressions) {
  const Work machine(live);
  auto list = breakpoints_of(given, machine->code(), expressions);
  std::optional<Breakpoints> after;
  const bool paused = with_signals(live, [&](const auto& interrupted) {
    after.emplace(machine->run(interrupted, std::move(list), expressions));
  });
  py::object faulty = py::none();
  if (const auto& fault = after->faulty())
    faulty = py::make_tuple(fault->first, fault->second.detail);
  return py::make_tuple(py::cast(after->reached()), faulty, paused);
}

/// Do work on the way back, which Ctrl-C stops, and another thread that wants a pause for good.
/// Return whether such a thread did.
template <class Job>
bool work_back(Live& live, Job&& job) {
  bool paused = false;
  const auto pauses = [&] {
    int asked = Live::kForGood;
    return paused = paused || live.pause.compare_exchange_strong(asked, Live::kNone);
  };
  if (pauses()) return true;  // the work may be too short to look
  work_away([&](InterruptCheck& interrupt) {
    std::forward<Job>(job)(
        std::function<bool()>([&] { return pauses() || interrupt.requested(kLook); }));
  });
  return paused;
}

/// Return the last step before the present one at which a breakpoint shows a block; -1: none, and
/// nothing where another thread wanted a pause.
std::optional<std::int64_t> last_met(Live& live, const py::list& given,
                                     const ExpressionList& expressions) {
  const Work machine(live);
  const auto list = breakpoints_of(given, machine->code(), expressions);
  std::optional<std::int64_t> step;
  work_back(live, [&](const auto& interrupted) {
    step = machine->last_met(list, expressions, interrupted);
  });
  return step;
}

/// Go back. Return whether another thread stopped it.
bool back(Live& live, std::int64_t step) {
  const Work machine(live);
  if (step < 0 || step > machine->blocks()) throw py::index_error("no such step");
  if (machine->history() == nullptr) throw py::value_error("the machine does not remember its way");
  return work_back(live, [&](const auto& interrupted) { machine->back(step, interrupted); });
}

/// Return the addresses of the blocks of a program with a sequence number, or on a line.
std::vector<Address> blocks_at(const Live& live, std::int32_t program, std::int64_t n,
                               std::int64_t line) {
  const auto held = live.code();
  const Code& code = *held;
  const Program& of = code.programs.at(static_cast<std::size_t>(program));
  std::vector<Address> found;
  for (Address at = of.first; at < of.last; ++at)
    if ((n < 0 || code.blocks[at].n == n) && (line < 0 || code.blocks[at].line == line) &&
        code.program_at(at) == program)
      found.push_back(at);
  return found;
}

py::object next_block(Live& live) {
  const Look machine(live);
  const Address address = machine->next_block();
  return address == kNowhere ? py::object(py::none()) : py::object(py::int_(address));
}

/// Compile expressions; return them, and of each the reason and the place why it is none.
py::tuple expressions_of(const Live& live,
                         const std::vector<std::pair<std::string, std::int32_t>>& texts) {
  ExpressionList list = compile_expressions(*live.code(), texts);
  py::list faults;
  for (const ExpressionList::One& one : list.list) {
    if (!one.fault) {
      faults.append(py::none());
      continue;
    }
    const Alarm alarm = alarm_of(*list.code, one.block, *one.fault);
    faults.append(py::make_tuple(alarm.detail, alarm.column, alarm.width));
  }
  return py::make_tuple(std::move(list), faults);
}

/// Return which expressions have a number as their value.
std::vector<bool> are_numbers(const ExpressionList& expressions) {
  std::vector<bool> numbers;
  for (const ExpressionList::One& one : expressions.list)
    numbers.push_back(one.type == ValueType::Number);
  return numbers;
}

/// Return the value of an expression, or raise what it would be in a program.
py::object evaluate(Live& live, const ExpressionList& expressions, std::size_t index) {
  const Look machine(live);
  double value = 0;
  std::string text;
  const ExpressionList::One& one = expressions.list.at(index);
  if (const auto alarm = machine->evaluate(expressions, one, value, text))
    throw py::value_error(alarm->detail);
  return one.type == ValueType::Number ? value_or_none(value) : py::object(py::str(text));
}

/// Return the first and the last block of the loops that a frame has open, the outermost first.
py::list open_loops(const Code& code, const State& s, std::size_t frame) {
  py::list loops;
  const std::size_t end = frame + 1 < s.frames.size() ? s.frames[frame + 1].loops : s.loops.size();
  for (std::size_t i = s.frames[frame].loops; i < end; ++i) {
    const Address start = s.loops[i].start;
    const Block& block = code.blocks[start];
    const bool known = block.op == Op::While || block.op == Op::Do || block.op == Op::For;
    const Address last = known ? code.statements[block.aux].end : kNowhere;
    loops.append(py::make_tuple(
        start, last == kNowhere ? py::object(py::none()) : py::object(py::int_(last))));
  }
  return loops;
}

/// Return the programs that are open, the main program first.
py::list open_frames(Live& live) {
  const Look machine(live);
  const State& s = machine->state();
  py::list rows;
  for (std::size_t i = 0; i < s.frames.size(); ++i) {
    const OpenFrame& of = s.frames[i];
    py::dict row;
    row["program"] = of.program;
    row["kind"] = std::string(to_string(of.kind));
    row["called_at"] = of.called_at;
    row["return_to"] = of.return_to;
    row["restart"] = of.restart;
    row["repeat"] = of.repeat;
    row["repeats"] = of.repeats;
    row["macro"] = of.macro;
    row["own_locals"] = of.own_locals;
    row["modal"] = of.modal >= 0 || of.interrupts;
    row["part"] = of.part_end != kNowhere;
    row["loops"] = open_loops(machine->code(), s, i);
    rows.append(row);
  }
  return rows;
}

/// Return whether a variable is a clock or a date of the control.
bool follows_time(const Live& live, std::int64_t number) {
  return group_of(live.code()->place(number).kind) == "clock";
}

/// Return how the control assigns a value to a variable: #100=5, R100=5.
std::string assignment(const Live& live, std::int64_t number, std::optional<double> value) {
  const auto held = live.code();
  const Code& code = *held;
  return std::string(code.spelling->variable) + std::to_string(number) + "=" +
         value_text(value.value_or(kVacant), code);
}

std::string_view role_of(std::optional<FrameInForce> frame) {
  if (!frame) return "stored";
  switch (*frame) {
    case FrameInForce::Settable:
      return "settable";
    case FrameInForce::Program:
      return "program";
    case FrameInForce::Basic:
      return "basic";
    case FrameInForce::Whole:
    case FrameInForce::Other:
      break;
  }
  return "";
}

/// Return the frames of the control that programs may write: by name, the role and how its value
/// is written.
py::dict control_frames(Live& live) {
  py::dict frames;
  for (const auto& of : Look(live)->control_frames())
    frames[py::str(of.name)] = py::make_tuple(role_of(of.role), of.text);
  return frames;
}

/// Raise the reason why something cannot be set.
void raise_refused(const std::optional<std::string>& refused) {
  if (refused) throw py::value_error(*refused);
}

void set_mode(Live& live, const std::string& mode, const std::string& text) {
  const Work machine(live);
  raise_refused(machine->set_mode(compile_mdi(*live.code(), text), mode));
}

void set_named(Live& live, const std::string& name, const std::vector<NamedValue>& values,
               int level) {
  const Work machine(live);
  if (level > machine->state().level) throw py::index_error("no such level");
  raise_refused(machine->set_named(level < 0 ? machine->state().level : level, name, values));
}

void set_position(Live& live, const std::string& axis, double value, bool in_machine) {
  const auto place = axis.size() == 1 ? kAxisNames.find(axis[0]) : std::string_view::npos;
  if (place == std::string_view::npos) throw py::key_error(axis + " is not an axis");
  const Work machine(live);
  raise_refused(machine->set_position(static_cast<int>(place), value,
                                      in_machine ? Coordinates::Machine : Coordinates::Work));
}

void set_next_block(Live& live, Address to) {
  if (to >= live.code()->blocks.size()) throw py::index_error("no such block");
  const Work machine(live);
  raise_refused(machine->set_next_block(to));
}

/// Make blocks that are typed in MDI those that run next. Return nothing where they do, or the
/// reason why one of them is none with its column and width there.
py::object type_in(Live& live, const std::string& text) {
  const Work machine(live);
  std::shared_ptr<const Code> with;
  work_away([&](InterruptCheck& interrupt) {
    with = compile_mdi(
        machine->code(), text, [&] { return interrupt.requested(kLook); }, &machine->state().texts);
  });
  const Program& typed = with->programs.back();
  for (Address at = typed.first; at < typed.last; ++at) {
    const Block& block = with->blocks[at];
    if (block.op != Op::Fault) continue;
    const Alarm alarm = alarm_of(*with, at, with->faults[block.aux]);
    return py::make_tuple(
        alarm.detail.empty() ? std::string(info(alarm.cause).meaning) : alarm.detail, alarm.line,
        alarm.column, alarm.width);
  }
  raise_refused(machine->type_in(std::move(with)));
  live.got_more_code();
  return py::none();
}

/// Return the numbers of the block-skip switches that are on, and whether M01 stops.
py::tuple switches(Live& live) {
  const Look machine(live);
  const Options& options = machine->options();
  py::list on;
  for (int k = 1; k <= Options::kSwitches; ++k)
    if ((options.skips >> k & 1) != 0) on.append(k);
  return py::make_tuple(py::tuple(on), options.optional_stop);
}

void set_switches(Live& live, const py::handle& on, bool stops) {
  const std::uint16_t skips = switches_of(on);
  Work(live)->set_switches(skips, stops);
}

}  // namespace

void add_debugging(MachineClass& machine) {
  py::class_<ExpressionList>(machine, "Expressions", py::is_final())
      .def_property_readonly("are_numbers", &are_numbers);
  machine.def("set_mode", &set_mode, py::arg("mode"), py::arg("text"))
      .def("set_position", &set_position, py::arg("axis"), py::arg("value"), py::arg("in_machine"))
      .def("set_named", &set_named, py::arg("name"), py::arg("values"), py::arg("level") = -1)
      .def("type_in", &type_in, py::arg("text"))
      .def("set_next_block", &set_next_block, py::arg("address"))
      .def_property_readonly("switches", &switches)
      .def("set_switches", &set_switches, py::arg("on"), py::arg("stops"))
      .def("run_to", &run_to, py::arg("breakpoints"), py::arg("expressions"))
      .def("last_met", &last_met, py::arg("breakpoints"), py::arg("expressions"))
      .def("remember", [](Live& live) { Work(live)->remember(); })
      .def("back", &back, py::arg("step"))
      .def_property_readonly("step_of_call", [](Live& live) { return Look(live)->step_of_call(); })
      .def_property_readonly("snapshots",
                             [](Live& live) -> py::tuple {
                               const Look machine(live);
                               const History* const history = machine->history();
                               if (history == nullptr) return py::make_tuple(0, 0);
                               return py::make_tuple(history->snapshots(), history->bytes());
                             })
      .def_property_readonly("open_frames", &open_frames)
      .def_property_readonly("modal_calls",
                             [](Live& live) { return Look(live)->state().modals.size(); })
      .def("follows_time", &follows_time, py::arg("number"))
      .def_property_readonly("control_frames", &control_frames)
      .def("assignment", &assignment, py::arg("number"), py::arg("value"))
      .def("blocks_at", &blocks_at, py::arg("program"), py::arg("n") = -1, py::arg("line") = -1)
      .def_property_readonly("next_block", &next_block)
      .def_property_readonly("address", [](Live& live) { return Look(live)->state().pc; })
      .def("expressions", &expressions_of, py::arg("texts"))
      .def("evaluate", &evaluate, py::arg("expressions"), py::arg("index"));
}

}  // namespace cncsub::bindings
