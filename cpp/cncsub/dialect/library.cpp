#include "cncsub/dialect/library.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include "cncsub/code/parameters.hpp"
#include "cncsub/code/target.hpp"
#include "cncsub/control/variable_table.hpp"
#include "cncsub/dialect/dialect.hpp"
#include "cncsub/system/kept_memory.hpp"

namespace cncsub {

const Dialect* find_dialect(std::string_view name) {
  static const Dialect kDialects[] = {
#define DIALECT(folder) \
  {#folder,             \
   folder##_reader,     \
   folder##_expression, \
   folder##_word,       \
   folder##_pieces,     \
   folder##_other_mode, \
   &folder##_spelling,  \
   folder##_rules,      \
   folder##_word_uses,  \
   folder##_keywords,   \
   folder##_precision},
#include "dialect/list.def"
#undef DIALECT
  };
  for (const Dialect& dialect : kDialects)
    if (dialect.name == name) return &dialect;
  return nullptr;
}

namespace {

constexpr std::size_t kProgram = 64;  // the work of giving a program its names, in bytes

void find_near_variables(Code& code) {
  std::size_t count = 0;
  for (const PlacedRange& placed : code.variables) {
    const VariableRange& range = placed.range;
    const VariablePlace place = code.place(range.first);
    const bool near = (place.is_local() || place.is_common()) && range.access != Access::WriteOnly;
    if (count == code.direct_variables.ranges.size() || !near) continue;
    code.direct_variables.ranges[count++] = {
        static_cast<std::uint32_t>(range.first),
        static_cast<std::uint32_t>(range.last - range.first + 1),
        place.is_local() ? Ins::LocalRaw : Ins::CommonRaw, static_cast<std::uint32_t>(place.index),
        place.is_local() || range.access == Access::ReadWrite};
  }
}

void number_variables(Code& code) {
  for (const VariableRange& range : variable_ranges(*code.control)) {
    if (range.kind == VariableKind::Local) {
      code.locals = std::max(code.locals, range.last + 1);
      code.locals_per_level = range.last - range.first + 1;
    }
    code.variables.push_back({range, code.commons});
    if (is_alias(range)) continue;
    if (range.kind == VariableKind::Common || range.kind == VariableKind::Kept)
      code.commons += range.last - range.first + 1;
  }
  for (PlacedRange& placed : code.variables)
    if (is_alias(placed.range)) placed.base = code.place(placed.range.from).index;
  if (!code.general_only) find_near_variables(code);
}

/// List what each block and each statement asks of the control.
void list_codes(Code& code) {
  if (code.general_only) code.code_lists.keep_none();
  const ReadingRules& rules = code.control->reading;
  rules.g_codes.value.for_each(
      [&](int code10) { code.g_codes.set(static_cast<std::size_t>(code10)); });
  if (code.g_codes.none() || rules.unlisted_codes.value == UnlistedCode::NotKnown)
    code.g_codes.set();
  cncsub::list_statements(code);
}

void resolve_codes(Code& code) {
  code.meanings = std::make_shared<const CodeMeanings>(
      *code.control, code.control->motion.machine.value, code.code_lists, code.word_uses);
}

bool has_constant_operands(const CallRecord& call) {
  for (const Operand* operand : {&call.p, &call.l, &call.start(), &call.device()})
    if (operand->kind == Operand::Kind::Expression) return false;
  return true;
}

/// Make a code ready for programs.
void prepare(Code& code, std::shared_ptr<const Control> control, const Dialect& dialect) {
  code.control = std::move(control);
  code.read_word = dialect.read_word;
  code.spelling = dialect.spelling;
  code.word_uses = dialect.word_uses;
  code.texts.number_of("");  // the value 0, of a text that was given nothing
  number_variables(code);
  if (!code.control->calls.search_path.value.empty()) code.call_path = code.commons++;
  list_codes(code);
}

const Dialect& dialect_of(const Control& control) {
  const Dialect* dialect = find_dialect(control.dialect);
  if (dialect == nullptr) throw std::invalid_argument("no dialect is called " + control.dialect);
  return *dialect;
}

/// Return the program of the control itself that a call leads to: one that no file has.
const SystemProgram* system_program(const Code& code, const CallRecord& call) {
  const std::string& name = call.name();
  if (name.empty()) return nullptr;
  for (const SystemProgram& of : code.control->system_programs)
    if (of.name.size() == name.size() && std::equal(name.begin(), name.end(), of.name.begin(),
                                                    [](char a, char b) { return upper(a) == b; }))
      return code.find(name) == kNoProgram ? &of : nullptr;
  return nullptr;
}

Fault not_computed(const CallRecord& call, const SystemProgram& called) {
  const CallExtras& extras = call.extras.get();
  std::string detail = "cncsub does not compute ";
  if (!called.is_inner()) {
    detail.append(called.name);
    if (!called.needs.empty()) detail += ": ";
  }
  return {Cause::CodeNotComputed, extras.name_at, extras.name_width, detail.append(called.needs)};
}

/// The reading of a library's files.
class Reading {
 public:
  Reading(Code& code, const std::function<bool()>& interrupted, ProgramNames other_mode)
      : code_(code),
        interrupt_(interrupted),
        to_(code, interrupt_),
        dialect_(dialect_of(*code.control)),
        other_mode_(std::move(other_mode)),
        read_(dialect_.reader(to_, other_mode_)) {}

  void read(std::vector<SourceFile>& files, const Sharing& sharing) {
    const std::function<void(Code&)> other = [this](Code& code) {
      prepare(code, code_.control, dialect_);
      code.external_device = code_.external_device;
    };
    read_files({code_, to_, read_, dialect_, other_mode_, other}, files, sharing);
  }

  /// Read the programs of the control itself that something calls and the user has not: their own
  /// calls too. The programs before are registered. Return their names.
  std::vector<std::string_view> read_system_programs() {
    std::vector<std::string_view> names;
    if (code_.control->system_programs.empty()) return names;
    for (std::size_t i = 0; i < code_.calls.size(); ++i) {
      if (interrupt_.requested(InterruptCheck::kBlock)) break;
      const SystemProgram* const called = system_program(code_, code_.calls[i]);
      if (called == nullptr || called->text.empty() ||
          std::find(names.begin(), names.end(), called->name) != names.end())
        continue;
      names.push_back(called->name);
      read_system_program(*called);
    }
    return names;
  }
  /// Read these programs of the control, and register and resolve them.
  void read_system_programs(const std::vector<std::string_view>& names) {
    const std::size_t before = code_.programs.size();
    for (const SystemProgram& of : code_.control->system_programs)
      if (std::find(names.begin(), names.end(), of.name) != names.end()) read_system_program(of);
    code_.register_programs([this] { return interrupted(kProgram); });
    resolve_calls(before);
  }
  void read_system_program(const SystemProgram& program) {
    const std::string name(program.name);
    SourceFile& file = code_.files.emplace_back();
    file.name = file.stem = name;
    file.text = FileText(program.text);
    file.system = true;
    read_(static_cast<std::uint32_t>(code_.files.size() - 1));
  }

  /// Decide, once and for all, the calls whose operands are written as numbers, in program `from`
  /// and those after it. The files have been read.
  void resolve_calls(std::size_t from) {
    to_.names().sort_heads();
    if (code_.calls.empty()) return;
    mark_part_ends();
    seen_.assign(code_.variants.size(), false);
    for (std::size_t p = from; p < code_.programs.size(); ++p)
      for (Address a = code_.programs[p].first;
           a < code_.programs[p].last && !interrupt_.requested(InterruptCheck::kBlock); ++a)
        resolve_block(code_.blocks[a], static_cast<std::int32_t>(p));
  }

  /// Let each block at which a part may end ask for its end, where parts are found as they run.
  void mark_part_ends() {
    const auto searched = [](const CallRecord& of) { return of.extras.get().first_text.present(); };
    if (std::none_of(code_.calls.begin(), code_.calls.end(), searched)) return;
    const auto mark = [this](std::size_t last) {
      if (last + 1 < code_.blocks.size()) code_.blocks[last + 1].skip |= Block::kPartEnd;
    };
    for (const LabelledHead& head : code_.heads) mark(head.address);
    for (std::size_t i = 0; i < code_.blocks.size(); ++i)
      if (code_.blocks[i].n >= 0) mark(i);
  }

  bool interrupted(std::size_t bytes) { return interrupt_.requested(bytes); }

 private:
  void resolve_block(Block& block, std::int32_t own) {
    if (block.op == Op::Select) {
      const Select variant = code_.selects[block.aux];
      resolve_variant(variant.first, own);
      resolve_variant(variant.second, own);
    } else if (block.op == Op::ParallelAssign) {
      const std::uint32_t words = code_.parallel_assigns[block.aux].words;
      if (words != OWord::kNone) resolve_variant(words, own);
    } else if (block.op == Op::Call || block.op == Op::MacroCall || block.op == Op::ModalCall) {
      resolve_call(block, code_.calls[block.aux], own);
    }
  }

  void resolve_variant(std::uint32_t i, std::int32_t own) {
    if (seen_[i]) return;
    seen_[i] = true;
    resolve_block(code_.variants[i], own);
  }

  void resolve_call(Block& block, CallRecord& call, std::int32_t own) {
    if (call.kind == CallKind::OWord) return;  // the reader has found the label
    const CallExtras& named = call.extras.get();
    if (call.kind == CallKind::Named && !means_one(code_, named.name, named.path))
      return choose_as_it_runs(block.aux);
    const std::int32_t program =
        call.kind == CallKind::Named ? find_called(code_, named.name, named.path, {}) : kNoProgram;
    if (auto fault = pass_parameters(code_, call, program))
      return to_.refuse(block, std::move(*fault));
    if (const SystemProgram* const called = system_program(code_, call))
      return to_.refuse(block, not_computed(call, *called));
    if (!has_constant_operands(call)) return;
    const CallOperands operands{call.p.value, call.l.value, call.start().value,
                                call.device().value};
    Target target;
    if (auto fault = decode_call(code_, call, operands, own, target))
      return to_.refuse(block, std::move(*fault));
    if (code_.general_only || find_target(code_, call, target, {}))
      return;  // reported when the call is reached
    call.target = target;
    call.constant = true;
  }

  /// Make a record for each program that a call may mean: the folder of the main program decides.
  void choose_as_it_runs(std::uint32_t number) {
    std::vector<CallChoice> choices;
    for (const std::int32_t program :
         programs_named(code_, code_.calls[number].extras.get().name)) {
      CallRecord one = code_.calls[number];
      CallChoice choice{program, static_cast<std::uint32_t>(code_.calls.size())};
      if (auto fault = pass_parameters(code_, one, program)) {
        choice.fault = static_cast<std::uint32_t>(code_.faults.size());
        code_.faults.push_back(std::move(*fault));
      }
      code_.calls.push_back(std::move(one));
      choices.push_back(choice);
    }
    CallRecord& call = code_.calls[number];
    call.extras.make().choices = std::move(choices);
    pass_parameters(code_, call, kNoProgram);  // what it reads is known where no program is found
  }

  Code& code_;
  InterruptCheck interrupt_;
  Builder to_;
  const Dialect& dialect_;
  ProgramNames other_mode_;
  FileReader read_;
  std::vector<bool> seen_;  // variants, which several blocks may share
};

/// Free many megabytes in a thread of its own. The system takes its time over them, and whoever
/// interrupted the reading must not wait.
void free_aside(std::shared_ptr<Code> code, std::vector<SourceFile> files) {
  try {
    std::thread([code = std::move(code), files = std::move(files)] {}).detach();
  } catch (const std::system_error&) {  // NOLINT: no thread to be had, it was freed here
  }
}

/// Return whether this character stands in the first lines of a file: # stands for macro statements
/// or computed words, N for numbered blocks.
bool begin_with(const std::vector<SourceFile>& files, char mark) {
  constexpr std::size_t kFirst = std::size_t{1} << 16;  // bytes of a file: not all of a large one
  std::size_t left = std::size_t{1} << 20;              // bytes of all files
  return std::any_of(files.begin(), files.end(), [&](const SourceFile& file) {
    const std::string_view first = file.text.view().substr(0, std::min(kFirst, left));
    left -= first.size();
    return first.find(mark) != std::string_view::npos;
  });
}

/// What is compiled, and how.
struct Compiling {
  const std::function<bool()>& interrupted;
  const Sharing& sharing;
};

/// Compile a code whose control and dialect are known. Return false where it was interrupted.
bool compile_files(Code& code, std::vector<SourceFile>& files, const ProgramNames& other_mode,
                   const Compiling& how) {
  Reading reading(code, how.interrupted, other_mode);
  std::size_t bytes = 0;
  for (const SourceFile& file : files) bytes += file.text.size();
  // Room that is never written costs nothing, and a table that never moves is never copied.
  code.blocks.reserve(bytes / 8 + files.size());
  code.cells.reserve(bytes / 4);
  if (begin_with(files, '#')) {
    code.statements.reserve(bytes / 32);
    code.expressions.reserve(bytes / 2);
  }
  if (begin_with(files, 'N')) code.sequence.reserve(bytes / 8);
  reading.read(files, how.sharing);
  const auto over = [&reading] { return reading.interrupted(kProgram); };
  code.register_programs(over);
  if (!reading.read_system_programs().empty()) code.register_programs(over);
  reading.resolve_calls(0);
  resolve_codes(code);
  system::give_back_large_memory();
  return !reading.interrupted(0);
}

/// Return the programs of the user that calls mean in the other mode of the language.
ProgramNames in_other_mode(const Code& code, const Dialect& dialect, const ProgramNames& known) {
  if (dialect.other_mode == nullptr) return {};
  const ProgramNames found = dialect.other_mode(code);
  ProgramNames all;
  std::set_union(known.begin(), known.end(), found.begin(), found.end(), std::back_inserter(all));
  return all;
}

/// Take the files back that were read into a code.
std::vector<SourceFile> files_of(Code& code) {
  std::vector<SourceFile> files;
  for (SourceFile& file : code.files)
    if (!file.system) files.push_back({file.name, file.stem, std::move(file.text), file.external});
  return files;
}

}  // namespace

std::shared_ptr<const Code> compile(const std::shared_ptr<const Control>& control,
                                    std::vector<SourceFile> files, bool external_device,
                                    const std::function<bool()>& interrupted,
                                    const Sharing& sharing, bool general_only) {
  const Dialect& dialect = dialect_of(*control);
  std::stable_partition(files.begin(), files.end(), [&](const SourceFile& file) {
    return defines_for_all(*dialect.spelling, file);
  });
  // Each reading finds the programs of the next level of calls in the other mode of the language.
  // Calls nested deeper than the control allows are never reached.
  const int most_readings = control->calls.max_nesting.value + 2;
  ProgramNames other_mode;
  for (int reading = 1;; ++reading) {
    auto code = std::make_shared<Code>();
    code->general_only = general_only;
    code->external_device = external_device;
    prepare(*code, control, dialect);
    if (!compile_files(*code, files, other_mode, {interrupted, sharing})) {
      free_aside(std::move(code), std::move(files));
      return nullptr;
    }
    ProgramNames found = in_other_mode(*code, dialect, other_mode);
    if (found == other_mode || reading >= most_readings) return code;
    other_mode = std::move(found);
    files = files_of(*code);
  }
}

std::shared_ptr<const Code> compile_mdi(const Code& code, const std::string& text,
                                        const std::function<bool()>& interrupted,
                                        const Texts* made) {
  const auto copied = [&] {
    auto copy = std::make_shared<Code>(code);
    for (std::size_t i = 0; made != nullptr && i < made->size(); ++i)
      copy->texts.number_of(made->at(i));
    return copy;
  };
  auto with = copied();
  std::size_t programs = with->programs.size();
  const ProgramNames other_mode = in_other_mode(code, dialect_of(*code.control), {});
  std::optional<Reading> reading(std::in_place, *with, interrupted, other_mode);
  std::vector<SourceFile> typed{{"MDI", "MDI", FileText(text), false}};
  reading->read(typed, {.threads = 1});
  if (const auto names = reading->read_system_programs(); !names.empty()) {
    // The typed text is the last program, so what it calls is read before it.
    reading.reset();
    with = copied();
    reading.emplace(*with, interrupted, other_mode);
    reading->read_system_programs(names);
    programs = with->programs.size();
    typed = {{"MDI", "MDI", FileText(text), false}};
    reading->read(typed, {.threads = 1});
  }
  // A text typed in MDI is no program of the memory: it is not registered, and nothing finds it.
  reading->resolve_calls(programs);
  resolve_codes(*with);
  with->blocks.back().skip |= Block::kPartEnd;  // it may be typed in the middle of a run
  if (!reading->interrupted(0)) return with;
  free_aside(std::move(with), {});
  return nullptr;
}

}  // namespace cncsub
