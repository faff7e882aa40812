#include "cncsub/machine.hpp"

#include <pybind11/stl.h>

#include <cmath>

#include "bindings.hpp"
#include "gil.hpp"
#include "live.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

template <class T>
T get(const py::dict& from, const char* key, T otherwise) {
  return from.contains(key) ? from[key].cast<T>() : otherwise;
}

double number_or_vacant(const py::handle& value) {
  return value.is_none() ? kVacant : value.cast<double>();
}

/// ("fraction", 0.5), ("never",) or an axis with its coordinate, ("X", 40.0).
SkipSignal skip_of(const py::tuple& from) {
  const auto kind = from[0].cast<std::string>();
  if (kind == "never") return {SkipSignal::Comes::Never};
  const auto value = from[1].cast<double>();
  if (kind == "fraction") return {SkipSignal::Comes::AtFraction, value};
  return {SkipSignal::Comes::AtCoordinate, value, static_cast<int>(kAxisNames.find(kind[0]))};
}

Solid solid_of(const py::dict& from) {
  Solid solid;
  const auto shape = from["shape"].cast<std::string>();
  solid.shape = shape == "plane"      ? Solid::Shape::Plane
                : shape == "box"      ? Solid::Shape::Box
                : shape == "cylinder" ? Solid::Shape::Cylinder
                                      : Solid::Shape::Sphere;
  solid.hole = get(from, "hole", false);
  solid.signal = get(from, "signal", 0);
  solid.at = get(from, "at", solid.at);
  solid.direction = get(from, "direction", solid.direction);
  solid.low = get(from, "low", solid.low);
  solid.high = get(from, "high", solid.high);
  solid.radius = get(from, "radius", 0.0);
  solid.first = get(from, "first", solid.first);
  solid.last = get(from, "last", solid.last);
  return solid;
}

std::shared_ptr<const Workpiece> workpiece_of(const py::dict& from) {
  auto workpiece = std::make_shared<Workpiece>();
  for (const py::handle solid : from["solids"])
    workpiece->solids.push_back(solid_of(solid.cast<py::dict>()));
  workpiece->stylus = get(from, "stylus", 0.0);
  workpiece->by_end = get(from, "by_end", false);
  if (from.contains("length")) workpiece->length = from["length"].cast<double>();
  workpiece->system = get(from, "system", workpiece->system);
  return workpiece;
}

Inputs inputs_of(const py::dict& from) {
  Inputs inputs;
  inputs.signals = get(from, "signals", inputs.signals);
  inputs.clock_ms = get(from, "clock_ms", 0.0);
  inputs.date = get(from, "date", 0.0);
  inputs.time = get(from, "time", 0.0);
  if (from.contains("skips"))
    for (const auto& [signal, skips] : from["skips"].cast<py::dict>())
      for (const py::handle skip : skips)
        inputs.skips.at(signal.cast<std::size_t>()).push_back(skip_of(skip.cast<py::tuple>()));
  if (from.contains("workpiece")) inputs.workpiece = workpiece_of(from["workpiece"]);
  if (from.contains("answers"))
    for (const auto& [code, values] : from["answers"].cast<py::dict>()) {
      const auto name = code.cast<std::string>();
      for (const auto& [number, value] : values.cast<py::dict>())
        inputs.answers[{name[0], std::stoll(name.substr(1))}][number.cast<std::int32_t>()] =
            number_or_vacant(value);
    }
  if (from.contains("operator") && !from["operator"].is_none()) {
    inputs.operator_given = true;
    for (const py::handle answer : from["operator"])
      inputs.operator_starts.push_back(answer.cast<std::string>() == "start");
  }
  if (from.contains("writes"))
    for (const py::handle write : from["writes"]) {
      std::map<std::int32_t, double> values;
      for (const auto& [number, value] : write.cast<py::dict>())
        values[number.cast<std::int32_t>()] = number_or_vacant(value);
      inputs.writes.push_back(std::move(values));
    }
  return inputs;
}

char axis_of(const std::string& name) { return name.empty() ? ' ' : name[0]; }

std::map<char, double> axes_of(const py::handle& from) {
  std::map<char, double> axes;
  for (const auto& [axis, value] : from.cast<py::dict>())
    axes[axis_of(axis.cast<std::string>())] = value.cast<double>();
  return axes;
}

Setup setup_of(const py::dict& from) {
  Setup setup;
  setup.machine = get(from, "machine", std::string());
  setup.increment = get(from, "increment", 0.001);
  if (from.contains("start")) setup.start = axes_of(from["start"]);
  if (from.contains("rapid")) setup.rapid = axes_of(from["rapid"]);
  if (from.contains("work_offsets"))
    for (const auto& [name, axes] : from["work_offsets"].cast<py::dict>())
      setup.work_offsets[name.cast<std::string>()] = axes_of(axes);
  if (from.contains("reference"))
    for (const auto& [number, axes] : from["reference"].cast<py::dict>())
      setup.reference[number.cast<int>()] = axes_of(axes);
  setup.length_offsets = get(from, "length_offsets", setup.length_offsets);
  setup.radius_offsets = get(from, "radius_offsets", setup.radius_offsets);
  if (from.contains("limits"))
    for (const auto& [axis, limits] : from["limits"].cast<py::dict>())
      setup.limits[axis_of(axis.cast<std::string>())] = limits.cast<std::pair<double, double>>();
  if (from.contains("stroke_area"))
    for (const auto& [axis, range] : from["stroke_area"].cast<py::dict>())
      setup.area[axis_of(axis.cast<std::string>())] = range.cast<std::pair<double, double>>();
  if (from.contains("tools"))
    for (const auto& [number, values] : from["tools"].cast<py::dict>()) {
      Setup::Tool tool;
      for (const auto& [key, value] : values.cast<py::dict>()) {
        const auto name = key.cast<std::string>();
        if (name == "tip")
          tool.tip = to_whole<int>(value.cast<double>());
        else if (name == "R")
          tool.radius = value.cast<double>();
        else
          tool.values[axis_of(name)] = value.cast<double>();
      }
      setup.tools[number.cast<int>()] = tool;
    }
  return setup;
}

Trace::Depth depth_of(const std::string& name) {
  if (name == "none") return Trace::Depth::None;
  if (name == "calls") return Trace::Depth::Calls;
  if (name == "blocks") return Trace::Depth::Blocks;
  if (name == "moves") return Trace::Depth::Moves;
  throw py::value_error("trace is 'none', 'calls', 'blocks' or 'moves', not '" + name + "'");
}

/// G54.1 P49 is a work coordinate system of some controls only.
void check_systems(const Control& control, const Options& options) {
  const std::int32_t most = control.max_extra_systems.value;
  const Setup& setup = options.setup;
  const auto check = [&](const std::string& field, const std::string& name) {
    if (const auto p = name.find('P');
        p != std::string::npos && std::stol(name.substr(p + 1)) > most)
      throw py::value_error(field + ": " + control.name + " has no " + name +
                            (most > 0 ? "; the last is G54.1 P" + std::to_string(most) : ""));
  };
  if (options.inputs.workpiece) check("coordinates", options.inputs.workpiece->system);
  for (const auto& [name, values] : setup.work_offsets) check("work_offsets", name);
}

/// The numbers in the inputs must be those of signals, and of variables that can be written.
void check_inputs(const Machine& machine, const Inputs& inputs) {
  for (const auto& [number, value] : inputs.signals)
    if (!machine.is_signal(number))
      throw py::value_error("signals: #" + std::to_string(number) + " is no signal on " +
                            machine.code().control->name);
  const auto check = [&](const char* field, const std::map<std::int32_t, double>& values) {
    for (const auto& [number, value] : values)
      if (auto fault = machine.unwritable(number); fault && !machine.is_signal(number))
        throw py::value_error(field + (": " + fault->detail));
  };
  for (const auto& write : inputs.writes) check("writes", write);
  for (const auto& [code, values] : inputs.answers) check("answers", values);
}

std::shared_ptr<Live> make_machine(const std::shared_ptr<Code>& code, std::int32_t main, bool mdi,
                                   std::optional<std::int64_t> start,
                                   const std::optional<py::dict>& variables,
                                   const std::vector<int>& block_skip, bool optional_stop,
                                   std::int64_t max_cycles, std::int64_t max_blocks,
                                   std::optional<double> max_seconds,
                                   std::optional<std::uint64_t> max_memory,
                                   const std::string& trace, const std::optional<py::dict>& inputs,
                                   const std::optional<py::dict>& setup) {
  if (main < 0 || static_cast<std::size_t>(main) >= code->programs.size())
    throw py::index_error("no such program");
  Options options;
  options.mdi = mdi;
  options.start = start.value_or(-1);
  if (variables)
    for (const auto& [number, value] : *variables)
      options.variables[number.cast<std::int32_t>()] = number_or_vacant(value);
  for (const int number : block_skip) {
    if (number < 1 || number > 9)
      throw py::value_error("a block-skip switch is 1 to 9, not " + std::to_string(number));
    options.skips = static_cast<std::uint16_t>(options.skips | (1u << number));
  }
  options.optional_stop = optional_stop;
  options.max_cycles = max_cycles;
  options.max_blocks = max_blocks;
  options.max_seconds = max_seconds.value_or(0);
  if (max_memory) options.max_memory = *max_memory;
  options.trace = depth_of(trace);
  if (inputs) options.inputs = inputs_of(*inputs);
  if (setup) options.setup = setup_of(*setup);
  check_systems(*code->control, options);
  const Program& program = code->programs[static_cast<std::size_t>(main)];
  if (start && code->first_of(program, *start) == kNowhere)
    throw py::value_error("start: there is no block N" + std::to_string(*start) + " in " +
                          code->name_of(program));
  const auto given = options.variables;
  const Inputs around = options.inputs;
  auto live = std::make_shared<Live>(code, main, std::move(options));
  for (const auto& [number, value] : given)
    if (auto fault = live->machine.write(number, value))
      throw py::value_error("variables: " + fault->detail);
  check_inputs(live->machine, around);
  return live;
}

/// Runs without the GIL; takes it now and then to let Ctrl-C in, which stops the run. What another
/// signal's handler raises goes on.
template <class... Extent>
void run_released(Machine& machine, const Extent&... extent) {
  std::optional<py::error_already_set> other;
  {
    Away away;
    const auto interrupted = [&other] {
      if (PyErr_CheckSignals() == 0) return false;
      if (PyErr_ExceptionMatches(PyExc_KeyboardInterrupt) != 0)
        PyErr_Clear();
      else
        other.emplace();
      return true;
    };
    machine.run([&] { return away.ask(interrupted); }, extent...);
  }
  if (other) throw std::move(*other);
}

void run(Live& live, const std::optional<std::pair<std::int64_t, std::int64_t>>& until) {
  const Work machine(live);
  const std::int64_t first = machine->blocks();
  std::function<bool(const Machine&)> pause;
  if (until)
    pause = [&](const Machine& m) {
      if (m.blocks() == first) return false;
      if (until->first < 0) return m.depth() <= until->second;
      const Code& code = m.code();
      return code.program_at(m.address()) == until->first &&
             code.blocks[m.address()].line == until->second;
    };
  run_released(*machine, pause);
}

bool step(Live& live) {
  const Work machine(live);
  const bool done = machine->step([] { return PyErr_CheckSignals() != 0; });
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  return done;
}

void run_blocks(Live& live, std::int64_t blocks) {
  const Work machine(live);
  run_released(*machine, blocks);
}

py::object stop_of(Live& live) {
  const Stop stop = Look(live)->stop();
  return stop == Stop::Running ? py::object(py::none())
                               : py::object(py::str(std::string(to_string(stop))));
}

py::object alarm_of(Live& live) {
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
  const Block& block = code.blocks[machine->address()];
  return py::make_tuple(
      code.name_of(code.programs[static_cast<std::size_t>(code.program_at(machine->address()))]),
      sequence_number(block.n), block.line);
}

template <class Pairs>
py::dict dict_of(const Pairs& pairs) {
  py::dict values;
  for (const auto& [name, value] : pairs) values[py::cast(name)] = value;
  return values;
}

void raise(const Fault& fault) { throw py::key_error(fault.detail); }

int level_or_present(const Machine& machine, int level) {
  if (level > machine.level()) throw py::index_error("no such level");
  return level < 0 ? machine.level() : level;
}

py::object get_variable(Live& live, std::int64_t number, int level) {
  const Look machine(live);
  double value = 0;
  if (auto fault = machine->read_at(number, level_or_present(*machine, level), value))
    raise(*fault);
  return value_or_none(value);
}

void set_variable(Live& live, std::int64_t number, std::optional<double> value, int level) {
  const Work machine(live);
  if (auto fault =
          machine->write_at(number, level_or_present(*machine, level), value.value_or(kVacant)))
    raise(*fault);
}

double get_signal(Live& live, std::int64_t number) {
  const Look machine(live);
  if (!machine->is_signal(number))
    throw py::key_error("#" + std::to_string(number) + " is no signal on " +
                        machine->code().control->name);
  const auto found = machine->signals().find(static_cast<std::int32_t>(number));
  return found == machine->signals().end() ? 0 : found->second;
}

void set_signal(Live& live, std::int32_t number, double value) {
  const Work machine(live);
  if (!machine->is_signal(number))
    throw py::key_error("#" + std::to_string(number) + " is no signal on " +
                        machine->code().control->name);
  machine->set_from_outside(number, value);
}

}  // namespace

void add_machine(py::module_& m) {
  py::class_<Live, std::shared_ptr<Live>>(m, "Machine", py::is_final())
      .def("run", &run, py::arg("until") = py::none())
      .def("run_blocks", &run_blocks, py::arg("blocks"))
      .def("step", &step)
      .def("copy", [](Live& live) { return std::make_shared<Live>(*Look(live)); })
      .def("interrupt", [](Live& live) { Work(live)->interrupt(); })
      .def("take",
           [](Live& live) {
             const Work machine(live);
             return Record(machine->shared_code(), machine->take());
           })
      .def_property_readonly("trace",
                             [](const std::shared_ptr<Live>& live) { return Record(live); })
      .def_property_readonly("code",
                             [](const Live& live) {
                               return std::const_pointer_cast<Code>(live.machine.shared_code());
                             })
      .def_property_readonly("stop", &stop_of)
      .def_property_readonly("waiting_for", [](Live& live) { return Look(live)->waiting_for(); })
      .def_property_readonly("alarm", &alarm_of)
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
      .def(
          "variables",
          [](Live& live, int level) {
            const Look machine(live);
            return dict_of(machine->variables(level_or_present(*machine, level)));
          },
          py::arg("level") = -1)
      .def("get_variable", &get_variable, py::arg("number"), py::arg("level") = -1)
      .def("set_variable", &set_variable, py::arg("number"), py::arg("value"),
           py::arg("level") = -1)
      .def(
          "can_be_vacant",
          [](Live& live, std::int64_t number) { return Look(live)->can_be_vacant(number); },
          py::arg("number"))
      .def_property_readonly("signals", [](Live& live) { return dict_of(Look(live)->signals()); })
      .def("get_signal", &get_signal, py::arg("number"))
      .def("set_signal", &set_signal, py::arg("number"), py::arg("value"))
      .def("reset", [](Live& live) { Work(live)->reset(); })
      .def(
          "cleared_by_reset",
          [](Live& live, std::int64_t number) { return Look(live)->cleared_by_reset(number); },
          py::arg("number"))
      .def_property_readonly("level", [](Live& live) { return Look(live)->level(); })
      .def_property_readonly("position",
                             [](Live& live) { return dict_of(Look(live)->motion().position()); })
      .def_property_readonly("modal",
                             [](Live& live) { return dict_of(Look(live)->motion().modal()); });
  m.def("machine", &make_machine, py::arg("code"), py::arg("main"), py::kw_only(),
        py::arg("mdi") = false, py::arg("start") = py::none(), py::arg("variables") = py::none(),
        py::arg("block_skip") = std::vector<int>{}, py::arg("optional_stop") = false,
        py::arg("max_cycles") = 1, py::arg("max_blocks") = 10'000'000,
        py::arg("max_seconds") = py::none(), py::arg("max_memory") = py::none(),
        py::arg("trace") = "moves", py::arg("inputs") = py::none(), py::arg("setup") = py::none());
}

}  // namespace cncsub::bindings
