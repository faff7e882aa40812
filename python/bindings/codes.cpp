// The treatment of the G codes of a control: computed, passed over, not computed, not known.

#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "bindings.hpp"
#include "cncsub/control/code_facts.hpp"
#include "cncsub/control/g_codes.hpp"
#include "cncsub/dialect/word_facts.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace cncsub::bindings {

namespace {

constexpr std::array kMeanings = {
#define MEANING(name, does, words, causes) std::string_view{#name},
#include "cncsub/control/meanings.def"
#undef MEANING
};

std::string name_of(Meaning meaning) {
  return std::string(kMeanings.at(static_cast<std::size_t>(meaning)));
}

/// Return each G code that the control's list or the tables of its kind of machine have, by number.
std::vector<std::tuple<std::string, std::string>> codes_of(const Control& control,
                                                           const std::string& machine) {
  const GCodes known(control, machine_of(control, machine));
  const Codes& listed = control.reading.g_codes.value;
  std::vector<std::tuple<std::string, std::string>> rows;
  for (int code = 0; code < Codes::kEnd; ++code) {
    const GCode found = known.find(code);
    if (found.code < 0 && !listed.has(code)) continue;
    rows.emplace_back(code_name(code), name_of(found.meaning));
  }
  return rows;
}

py::tuple source_row(const CodeSource& by) {
  return py::make_tuple(by.rule.empty() ? py::object(py::none()) : py::str(by.rule), by.source,
                        std::string(to_string(by.evidence)));
}

py::dict row_of(const CodeFacts& facts) {
  py::list words, causes, sources, programs;
  for (const CodeWord& word : facts.words)
    words.append(py::make_tuple(word.letters, word.says, py::cast(word.rules)));
  for (const std::string_view slug : facts.causes) causes.append(std::string(slug));
  for (const CodeSource& by : facts.sources) sources.append(source_row(by));
  for (const CodeProgram& called : facts.programs)
    programs.append(py::make_tuple(called.kind, called.program, source_row(called.by)));
  return py::dict("name"_a = facts.name, "treatment"_a = facts.treatment, "does"_a = facts.does,
                  "usual"_a = facts.usual, "group"_a = facts.group, "words"_a = words,
                  "causes"_a = causes, "sources"_a = sources, "programs"_a = programs);
}

/// Return what is known of a code, of a word of the control's language such as GOTOF, of an address
/// such as T or N10, or of a variable by its number; None where the text is none of these.
py::object facts_of(const Control& control, const std::string& name, const std::string& machine) {
  const auto facts = named_facts(control, machine_of(control, machine), name);
  return facts ? py::object(row_of(*facts)) : py::none();
}

/// Return the words of a control's language, each with its treatment and what it does.
std::vector<std::tuple<std::string, std::string, std::string>> keywords(const Control& control) {
  std::vector<std::tuple<std::string, std::string, std::string>> rows;
  for (const Keyword& word : keywords_of(control))
    rows.emplace_back(word.name, word.treatment, word.does);
  return rows;
}

/// Return a variable as programs of a control write it: #500, R5, $TC_DP3[5,1].
std::string variable_name(const Control& control, std::int64_t number) {
  const Dialect* const dialect = find_dialect(control.dialect);
  return dialect == nullptr ? "#" + std::to_string(number)
                            : dialect->spelling->name_of_variable(control, number);
}

/// Return the number of a variable as programs of a control write it; None where it has none.
std::optional<std::int64_t> variable_number(const Control& control, const std::string& name) {
  const Dialect* const dialect = find_dialect(control.dialect);
  if (dialect == nullptr) return std::nullopt;
  return dialect->spelling->number_of_variable(control, name);
}

}  // namespace

void add_codes(py::module_& m) {
  m.def("code_facts", &facts_of, py::arg("control"), py::arg("name"), py::arg("machine") = "");
  m.def("keywords", &keywords, py::arg("control"));
  m.def("variable_name", &variable_name, py::arg("control"), py::arg("number"));
  m.def("variable_number", &variable_number, py::arg("control"), py::arg("name"));
  m.def("names_in_block", &names_in, py::arg("control"), py::arg("block"));
  m.def("g_codes", &codes_of, py::arg("control"), py::arg("machine") = "");
}

}  // namespace cncsub::bindings
