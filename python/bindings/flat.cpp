// The flat program of a run, piece by piece.
#include "cncsub/flat/flat.hpp"

#include <pybind11/stl.h>

#include <cstring>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "bindings.hpp"
#include "gil.hpp"
#include "live.hpp"
#include "rows.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

/// The state of a flat program. One caller works on it at a time.
struct Flattening {
  Flattening(const Machine& machine, bool comments, std::optional<Machine> of_other)
      : other(std::move(of_other)), run(machine, comments, other ? &*other : nullptr) {}

  std::optional<Machine> other;  // of the control that the program is written for
  FlatRun run;
  std::mutex at_work;
};

py::object column(const std::vector<std::int32_t>& values) {
  const Array<std::int32_t> array(values.size());
  if (!values.empty()) std::memcpy(array.data, values.data(), values.size() * sizeof(values[0]));
  return array.object;
}

/// Exclusive access to the run; it throws where another thread has it.
class Resting {
 public:
  explicit Resting(Flattening& self) : only_(self.at_work, std::try_to_lock), run_(self.run) {
    if (!only_) throw std::runtime_error("the flat program is being written in another thread");
  }
  FlatRun* operator->() const { return &run_; }

 private:
  std::unique_lock<std::mutex> only_;
  FlatRun& run_;
};

/// Return the next piece: its text and the columns of its origins; None at the end.
py::object next(Flattening& self) {
  const Resting run(self);
  std::string text;
  FlatOrigins origins;
  bool more = false;
  {
    GilRelease away;
    const auto interrupted = [] { return PyErr_CheckSignals() != 0; };
    more = run->next([&] { return away.ask(interrupted); }, text, origins);
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

/// Return why the text ends before the run does: the reason, and program, n and line (None where it
/// is no single block); None where the text is complete.
py::object refusal(Flattening& self) {
  const Resting run(self);
  const auto& refused = run->refusal();
  if (!refused) return py::none();
  if (refused->at == kNowhere)
    return py::make_tuple(refused->reason, py::none(), py::none(), py::none());
  const Code& code = run->machine().code();
  const Block& block = code.blocks[refused->at];
  return py::make_tuple(refused->reason, code.name_of(code.program_at(refused->at)),
                        sequence_number(block.n), block.line);
}

}  // namespace

void add_flat(py::module_& m) {
  py::class_<Flattening, std::shared_ptr<Flattening>>(m, "Flattening", py::is_final())
      .def("next", &next)
      .def_property_readonly("refusal", &refusal)
      .def_property_readonly("ends", [](Flattening& self) { return Resting(self)->ends(); })
      .def_property_readonly(
          "stop",
          [](Flattening& self) { return std::string(to_string(Resting(self)->machine().stop())); })
      .def_property_readonly(
          "waiting_for",
          [](Flattening& self) { return Resting(self)->machine().state().waiting_for; })
      .def_property_readonly("alarm",
                             [](Flattening& self) {
                               const Resting run(self);
                               const auto& alarm = run->machine().alarm();
                               return alarm ? py::cast(*alarm) : py::object(py::none());
                             })
      .def_property_readonly("program_names", [](Flattening& self) {
        const Resting run(self);
        const Code& code = run->machine().code();
        py::list names;
        for (const Program& program : code.programs) names.append(code.name_of(program));
        return names;
      });
  m.def(
      "flattening",
      [](Live& live, bool comments, Live* other) {
        std::optional<Machine> copy;
        if (other != nullptr) copy.emplace(*Look(*other));
        return std::make_shared<Flattening>(*Look(live), comments, std::move(copy));
      },
      py::arg("machine"), py::arg("comments"), py::arg("other") = py::none());
}

}  // namespace cncsub::bindings
