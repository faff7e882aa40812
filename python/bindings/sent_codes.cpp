// The M, T and S codes that were sent to the machine, as a table and as lists, and the skips
// without a signal.
#include <cmath>

#include "bindings.hpp"
#include "gil.hpp"
#include "live.hpp"
#include "rows.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

using Sent = Trace::Sent;

constexpr std::string_view kKinds = "MTS";

py::object code_column(const Record& record, const std::string& name) {
  const Record::Reading reading(record);
  const auto shared = record.code();
  const Code& code = *shared;
  const auto& codes = record.trace().codes;
  if (name == "kind")
    return array_of<std::int32_t>(codes, [](const Sent& sent) { return kKinds.find(sent.kind); });
  if (name == "value") return array_of<double>(codes, [](const Sent& sent) { return sent.value; });
  if (name == "step")
    return array_of<std::int64_t>(codes, [](const Sent& sent) { return sent.step; });
  if (name == "program")
    return array_of<std::int32_t>(codes,
                                  [&](const Sent& sent) { return code.program_at(sent.address); });
  if (name == "n")
    return array_of<std::int32_t>(codes,
                                  [&](const Sent& sent) { return code.blocks[sent.address].n; });
  if (name == "line")
    return array_of<std::int32_t>(codes,
                                  [&](const Sent& sent) { return code.blocks[sent.address].line; });
  throw py::key_error(name);
}

/// Return a whole number as an int.
py::object plain_number(double value) {
  constexpr double kExact = 9007199254740992.0;
  if (std::fabs(value) <= kExact && value == std::floor(value))
    return py::int_(static_cast<std::int64_t>(value));
  return py::float_(value);
}

py::tuple code_row(const Record& record, std::size_t index) {
  const Record::Reading reading(record);
  if (index >= record.trace().codes.size()) throw py::index_error("no such code");
  const Sent& sent = record.trace().codes[index];
  const auto shared = record.code();
  const Code& code = *shared;
  const Block& block = code.blocks[sent.address];
  return py::make_tuple(std::string(1, sent.kind), plain_number(sent.value), sent.step,
                        code.name_of(code.program_at(sent.address)), sequence_number(block.n),
                        block.line);
}

py::list values_of(const Record& record, char kind) {
  const Record::Reading reading(record);
  const auto& codes = record.trace().codes;
  py::list list;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (codes[i].kind == kind) list.append(py::int_(static_cast<std::int64_t>(codes[i].value)));
    if (i % 4096 == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  return list;
}

/// Return step, program, sequence number and line of the blocks of G31 that met no signal.
py::list missed_skips(const Record& record) {
  const Record::Reading reading(record);
  const auto shared = record.code();
  const Code& code = *shared;
  py::list list;
  const auto& missed = record.trace().missed_skips;
  for (std::size_t i = 0; i < missed.size(); ++i) {
    const Block& block = code.blocks[missed[i].address];
    list.append(py::make_tuple(missed[i].step, code.name_of(code.program_at(missed[i].address)),
                               sequence_number(block.n), block.line));
  }
  return list;
}

}  // namespace

void add_sent_codes(py::class_<Record>& trace) {
  trace
      .def_property_readonly("codes",
                             [](const Record& record) {
                               const Record::Reading reading(record);
                               return record.trace().codes.size();
                             })
      .def("code_row", &code_row, py::arg("index"))
      .def("code_column", &code_column, py::arg("name"))
      .def_property_readonly("m_codes", [](const Record& record) { return values_of(record, 'M'); })
      .def_property_readonly("t_codes", [](const Record& record) { return values_of(record, 'T'); })
      .def_property_readonly("missed_skips", &missed_skips);
}

}  // namespace cncsub::bindings
