// Rows of tables as objects of the package.
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>

#include "cncsub/trace/trace.hpp"

namespace cncsub::bindings {

/// A step as an object of `row`, the class `Step`: whoever asks for one block after another pays
/// for no more than that.
pybind11::object step_object(const Trace& trace, const Code& code, std::size_t index,
                             const pybind11::type& row);

}  // namespace cncsub::bindings
