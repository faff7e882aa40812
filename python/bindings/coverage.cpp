#include "cncsub/analysis/coverage.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "bindings.hpp"
#include "program_data.hpp"
#include "rows.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

/// By address: executions whose condition held and failed, loops, calls, arguments.
py::tuple coverage(const Record& record) {
  const Record::Reading reading(record);
  const std::size_t blocks = record.code().blocks.size();
  const Array<std::int64_t> held(blocks), failed(blocks);
  Coverage found;
  work_away([&](InterruptCheck& interrupt) {
    std::fill_n(held.data, blocks, 0);
    std::fill_n(failed.data, blocks, 0);
    found = coverage_of(record.code(), record.trace(), held.data, failed.data, interrupt);
  });
  py::list loops, calls, arguments;
  for (const auto& [address, entries] : found.loops)
    loops.append(py::make_tuple(address, entries[0], entries[1], entries[2]));
  for (const Coverage::Call& call : found.calls)
    calls.append(
        py::make_tuple(call.address, std::string(to_string(call.kind)), call.program, call.count));
  for (const Coverage::Given& given : found.arguments)
    arguments.append(py::make_tuple(given.program, given.variable, given.count));
  return py::make_tuple(held.object, failed.object, loops, calls, arguments);
}

/// Of every program its blocks: (address, n, line, text, branch). A block that programs share is
/// one of the innermost.
py::list blocks(const Code& code) {
  const Branches branches(code);
  py::list programs;
  for (std::size_t p = 0; p < code.programs.size(); ++p) {
    const Program& program = code.programs[p];
    py::list own;
    for (Address a = program.first; a < program.last; ++a) {
      if ((a & 0xffff) == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (code.program_at(a) != static_cast<std::int32_t>(p)) continue;
      const Block& block = code.blocks[a];
      const std::string_view text = code.text_of(block, program);
      own.append(py::make_tuple(a, sequence_number(block.n), block.line,
                                py::str(text.data(), text.size()),
                                std::string(to_string(branches.of[a]))));
    }
    programs.append(std::move(own));
  }
  return programs;
}

}  // namespace

void add_coverage(py::module_& m) {
  m.def(
      "keeps_blocks",
      [](const Record& record) { return record.trace().depth >= Trace::Depth::Blocks; },
      py::arg("trace"));
  m.def("coverage", &coverage, py::arg("trace"));
  m.def("coverage_blocks", &blocks, py::arg("code"));
}

}  // namespace cncsub::bindings
