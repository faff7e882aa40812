#include "cncsub/code/references.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "cncsub/analysis/formatting.hpp"
#include "cncsub/analysis/mentions.hpp"
#include "cncsub/text/scan.hpp"
#include "gil.hpp"
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
                          column(of.place), of.own_locals);
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

/// The column of each place of a file, counted in characters from 1. The places come in order, or
/// else the line is counted through again.
class Columns {
 public:
  explicit Columns(std::string_view text) : text_(text) {}

  std::pair<std::uint32_t, std::size_t> line_and_column(std::size_t at) {
    at = std::min(at, text_.size());
    if (at < at_) *this = Columns(text_);
    for (; at_ < at; ++at_) {
      if (text_[at_] == '\n') {
        ++line_;
        column_ = 1;
      } else if (!is_inside_character(text_[at_])) {
        ++column_;
      }
    }
    return {line_, column_};
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1;
  std::size_t column_ = 1;
};

constexpr std::string_view name_of(Mention::Kind kind) {
  switch (kind) {
    case Mention::Kind::Number:
      return "number";
    case Mention::Kind::Label:
      return "label";
    case Mention::Kind::Program:
      return "program";
    case Mention::Kind::Variable:
      return "variable";
  }
  return "";
}

/// Return the order of mentions in their files.
std::vector<std::size_t> by_place(const Code& code, const std::vector<Mention>& all) {
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) {
    const Mention& of = all[i];
    return std::pair(code.programs[static_cast<std::size_t>(of.program)].file, of.place.at);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return order;
}

/// Lines of a file: its name, the first and the last of them, from 1.
using LinesAsked = std::tuple<std::string, std::uint32_t, std::uint32_t>;
/// A program, a block of it, or a variable: its program, its block there, its number, its name.
using NameAsked = std::tuple<std::int32_t, std::optional<std::uint32_t>, std::int64_t, std::string>;

/// Return where the line so many lines after the one at `from` begins, or the end of the text.
std::size_t line_after(std::string_view text, std::size_t from, std::uint32_t lines) {
  for (; lines > 0 && from < text.size(); --lines)
    from = std::min(text.find('\n', from), text.size() - 1) + 1;
  return from;
}

/// Return the part of a file that some lines are; nothing where there is no such file.
std::optional<MentionsAsked::Part> part_of(const Code& code, const LinesAsked& lines) {
  const auto& [name, first, last] = lines;
  for (std::size_t i = 0; i < code.files.size(); ++i) {
    if (code.files[i].name != name) continue;
    const std::string_view text = code.files[i].text.view();
    const std::size_t from = line_after(text, 0, std::max(first, 1U) - 1);
    const std::size_t begin = line_after(text, from, std::max(first, last) - std::max(first, 1U));
    const std::size_t to = std::min(text.find('\n', begin), text.size());
    return MentionsAsked::Part{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(from),
                               static_cast<std::uint32_t>(to)};
  }
  return std::nullopt;
}

MentionsAsked::Named named_by(const Code& code, const NameAsked& asked) {
  const auto& [program, block, number, name] = asked;
  MentionsAsked::Named named{program, kNowhere, number, name};
  if (block) named.block = code.programs.at(static_cast<std::size_t>(program)).first + *block;
  return named;
}

py::list mentions(const Code& code, const std::string& machine, const std::string& kinds,
                  const std::optional<LinesAsked>& lines, const std::optional<NameAsked>& name) {
  const auto asked = [&](std::string_view kind) { return kinds.find(kind) != std::string::npos; };
  std::vector<Mention> all;
  MentionsAsked of{asked("block"), asked("program"), asked("variable"), asked("unnumbered")};
  if (lines && !(of.part = part_of(code, *lines))) return py::list();
  if (name) of.named = named_by(code, *name);
  work_away([&](InterruptCheck& interrupt) { all = mentions_of(code, machine, of, interrupt); });
  py::list rows;
  std::uint32_t file = 0;
  std::optional<Columns> columns;
  const auto place_in = [&](std::int32_t program, Address at) {
    const bool known = program != kNoProgram && at != kNowhere;
    const Address first = known ? code.programs[static_cast<std::size_t>(program)].first : 0;
    return known ? py::object(py::int_(at - first)) : py::none();
  };
  for (const std::size_t i : by_place(code, all)) {
    const Mention& of = all[i];
    const Program& program = code.programs[static_cast<std::size_t>(of.program)];
    const std::string_view text = code.files[program.file].text.view();
    if (!columns || std::exchange(file, program.file) != program.file) columns.emplace(text);
    const auto [line, column] = columns->line_and_column(of.place.at);
    const auto text_at = [&](const TextPlace& place) {
      return std::string(text.substr(std::min<std::size_t>(place.at, text.size()), place.width));
    };
    const bool has_word = of.word.width > 0;
    const std::uint32_t before = has_word ? of.place.at - of.word.at : 0;
    rows.append(py::make_tuple(std::string(name_of(of.kind)), of.defines, of.computed, of.in_caller,
                               of.fixed, of.program, place_in(of.program, of.block), line, column,
                               text_at(of.place), of.number, of.name, of.to_program,
                               place_in(of.to_program, of.to),
                               has_word ? text_at(of.word) : std::string(), before));
    if (rows.size() % 4096 == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  return rows;
}

/// Call `take` with the references of each block of a program, until it returns false.
template <class Take>
bool take_references(const Code& code, std::size_t index, InterruptCheck& interrupt,
                     const Take& take) {
  const Program& program = code.programs[index];
  for (Address at = program.first; at < program.last; ++at) {
    const Block& block = code.blocks[at];
    if (interrupt.requested(InterruptCheck::kBlock)) return false;
    if (!take(at, references_of(code, block, static_cast<std::int32_t>(index)))) return false;
  }
  return true;
}

/// Return the variables of a program, each once, as number, name, the text that names it, and the
/// place of the first block that does. The block's own writing comes before its reading.
py::list variables_used(const ProgramData& program) {
  const Code& code = *program.code;
  std::vector<std::pair<Address, VariableReference>> found;
  std::set<std::int64_t> numbers;
  std::set<std::string> names;
  work_away([&](InterruptCheck& interrupt) {
    take_references(code, program.index, interrupt, [&](Address at, const References& of) {
      for (const auto* list : {&of.writes, &of.reads})
        for (const VariableReference& each : *list) {
          if (each.computed) continue;
          const bool is_new = each.name.empty() ? numbers.insert(each.number).second
                                                : names.insert(capitals(each.name)).second;
          if (is_new) found.emplace_back(at, each);
        }
      return true;
    });
  });
  const Rows rows(code, static_cast<std::int32_t>(program.index));
  py::list list;
  for (const auto& [at, each] : found) {
    const py::tuple row = rows.variable(each);
    list.append(py::make_tuple(row[0], row[1], row[3], at - program.program().first));
  }
  return list;
}

/// Return the numbers of the first variables that blocks write and that can be read, and whether
/// any block reads a variable.
std::pair<std::vector<std::int64_t>, bool> written_variables(const Code& code, std::size_t most) {
  std::vector<std::int64_t> numbers;
  std::set<std::int64_t> known;
  bool reads = false;
  const auto take = [&](Address /*at*/, const References& of) {
    reads = reads || !of.reads.empty();
    for (const VariableReference& each : of.writes) {
      if (each.number < 0 || each.computed || !known.insert(each.number).second) continue;
      const VariablePlace place = code.place(each.number);
      if (place.range != nullptr && place.range->access != Access::WriteOnly &&
          numbers.size() < most)
        numbers.push_back(each.number);
    }
    return true;
  };
  work_away([&](InterruptCheck& interrupt) {
    for (std::size_t p = 0; p < code.programs.size(); ++p)
      if (!take_references(code, p, interrupt, take)) return;
  });
  return {numbers, reads};
}

/// Return the changes of a file, as line, column, old and new text, and the lines that stay.
py::tuple formatted(const Code& code, const std::string& name, const std::string& blanks,
                    int indent, bool capitals, bool points) {
  const auto known = std::find_if(code.files.begin(), code.files.end(), [&](const SourceFile& of) {
    return of.name == name && !of.external && !of.system;
  });
  if (known == code.files.end()) throw py::key_error("no file " + name);
  const auto file = static_cast<std::uint32_t>(known - code.files.begin());
  Layout layout{Layout::Blanks::Keep, indent, capitals, points};
  if (blanks == "one") layout.blanks = Layout::Blanks::One;
  if (blanks == "none") layout.blanks = Layout::Blanks::None;
  Formatted found;
  work_away([&](InterruptCheck& interrupt) { found = format_file(code, file, layout, interrupt); });
  const std::string_view text = code.files[file].text.view();
  Columns columns(text);
  py::list rows;
  for (const LayoutChange& change : found.changes) {
    const auto [line, column] = columns.line_and_column(change.at);
    rows.append(py::make_tuple(line, column, std::string(text.substr(change.at, change.width)),
                               change.text));
  }
  return py::make_tuple(rows, found.left);
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
  m.def("formatted", &formatted, py::arg("code"), py::arg("name"), py::arg("blanks"),
        py::arg("indent"), py::arg("capitals"), py::arg("points"));
  m.def("refused_blocks", &refused_blocks, py::arg("code"));
  m.def("mentions", &mentions, py::arg("code"), py::arg("machine"), py::arg("kinds"),
        py::arg("lines") = py::none(), py::arg("name") = py::none());
  m.def("variables_used", &variables_used, py::arg("program"));
  m.def("written_variables", &written_variables, py::arg("code"), py::arg("most"));
  m.def("each_call", &each_call, py::arg("code"), py::arg("take"));
}

}  // namespace cncsub::bindings
