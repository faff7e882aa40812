#include <pybind11/stl.h>

#include <cctype>

#include "bindings.hpp"
#include "cncsub/control.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

struct AlarmRow {
  std::string cause;
  AlarmEntry entry;
};

py::object value_of(const RuleView& rule) {
  return std::visit([](const auto& value) -> py::object { return py::cast(value); }, rule.value);
}

py::tuple texts(const std::vector<Option>& options, std::string_view Option::* part) {
  py::tuple list(options.size());
  for (std::size_t i = 0; i < options.size(); ++i) list[i] = py::str(std::string(options[i].*part));
  return list;
}

bool is_parameter_name(const std::string& name) {
  std::size_t digits = 0, bits = 0, hashes = 0;
  for (const char c : name) {
    if (c == '#')
      ++hashes;
    else if (std::isdigit(static_cast<unsigned char>(c)) != 0)
      ++(hashes == 0 ? digits : bits);
    else
      return false;
  }
  return digits > 0 && hashes <= 1 && (hashes == 0 || bits == 1 || bits == 2);
}

std::shared_ptr<Control> with_parameters(const Control& control,
                                         const std::map<std::string, double>& parameters) {
  auto changed = std::make_shared<Control>(control);
  for (const auto& [name, value] : parameters) {
    if (!is_parameter_name(name))
      throw py::value_error(
          "'" + name +
          "' is no parameter: write its number, as '6050', or number and bit, as '6001#5'");
    if (auto wrong = changed->set_parameter(name, value)) throw py::value_error(*wrong);
  }
  return changed;
}

RuleValue rule_value(const py::handle& value) {
  try {
    if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
    if (py::isinstance<py::int_>(value)) return value.cast<std::int64_t>();
    if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  } catch (const py::cast_error&) {  // beyond 64 bits, or no characters
    throw py::value_error("a rule does not take " + py::repr(value).cast<std::string>());
  }
  throw py::type_error("a rule is True or False, a whole number or a text");
}

std::shared_ptr<Control> replace(const Control& control, const py::kwargs& changes) {
  auto changed = std::make_shared<Control>(control);
  for (const auto& [key, value] : changes) {
    const RuleValue to = rule_value(value);
    if (auto wrong = set_rule(*changed, key.cast<std::string>(), to)) throw py::value_error(*wrong);
  }
  return changed;
}

}  // namespace

void add_controls(py::module_& m) {
  m.def("causes", [] {
    std::vector<std::tuple<std::string, std::string, std::string>> rows;
    for (const CauseInfo& cause : all_causes())
      rows.emplace_back(cause.slug, cause.meaning, cause.cure);
    return rows;
  });
  py::class_<RuleView>(m, "Rule", py::is_final())
      .def_readonly("name", &RuleView::name)
      .def_readonly("meaning", &RuleView::meaning)
      .def_readonly("source", &RuleView::source)
      .def_property_readonly("value", &value_of)
      .def_property_readonly("evidence",
                             [](const RuleView& r) { return std::string(to_string(r.evidence)); })
      .def_property_readonly("choices",
                             [](const RuleView& r) { return texts(r.options, &Option::slug); })
      .def_property_readonly("examples",
                             [](const RuleView& r) { return texts(r.options, &Option::example); })
      .def("__repr__", [](const RuleView& r) {
        return "<Rule " + r.name + " = " + py::repr(value_of(r)).cast<std::string>() + ">";
      });
  py::class_<Parameter>(m, "Parameter", py::is_final())
      .def_readonly("name", &Parameter::name)
      .def_readonly("value", &Parameter::value)
      .def_readonly("meaning", &Parameter::meaning)
      .def_readonly("source", &Parameter::source)
      .def_property_readonly("evidence",
                             [](const Parameter& p) { return std::string(to_string(p.evidence)); });
  py::class_<AlarmRow>(m, "AlarmEntry", py::is_final())
      .def_readonly("cause", &AlarmRow::cause)
      .def_property_readonly("number", [](const AlarmRow& a) { return a.entry.number; })
      .def_property_readonly("text", [](const AlarmRow& a) { return text_or_none(a.entry.text); })
      .def_property_readonly("source", [](const AlarmRow& a) { return a.entry.source; })
      .def_property_readonly(
          "evidence", [](const AlarmRow& a) { return std::string(to_string(a.entry.evidence)); });
  py::class_<Control, std::shared_ptr<Control>>(m, "Control", py::is_final())
      .def_readonly("name", &Control::name)
      .def_readonly("title", &Control::title)
      .def_property_readonly("rules",
                             [](const Control& c) {
                               const auto list = rules(c);
                               py::tuple rows(list.size());
                               for (std::size_t i = 0; i < list.size(); ++i)
                                 rows[i] = py::cast(list[i]);
                               return rows;
                             })
      .def_property_readonly("parameters",
                             [](const Control& c) {
                               py::dict rows;
                               for (const Parameter& p : c.parameters)
                                 rows[py::str(p.name)] = py::cast(p);
                               return rows;
                             })
      .def_property_readonly("alarms",
                             [](const Control& c) {
                               py::dict rows;
                               for (const auto& [cause, entry] : c.alarms) {
                                 const std::string slug(info(cause).slug);
                                 rows[py::str(slug)] = py::cast(AlarmRow{slug, entry});
                               }
                               return rows;
                             })
      .def("with_parameters", &with_parameters, py::arg("parameters"))
      .def("replace", &replace)
      .def("__copy__", [](const Control& c) { return std::make_shared<Control>(c); })
      .def("__repr__",
           [](const Control& c) { return "<Control " + c.name + ": " + c.title + ">"; });
  m.def("controls", [] {
    std::vector<std::shared_ptr<Control>> list;
    for (const Control& control : all_controls())
      list.push_back(std::make_shared<Control>(control));
    return list;
  });
}

}  // namespace cncsub::bindings
