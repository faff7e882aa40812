// The changes of the variables that are watched, as a table.
#include <pybind11/stl.h>

#include "bindings.hpp"
#include "gil.hpp"
#include "live.hpp"
#include "rows.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

/// Return the block of a change; null for a change from outside, which belongs to no step.
const Block* block_of(const Code& code, const Trace::Change& change) {
  return change.step < 0 ? nullptr : &code.blocks[change.address];
}

py::object change_column(const Record& record, const std::string& name) {
  const Record::Reading reading(record);
  const auto shared = record.code();
  const Code& code = *shared;
  using Change = Trace::Change;
  const auto& changes = record.trace().changes;
  if (name == "step")
    return array_of<std::int64_t>(changes, [](const Change& change) { return change.step; });
  if (name == "variable")
    return array_of<std::int32_t>(changes, [](const Change& change) { return change.variable; });
  if (name == "value")
    return array_of<double>(changes, [](const Change& change) { return change.value; });
  if (name == "program")
    return array_of<std::int32_t>(changes, [&](const Change& change) {
      return change.step < 0 ? -1 : code.program_at(change.address);
    });
  const auto of_block = [&](auto fact) {
    return array_of<std::int32_t>(changes, [&code, fact](const Change& change) {
      const Block* block = block_of(code, change);
      return block == nullptr ? -1 : fact(*block);
    });
  };
  if (name == "n") return of_block([](const Block& block) { return block.n; });
  if (name == "line")
    return of_block([](const Block& block) { return static_cast<std::int32_t>(block.line); });
  throw py::key_error(name);
}

py::tuple change_row(const Record& record, std::size_t index) {
  const Record::Reading reading(record);
  if (index >= record.trace().changes.size()) throw py::index_error("no such change");
  const Trace::Change& change = record.trace().changes[index];
  const auto shared = record.code();
  const Code& code = *shared;
  const Block* block = block_of(code, change);
  if (block == nullptr)
    return py::make_tuple(py::none(), change.variable, value_or_none(change.value), py::none(),
                          py::none(), py::none());
  return py::make_tuple(change.step, change.variable, value_or_none(change.value),
                        code.name_of(code.program_at(change.address)), sequence_number(block->n),
                        block->line);
}

/// Return the watched variables, with their values before the first row.
py::dict watched(const Record& record) {
  const Record::Reading reading(record);
  py::dict values;
  for (const Trace::Watched& variable : record.trace().watched)
    values[py::int_(variable.number)] = value_or_none(variable.before);
  return values;
}

}  // namespace

void add_watch(py::class_<Record>& trace) {
  trace
      .def_property_readonly("changes",
                             [](const Record& record) {
                               const Record::Reading reading(record);
                               return record.trace().changes.size();
                             })
      .def("change_row", &change_row, py::arg("index"))
      .def("change_column", &change_column, py::arg("name"))
      .def_property_readonly("watched", &watched);
}

}  // namespace cncsub::bindings
