#include <pybind11/stl.h>

#include <algorithm>
#include <limits>

#include "bindings.hpp"
#include "cncsub/control/alias.hpp"
#include "cncsub/control/control.hpp"
#include "cncsub/control/source.hpp"
#include "cncsub/control/spelled.hpp"
#include "cncsub/control/variable_table.hpp"
#include "cncsub/dialect/asked.hpp"
#include "cncsub/dialect/dialect.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

constexpr const char* kWithParameters = R"(with_parameters(parameters)

The control with parameters changed: a mapping from number, or number and bit, to value.

Raises `ValueError` for a parameter that the control does not have, and suggests similar ones.

>>> import cncsub
>>> control = cncsub.controls["fanuc-0i-f"].with_parameters({"6050": 70, "6001#5": 1})
>>> control.parameters["6050"].value
70.0
)";

constexpr const char* kReplace = R"(replace(**rules)

The control with rules changed, by the names that `control.rules` shows.

An entry is added to a list (`g_meanings="68.2=neutral"`), removed (`"-68.2"`), or the list is given
as a whole (`"= 0 1 2"`). `commons` is always given as a whole: ranges of variable numbers, and
names of `control.variable_options`. Raises `ValueError` with the entry that is wrong and similar ones.

>>> import cncsub
>>> control = cncsub.controls["mitsubishi-m700"].replace(commons="100-199 500-999 900000-907399")
>>> cncsub.loads("O1\n#900000=7\nM30\n", control=control).run().variables[900000]
7.0
>>> control.replace(commons="199-100")
Traceback (most recent call last):
ValueError: commons: 199-100 ends before it begins: write 100-199
)";
constexpr const char* kFromToml = R"(from_toml(path)

A control of your own, made from a built-in one by a TOML file.

The file has `name` and `base`, and can have `title` and the tables `rules`, `parameters`, `calls`
(codes that call programs) and `alarms`; each value alone, or with a `note` that says where it comes
from. Without a `name` it has only `base`, `rules` and `parameters`, and makes what `replace` and
`with_parameters` make. The same can be the table `control` of `cncsub.toml`. Raises
`ValueError` for what a control cannot be, with the file and the key.

>>> import cncsub, pathlib, tempfile
>>> file = pathlib.Path(tempfile.mkdtemp()) / "our-mill.toml"
>>> _ = file.write_text(
...     'name = "our-mill"\n'
...     'base = "fanuc-0i-f"\n'
...     'rules.max_nesting = {value = 4, note = "the sheet of the builder, page 12"}\n'
...     'calls.M60 = "macro-call:9020"\n'
... )
>>> control = cncsub.Control.from_toml(file)
>>> control.name, control.base
('our-mill', 'fanuc-0i-f')
>>> next(rule.source for rule in control.rules if rule.name == "max_nesting")
'the sheet of the builder, page 12'
>>> text = "O1\nM60\nM30\nO9020\n#500=7\nM99\n"
>>> cncsub.loads(text, control=control).run().variables[500]
7.0
)";
constexpr const char* kToToml = R"(to_toml()

The control as the TOML that `from_toml` reads: its base, and what differs.

A changed control without a name of its own is written without one: it is its base with changes.
Two controls are equal if they answer alike, wherever their answers come from.

>>> import cncsub, pathlib, tempfile
>>> control = cncsub.controls["fanuc-0i-f"].replace(max_nesting=3)
>>> control
<Control fanuc-0i-f + max_nesting=3: FANUC Series 0i-F>
>>> control.to_toml().splitlines()
['base = "fanuc-0i-f"', '', '[rules]', 'max_nesting = 3']
>>> file = pathlib.Path(tempfile.mkdtemp()) / "shallow.toml"
>>> _ = file.write_text(control.to_toml(), encoding="utf-8")
>>> cncsub.Control.from_toml(file) == control
True
)";
constexpr const char* kAbsent = R"(The groups of rules that the control does not have.

Each with its source and evidence: a control without macros has no rule of macros.

>>> import cncsub
>>> control = cncsub.controls["gsk-928te"]
>>> list(control.absent), {"macros"} & {rule.group for rule in control.rules}
(['macros'], set())
>>> control.replace(max_loops=2)
Traceback (most recent call last):
ValueError: gsk-928te has no rules of macros, such as max_loops: general knowledge: no macro statements
)";
constexpr const char* kVariableOptions =
    R"(Variables that are an option of the control, by the name of the option.

Each has `meaning`, `numbers`, `fitted` (whether the control has them all as it is set), `source`,
`evidence`, and the `rule` by which `replace` fits it: `commons`, whose options name all commons of
a control, or `variable_options`, whose options are added.

>>> import cncsub
>>> option = cncsub.controls["mitsubishi-m700"].variable_options["700-sets"]
>>> option.numbers, option.fitted, option.rule
('100-199 400-999', False, 'commons')
>>> control = cncsub.controls["fanuc-0i-f"].replace(variable_options="work-offsets-by-axis")
>>> cncsub.loads("O1\n#2501=5\n#100=#5221\nM30\n", control=control).run().variables[100]
5.0
)";

struct ParameterRow : Parameter {
  bool used = false;
};

struct AlarmRow {
  std::string cause;
  AlarmEntry entry;
};
struct VariableOptionRow {
  VariableOption option;
  bool fitted = false;
};

/// The alarm of a user's own control; an empty field is as in the base.
struct OwnAlarm {
  std::string slug;
  std::optional<std::string> number, text;
  std::string source;
};
using OwnRuleRow = std::tuple<std::string, py::object, std::string>;
using OwnParameterRow = std::tuple<std::string, double, std::string>;
using OwnAlarmRow =
    std::tuple<std::string, std::optional<std::string>, std::optional<std::string>, std::string>;

py::object object_of(const RuleValue& value) {
  return std::visit([](const auto& held) -> py::object { return py::cast(held); }, value);
}
py::object value_of(const RuleView& rule) { return object_of(rule.value); }

py::tuple texts(const std::vector<Option>& options, std::string_view Option::* part) {
  py::tuple list(options.size());
  for (std::size_t i = 0; i < options.size(); ++i) list[i] = py::str(std::string(options[i].*part));
  return list;
}

std::string shown(const py::handle& value) { return py::repr(value).cast<std::string>(); }

std::string type_of(const py::handle& value) {
  return py::type::of(value).attr("__name__").cast<std::string>();
}

/// Return a number of Python or NumPy; nothing for a text or a value that is no number.
std::optional<double> number_of(const py::handle& value) {
  if (!PyNumber_Check(value.ptr())) return std::nullopt;
  const double number = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred() == nullptr) return number;
  const bool large = PyErr_ExceptionMatches(PyExc_OverflowError) != 0;
  PyErr_Clear();
  return large ? std::optional(std::numeric_limits<double>::infinity()) : std::nullopt;
}

/// The source of what a caller has changed.
constexpr const char* kByCaller = "set by the caller";
/// The evidence of what users say of their own machine, which is no document that we have seen.
constexpr Evidence kBySomebody = Evidence::Secondary;

/// Set the source of a parameter of a user's own control.
void mark_parameter(Control& control, const std::string& name, const std::string& source) {
  for (Parameter& known : control.parameters)
    if (known.name == name) {
      known.source = source;
      known.evidence = kBySomebody;
    }
}

std::shared_ptr<Control> with_parameters(const Control& control, const py::object& parameters) {
  if (!py::isinstance<py::dict>(parameters) && !py::hasattr(parameters, "items"))
    throw py::type_error("with_parameters takes a mapping such as {'6050': 70}, not " +
                         type_of(parameters));
  auto changed = std::make_shared<Control>(control);
  for (const auto& [key, value] : py::dict(parameters)) {
    if (!py::isinstance<py::str>(key) || PyUnicode_AsUTF8(key.ptr()) == nullptr) {
      PyErr_Clear();  // error of a text with a lone surrogate
      throw py::type_error(
          "the name of a parameter must be a text such as '6050' or '6001#5', not " + shown(key));
    }
    const auto number = number_of(value);
    if (!number)
      throw py::type_error("parameter " + py::str(key).cast<std::string>() +
                           " must be a number, not " + shown(value));
    if (auto wrong = changed->set_parameter(key.cast<std::string>(), *number))
      throw py::value_error(*wrong);
    if (!control.base.empty()) mark_parameter(*changed, key.cast<std::string>(), kByCaller);
  }
  return changed;
}

RuleValue rule_value(const py::handle& value) {
  try {
    if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
    if (py::isinstance<py::int_>(value)) return value.cast<std::int64_t>();
    if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  } catch (const py::cast_error&) {  // more than 64 bits, or a lone surrogate
    throw py::value_error("a rule does not take " + shown(value));
  }
  throw py::type_error("a rule must be True or False, a whole number or a text, not " +
                       shown(value));
}

const Control& base_of(const std::string& name) {
  for (const Control& control : all_controls())
    if (control.name == name) return control;
  throw py::value_error("there is no control '" + name + "'");
}

const Control& base_of(const Control& control) {
  return base_of(control.base.empty() ? control.name : control.base);
}

/// Raise where no control has a rule of this name, with the names that are near.
void check_rule_name(const Control& control, const std::string& name) {
  const auto all = rules(Control());
  if (std::any_of(all.begin(), all.end(), [&](const RuleView& rule) { return rule.name == name; }))
    return;
  py::list names;
  for (const RuleView& rule : asked_rules(control)) names.append(rule.name);
  const auto near =
      py::module_::import("cncsub.controls")
          .attr("did_you_mean")(name, names,
                                "; `cncsub controls " + control.name + " --all` lists the rules");
  throw py::value_error("there is no rule " + name + near.cast<std::string>());
}

/// Set a rule as a caller asks, or raise what is wrong with its name or its value.
void change_rule(Control& control, const std::string& name, const RuleValue& value,
                 const std::string& source, Evidence evidence) {
  check_rule_name(control, name);
  if (auto wrong = never_asked(control, name)) throw py::value_error(*wrong);
  if (auto wrong = set_rule(control, name, value, source, evidence)) throw py::value_error(*wrong);
}

std::shared_ptr<Control> replace(const Control& control, const py::kwargs& changes) {
  auto changed = std::make_shared<Control>(control);
  for (const auto& [key, value] : changes) {
    const RuleValue to = rule_value(value);
    const auto name = key.cast<std::string>();
    change_rule(*changed, name, to, kByCaller, Evidence::Inferred);
  }
  return changed;
}

/// Return the value that sets a rule: a list with = in front replaces the list that is there.
py::object whole_of(const RuleView& rule) {
  const auto* text = std::get_if<std::string>(&rule.value);
  return text == nullptr || !rule.options.empty() ? value_of(rule) : py::str("=" + *text);
}

/// Return the entries of a list or a set that have a source of their own: entry -> (source,
/// evidence).
py::dict entries_of(const RuleView& rule) {
  py::dict rows;
  for (const EntrySource& reported : rule.entries)
    rows[py::str(reported.entry)] =
        py::make_tuple(reported.source, std::string(to_string(reported.evidence)));
  return rows;
}

Evidence evidence_of(const std::string& text) {
  for (const Evidence evidence : {Evidence::SourceDocument, Evidence::Manual, Evidence::Secondary})
    if (text == to_string(evidence)) return evidence;
  return Evidence::Inferred;
}

void set_alarm(Control& control, const OwnAlarm& own) {
  for (std::size_t i = 0; i < all_causes().size(); ++i) {
    if (all_causes()[i].slug != own.slug) continue;
    AlarmEntry& entry = control.alarms[static_cast<Cause>(i)];
    if (own.number) entry.number = *own.number;
    if (own.number) entry.directed.clear();
    if (own.text) entry.text = *own.text;
    entry.printed = entry.printed || own.text;
    entry.source = own.source;
    entry.evidence = kBySomebody;
    return;
  }
  throw py::value_error("there is no cause " + own.slug);
}

Evidence evidence_of_own(const std::string& source) {
  return source == kByCaller ? Evidence::Inferred : kBySomebody;
}

/// Make a control from a base with what differs, each difference with its source.
std::shared_ptr<Control> own_control(const Control& base, const std::string& name,
                                     const std::string& title,
                                     const std::vector<OwnRuleRow>& rules_of,
                                     const std::vector<OwnParameterRow>& parameters,
                                     const std::vector<OwnAlarmRow>& alarms) {
  auto control = std::make_shared<Control>(base);
  control->base = base.base.empty() ? base.name : base.base;
  control->name = name;
  control->title = title;
  for (const auto& [parameter, value, source] : parameters) {
    if (auto wrong = control->set_parameter(parameter, value)) throw py::value_error(*wrong);
    mark_parameter(*control, parameter, source);
  }
  for (const auto& [rule, value, source] : rules_of) {
    const RuleValue to = rule_value(value);
    change_rule(*control, rule, to, source, evidence_of_own(source));
  }
  for (const auto& [slug, number, text, source] : alarms)
    set_alarm(*control, {slug, number, text, source});
  return control;
}

/// Return the alarms of a user's own control that differ from its base, as own_control takes them.
std::vector<OwnAlarmRow> own_alarms(const Control& control, const Control& base) {
  std::vector<OwnAlarmRow> rows;
  for (const auto& [cause, entry] : control.alarms) {
    const AlarmEntry* const before = base.alarm(cause);
    if (before != nullptr && before->source == entry.source) continue;
    std::optional<std::string> number, text;
    if (before == nullptr || before->number != entry.number) number = entry.number;
    if (before == nullptr || before->text != entry.text) text = entry.text;
    rows.emplace_back(std::string(info(cause).slug), number, text, entry.source);
  }
  return rows;
}

// A changed control is pickled as its name and its changes, because the effects of parameters are
// code.
py::tuple state_of(const Control& control) {
  const Control& base = base_of(control);
  Control again = base;
  py::dict parameters, changes;
  for (const Parameter& p : control.parameters)
    if (p.value != base.parameter(p.name)) {
      parameters[py::str(p.name)] = p.value;
      again.set_parameter(p.name, p.value);
    }
  const auto now = rules(control), then = rules(again);
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i].value != then[i].value || now[i].source != then[i].source ||
        now[i].entries != then[i].entries)
      changes[py::str(now[i].name)] =
          py::make_tuple(whole_of(now[i]), now[i].source, entries_of(now[i]));
  if (control.base.empty()) return py::make_tuple(control.name, parameters, changes);
  std::vector<OwnParameterRow> noted;
  for (const Parameter& p : control.parameters)
    for (const Parameter& before : base.parameters)
      if (before.name == p.name && before.source != p.source)
        noted.emplace_back(p.name, p.value, p.source);
  return py::make_tuple(base.name, parameters, changes, control.name, control.title, noted,
                        own_alarms(control, base));
}

std::shared_ptr<Control> control_of(const py::tuple& state) {
  const bool own = state.size() == 7;
  if (!own && state.size() != 3) throw py::value_error("this is not a Control");
  const Control& base = base_of(state[0].cast<std::string>());
  auto control = with_parameters(base, state[1]);
  if (own)
    control = own_control(*control, state[3].cast<std::string>(), state[4].cast<std::string>(), {},
                          state[5].cast<std::vector<OwnParameterRow>>(),
                          state[6].cast<std::vector<OwnAlarmRow>>());
  for (const auto& [key, change] : py::dict(state[2])) {
    const auto reported = change.cast<py::tuple>();
    if (reported.size() != 3) throw py::value_error("this is not a Control");
    const auto source = reported[1].cast<std::string>();
    if (auto wrong = set_rule(*control, key.cast<std::string>(), rule_value(reported[0]), source,
                              own ? evidence_of_own(source) : Evidence::Inferred))
      throw py::value_error(*wrong);
    std::vector<EntrySource> entries;
    for (const auto& [entry, origin] : py::dict(reported[2])) {
      const auto pair = origin.cast<std::pair<std::string, std::string>>();
      entries.push_back({entry.cast<std::string>(), pair.first, evidence_of(pair.second)});
    }
    tell_entries(*control, key.cast<std::string>(), entries);
  }
  return control;
}

template <class T>
bool is_by_caller(const Rule<T>& rule) {
  return rule.source == kByCaller ||
         std::any_of(rule.entries.begin(), rule.entries.end(),
                     [](const EntrySource& entry) { return entry.source == kByCaller; });
}

/// Return whether a caller has changed a control since its file or its maker described it.
bool is_changed(const Control& control) {
#define RULE(group, type, name, value, meaning) \
  if (is_by_caller(control.group.name)) return true;
#include "cncsub/control/rules.def"
  const Control& base = base_of(control);
  return std::any_of(control.parameters.begin(), control.parameters.end(),
                     [&](const Parameter& parameter) {
                       if (!control.base.empty()) return parameter.source == kByCaller;
                       return parameter.value != base.parameter(parameter.name);
                     });
}

/// Return the name of a control, with what a caller has changed.
std::string whole_name(const Control& control) {
  if (!is_changed(control)) return control.name;
  return py::module_::import("cncsub.control_changes")
      .attr("name_of")(control.name, std::make_shared<Control>(control))
      .cast<std::string>();
}

/// Return whether two controls answer alike; where their answers come from does not count.
bool are_equal(const Control& a, const Control& b) {
  if (&a == &b) return true;
  if (a.name != b.name || a.base != b.base || a.title != b.title) return false;
#define RULE(group, type, name, value_of, meaning) \
  if (!(a.group.name.value == b.group.name.value)) return false;
#include "cncsub/control/rules.def"
  const auto same_value = [](const Parameter& one, const Parameter& other) {
    return one.name == other.name && one.value == other.value;
  };
  const auto same_alarm = [](const auto& one, const auto& other) {
    return one.first == other.first && one.second.number == other.second.number &&
           one.second.text == other.second.text;
  };
  return std::equal(a.parameters.begin(), a.parameters.end(), b.parameters.begin(),
                    b.parameters.end(), same_value) &&
         std::equal(a.alarms.begin(), a.alarms.end(), b.alarms.begin(), b.alarms.end(), same_alarm);
}

/// Return the hash of its names. Copies with other rules share it, and `are_equal` tells them
/// apart: the values of all rules would take a hundred times as long.
py::ssize_t hash_of(const Control& control) {
  return py::hash(py::make_tuple(control.name, control.base, control.title));
}

std::string written(double number) { return py::str("{:g}").format(number).cast<std::string>(); }

}  // namespace

void add_controls(py::module_& m) {
  m.def("control", &control_of, py::arg("state"));
  m.def("own_control", &own_control, py::arg("base"), py::arg("name"), py::arg("title"),
        py::arg("rules"), py::arg("parameters"), py::arg("alarms"));
  m.def("causes", [] {
    std::vector<std::tuple<std::string, std::string, std::string>> rows;
    for (const CauseInfo& cause : all_causes())
      rows.emplace_back(cause.slug, cause.meaning, spelled(cause.cure, Control()));
    return rows;
  });
  m.def("sources", [] {
    std::vector<std::tuple<std::string, std::string, std::string, std::string, std::string>> rows;
    for (const Source& s : all_sources())
      rows.emplace_back(s.key, s.title, s.address, s.about, to_string(s.evidence));
    return rows;
  });
  m.def("cited", [](const std::string& text) {
    std::vector<std::string> keys;
    for (const Source* source : cited(text)) keys.emplace_back(source->key);
    return keys;
  });
  m.def("strongest", [](const std::string& text, const std::string& control) {
    return std::string(to_string(strongest(text, control)));
  });
  py::class_<RuleView>(m, "Rule", py::is_final())
      .def_readonly("name", &RuleView::name)
      .def_readonly("group", &RuleView::group)
      .def_readonly("meaning", &RuleView::meaning)
      .def_readonly("source", &RuleView::source)
      .def_property_readonly("value", &value_of)
      .def_property_readonly("family", [](const RuleView& r) { return object_of(r.family); })
      .def_property_readonly("evidence",
                             [](const RuleView& r) { return std::string(to_string(r.evidence)); })
      .def_property_readonly("choices",
                             [](const RuleView& r) { return texts(r.options, &Option::slug); })
      .def_property_readonly("entries",
                             [](const RuleView& r) { return texts(r.members, &Option::slug); })
      .def_property_readonly("examples",
                             [](const RuleView& r) {
                               return texts(r.options.empty() ? r.members : r.options,
                                            &Option::example);
                             })
      .def_property_readonly("sources", &entries_of)
      .def("__repr__", [](const RuleView& r) {
        return "<Rule " + r.name + " = " + py::repr(value_of(r)).cast<std::string>() + ">";
      });
  py::class_<ParameterRow>(m, "Parameter", py::is_final())
      .def_readonly("name", &Parameter::name)
      .def_readonly("value", &Parameter::value)
      .def_readonly("meaning", &Parameter::meaning)
      .def_readonly("source", &Parameter::source)
      .def_property_readonly(
          "evidence", [](const ParameterRow& p) { return std::string(to_string(p.evidence)); })
      .def_property_readonly("rule",
                             [](const ParameterRow& p) {
                               return p.sets.empty() ? py::object(py::none())
                                                     : py::str(p.sets.front().rule);
                             })
      .def_property_readonly("rules",
                             [](const ParameterRow& p) {
                               py::tuple names(p.sets.size());
                               for (std::size_t i = 0; i < p.sets.size(); ++i)
                                 names[i] = p.sets[i].rule;
                               return names;
                             })
      .def_readonly(
          "used", &ParameterRow::used,
          "Whether cncsub computes anything from it; if not, it is only the value that a program "
          "can read, as by PRM[].")
      .def("__repr__", [](const ParameterRow& p) {
        return "<Parameter " + p.name + " = " + written(p.value) + ": " + p.meaning + ">";
      });
  py::class_<AlarmRow>(m, "AlarmEntry", py::is_final())
      .def_readonly("cause", &AlarmRow::cause)
      .def_property_readonly("number", [](const AlarmRow& a) { return a.entry.number; })
      .def_property_readonly("text", [](const AlarmRow& a) { return text_or_none(a.entry.text); })
      .def_property_readonly("printed", [](const AlarmRow& a) { return a.entry.printed; })
      .def_property_readonly("directed",
                             [](const AlarmRow& a) {
                               py::dict rows;
                               for (const DirectedNumber& one : a.entry.directed)
                                 rows[py::str(one.direction)] =
                                     py::make_tuple(one.number, text_or_none(one.text));
                               return rows;
                             })
      .def_property_readonly("source", [](const AlarmRow& a) { return a.entry.source; })
      .def_property_readonly(
          "evidence", [](const AlarmRow& a) { return std::string(to_string(a.entry.evidence)); })
      .def("__repr__", [](const AlarmRow& a) {
        return "<AlarmEntry " + (a.entry.number.empty() ? "" : a.entry.number + " ") + a.cause +
               ">";
      });
  py::class_<VariableOptionRow>(m, "VariableOption", py::is_final())
      .def_property_readonly("name", [](const VariableOptionRow& v) { return v.option.name; })
      .def_property_readonly("meaning", [](const VariableOptionRow& v) { return v.option.meaning; })
      .def_property_readonly("numbers",
                             [](const VariableOptionRow& v) { return numbers_of(v.option); })
      .def_property_readonly("rule",
                             [](const VariableOptionRow& v) {
                               return v.option.commons.empty() ? "variable_options" : "commons";
                             })
      .def_readonly("fitted", &VariableOptionRow::fitted)
      .def_property_readonly("source", [](const VariableOptionRow& v) { return v.option.source; })
      .def_property_readonly(
          "evidence",
          [](const VariableOptionRow& v) { return std::string(to_string(v.option.evidence)); })
      .def("__repr__", [](const VariableOptionRow& v) {
        return "<VariableOption " + v.option.name + ": " + numbers_of(v.option) +
               (v.fitted ? ", fitted>" : ">");
      });
  // Python writes no signature above these docstrings, because they begin with their own.
  py::options plain;
  plain.disable_function_signatures();
  py::class_<Control, std::shared_ptr<Control>>(m, "Control", py::is_final())
      .def_property_readonly("name", &whole_name)
      .def_readonly("title", &Control::title)
      .def_readonly("dialect", &Control::dialect)
      .def_property_readonly("precision",
                             [](const Control& c) { return find_dialect(c.dialect)->precision; })
      .def_property_readonly("base",
                             [](const Control& c) { return c.base.empty() ? c.name : c.base; })
      .def_property_readonly("rules",
                             [](const Control& c) {
                               const auto list = asked_rules(c);
                               py::tuple rows(list.size());
                               for (std::size_t i = 0; i < list.size(); ++i)
                                 rows[i] = py::cast(list[i]);
                               return rows;
                             })
      .def_property_readonly(
          "absent",
          [](const Control& c) {
            py::dict rows;
            for (const AbsentGroup& group : c.absent)
              rows[py::str(std::string(to_string(group.group)))] =
                  py::make_tuple(group.source, std::string(to_string(group.evidence)));
            return rows;
          },
          kAbsent)
      .def_property_readonly("parameters",
                             [](const Control& c) {
                               py::dict rows;
                               for (const Parameter& p : c.parameters)
                                 rows[py::str(p.name)] = py::cast(ParameterRow{p, c.uses(p)});
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
      .def_property_readonly(
          "variable_options",
          [](const Control& c) {
            py::dict rows;
            for (const VariableOption& option : c.variable_choices)
              rows[py::str(option.name)] =
                  py::cast(VariableOptionRow{option, is_fitted(c, option)});
            return rows;
          },
          kVariableOptions)
      .def(
          "with_parameters",
          [](const Control& c, const py::args& args, const py::kwargs& named) {
            const bool by_name = args.empty() && named.size() == 1 && named.contains("parameters");
            if (!by_name && (args.size() != 1 || !named.empty()))
              throw py::type_error("with_parameters takes one mapping, such as {'6050': 70}");
            return with_parameters(c, by_name ? py::object(named["parameters"]) : args[0]);
          },
          kWithParameters)
      .def(
          "replace",
          [](const Control& c, const py::args& args, const py::kwargs& changes) {
            if (!args.empty())
              throw py::type_error("replace takes rules by their names: max_nesting=10");
            return replace(c, changes);
          },
          kReplace)
      .def_static(
          "from_toml",
          [](const py::object& path) {
            return py::module_::import("cncsub.own_control").attr("from_toml")(path);
          },
          py::arg("path"), kFromToml)
      .def(
          "to_toml",
          [](const py::object& c) {
            return py::module_::import("cncsub.control_changes").attr("to_toml")(c);
          },
          kToToml)
      .def(
          "__eq__",
          [](const Control& c, const py::object& other) -> py::object {
            if (!py::isinstance<Control>(other))
              return py::reinterpret_borrow<py::object>(Py_NotImplemented);
            return py::bool_(are_equal(c, other.cast<const Control&>()));
          },
          py::arg("value"))
      .def("__hash__", &hash_of)
      .def("__copy__", [](const Control& c) { return std::make_shared<Control>(c); })
      .def(
          "__deepcopy__",
          [](const Control& c, const py::object&) { return std::make_shared<Control>(c); },
          py::arg("memo"))
      .def("__reduce__",
           [again = m.attr("control")](const Control& c) {
             return py::make_tuple(again, py::make_tuple(state_of(c)));
           })
      .def("__repr__",
           [](const Control& c) { return "<Control " + whole_name(c) + ": " + c.title + ">"; });
  m.def("aliases", [] {
    py::list rows;
    for (const Alias& alias : all_aliases())
      rows.append(py::make_tuple(std::string(alias.name), std::string(alias.control),
                                 std::string(alias.source),
                                 std::string(to_string(alias.evidence))));
    return rows;
  });
  m.def("controls", [] {
    std::vector<std::shared_ptr<Control>> list;
    for (const Control& control : all_controls())
      list.push_back(std::make_shared<Control>(control));
    return list;
  });
}

}  // namespace cncsub::bindings
