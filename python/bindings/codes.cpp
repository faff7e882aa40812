// The treatment of the G codes of a control: computed, passed over, not computed, not known.

#include <pybind11/stl.h>

#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "bindings.hpp"
#include "cncsub/control/g_codes.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

// clang-format off
#define CNCSUB_NAMED(name) std::string_view{#name},
constexpr std::array kMeanings = {CNCSUB_MEANINGS(CNCSUB_NAMED)};
#undef CNCSUB_NAMED
// clang-format on

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

}  // namespace

void add_codes(py::module_& m) {
  m.def("g_codes", &codes_of, py::arg("control"), py::arg("machine") = "");
}

}  // namespace cncsub::bindings
