#include "cncsub/machine.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>

#include "bindings.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

py::object value_or_none(double value) {
  return is_vacant(value) ? py::object(py::none()) : py::object(py::float_(value));
}

template <class T>
T get(const py::dict& from, const char* key, T otherwise) {
  return from.contains(key) ? from[key].cast<T>() : otherwise;
}

double number_or_vacant(const py::handle& value) {
  return value.is_none() ? kVacant : value.cast<double>();
}

Inputs inputs_of(const py::dict& from) {
  Inputs inputs;
  inputs.signals = get(from, "signals", inputs.signals);
  inputs.clock_ms = get(from, "clock_ms", 0.0);
  inputs.date = get(from, "date", 0.0);
  inputs.time = get(from, "time", 0.0);
  inputs.skips = get(from, "skips", inputs.skips);
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
  if (from.contains("tools"))
    for (const auto& [number, values] : from["tools"].cast<py::dict>()) {
      Setup::Tool tool;
      for (const auto& [key, value] : values.cast<py::dict>()) {
        const auto name = key.cast<std::string>();
        if (name == "tip")
          tool.tip = static_cast<int>(value.cast<double>());
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

std::unique_ptr<Machine> make_machine(const std::shared_ptr<Code>& code, std::int32_t main,
                                      bool mdi, std::optional<std::int64_t> start,
                                      const std::optional<py::dict>& variables,
                                      const std::vector<int>& block_skip, bool optional_stop,
                                      std::int64_t max_cycles, std::int64_t max_blocks,
                                      std::optional<double> max_seconds, const std::string& trace,
                                      const std::optional<py::dict>& inputs,
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
  options.trace = depth_of(trace);
  if (inputs) options.inputs = inputs_of(*inputs);
  if (setup) options.setup = setup_of(*setup);
  return std::make_unique<Machine>(code, main, std::move(options));
}

/// Runs without the GIL; takes it now and then to let Ctrl-C in.
void run(Machine& machine, const std::optional<std::pair<std::int64_t, std::int64_t>>& until) {
  bool raised = false;
  const std::int64_t first = machine.blocks();
  std::function<bool(const Machine&)> pause;
  if (until)
    pause = [&](const Machine& m) {
      if (m.blocks() == first) return false;
      if (until->first < 0) return m.depth() <= until->second;
      const Code& code = m.code();
      return code.program_at(m.address()) == until->first &&
             code.blocks[m.address()].line == until->second;
    };
  {
    py::gil_scoped_release release;
    machine.run(
        [&] {
          py::gil_scoped_acquire acquire;
          raised = PyErr_CheckSignals() != 0;
          if (raised) PyErr_Clear();
          return raised;
        },
        pause);
  }
}

template <class T, class Value>
py::array_t<T> step_array(const Machine& machine, Value&& value) {
  const auto& steps = machine.trace().steps;
  py::array_t<T> array(static_cast<py::ssize_t>(steps.size()));
  T* out = array.mutable_data();
  py::gil_scoped_release release;
  steps.for_each_run([&](const Trace::Step* rows, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) *out++ = static_cast<T>(value(rows[i]));
  });
  return array;
}

std::int32_t depth_of_call(const Machine& machine, std::int32_t call) {
  return call < 0 ? 0 : machine.trace().calls[static_cast<std::size_t>(call)].depth;
}

py::array step_column(const Machine& machine, const std::string& name) {
  const Code& code = machine.code();
  if (name == "step") {
    py::array_t<std::int64_t> array(static_cast<py::ssize_t>(machine.trace().steps.size()));
    for (py::ssize_t i = 0; i < array.size(); ++i) array.mutable_data()[i] = i;
    return array;
  }
  if (name == "program") {
    std::int32_t last = 0;  // most steps lie in the program of the step before
    return step_array<std::int32_t>(machine, [&, last](const Trace::Step& s) mutable {
      const Program& guess = code.programs[static_cast<std::size_t>(last)];
      if (s.address < guess.first || s.address > guess.last) last = code.program_at(s.address);
      return last;
    });
  }
  if (name == "n")
    return step_array<std::int32_t>(machine,
                                    [&](const Trace::Step& s) { return code.blocks[s.address].n; });
  if (name == "line")
    return step_array<std::int32_t>(
        machine, [&](const Trace::Step& s) { return code.blocks[s.address].line; });
  if (name == "depth")
    return step_array<std::int32_t>(
        machine, [&](const Trace::Step& s) { return depth_of_call(machine, s.call); });
  if (name == "frame")
    return step_array<std::int32_t>(machine, [](const Trace::Step& s) { return s.call; });
  if (name == "repeat")
    return step_array<std::int32_t>(machine, [](const Trace::Step& s) { return s.repeat; });
  throw py::key_error(name);
}

py::tuple step_row(const Machine& machine, std::size_t index) {
  if (index >= machine.trace().steps.size()) throw py::index_error("no such step");
  const Trace::Step step = machine.trace().steps[index];
  const Code& code = machine.code();
  const Block& block = code.blocks[step.address];
  return py::make_tuple(index,
                        code.programs[static_cast<std::size_t>(code.program_at(step.address))].name,
                        sequence_number(block.n), block.line, depth_of_call(machine, step.call),
                        step.call, step.repeat);
}

py::array call_column(const Machine& machine, const std::string& name) {
  const auto& calls = machine.trace().calls;
  const auto column = [&](auto value) {
    py::array_t<std::int64_t> array(static_cast<py::ssize_t>(calls.size()));
    std::int64_t* out = array.mutable_data();
    calls.for_each_run([&](const CallRow* rows, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) *out++ = static_cast<std::int64_t>(value(rows[i]));
    });
    return array;
  };
  const auto codes = [&](auto value) {
    py::array_t<std::int32_t> array(static_cast<py::ssize_t>(calls.size()));
    std::int32_t* out = array.mutable_data();
    calls.for_each_run([&](const CallRow* rows, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) *out++ = static_cast<std::int32_t>(value(rows[i]));
    });
    return array;
  };
  if (name == "call") {
    std::int64_t next = 0;
    return column([next](const CallRow&) mutable { return next++; });
  }
  if (name == "parent") return column([](const CallRow& c) { return c.parent; });
  if (name == "kind") return codes([](const CallRow& c) { return static_cast<int>(c.kind); });
  if (name == "program") return codes([](const CallRow& c) { return c.program; });
  if (name == "start_n") return column([](const CallRow& c) { return c.start_n; });
  if (name == "repeats") return column([](const CallRow& c) { return c.repeats; });
  if (name == "level") return column([](const CallRow& c) { return c.level; });
  if (name == "first_step") return column([](const CallRow& c) { return c.first_step; });
  if (name == "last_step") return column([](const CallRow& c) { return c.last_step; });
  if (name == "caller_step") return column([](const CallRow& c) { return c.caller_step; });
  throw py::key_error(name);
}

py::tuple call_row(const Machine& machine, std::size_t index) {
  if (index >= machine.trace().calls.size()) throw py::index_error("no such call");
  const CallRow call = machine.trace().calls[index];
  return py::make_tuple(index, call.parent, std::string(to_string(call.kind)),
                        machine.code().programs[static_cast<std::size_t>(call.program)].name,
                        sequence_number(call.start_n), call.repeats, call.level, call.first_step,
                        call.last_step, call.caller_step);
}

py::array move_column(const Machine& machine, const std::string& name) {
  const Moves& moves = machine.trace().moves;
  const auto rows = static_cast<py::ssize_t>(moves.size());
  const bool whole = name == "move" || name == "step" || name == "kind" || name == "plane" ||
                     name == "tool" || name == "h" || name == "d" || name == "feed_mode";
  if (whole) {
    py::array_t<std::int64_t> array(rows);
    std::int64_t* out = array.mutable_data();
    py::gil_scoped_release release;
    moves.column(name, out);
    return array;
  }
  py::array_t<double> array(rows);
  double* out = array.mutable_data();
  bool known = false;
  {
    py::gil_scoped_release release;
    known = moves.column(name, out);
  }
  if (!known) throw py::key_error(name);
  return array;
}

std::string axis_name(char axis, const char* before = "") {
  return before + std::string(1, static_cast<char>(axis - 'A' + 'a'));
}

py::dict move_row(const Machine& machine, std::size_t index) {
  if (index >= machine.trace().moves.size()) throw py::index_error("no such move");
  const MoveRow row = machine.trace().moves.row(index);
  py::dict fields;
  fields["move"] = index;
  fields["step"] = row.step;
  fields["kind"] = std::string(to_string(row.kind));
  std::string axes = "XYZ";
  for (const char axis : machine.trace().moves.axes())
    if (axes.find(axis) == std::string::npos) axes += axis;
  for (const char axis : axes) {
    const auto place = kAxisNames.find(axis);
    fields[py::str(axis_name(axis))] = row.point[place];
    fields[py::str(axis_name(axis, "m"))] = row.machine[place];
  }
  fields["cx"] = row.centre[0];
  fields["cy"] = row.centre[1];
  fields["cz"] = row.centre[2];
  fields["plane"] = row.state == nullptr ? 0 : row.state->plane;
  fields["feed"] = row.state == nullptr ? 0 : row.state->feed;
  fields["spindle"] = row.spindle;
  fields["tool"] = row.state == nullptr ? 0 : row.state->tool;
  fields["feed_mode"] = row.state == nullptr ? 0 : static_cast<int>(row.state->feed_mode);
  fields["h"] = row.state == nullptr ? 0 : row.state->h;
  fields["d"] = row.state == nullptr ? 0 : row.state->d;
  fields["length"] = row.length;
  fields["time"] = row.time;
  return fields;
}

py::dict bounds_of(const Machine& machine) {
  py::dict bounds;
  const Moves& moves = machine.trace().moves;
  const Moves::Bounds box = moves.bounds();
  for (const char axis : moves.axes()) {
    const auto place = kAxisNames.find(axis);
    if (!std::isnan(box.low[place]))
      bounds[py::str(axis_name(axis))] = py::make_tuple(box.low[place], box.high[place]);
  }
  return bounds;
}

py::dict variables_of(const Machine& machine, int level) {
  if (level > machine.level()) throw py::index_error("no such level");
  py::dict values;
  for (const auto& [number, value] : machine.variables(level < 0 ? machine.level() : level))
    values[py::int_(number)] = value;
  return values;
}

void raise(const Fault& fault) { throw py::key_error(fault.detail); }

int level_or_present(const Machine& machine, int level) {
  if (level > machine.level()) throw py::index_error("no such level");
  return level < 0 ? machine.level() : level;
}

}  // namespace

void add_machine(py::module_& m) {
  py::class_<Machine>(m, "Machine", py::is_final())
      .def(py::init(&make_machine), py::arg("code"), py::arg("main"), py::kw_only(),
           py::arg("mdi") = false, py::arg("start") = py::none(), py::arg("variables") = py::none(),
           py::arg("block_skip") = std::vector<int>{}, py::arg("optional_stop") = false,
           py::arg("max_cycles") = 1, py::arg("max_blocks") = 10'000'000,
           py::arg("max_seconds") = py::none(), py::arg("trace") = "moves",
           py::arg("inputs") = py::none(), py::arg("setup") = py::none())
      .def("run", &run, py::arg("until") = py::none())
      .def("step", &Machine::step)
      .def("copy", [](const Machine& machine) { return std::make_unique<Machine>(machine); })
      .def_property_readonly("code",
                             [](const Machine& machine) {
                               return std::const_pointer_cast<Code>(machine.shared_code());
                             })
      .def_property_readonly(
          "stop",
          [](const Machine& machine) {
            return machine.stop() == Stop::Running
                       ? py::object(py::none())
                       : py::object(py::str(std::string(to_string(machine.stop()))));
          })
      .def_property_readonly("waiting_for", &Machine::waiting_for)
      .def_property_readonly("alarm",
                             [](const Machine& machine) {
                               return machine.alarm() ? py::cast(*machine.alarm())
                                                      : py::object(py::none());
                             })
      .def_property_readonly("stack",
                             [](const Machine& machine) {
                               const auto frames = machine.frames();
                               py::tuple rows(frames.size());
                               for (std::size_t i = 0; i < frames.size(); ++i)
                                 rows[i] = py::cast(frames[i]);
                               return rows;
                             })
      .def_property_readonly(
          "position_in_program",
          [](const Machine& machine) {
            const Code& code = machine.code();
            const Block& block = code.blocks[machine.address()];
            return py::make_tuple(
                code.programs[static_cast<std::size_t>(code.program_at(machine.address()))].name,
                sequence_number(block.n), block.line);
          })
      .def_property_readonly("blocks", &Machine::blocks)
      .def_property_readonly("steps",
                             [](const Machine& machine) { return machine.trace().steps.size(); })
      .def("step_row", &step_row, py::arg("index"))
      .def("step_column", &step_column, py::arg("name"))
      .def_property_readonly("program_names",
                             [](const Machine& machine) {
                               std::vector<std::string> names;
                               for (const Program& program : machine.code().programs)
                                 names.push_back(program.name);
                               return names;
                             })
      .def_property_readonly("calls",
                             [](const Machine& machine) { return machine.trace().calls.size(); })
      .def("call_row", &call_row, py::arg("index"))
      .def("call_column", &call_column, py::arg("name"))
      .def_property_readonly("kind_names",
                             [](const Machine&) {
                               std::vector<std::string> names;
                               for (int i = 0; i <= static_cast<int>(CallKind::Ascii); ++i)
                                 names.emplace_back(to_string(static_cast<CallKind>(i)));
                               return names;
                             })
      .def(
          "call_arguments",
          [](const Machine& machine, std::size_t index) {
            if (index >= machine.trace().calls.size()) throw py::index_error("no such call");
            py::dict values;
            for (const auto& [number, value] : machine.arguments(index))
              values[py::int_(number)] = value_or_none(value);
            return values;
          },
          py::arg("index"))
      .def_property_readonly("moves",
                             [](const Machine& machine) { return machine.trace().moves.size(); })
      .def("move_row", &move_row, py::arg("index"))
      .def("move_column", &move_column, py::arg("name"))
      .def_property_readonly("move_kinds",
                             [](const Machine&) {
                               std::vector<std::string> names;
                               for (int i = 0; i <= static_cast<int>(MoveKind::Dwell); ++i)
                                 names.emplace_back(to_string(static_cast<MoveKind>(i)));
                               return names;
                             })
      .def_property_readonly("move_axes",
                             [](const Machine& machine) {
                               std::vector<std::string> names;
                               for (const char axis : machine.trace().moves.axes())
                                 names.push_back(axis_name(axis));
                               return names;
                             })
      .def_property_readonly("path_length",
                             [](const Machine& machine) { return machine.trace().moves.length(); })
      .def_property_readonly("time", [](const Machine& machine) { return machine.motion().time(); })
      .def_property_readonly("bounds", &bounds_of)
      .def_property_readonly("m_codes",
                             [](const Machine& machine) { return machine.trace().m_codes; })
      .def_property_readonly("t_codes",
                             [](const Machine& machine) { return machine.trace().t_codes; })
      .def_property_readonly("messages",
                             [](const Machine& machine) { return machine.trace().messages; })
      .def("variables", &variables_of, py::arg("level") = -1)
      .def(
          "get_variable",
          [](Machine& machine, std::int64_t number, int level) {
            double value = 0;
            if (auto fault = machine.read_at(number, level_or_present(machine, level), value))
              raise(*fault);
            return value_or_none(value);
          },
          py::arg("number"), py::arg("level") = -1)
      .def(
          "set_variable",
          [](Machine& machine, std::int64_t number, std::optional<double> value, int level) {
            if (auto fault = machine.write_at(number, level_or_present(machine, level),
                                              value.value_or(kVacant)))
              raise(*fault);
          },
          py::arg("number"), py::arg("value"), py::arg("level") = -1)
      .def("reset", &Machine::reset)
      .def("cleared_by_reset", &Machine::cleared_by_reset, py::arg("number"))
      .def_property_readonly("level", &Machine::level)
      .def_property_readonly("position",
                             [](const Machine& machine) {
                               py::dict values;
                               for (const auto& [axis, value] : machine.motion().position())
                                 values[py::str(axis)] = value;
                               return values;
                             })
      .def_property_readonly("modal", [](const Machine& machine) {
        py::dict values;
        for (const auto& [group, code] : machine.motion().modal()) values[py::str(group)] = code;
        return values;
      });
}

}  // namespace cncsub::bindings
