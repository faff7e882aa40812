#include "cncsub/analysis/check.hpp"

#include <pybind11/stl.h>

#include <string>
#include <utility>

#include "bindings.hpp"
#include "cncsub/analysis/flow.hpp"
#include "cncsub/analysis/points.hpp"
#include "cncsub/control/spelled.hpp"
#include "gil.hpp"
#include "live.hpp"
#include "program_data.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

Frame frame_of(const Code& code, Address at) {
  const std::int32_t index = code.program_at(at);
  const Program& program = code.programs[static_cast<std::size_t>(index)];
  const Block& block = code.blocks[at];
  Frame frame{.program = code.name_of(program),
              .n = block.n,
              .line = block.line,
              .file = code.files[program.file].name,
              .kind = {},
              .called = {}};
  const References references = references_of(code, block, index);
  if (references.calls.empty()) return frame;
  const CallReference& call = references.calls.front();
  frame.kind = to_string(call.kind);
  frame.called = call.program;
  frame.repeats = call.repeats;
  return frame;
}

/// A finding, ready for Python. Its texts are made without the GIL.
struct Told {
  Check check{};
  Alarm place;
  std::string hint;
  std::optional<Alarm> alarm;
  std::vector<Frame> path;
  std::vector<std::pair<Alarm, std::pair<std::string, std::string>>> edits;  // place, old, new
  std::vector<Alarm> again;  // the first of the other places
  std::size_t count = 1;     // of all its places
};

constexpr std::size_t kMostPlaces = 1000;  // shown of one finding

Told reported(const Code& code, const Finding& finding, InterruptCheck& interrupt) {
  Told row{.check = finding.check,
           .place = alarm_of(
               code, finding.block,
               {.at = finding.place.at, .width = finding.place.width, .detail = finding.detail}),
           .hint = finding.hint,
           .alarm = std::nullopt,
           .path = {},
           .edits = {},
           .again = {},
           .count = finding.again.size() + 1};
  if (finding.alarm) row.alarm = alarm_of(code, finding.alarm_block, *finding.alarm);
  for (const Address at : finding.path) row.path.push_back(frame_of(code, at));
  constexpr std::size_t kLine = 1024;  // usual bytes scanned to find its column
  for (const CertainEdit& edit : finding.edits) {
    if (interrupt.requested(kLine)) break;
    const Program& program = code.programs[static_cast<std::size_t>(code.program_at(edit.block))];
    const std::string_view text = code.files[program.file].text.view();
    row.edits.push_back(
        {alarm_of(code, edit.block, {.at = edit.place.at, .width = edit.place.width, .detail = {}}),
         {std::string(text.substr(edit.place.at, edit.place.width)), edit.text}});
  }
  for (const FoundAgain& at : finding.again) {
    if (row.again.size() == kMostPlaces || interrupt.requested(kLine)) break;
    Fault fault = finding.alarm && finding.alarm_block == finding.block ? *finding.alarm : Fault{};
    fault.at = at.place.at;
    fault.width = at.place.width;
    row.again.push_back(alarm_of(code, at.block, fault));
  }
  if (row.alarm && finding.alarm_block == finding.block) row.place = *row.alarm;
  if (row.alarm) row.alarm->frames.assign(row.path.rbegin(), row.path.rend());
  return row;
}

py::object alarm_or_none(const std::optional<Alarm>& alarm) {
  if (!alarm) return py::none();
  return py::cast(*alarm);
}

py::tuple row_of(Told& row) {
  py::tuple path(row.path.size()), again(row.again.size());
  for (std::size_t i = 0; i < row.path.size(); ++i) path[i] = py::cast(std::move(row.path[i]));
  for (std::size_t i = 0; i < row.again.size(); ++i) {
    const std::string line = row.again[i].source_line;
    again[i] = py::make_tuple(std::move(row.again[i]), line);
  }
  py::list edits;
  for (const auto& [at, texts] : row.edits)
    edits.append(py::make_tuple(at.file, at.line, at.column, texts.first, texts.second));
  const std::string line = row.place.source_line;
  return py::make_tuple(static_cast<int>(row.check), std::move(row.place), line,
                        alarm_or_none(row.alarm), path, edits, again, row.count, row.hint);
}

py::list check_all(const Code& code, std::int32_t main, const std::string& machine,
                   const std::vector<std::int32_t>& entries) {
  std::vector<Told> all;
  work_away([&](InterruptCheck& interrupt) {
    for (const Finding& finding : check(code, {main, entries}, machine, interrupt)) {
      if (interrupt.requested(InterruptCheck::kLook / 64)) break;
      all.push_back(reported(code, finding, interrupt));
    }
  });
  py::list rows;
  for (Told& row : all) {
    if ((py::len(rows) & 0xfff) == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
    rows.append(row_of(row));
  }
  return rows;
}

/// Return the texts of the rules and the causes in the words of a control: meaning and hint of each
/// rule, meaning and cure of each cause.
py::tuple told_for(const Control& control) {
  const auto text = [&control](std::string_view of) { return py::str(spelled(of, control)); };
  py::list rules;
  py::dict causes;
  for (const CheckInfo& of : all_checks())
    rules.append(py::make_tuple(text(of.meaning), text(of.hint)));
  for (const CauseInfo& of : all_causes())
    causes[py::str(std::string(of.slug))] = py::make_tuple(text(of.meaning), text(of.cure));
  return py::make_tuple(rules, causes);
}

py::list all_rules() {
  const auto text = [](std::string_view of) { return py::str(of.data(), of.size()); };
  py::list rows;
  for (const CheckInfo& of : all_checks())
    rows.append(py::make_tuple(text(of.number), text(of.slug), text(of.severity), text(of.meaning),
                               text(of.hint), text(of.example), text(of.control)));
  return rows;
}

/// The paths through all programs of a memory: those of one program depend on the others.
struct Flows {
  std::shared_ptr<const Code> code;
  std::vector<ProgramFlow> all;
};

Flows flows(const std::shared_ptr<Code>& code) {
  Flows found{.code = code, .all = {}};
  work_away([&](InterruptCheck& interrupt) { found.all = flow_of(*code, interrupt); });
  return found;
}

/// Return the paths of a program: (block, where it goes on, why). The end is the place after the
/// last block; None stands for any block with a number.
py::tuple flow(const Flows& flows, const ProgramData& program) {
  const ProgramFlow& own = flows.all[program.index];
  const std::vector<bool> reached = own.reached();
  const Address last = reached.back() ? own.anywhere() : own.last();
  py::list edges, returns, ends;
  for (Address at = own.first(); at <= last; ++at) {
    const auto place = [&](Address of) -> py::object {
      return of == own.anywhere() ? py::object(py::none()) : py::int_(of - own.first());
    };
    for (const Exit* exit = own.begin(at); exit != own.end(at); ++exit)
      edges.append(py::make_tuple(place(at), place(exit->to), std::string(to_string(exit->kind))));
    if (own.returns(at)) returns.append(place(at));
    if (own.ends(at)) ends.append(place(at));
  }
  py::list unreached;
  for (Address at = own.first(); at < own.last(); ++at)
    if (!reached[at - own.first()]) unreached.append(at - own.first());
  return py::make_tuple(edges, returns, ends, unreached);
}

/// Return the jumps of a program whose block is known, as the places of both ends.
std::vector<std::pair<Address, Address>> jumps(const Flows& flows, const ProgramData& program) {
  const ProgramFlow& own = flows.all[program.index];
  std::vector<std::pair<Address, Address>> found;
  for (Address at = own.first(); at < own.last(); ++at)
    for (const Exit* exit = own.begin(at); exit != own.end(at); ++exit)
      if (exit->kind == ExitKind::Jump && exit->to >= own.first() && exit->to < own.last())
        found.emplace_back(at - own.first(), exit->to - own.first());
  return found;
}

}  // namespace

namespace {

/// Return the programs that have a step in a record.
std::vector<bool> programs_of(const Record& record) {
  const auto shared = record.code();
  const Code& code = *shared;
  std::vector<bool> ran(code.programs.size(), false);
  const Program* last = nullptr;
  const auto& steps = record.trace().steps;
  steps.for_each_run(0, steps.size(), [&](const Trace::Step* rows, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const Address at = rows[i].address;
      if (last != nullptr && at >= last->first && at < last->last) continue;
      const auto program = static_cast<std::size_t>(code.program_at(at));
      ran[program] = true;
      last = &code.programs[program];
    }
  });
  return ran;
}

/// Return how many lengths of the programs that ran have no point, and of the first one: its
/// letter, its value, its program, N and line; None where there are none.
py::object lengths_without_point(const Record& record, const std::string& machine) {
  const Record::Reading reading(record);
  const auto code = record.code();
  WithoutPoint found;
  work_away([&](InterruptCheck& interrupt) {
    found = cncsub::lengths_without_point(*code, programs_of(record), machine, interrupt);
  });
  if (found.count == 0) return py::none();
  const Block& block = code->blocks[found.block];
  return py::make_tuple(found.count, std::string(1, found.address), found.value,
                        code->name_of(code->program_at(found.block)), sequence_number(block.n),
                        block.line);
}

}  // namespace

void add_check(py::module_& m) {
  m.def("lengths_without_point", &lengths_without_point, py::arg("record"), py::arg("machine"));
  m.def("check", &check_all, py::arg("code"), py::arg("main"), py::arg("machine"),
        py::arg("entries"));
  m.def("checks", &all_rules);
  m.def("told_for", &told_for, py::arg("control"));
  py::class_<Flows>(m, "Flows", py::is_final());
  m.def("flows", &flows, py::arg("code"));
  m.def("flow", &flow, py::arg("flows"), py::arg("program"));
  m.def("jumps", &jumps, py::arg("flows"), py::arg("program"));
}

}  // namespace cncsub::bindings
