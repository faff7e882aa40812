// What a run executes as a flat program, piece by piece.
#include "cncsub/flat/flat.hpp"

#include <pybind11/stl.h>

#include <cstring>
#include <memory>
#include <mutex>

#include "bindings.hpp"
#include "gil.hpp"
#include "live.hpp"
#include "rows.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

/// One caller works on it at a time.
struct Flattening {
  Flattening(const Machine& machine, bool comments) : run(machine, comments) {}

  FlatRun run;
  std::mutex at_work;
};

py::object column(const std::vector<std::int32_t>& values) {
  const Array<std::int32_t> array(values.size());
  if (!values.empty()) std::memcpy(array.data, values.data(), values.size() * sizeof(values[0]));
  return array.object;
}

/// The next piece: its text and the columns of its origins. None where nothing more comes.
py::object next(Flattening& self) {
  const std::unique_lock only(self.at_work, std::try_to_lock);
  if (!only) throw std::runtime_error("the flat program is being written in another thread");
  std::string text;
  FlatOrigins origins;
  bool more = false;
  {
    Away away;
    const auto interrupted = [] { return PyErr_CheckSignals() != 0; };
    more = self.run.next([&] { return away.ask(interrupted); }, text, origins);
  }
  if (PyErr_Occurred() != nullptr) throw py::error_already_set();
  if (!more) return py::none();
  py::dict columns;
  columns["program"] = column(origins.program);
  columns["n"] = column(origins.n);
  columns["line"] = column(origins.line);
  columns["call"] = column(origins.call);
  columns["pass"] = column(origins.repeat);
  return py::make_tuple(py::bytes(text), columns);
}

/// Why the text ends before the run does: the reason, and program, n and line; None where it is
/// whole.
py::object refusal(const Flattening& self) {
  const auto& refused = self.run.refusal();
  if (!refused) return py::none();
  const Code& code = self.run.machine().code();
  const Block& block = code.blocks[refused->at];
  return py::make_tuple(refused->reason, code.name_of(code.program_at(refused->at)),
                        sequence_number(block.n), block.line);
}

}  // namespace

void add_flat(py::module_& m) {
  py::class_<Flattening>(m, "Flattening", py::is_final())
      .def("next", &next)
      .def_property_readonly("refusal", &refusal)
      .def_property_readonly("ends", [](const Flattening& self) { return self.run.ends(); })
      .def_property_readonly(
          "stop",
          [](const Flattening& self) { return std::string(to_string(self.run.machine().stop())); })
      .def_property_readonly(
          "waiting_for",
          [](const Flattening& self) { return self.run.machine().state().waiting_for; })
      .def_property_readonly("alarm",
                             [](const Flattening& self) {
                               const auto& alarm = self.run.machine().alarm();
                               return alarm ? py::cast(*alarm) : py::object(py::none());
                             })
      .def_property_readonly("program_names", [](const Flattening& self) {
        const Code& code = self.run.machine().code();
        py::list names;
        for (const Program& program : code.programs) names.append(code.name_of(program));
        return names;
      });
  m.def(
      "flattening",
      [](Live& live, bool comments) {
        return std::make_unique<Flattening>(*Look(live), comments);
      },
      py::arg("machine"), py::arg("comments"));
}

}  // namespace cncsub::bindings
