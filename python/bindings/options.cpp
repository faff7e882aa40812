#include "options.hpp"

#include <pybind11/stl.h>

#include <memory>

#include "cncsub/code/variable_faults.hpp"
#include "cncsub/machine/values/variables.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

template <class T>
T get(const py::dict& from, const char* key, T otherwise) {
  return from.contains(key) ? from[key].cast<T>() : otherwise;
}

/// Return a skip signal from ("fraction", 0.5), ("never",) or an axis with its coordinate, ("X",
/// 40.0).
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

char axis_of(const std::string& name) { return name.empty() ? ' ' : name[0]; }

std::map<char, double> axes_of(const py::handle& from) {
  std::map<char, double> axes;
  for (const auto& [axis, value] : from.cast<py::dict>())
    axes[axis_of(axis.cast<std::string>())] = value.cast<double>();
  return axes;
}

}  // namespace

double number_or_vacant(const py::handle& value) {
  return value.is_none() ? kVacant : value.cast<double>();
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

static void read_edge(const py::dict& from, Setup::Edge& edge) {
  for (const auto& [key, value] : from) {
    const auto name = key.cast<std::string>();
    if (name == "tip")
      edge.tip = to_whole<int>(value.cast<double>());
    else if (name == "R")
      edge.radius = value.cast<double>();
    else if (name != "name" && name != "edges")
      edge.values[axis_of(name)] = value.cast<double>();
  }
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
      read_edge(values.cast<py::dict>(), tool);
      if (values.contains("name")) tool.name = values["name"].cast<std::string>();
      if (values.contains("edges"))
        for (const auto& [edge, offsets] : values["edges"].cast<py::dict>())
          read_edge(offsets.cast<py::dict>(), tool.edges[edge.cast<int>()]);
      setup.tools[number.cast<int>()] = tool;
    }
  return setup;
}

Trace::Depth depth_of(const std::string& name) {
  if (name == "none") return Trace::Depth::None;
  if (name == "calls") return Trace::Depth::Calls;
  if (name == "blocks") return Trace::Depth::Blocks;
  if (name == "moves") return Trace::Depth::Moves;
  throw py::value_error("trace must be 'none', 'calls', 'blocks' or 'moves', not '" + name + "'");
}

std::uint16_t switches_of(const py::handle& from) {
  std::uint16_t switches = 0;
  for (const int number : from.cast<std::vector<int>>()) {
    if (number < 1 || number > Options::kSwitches)
      throw py::value_error("a block-skip switch must be 1 to 10, not " + std::to_string(number));
    switches = static_cast<std::uint16_t>(switches | (1u << number));
  }
  return switches;
}

namespace {

std::map<std::int32_t, double> variables_of(const py::handle& from) {
  std::map<std::int32_t, double> variables;
  for (const auto& [number, value] : from.cast<py::dict>())
    variables[number.cast<std::int32_t>()] = number_or_vacant(value);
  return variables;
}

using Take = void (*)(Options& options, const py::handle& value);

/// Return the options by their names in Python, each with the function that stores it.
const std::map<std::string, Take>& takes() {
  static const std::map<std::string, Take> rows = {
      {"mode", [](Options& o, const py::handle& v) { o.mdi = v.cast<std::string>() == "mdi"; }},
      {"start", [](Options& o, const py::handle& v) { o.start = v.cast<std::int64_t>(); }},
      {"variables", [](Options& o, const py::handle& v) { o.variables = variables_of(v); }},
      {"block_skip", [](Options& o, const py::handle& v) { o.skips = switches_of(v); }},
      {"optional_stop", [](Options& o, const py::handle& v) { o.optional_stop = v.cast<bool>(); }},
      {"max_cycles",
       [](Options& o, const py::handle& v) { o.max_cycles = v.cast<std::int64_t>(); }},
      {"max_blocks",
       [](Options& o, const py::handle& v) { o.max_blocks = v.cast<std::int64_t>(); }},
      {"max_seconds", [](Options& o, const py::handle& v) { o.max_seconds = v.cast<double>(); }},
      {"max_memory",
       [](Options& o, const py::handle& v) { o.max_memory = v.cast<std::uint64_t>(); }},
      {"trace", [](Options& o, const py::handle& v) { o.trace = depth_of(v.cast<std::string>()); }},
      {"conditions", [](Options& o, const py::handle& v) { o.conditions = v.cast<bool>(); }},
      {"inputs", [](Options& o, const py::handle& v) { o.inputs = inputs_of(v.cast<py::dict>()); }},
      {"setup", [](Options& o, const py::handle& v) { o.setup = setup_of(v.cast<py::dict>()); }},
      {"watch",
       [](Options& o, const py::handle& v) { o.watch = v.cast<std::vector<std::int32_t>>(); }},
  };
  return rows;
}

}  // namespace

Options options_of(const py::dict& from) {
  Options options;
  for (const auto& [key, value] : from) {
    const auto name = key.cast<std::string>();
    const auto row = takes().find(name);
    if (row == takes().end()) throw py::type_error("a machine has no option " + name);
    try {
      if (!value.is_none()) row->second(options, value);
    } catch (const py::cast_error&) {
      throw py::type_error("the value has the wrong type for the option " + name);
    }
  }
  return options;
}

void refuse(const char* option, const std::string& why) {
  const py::object error = py::reinterpret_borrow<py::object>(PyExc_ValueError)(why);
  error.attr("option") = option;
  PyErr_SetObject(PyExc_ValueError, error.ptr());
  throw py::error_already_set();
}

void check_systems(const Control& control, const Options& options) {
  const std::int32_t most = control.motion.max_extra_systems.value;
  const Setup& setup = options.setup;
  const auto check = [&](const char* option, const std::string& field, const std::string& name) {
    if (has_system(control, name)) return;
    const int codes = control.motion.extra_system_codes.value;
    const std::string last = codes > 0
                                 ? "; its extra systems are codes after G" + std::to_string(codes)
                             : name.find('P') != std::string::npos && most > 0
                                 ? "; the last is G54.1 P" + std::to_string(most)
                                 : "";
    refuse(option, field + ": " + control.name + " has no " + name + last);
  };
  if (options.inputs.workpiece && options.inputs.workpiece->system != "machine")
    check("inputs", "coordinates", options.inputs.workpiece->system);
  for (const auto& [name, values] : setup.work_offsets) check("setup", "work_offsets", name);
}

void check_inputs(const Code& code, const Inputs& inputs) {
  for (const auto& [number, value] : inputs.signals)
    if (!is_signal(code, number))
      refuse("inputs",
             "signals: #" + std::to_string(number) + " is not a signal on " + code.control->name);
  const auto check = [&](const char* field, const std::map<std::int32_t, double>& values) {
    for (const auto& [number, value] : values)
      if (auto fault = unwritable(code, number); fault && !is_signal(code, number))
        refuse("inputs", field + (": " + fault->detail));
  };
  for (const auto& write : inputs.writes) check("writes", write);
  for (const auto& [code, values] : inputs.answers) check("answers", values);
}

}  // namespace cncsub::bindings
