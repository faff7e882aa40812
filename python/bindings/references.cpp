#include "cncsub/code/references.hpp"

#include <algorithm>
#include <string>

#include "bindings.hpp"
#include "program_data.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

/// Makes rows for Python. A computed value is given as its text.
class Rows {
 public:
  Rows(const Code& code, std::int32_t program)
      : code_(code),
        program_(program),
        text_(code.files[code.programs[static_cast<std::size_t>(program)].file].text.view()) {}

  py::tuple call(const CallReference& of) const {
    const bool found = of.found != kNoProgram;
    return py::make_tuple(std::string(to_string(of.kind)),
                          of.program.empty() ? py::none() : py::object(py::str(of.program)),
                          found ? py::object(py::int_(of.found)) : py::none(), of.external,
                          sequence_number(of.start), of.repeats, text(of.computed_program),
                          text(of.computed_start), text(of.computed_repeats), text(of.place),
                          column(of.place));
  }
  py::tuple jump(const JumpReference& of) const {
    const Program& own = code_.programs[static_cast<std::size_t>(program_)];
    const bool inside = of.to != kNowhere && of.to >= own.first && of.to < own.last;
    return py::make_tuple(std::string(of.kind), of.conditional, of.in_caller, sequence_number(of.n),
                          inside ? py::object(py::int_(of.to - own.first)) : py::none(),
                          text(of.computed), text(of.place), column(of.place));
  }
  py::tuple variable(const VariableReference& of) const {
    return py::make_tuple(of.number < 0 ? py::none() : py::object(py::int_(of.number)),
                          of.name.empty() ? py::none() : py::object(py::str(of.name)), of.computed,
                          text(of.place), column(of.place));
  }

 private:
  py::str text(const TextPlace& place) const {
    const std::size_t at = std::min<std::size_t>(place.at, text_.size());
    const std::string found(text_.substr(at, place.width));
    const std::size_t last = found.find_last_not_of(" \t\r");
    return py::str(found.substr(0, last == std::string::npos ? 0 : last + 1));
  }
  py::object text(const std::optional<TextPlace>& place) const {
    return place ? py::object(text(*place)) : py::none();
  }
  /// Return the column of a place, counted in characters from 1.
  std::size_t column(const TextPlace& place) const {
    const std::size_t at = std::min<std::size_t>(place.at, text_.size());
    const std::size_t line = at == 0 ? 0 : text_.rfind('\n', at - 1) + 1;
    const auto* const from = reinterpret_cast<const unsigned char*>(text_.data());
    return 1 + static_cast<std::size_t>(std::count_if(
                   from + line, from + at, [](unsigned char c) { return (c & 0xc0) != 0x80; }));
  }

  const Code& code_;
  std::int32_t program_;
  const std::string_view text_;
};

/// Return the references of one block: calls, jumps, reads, writes.
py::tuple references(const Code& code, std::int32_t program, const Block& block) {
  const References of = references_of(code, block, program);
  const Rows rows(code, program);
  const auto listed = [](const auto& from, const auto& row) {
    py::list list;
    for (const auto& each : from) list.append(row(each));
    return py::tuple(list);
  };
  const auto variable = [&](const VariableReference& each) { return rows.variable(each); };
  return py::make_tuple(
      listed(of.calls, [&](const CallReference& each) { return rows.call(each); }),
      listed(of.jumps, [&](const JumpReference& each) { return rows.jump(each); }),
      listed(of.reads, variable), listed(of.writes, variable));
}

/// Call `take` with each call of every program: the place of the program, the block, the call as a
/// row.
template <class Take>
void take_calls(const Code& code, const Take& take) {
  std::size_t looked_at = 0;
  for (std::size_t p = 0; p < code.programs.size(); ++p) {
    const Program& program = code.programs[p];
    const auto own = static_cast<std::int32_t>(p);
    const Rows rows(code, own);
    for (Address a = program.first; a < program.last; ++a) {
      if ((++looked_at & 0xfff) == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (code.files[program.file].system) break;  // of the control, not of the user
      if (!may_call(code.blocks[a].op) || code.program_at(a) != own) continue;
      for (const CallReference& call : references_of(code, code.blocks[a], own).calls)
        take(p, a, rows.call(call));
    }
  }
}

/// Return all calls as a list: (program, block, call).
py::list all_calls(const Code& code) {
  py::list list;
  take_calls(code, [&](std::size_t program, Address at, const py::tuple& call) {
    list.append(py::make_tuple(program, at - code.programs[program].first, call));
  });
  return list;
}

/// Call `take` with each call in turn: (program, n, line, call). No list of all calls is made.
void each_call(const Code& code, const py::function& take) {
  take_calls(code, [&](std::size_t program, Address at, const py::tuple& call) {
    take(program, sequence_number(code.blocks[at].n), code.blocks[at].line, call);
  });
}

}  // namespace

void add_references(py::module_& m) {
  m.def(
      "references",
      [](const ProgramData& program, std::size_t block) {
        return references(*program.code, static_cast<std::int32_t>(program.index),
                          program.block(block));
      },
      py::arg("program"), py::arg("block"));
  m.def("all_calls", &all_calls, py::arg("code"));
  m.def("each_call", &each_call, py::arg("code"), py::arg("take"));
}

}  // namespace cncsub::bindings
