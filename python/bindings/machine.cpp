#include "cncsub/machine/machine.hpp"

#include <pybind11/stl.h>

#include <cmath>

#include "bindings.hpp"
#include "cncsub/machine/values/variables.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "gil.hpp"
#include "live.hpp"
#include "options.hpp"
#include "rows.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

constexpr std::size_t kLookBytes = 1 << 8;  // the work of checking a block, in bytes

/// Refuse a watched variable that cannot be read.
void check_watch(const Machine& machine, const std::vector<std::int32_t>& watch) {
  for (const std::int32_t number : watch) {
    double value = 0;
    if (auto fault = machine.read(number, 0, value)) refuse("watch", "watch: " + fault->detail);
    if (machine.code().place(number).kind == VariableKind::Vacant)
      refuse("watch", "watch: #" + std::to_string(number) + " is always vacant");
  }
}

std::shared_ptr<Live> make_machine(const std::shared_ptr<Code>& code, std::int32_t main,
                                   const py::kwargs& given) {
  if (main < 0 || static_cast<std::size_t>(main) >= code->programs.size())
    throw py::index_error("no such program");
  Options options = options_of(given);
  check_systems(*code->control, options);
  const Program& program = code->programs[static_cast<std::size_t>(main)];
  if (options.start >= 0 && code->first_of(program, options.start) == kNowhere)
    refuse("start", "start: there is no block N" + std::to_string(options.start) + " in " +
                        code->name_of(program));
  const auto variables = options.variables;
  const auto watch = options.watch;
  const Inputs inputs = options.inputs;
  auto live = std::make_shared<Live>(code, main, std::move(options));
  for (const auto& [number, value] : variables)
    if (auto fault = live->machine.write(number, 0, value))
      refuse("variables", "variables: " + fault->detail);
  check_inputs(*code, inputs);
  check_watch(live->machine, watch);
  return live;
}

bool run(Live& live) {
  const Work machine(live);
  return with_signals(live, [&](const auto& interrupted) { machine->run(interrupted); });
}

/// Execute a step and return it; None where the run has stopped.
py::object step(Live& live, const py::type& row) {
  const Work machine(live);
  const bool done = machine->step([] { return PyErr_CheckSignals() != 0; });
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  const Trace& trace = machine->trace();
  if (!done) return py::none();
  if (trace.steps.empty()) throw py::index_error("no step was recorded");
  return step_object(trace, machine->shared_code(), trace.steps.size() - 1, row);
}

void run_blocks(Live& live, std::int64_t blocks) {
  const Work machine(live);
  with_signals(live, [&](const auto& interrupted) { machine->run(interrupted, blocks); });
}

py::object stop_of(Live& live) {
  const Stop stop = Look(live)->stop();
  return stop == Stop::Running ? py::object(py::none())
                               : py::object(py::str(std::string(to_string(stop))));
}

py::object last_alarm(Live& live) {
  const Look machine(live);
  return machine->alarm() ? py::cast(*machine->alarm()) : py::object(py::none());
}

py::tuple stack_of(Live& live) {
  const auto frames = Look(live)->frames();
  py::tuple rows(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) rows[i] = py::cast(frames[i]);
  return rows;
}

py::tuple position_in_program(Live& live) {
  const Look machine(live);
  const Code& code = machine->code();
  const Address address = machine->state().pc;
  const Block& block = code.blocks[address];
  return py::make_tuple(code.name_of(code.program_at(address)), sequence_number(block.n),
                        block.line);
}

/// Return why the program had not ended.
py::dict endless(Live& live) {
  const Look machine(live);
  Endless found;
  work_away([&](InterruptCheck& interrupt) {
    found = machine->endless([&] { return interrupt.requested(kLookBytes); });
  });
  const Code& code = machine->code();
  py::list blocks;
  for (const Address address : found.blocks) {
    const Program& program = code.programs[static_cast<std::size_t>(code.program_at(address))];
    const Block& block = code.blocks[address];
    blocks.append(py::make_tuple(code.name_of(program), sequence_number(block.n), block.line,
                                 code.files[program.file].name,
                                 std::string(code.text_of(block, program))));
  }
  py::dict facts;
  facts["kind"] = std::string(to_string(found.kind));
  facts["proven"] = found.proven;
  facts["period"] = found.period;
  facts["looked"] = found.looked;
  facts["outside"] = found.outside;
  facts["blocks"] = py::tuple(blocks);
  facts["changing"] = py::tuple(py::cast(found.changing));
  facts["then"] = found.then == Stop::Running ? py::object(py::none())
                                              : py::cast(std::string(to_string(found.then)));
  return facts;
}

template <class Pairs>
py::dict dict_of(const Pairs& pairs) {
  py::dict values;
  for (const auto& [name, value] : pairs) values[py::cast(name)] = value;
  return values;
}

void raise(const Fault& fault) { throw py::key_error(fault.detail); }

int level_or_present(const Machine& machine, int level) {
  const int present = machine.state().level;
  if (level > present) throw py::index_error("no such level");
  return level < 0 ? present : level;
}

py::object get_variable(Live& live, std::int64_t number, int level) {
  const Look machine(live);
  double value = 0;
  if (auto fault = machine->read(number, level_or_present(*machine, level), value)) raise(*fault);
  return value_or_none(value);
}

/// Return one value of a variable that has a name, as its type is in Python.
py::object named_value(const Machine& machine, DefinedVariable::Type type, double value) {
  if (is_vacant(value)) value = 0;
  const auto whole = to_whole<std::int64_t>(value);
  switch (type) {
    case DefinedVariable::Type::Real:
    case DefinedVariable::Type::Frame:  // of a parameter: no variable is shown as one
      break;
    case DefinedVariable::Type::Int:
    case DefinedVariable::Type::Char:
      return py::int_(whole);
    case DefinedVariable::Type::Bool:
      return py::bool_(value != 0);
    case DefinedVariable::Type::Text:
      return py::str(machine.text(value));
    case DefinedVariable::Type::Axis:
      return py::str(axis_letter(value));
  }
  return py::float_(value);
}

/// Return an array as lists in each other, from `at` on, which goes past it.
py::object named_array(const Machine& machine, const NamedValues& of, std::size_t dimension,
                       const double*& at) {
  if (dimension == of.extents.size()) return named_value(machine, of.variable->type, *at++);
  py::list list;
  for (std::int32_t i = 0; i < of.extents[dimension]; ++i)
    list.append(named_array(machine, of, dimension + 1, at));
  return list;
}

py::dict named_variables(Live& live, int level) {
  const Look machine(live);
  py::dict named;
  for (const NamedValues& of : machine->named(level_or_present(*machine, level))) {
    const double* at = of.values;
    const py::str name(of.variable->name);
    if (!named.contains(name)) named[name] = named_array(*machine, of, 0, at);
  }
  return named;
}

void set_variable(Live& live, std::int64_t number, std::optional<double> value, int level) {
  const Work machine(live);
  if (auto fault =
          machine->write(number, level_or_present(*machine, level), value.value_or(kVacant)))
    raise(*fault);
}

double get_signal(Live& live, std::int64_t number) {
  const Look machine(live);
  if (!is_signal(machine->code(), number))
    throw py::key_error("#" + std::to_string(number) + " is not a signal on " +
                        machine->code().control->name);
  const auto& signals = machine->state().signals;
  const auto found = signals.find(static_cast<std::int32_t>(number));
  return found == signals.end() ? 0 : found->second;
}

void set_signal(Live& live, std::int32_t number, double value) {
  const Work machine(live);
  if (!is_signal(machine->code(), number))
    throw py::key_error("#" + std::to_string(number) + " is not a signal on " +
                        machine->code().control->name);
  machine->set_from_outside(number, value);
}

/// Add the functions that run a machine and return its position.
void add_run(MachineClass& machine) {
  machine.def("run", &run)
      .def("run_blocks", &run_blocks, py::arg("blocks"))
      .def("step", &step, py::arg("row"))
      .def("copy", [](Live& live) { return std::make_shared<Live>(*Look(live)); })
      .def(
          "pause",
          [](Live& live, bool for_good) {
            int none = Live::kNone;
            if (for_good)
              live.pause = Live::kForGood;
            else
              live.pause.compare_exchange_strong(none, Live::kMoment);
          },
          py::arg("for_good") = true)
      .def("has_run", [](const Live& live, const Code& code) { return live.has_run(code); })
      .def("interrupt", [](Live& live) { Work(live)->interrupt(); })
      .def("take",
           [](Live& live) {
             const Work machine(live);
             return Record(machine->shared_code(), machine->take());
           })
      .def_property_readonly("trace",
                             [](const std::shared_ptr<Live>& live) { return Record(live); })
      .def_property_readonly(
          "code", [](const Live& live) { return std::const_pointer_cast<Code>(live.code()); })
      .def_property_readonly("stop", &stop_of)
      .def_property_readonly("waiting_for",
                             [](Live& live) { return Look(live)->state().waiting_for; })
      .def("endless", &endless)
      .def_property_readonly("alarm", &last_alarm)
      .def_property_readonly("stack", &stack_of)
      .def_property_readonly("position_in_program", &position_in_program)
      .def_property_readonly("blocks", [](Live& live) { return Look(live)->blocks(); })
      .def_property_readonly("axes",
                             [](Live& live) {
                               py::list names;
                               for (const char axis : Look(live)->axes())
                                 names.append(std::string(1, static_cast<char>(axis | 0x20)));
                               return names;
                             })
      .def_property_readonly("memory", [](Live& live) { return Look(live)->memory(); })
      .def("reset", [](Live& live) { Work(live)->reset(); })
      .def_property_readonly(
          "position", [](Live& live) { return dict_of(position(Look(live)->motion().view())); })
      .def_property_readonly(
          "position_in_machine",
          [](Live& live) { return dict_of(position_in_machine(Look(live)->motion().view())); })
      .def_property_readonly("modal",
                             [](Live& live) { return dict_of(modal(Look(live)->motion().view())); })
      .def_property_readonly("inch", [](Live& live) { return g20(Look(live)->motion().state()); });
}

/// Add its variables and signals.
void add_variables(MachineClass& machine) {
  machine
      .def(
          "variables",
          [](Live& live, int level) {
            const Look machine(live);
            return dict_of(machine->variables(level_or_present(*machine, level)));
          },
          py::arg("level") = -1)
      .def("named_variables", &named_variables, py::arg("level") = -1)
      .def("get_variable", &get_variable, py::arg("number"), py::arg("level") = -1)
      .def("set_variable", &set_variable, py::arg("number"), py::arg("value"),
           py::arg("level") = -1)
      .def(
          "can_be_vacant",
          [](Live& live, std::int64_t number) { return can_be_vacant(Look(live)->code(), number); },
          py::arg("number"))
      .def_property_readonly("signals",
                             [](Live& live) { return dict_of(Look(live)->state().signals); })
      .def("get_signal", &get_signal, py::arg("number"))
      .def("set_signal", &set_signal, py::arg("number"), py::arg("value"))
      .def(
          "cleared_by_reset",
          [](Live& live, std::int64_t number) {
            return cleared_by_reset(Look(live)->code(), number);
          },
          py::arg("number"))
      .def_property_readonly("level", [](Live& live) { return Look(live)->state().level; });
}

}  // namespace

void add_machine(py::module_& m) {
  MachineClass machine(m, "Machine", py::is_final());
  add_run(machine);
  add_variables(machine);
  add_debugging(machine);
  m.def("mode_names", &mode_names);
  m.def("machine", &make_machine, py::arg("code"), py::arg("main"));
}

}  // namespace cncsub::bindings
