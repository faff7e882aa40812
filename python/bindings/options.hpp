// The arguments of a run, as Python writes them.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "cncsub/machine/machine.hpp"

namespace cncsub::bindings {

/// Return the options of a run by their names in Python. What is None or missing keeps its value.
Options options_of(const pybind11::dict& from);
/// Raise ValueError with the name of the option as its attribute `option`.
[[noreturn]] void refuse(const char* option, const std::string& why);

Inputs inputs_of(const pybind11::dict& from);
Setup setup_of(const pybind11::dict& from);
Trace::Depth depth_of(const std::string& name);
/// Return the block-skip switches of a list of their numbers, a bit each.
std::uint16_t switches_of(const pybind11::handle& from);
/// Return a number; None is the vacant value.
double number_or_vacant(const pybind11::handle& value);

/// Refuse work coordinate systems that the control does not have: only some controls have G54.1
/// P49.
void check_systems(const Control& control, const Options& options);
/// Refuse inputs whose numbers are not those of signals or of variables that can be written.
void check_inputs(const Code& code, const Inputs& inputs);

}  // namespace cncsub::bindings
