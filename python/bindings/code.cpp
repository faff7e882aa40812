#include "cncsub/code/code.hpp"

#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <utility>

#include "bindings.hpp"
#include "cncsub/control/variable_table.hpp"
#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/library.hpp"
#include "cncsub/system/freed_memory.hpp"
#include "cncsub/system/kept_memory.hpp"
#include "cncsub/system/memory.hpp"
#include "cncsub/text/words.hpp"
#include "gil.hpp"
#include "program_data.hpp"
#include "text.hpp"

namespace py = pybind11;

namespace cncsub::bindings {

namespace {

/// Return the listed programs in their order: those of the memory or of the external device.
template <class Row>
py::list listed(const Code& code, bool external, const Row& row) {
  py::list rows;
  for (std::size_t i = 0; i < code.programs.size(); ++i) {
    const Program& program = code.programs[i];
    if (code.files[program.file].external == external && is_listed(code, program))
      rows.append(row(i));
  }
  return rows;
}
py::list names(const Code& code, bool external) {
  return listed(code, external, [&](std::size_t i) { return code.name_of(code.programs[i]); });
}
py::list places(const Code& code, bool external) {
  return listed(code, external, [](std::size_t i) { return i; });
}

/// Return the duplicates. Parts of files are not among them: each file may have its own of one
/// name.
std::vector<std::size_t> duplicates(const Code& code) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < code.programs.size(); ++i)
    if (code.programs[i].duplicate_of != kNoProgram && code.programs[i].inside == kNoProgram)
      found.push_back(i);
  return found;
}

std::optional<std::int32_t> main_of_memory(const Code& code) {
  const std::int32_t main = code.main_program();
  if (main == kNoProgram) return std::nullopt;
  return main;
}

/// Return the group in which a variable is shown, whether it can be read and whether it can be
/// written; nothing where the control has no such variable.
std::optional<std::tuple<std::string, bool, bool>> variable_facts(const Code& code,
                                                                  std::int64_t number) {
  const VariablePlace place = code.place(number);
  if (place.range == nullptr) return std::nullopt;
  const Access access = place.range->access;
  return std::tuple(std::string(group_of(place.kind)), access != Access::WriteOnly,
                    access != Access::ReadOnly && place.kind != VariableKind::Vacant);
}

using FileRow = std::tuple<std::string, std::string, std::vector<py::object>, bool>;

/// Return the contents of a piece: a text, or bytes that are UTF-8.
std::string_view view_of(const py::object& piece) {
  if (PyByteArray_Check(piece.ptr()) != 0)
    return {PyByteArray_AsString(piece.ptr()),
            static_cast<std::size_t>(PyByteArray_Size(piece.ptr()))};
  return piece.cast<std::string_view>();
}

/// Return the pieces as one text, with Ctrl-C let in between. A `Text` is moved out of and left
/// empty.
FileText joined(const std::vector<py::object>& pieces) {
  if (pieces.size() == 1 && py::isinstance<Text>(pieces[0]))
    return std::move(pieces[0].cast<Text&>().text);
  constexpr std::size_t kOnce = std::size_t{1} << 22;
  std::size_t bytes = 0;
  for (const py::object& piece : pieces) bytes += view_of(piece).size();
  FileText text(bytes);
  char* to = text.data();
  for (const py::object& piece : pieces) {
    for (std::string_view left = view_of(piece); !left.empty();) {
      const std::string_view some = left.substr(0, kOnce);
      to = std::copy(some.begin(), some.end(), to);
      left.remove_prefix(some.size());
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
  }
  return text;
}

/// Add a file and whether it is on the external device, or several files. `Texts` are moved out of
/// and left empty.
void add_row(std::vector<SourceFile>& files, const py::handle& row) {
  if (py::len(row) != 2) {
    const auto [name, stem, pieces, external] = row.cast<FileRow>();
    files.push_back({name, stem, joined(pieces), external});
    return;
  }
  auto [texts, external] = row.cast<std::pair<py::object, bool>>();
  for (SourceFile& file : std::exchange(texts.cast<Texts&>().files, {})) {
    file.external = external;
    files.push_back(std::move(file));
  }
}

/// Compile files to a library. Ctrl-C raises an exception: half a library is no library.
std::shared_ptr<Code> compile_files(const std::shared_ptr<Control>& control,
                                    const py::sequence& rows, bool external_device,
                                    std::size_t threads, std::optional<std::size_t> piece,
                                    bool general_only) {
  Sharing sharing;
  sharing.threads = threads;
  if (piece) sharing.piece = std::max<std::size_t>(1, *piece);
  std::vector<SourceFile> files;
  files.reserve(rows.size());
  for (const py::handle& row : rows) add_row(files, row);
  std::shared_ptr<const Code> code;
  {
    GilRelease away;
    code = compile(
        control, std::move(files), external_device,
        [&away] { return away.ask([] { return PyErr_CheckSignals() != 0; }); }, sharing,
        general_only);
  }
  if (!code) throw py::error_already_set();
  return std::const_pointer_cast<Code>(code);
}

/// Kind and text of each token of a block; of a word also its address, its value and its text
/// without blanks and comments.
py::list tokens(ReadWord read, std::string_view block) {
  py::list rows;
  TokenReader reader(read, block);
  while (const auto token = reader.next()) {
    const auto written = py::str(std::string(block.substr(token->at, token->width)));
    const auto kind = py::str(std::string(to_string(token->kind)));
    const WrittenWord& word = token->word;
    if (token->kind == BlockToken::Kind::Word)
      rows.append(py::make_tuple(kind, written, word.address,
                                 word.known ? py::object(py::float_(word.value)) : py::none(),
                                 word.text));
    else
      rows.append(py::make_tuple(kind, written, "", py::none(), ""));
    if (rows.size() % 4096 == 0 && PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  return rows;
}

/// Return the variables of the control itself: the first and the last number of each range, and
/// what they hold.
std::vector<std::tuple<std::int32_t, std::int32_t, std::string>> system_variables(
    const Code& code) {
  std::vector<std::tuple<std::int32_t, std::int32_t, std::string>> found;
  for (const VariableRange& of : code.control->variables) {
    const bool of_programs = of.kind == VariableKind::Local || of.kind == VariableKind::Common ||
                             of.kind == VariableKind::Kept;
    if (!of_programs) found.emplace_back(of.first, of.last, what_it_holds(of.kind));
  }
  return found;
}

/// Return "local", "common" or "kept" for a variable of programs, "image" for a local by the number
/// of its level, "control" for one of the control; empty where there is none.
std::string variable_kind(const Code& code, std::int64_t number) {
  const VariablePlace place = code.place(number);
  if (place.range == nullptr) return "";
  switch (place.kind) {
    case VariableKind::Local:
      return "local";
    case VariableKind::Common:
      return "common";
    case VariableKind::Kept:
      return "kept";
    case VariableKind::LevelImage:
      return "image";
    default:
      return "control";
  }
}

}  // namespace

void add_code(py::module_& m) {
  m.def(
      "tokens",
      [](const std::shared_ptr<Control>& control, const std::string& block) {
        return tokens(find_dialect(control->dialect)->read_word, block);
      },
      py::arg("control"), py::arg("block"));
  py::class_<ProgramData>(m, "ProgramData", py::is_final())
      .def_property_readonly(
          "code", [](const ProgramData& p) { return std::const_pointer_cast<Code>(p.code); })
      .def_property_readonly("name",
                             [](const ProgramData& p) { return p.code->name_of(p.program()); })
      .def_property_readonly("file", [](const ProgramData& p) { return p.file().name; })
      .def_property_readonly("line", [](const ProgramData& p) { return p.program().line; })
      .def_property_readonly("text",
                             [](const ProgramData& p) {
                               return p.file().text.view().substr(
                                   p.program().text, p.program().text_end - p.program().text);
                             })
      .def_property_readonly("span",
                             [](const ProgramData& p) {
                               const Program& of = p.program();
                               return std::tuple(of.file, of.text, of.text_end);
                             })
      .def_property_readonly(
          "has_head",
          [](const ProgramData& p) { return p.program().name_length != Program::kOfFile; })
      .def_property_readonly("system", [](const ProgramData& p) { return p.file().system; })
      .def_property_readonly("inside",
                             [](const ProgramData& p) { return p.program().inside != kNoProgram; })
      .def(
          "start",
          [](const ProgramData& p, std::size_t size) {
            const std::size_t whole = p.program().text_end - p.program().text;
            return bytes_of(p.file().text, p.program().text, std::min(size, whole));
          },
          py::arg("size"))
      .def_property_readonly("comment",
                             [](const ProgramData& p) { return p.code->comment_of(p.program()); })
      .def_property_readonly("external", [](const ProgramData& p) { return p.file().external; })
      .def_property_readonly("duplicate_of",
                             [](const ProgramData& p) { return p.program().duplicate_of; })
      .def_property_readonly(
          "blocks", [](const ProgramData& p) { return p.program().last - p.program().first; })
      .def("block",
           [](const ProgramData& p, std::size_t i) {
             const Block& block = p.block(i);
             return py::make_tuple(sequence_number(block.n), block.line,
                                   py::str(std::string(p.code->text_of(block, p.program()))));
           })
      .def("column",
           [](const ProgramData& p, std::size_t i) {
             const std::string_view text = p.file().text.view();
             const std::size_t at = p.block(i).text;
             const std::size_t end_before = at == 0 ? text.npos : text.rfind('\n', at - 1);
             const std::string_view before =
                 text.substr(end_before + 1, at - (end_before + 1));  // npos + 1 is 0
             return 1 + std::count_if(before.begin(), before.end(),
                                      [](char c) { return !is_inside_character(c); });
           })
      .def("tokens", [](const ProgramData& p, std::size_t i) {
        return tokens(p.code->read_word, p.code->text_of(p.block(i), p.program()));
      });
  py::class_<Code, std::shared_ptr<Code>>(m, "Code", py::is_final())
      .def_property_readonly(
          "control", [](const Code& c) { return std::const_pointer_cast<Control>(c.control); })
      .def(
          "program",
          [](const std::shared_ptr<Code>& c, std::size_t i) {
            if (i >= c->programs.size()) throw py::index_error("no such program");
            return ProgramData{c, i};
          },
          py::arg("index"))
      .def(
          "place_of",
          [](const Code& c, Address address) {
            if (address >= c.blocks.size()) throw py::index_error("no such block");
            const std::int32_t program = c.program_at(address);
            return std::pair(program,
                             address - c.programs[static_cast<std::size_t>(program)].first);
          },
          py::arg("address"))
      .def("names", &names, py::arg("external") = false)
      .def_property_readonly("variable_sign",
                             [](const Code& c) { return std::string(c.spelling->variable); })
      .def("variable_kind", &variable_kind, py::arg("number"))
      .def("places", &places, py::arg("external") = false)
      .def_property_readonly("duplicates", &duplicates)
      .def("variable_facts", &variable_facts, py::arg("number"))
      .def_property_readonly("system_variables", &system_variables)
      .def("__len__", [](const Code& c) { return c.programs.size(); })
      .def_property_readonly("main", &main_of_memory)
      .def_property_readonly("sources",
                             [](const Code& c) {
                               py::list rows;
                               for (const SourceFile& file : c.files)
                                 if (!file.system)
                                   rows.append(py::make_tuple(file.name, file.stem,
                                                              bytes_of(file.text), file.external));
                               return rows;
                             })
      .def_property_readonly("leaders",
                             [](const Code& c) {
                               py::list rows;
                               for (const SourceFile& file : c.files)
                                 if (file.leader > 0)
                                   rows.append(py::make_tuple(file.name, file.leader));
                               return rows;
                             })
      .def_readonly("external_device", &Code::external_device)
      .def_readonly("general_only", &Code::general_only)
      .def(
          "find",
          [](const Code& c, const std::string& name, bool external) {
            return c.find(name, external);
          },
          py::arg("name"), py::arg("external") = false)
      .def(
          "find",
          [](const Code& c, std::int64_t number, bool external) {
            return c.find(number, external);
          },
          py::arg("name"), py::arg("external") = false)
      .def(
          "with_mdi",
          [](const Code& c, const std::string& text) {
            std::shared_ptr<const Code> with;
            {
              GilRelease away;
              with = compile_mdi(
                  c, text, [&away] { return away.ask([] { return PyErr_CheckSignals() != 0; }); });
            }
            if (!with) throw py::error_already_set();
            return std::const_pointer_cast<Code>(with);
          },
          py::arg("text"));
  m.def(
      "unify_line_ends",
      [](const py::bytes& text) {
        std::string unified = text;
        InterruptCheck never;
        cncsub::unify_line_ends(unified.data(), unified.data() + unified.size(), never);
        return py::bytes(unified);
      },
      py::arg("text"));
  m.def(
      "give_back_memory",
      [] {
        system::give_back_large_memory();
        system::give_back_freed_memory();
      },
      py::call_guard<py::gil_scoped_release>());
  m.def("compile", &compile_files, py::arg("control"), py::arg("files"),
        py::arg("external_device") = false, py::kw_only(), py::arg("threads") = 0,
        py::arg("piece") = py::none(), py::arg("general_only") = false);
}

}  // namespace cncsub::bindings
