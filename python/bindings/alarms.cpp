#include <pybind11/stl.h>

#include "bindings.hpp"
#include "cncsub/alarm.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

void add_alarms(py::module_& m) {
  py::class_<Frame>(m, "Frame", py::is_final())
      .def_readonly("program", &Frame::program)
      .def_property_readonly("n", [](const Frame& f) { return sequence_number(f.n); })
      .def_readonly("line", &Frame::line)
      .def_readonly("file", &Frame::file)
      .def_readonly("kind", &Frame::kind)
      .def_readonly("called", &Frame::called)
      .def_readonly("repeat", &Frame::repeat)
      .def_readonly("repeats", &Frame::repeats)
      .def("__repr__", [](const Frame& f) {
        return "<Frame " + f.called + " called from " + f.program +
               (f.n < 0 ? "" : " N" + std::to_string(f.n)) + " (" + f.kind + ", pass " +
               std::to_string(f.repeat) + " of " + std::to_string(f.repeats) + ")>";
      });
  py::class_<Alarm>(m, "Alarm", py::is_final())
      .def_property_readonly("cause",
                             [](const Alarm& a) { return std::string(info(a.cause).slug); })
      .def_property_readonly("number", [](const Alarm& a) { return text_or_none(a.number); })
      .def_property_readonly("text", [](const Alarm& a) { return text_or_none(a.text); })
      .def_readonly("program", &Alarm::program)
      .def_property_readonly("n", [](const Alarm& a) { return sequence_number(a.n); })
      .def_readonly("line", &Alarm::line)
      .def_readonly("column", &Alarm::column)
      .def_readonly("word", &Alarm::word)
      .def_readonly("file", &Alarm::file)
      .def_readonly("detail", &Alarm::detail)
      .def_property_readonly("frames",
                             [](const Alarm& a) {
                               py::tuple rows(a.frames.size());
                               for (std::size_t i = 0; i < a.frames.size(); ++i)
                                 rows[i] = py::cast(a.frames[i]);
                               return rows;
                             })
      .def("__str__", [](const Alarm& a) { return message(a); })
      .def("__repr__", [](const Alarm& a) {
        return "<Alarm " + (a.number.empty() ? "" : a.number + " ") +
               std::string(info(a.cause).slug) + " at " + a.program +
               (a.n < 0 ? "" : " N" + std::to_string(a.n)) + ">";
      });
}

}  // namespace cncsub::bindings
