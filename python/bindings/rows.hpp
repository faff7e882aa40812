// Rows of tables as objects of the package, and columns as arrays.
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <string>
#include <type_traits>

#include "cncsub/trace/trace.hpp"
#include "gil.hpp"
#include "live.hpp"

namespace cncsub::bindings {

/// Return an array of NumPy with so many items of a type, not written yet. NumPy makes it: Python
/// has imported NumPy where it asks for an array. A large array lies in memory that may have been
/// used before.
pybind11::object empty_array(std::size_t items, std::size_t item_bytes, const std::string& type);

/// An array to be filled.
template <class T>
struct Array {
  explicit Array(std::size_t size)
      : object(empty_array(size, sizeof(T),
                           (std::is_integral_v<T> ? "i" : "f") + std::to_string(sizeof(T)))),
        data(static_cast<T*>(
            pybind11::reinterpret_borrow<pybind11::buffer>(object).request(true).ptr)) {}

  pybind11::object object;
  T* data;
};

/// Return an array with what `value` returns for each row of a column; it is made without the GIL.
template <class T, class Rows, class Value>
pybind11::object array_of(const Rows& rows, Value&& value) {
  const Array<T> array(rows.size());
  T* next = array.data;
  work_away([&](InterruptCheck& interrupt) {
    rows.for_each_run(0, rows.size(), [&](const auto* run, std::size_t count) {
      if (interrupt.requested(count * sizeof(*run))) return;
      for (std::size_t i = 0; i < count; ++i) *next++ = static_cast<T>(value(run[i]));
    });
  });
  return array.object;
}

/// Return a step as an object of `row`, the class `Step`. A caller that asks for single blocks pays
/// for no more than these.
pybind11::object step_object(const Trace& trace, const std::shared_ptr<const Code>& code,
                             std::size_t index, const pybind11::type& row);

/// Add the tables of steps, of watched variables, of conditions and of sent codes, and the path as
/// points.
void add_steps(pybind11::class_<Record>& trace);
void add_watch(pybind11::class_<Record>& trace);
void add_conditions(pybind11::class_<Record>& trace);
void add_sent_codes(pybind11::class_<Record>& trace);
void add_paths(pybind11::class_<Record>& trace);

/// Add the block of a row of the moves, by the bits of the step that the row holds.
void add_block(pybind11::dict& fields, const Record& record, std::uint32_t step_of_move);

/// Add the other fields of a row of the moves: where it begins, the centre of the tool's arc,
/// whether a cycle makes it and whether a radius offset is active.
void add_begin(pybind11::dict& fields, const Moves& moves, std::size_t index);

}  // namespace cncsub::bindings
