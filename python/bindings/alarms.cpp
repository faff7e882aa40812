#include <pybind11/stl.h>

#include <algorithm>

#include "bindings.hpp"
#include "cncsub/control/alarm.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

// Alarms are values: they can be compared, copied and sent to another process.
py::tuple state_of(const Frame& f) {
  return py::make_tuple(f.program, f.n, f.line, f.file, f.kind, f.called, f.repeat, f.repeats);
}
Frame frame_of(const py::tuple& state) {
  if (state.size() != 8) throw py::value_error("this is not a Frame");
  return {state[0].cast<std::string>(),   state[1].cast<std::int64_t>(),
          state[2].cast<std::uint32_t>(), state[3].cast<std::string>(),
          state[4].cast<std::string>(),   state[5].cast<std::string>(),
          state[6].cast<std::int64_t>(),  state[7].cast<std::int64_t>()};
}

py::tuple state_of(const Alarm& a) {
  py::list frames;
  for (const Frame& frame : a.frames) frames.append(state_of(frame));
  return py::make_tuple(std::string(info(a.cause).slug), a.number, a.text, a.program, a.n, a.line,
                        a.column, a.width, a.word, a.file, a.detail, a.source_line, frames);
}
Alarm alarm_from(const py::tuple& state) {
  if (state.size() != 13) throw py::value_error("this is not an Alarm");
  Alarm alarm;
  const auto slug = state[0].cast<std::string>();
  const auto& causes = all_causes();
  const auto found = std::find_if(causes.begin(), causes.end(),
                                  [&](const CauseInfo& cause) { return cause.slug == slug; });
  if (found == causes.end()) throw py::value_error("there is no cause " + slug);
  alarm.cause = static_cast<Cause>(found - causes.begin());
  alarm.number = state[1].cast<std::string>();
  alarm.text = state[2].cast<std::string>();
  alarm.program = state[3].cast<std::string>();
  alarm.n = state[4].cast<std::int64_t>();
  alarm.line = state[5].cast<std::uint32_t>();
  alarm.column = state[6].cast<std::uint32_t>();
  alarm.width = state[7].cast<std::uint32_t>();
  alarm.word = state[8].cast<std::string>();
  alarm.file = state[9].cast<std::string>();
  alarm.detail = state[10].cast<std::string>();
  alarm.source_line = state[11].cast<std::string>();
  for (const py::handle frame : state[12])
    alarm.frames.push_back(frame_of(frame.cast<py::tuple>()));
  return alarm;
}

/// Return the value that pickling and copying need.
template <class Value>
py::tuple reduced(const py::object& again, const Value& value) {
  return py::make_tuple(again, py::make_tuple(state_of(value)));
}

}  // namespace

void add_alarms(py::module_& m) {
  m.def("frame", &frame_of, py::arg("state"));
  m.def("alarm", &alarm_from, py::arg("state"));
  py::class_<Frame>(m, "Frame", py::is_final())
      .def_readonly("program", &Frame::program)
      .def_property_readonly("n", [](const Frame& f) { return sequence_number(f.n); })
      .def_readonly("line", &Frame::line)
      .def_readonly("file", &Frame::file)
      .def_readonly("kind", &Frame::kind)
      .def_readonly("called", &Frame::called)
      .def_readonly("repeat", &Frame::repeat)
      .def_readonly("repeats", &Frame::repeats)
      .def(
          "__eq__", [](const Frame& a, const Frame& b) { return a == b; }, py::is_operator())
      .def("__hash__", [](const Frame& f) { return py::hash(state_of(f)); })
      .def("__reduce__", [again = m.attr("frame")](const Frame& f) { return reduced(again, f); })
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
      .def(
          "__eq__", [](const Alarm& a, const Alarm& b) { return a == b; }, py::is_operator())
      .def("__hash__", [](const Alarm& a) { return py::hash(py::str(message(a))); })
      .def("__reduce__", [again = m.attr("alarm")](const Alarm& a) { return reduced(again, a); })
      .def("__str__", [](const Alarm& a) { return message(a); })
      .def("__repr__", [](const Alarm& a) {
        return "<Alarm " + (a.number.empty() ? "" : a.number + " ") +
               std::string(info(a.cause).slug) + " at " + a.program +
               (a.n < 0 ? "" : " N" + std::to_string(a.n)) + ">";
      });
}

}  // namespace cncsub::bindings
