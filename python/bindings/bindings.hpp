// The parts of the module. Each file names what it exports; none of them decides anything.
#pragma once

#include <pybind11/pybind11.h>

#include "cncsub/code/code.hpp"
#include "shared.hpp"

namespace cncsub::bindings {

void add_controls(pybind11::module_& m);
void add_codes(pybind11::module_& m);
void add_alarms(pybind11::module_& m);
void add_files(pybind11::module_& m);
void add_code(pybind11::module_& m);
void add_references(pybind11::module_& m);
void add_check(pybind11::module_& m);
void add_coverage(pybind11::module_& m);
void add_flat(pybind11::module_& m);
void add_comparison(pybind11::module_& m);
void add_machine(pybind11::module_& m);
void add_trace(pybind11::module_& m);

/// Return a sequence number; None for -1, where a block has none.
inline pybind11::object sequence_number(std::int64_t n) {
  return n < 0 ? pybind11::object(pybind11::none()) : pybind11::object(pybind11::int_(n));
}
/// Return a value; None for the vacant value.
inline pybind11::object value_or_none(double value) {
  return is_vacant(value) ? pybind11::object(pybind11::none())
                          : pybind11::object(pybind11::float_(value));
}
/// Return a text; None for an empty one.
inline pybind11::object text_or_none(const std::string& text) {
  return text.empty() ? pybind11::object(pybind11::none()) : pybind11::object(pybind11::str(text));
}

}  // namespace cncsub::bindings
