#include "cncsub/analysis/coverage.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "program_data.hpp"
#include "rows.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

/// Return by address: executions whose condition held and failed, times passed over, loops, calls,
/// arguments.
py::tuple coverage(const Record& record) {
  const Record::Reading reading(record);
  const auto code = record.code();
  const std::size_t blocks = code->blocks.size();
  const Array<std::int64_t> held(blocks), failed(blocks), skipped(blocks);
  Coverage found;
  work_away([&](InterruptCheck& interrupt) {
    for (std::int64_t* counts : {held.data, failed.data, skipped.data})
      std::fill_n(counts, blocks, 0);
    found = coverage_of(*code, record.trace(), {held.data, failed.data, skipped.data}, interrupt);
  });
  py::list loops, calls, arguments;
  for (const auto& [address, entries] : found.loops)
    loops.append(py::make_tuple(address, entries[0], entries[1], entries[2]));
  for (const Coverage::Call& call : found.calls)
    calls.append(
        py::make_tuple(call.address, std::string(to_string(call.kind)), call.program, call.count));
  for (const Coverage::Given& given : found.arguments)
    if (code->named(false, given.variable) == nullptr)  // a parameter always has a value
      arguments.append(py::make_tuple(given.program, given.variable, given.count));
  return py::make_tuple(held.object, failed.object, skipped.object, loops, calls, arguments);
}

/// Return the blocks of every program as columns: addresses, n, line, text, branch, whether it has
/// a skip mark. A block that programs share belongs to the innermost one.
py::list blocks(const Code& code) {
  const Branches branches(code);
  std::vector<py::str> names;  // made once, not for every block
  for (int i = 0; i <= static_cast<int>(Branch::Repeat); ++i)
    names.emplace_back(std::string(to_string(static_cast<Branch>(i))));
  py::list programs;
  for (std::size_t p = 0; p < code.programs.size(); ++p) {
    const Program& program = code.programs[p];
    py::list addresses, n, lines, texts, kinds, skips;
    for (Address a = program.first; a < program.last; ++a) {
      if ((a & 0xffff) == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (code.files[program.file].system) break;  // of the control, not of the user
      if (code.program_at(a) != static_cast<std::int32_t>(p)) continue;
      const Block& block = code.blocks[a];
      const std::string_view text = code.text_of(block, program);
      addresses.append(a);
      n.append(sequence_number(block.n));
      lines.append(block.line);
      texts.append(py::str(text.data(), text.size()));
      kinds.append(names[static_cast<std::size_t>(branches.of[a])]);
      skips.append(block.can_be_skipped());
    }
    programs.append(py::make_tuple(addresses, n, lines, texts, kinds, skips));
  }
  return programs;
}

/// Return which addresses are blocks that can be executed, and the blocks that decide: address,
/// branch, whether it has a skip mark.
py::tuple deciding(const Code& code) {
  const Branches branches(code);
  const Array<std::int64_t> known(code.blocks.size());
  std::fill_n(known.data, code.blocks.size(), 0);
  py::list decide;
  for (const Program& program : code.programs)
    for (Address a = program.first; a < program.last && !code.files[program.file].system; ++a) {
      known.data[a] = 1;
      if (branches.of[a] == Branch::None && !code.blocks[a].can_be_skipped()) continue;
      if (code.program_at(a) != static_cast<std::int32_t>(&program - code.programs.data()))
        continue;  // a part's own block, which is counted there
      decide.append(py::make_tuple(a, std::string(to_string(branches.of[a])),
                                   code.blocks[a].can_be_skipped()));
    }
  return py::make_tuple(known.object, decide);
}

}  // namespace

void add_coverage(py::module_& m) {
  m.def(
      "keeps_blocks",
      [](const Record& record) { return record.trace().depth >= Trace::Depth::Blocks; },
      py::arg("trace"));
  m.def("coverage", &coverage, py::arg("trace"));
  m.def("coverage_blocks", &blocks, py::arg("code"));
  m.def("coverage_deciding", &deciding, py::arg("code"));
}

}  // namespace cncsub::bindings
