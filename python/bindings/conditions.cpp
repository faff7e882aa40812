// What the conditions of a run compared, as a table.
#include <algorithm>
#include <array>

#include "bindings.hpp"
#include "cncsub/code/spelling.hpp"
#include "gil.hpp"
#include "live.hpp"
#include "rows.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

using Compared = Trace::Compared;

/// The operators of the column `operator`, by their numbers there. End: a value alone.
constexpr std::array kOperators = {Ins::End,       Ins::Equal,       Ins::NotEqual,
                                   Ins::Greater,   Ins::Less,        Ins::GreaterEqual,
                                   Ins::LessEqual, Ins::NearlyEqual, Ins::NearlyNotEqual};

std::int32_t operator_number(Ins op) {
  return static_cast<std::int32_t>(std::find(kOperators.begin(), kOperators.end(), op) -
                                   kOperators.begin());
}

/// Return how the language writes an operator.
std::string_view written_operator(const Code& code, Ins op) {
  const auto rows = code.spelling->operators(code.control->macros.logic_order.value);
  const auto found = std::find_if(rows.begin(), rows.end(), [op](const OperatorRow& row) {
    return op != Ins::End && (exact(row.op) == op || row.other == op);
  });
  return found == rows.end() ? "" : found->spelling;
}

py::list operator_texts(const Record& record) {
  const auto code = record.code();
  py::list texts;
  for (const Ins op : kOperators) texts.append(py::str(std::string(written_operator(*code, op))));
  return texts;
}

py::object compared_column(const Record& record, const std::string& name) {
  const Record::Reading reading(record);
  const auto shared = record.code();
  const Code& code = *shared;
  const auto& rows = record.trace().compared;
  if (name == "step")
    return array_of<std::int64_t>(rows, [](const Compared& row) { return row.step; });
  if (name == "left") return array_of<double>(rows, [](const Compared& row) { return row.left; });
  if (name == "right") return array_of<double>(rows, [](const Compared& row) { return row.right; });
  if (name == "operator")
    return array_of<std::int32_t>(rows,
                                  [](const Compared& row) { return operator_number(row.op); });
  if (name == "holds")
    return array_of<std::int8_t>(rows, [](const Compared& row) { return row.holds ? 1 : 0; });
  if (name == "program")
    return array_of<std::int32_t>(
        rows, [&](const Compared& row) { return code.program_at(row.address); });
  if (name == "n")
    return array_of<std::int32_t>(rows,
                                  [&](const Compared& row) { return code.blocks[row.address].n; });
  if (name == "line")
    return array_of<std::int32_t>(
        rows, [&](const Compared& row) { return code.blocks[row.address].line; });
  throw py::key_error(name);
}

py::tuple compared_row(const Record& record, std::size_t index) {
  const Record::Reading reading(record);
  if (index >= record.trace().compared.size()) throw py::index_error("no such comparison");
  const Compared& row = record.trace().compared[index];
  const auto shared = record.code();
  const Code& code = *shared;
  const Block& block = code.blocks[row.address];
  return py::make_tuple(row.step, value_or_none(row.left),
                        std::string(written_operator(code, row.op)), value_or_none(row.right),
                        row.holds, code.name_of(code.program_at(row.address)),
                        sequence_number(block.n), block.line);
}

}  // namespace

void add_conditions(py::class_<Record>& trace) {
  trace
      .def_property_readonly("compared",
                             [](const Record& record) {
                               const Record::Reading reading(record);
                               return record.trace().compared.size();
                             })
      .def_property_readonly("operator_texts", &operator_texts)
      .def("compared_row", &compared_row, py::arg("index"))
      .def("compared_column", &compared_column, py::arg("name"));
}

}  // namespace cncsub::bindings
