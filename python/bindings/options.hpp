// What a run is given, as Python writes it.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "cncsub/machine/machine.hpp"

namespace cncsub::bindings {

/// The options of a run by their names in Python; what is None or missing stays as it is.
Options options_of(const pybind11::dict& from);
/// Raise ValueError with the name of the option as its attribute `option`.
[[noreturn]] void refuse(const char* option, const std::string& why);

Inputs inputs_of(const pybind11::dict& from);
Setup setup_of(const pybind11::dict& from);
Trace::Depth depth_of(const std::string& name);
/// None is the vacant value.
double number_or_vacant(const pybind11::handle& value);

/// The work coordinate systems that are named must be those of the control: G54.1 P49 is one of
/// some controls only.
void check_systems(const Control& control, const Options& options);
/// The numbers in the inputs must be those of signals, and of variables that can be written.
void check_inputs(const Code& code, const Inputs& inputs);

}  // namespace cncsub::bindings
