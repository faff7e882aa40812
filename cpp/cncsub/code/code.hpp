// The programs of a library, compiled: every block once, against the control's rules, into flat
// arrays.
//
// A block's address is one number, its place in `Code::blocks`, and so is a jump target, a return
// address and the origin of a step. A block that the control would refuse is kept as the fault it
// will raise when it is reached.
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "cncsub/code/block.hpp"
#include "cncsub/code/call.hpp"
#include "cncsub/code/expression.hpp"
#include "cncsub/code/fault.hpp"
#include "cncsub/code/o_word.hpp"
#include "cncsub/code/open_table.hpp"
#include "cncsub/code/program.hpp"
#include "cncsub/code/spelling.hpp"
#include "cncsub/code/statement.hpp"
#include "cncsub/code/texts.hpp"
#include "cncsub/code/word_uses.hpp"
#include "cncsub/control/control.hpp"
#include "cncsub/system/kept_memory.hpp"
#include "cncsub/text/number.hpp"
#include "cncsub/text/words.hpp"

namespace cncsub {

using system::LargeVector;

/// The most digits of a number, whatever a rule says: a double holds no more.
constexpr int kMostDigits = 15;
inline int most_digits(const Control& control) {
  return std::min<int>(control.reading.max_digits.value, kMostDigits);
}

/// The place of a variable.
struct VariablePlace {
  VariableKind kind = VariableKind::Common;
  std::int32_t index = -1;  // Local: the number itself; Common and Kept: the place among the
                            // commons; else number - first
  const VariableRange* range = nullptr;  // null: there is no such variable

  bool is_local() const { return range != nullptr && kind == VariableKind::Local; }
  bool is_common() const {
    return range != nullptr && (kind == VariableKind::Common || kind == VariableKind::Kept);
  }
};

/// A range of variables, and where the first of its commons lies.
struct PlacedRange {
  VariableRange range;
  std::int32_t base = 0;
};

/// The block from which on a control structure is the innermost one; `first` and `last`: its own
/// blocks; kNowhere: it has no end, or there is no structure.
struct StructureMark {
  Address from, first = kNowhere, last = kNowhere;
};

/// Locals, or some of the first commons: where they lie, and the instruction that pushes a value
/// that may be vacant.
struct DirectVariables {
  std::uint32_t first = 0, count = 0;
  Ins raw{};
  std::uint32_t base = 0;  // where the first lies
  bool writable = false;
};

/// The ranges of the variables that programs use most.
struct DirectVariableRanges {
  std::array<DirectVariables, 3> ranges{};

  /// Return the range that holds a variable; null where none does.
  const DirectVariables* find(std::uint32_t number) const {
    for (const DirectVariables& of : ranges)
      if (number - of.first < of.count) return &of;
    return nullptr;
  }
};

constexpr std::size_t kLookedAt = 65535;  // bytes of a block in which words are looked for

struct Code {
  std::shared_ptr<const Control> control;
  std::vector<PlacedRange> variables;  // by number
  DirectVariableRanges direct_variables;
  ReadWord read_word = nullptr;        // of the dialect that the programs are written in
  const Spelling* spelling = nullptr;  // the same
  std::span<const WordUse>
      word_uses;  // the words that it refuses without a code; none: it takes all
  bool external_device = false;
  bool general_only = false;   // read and run by the general path alone, see `compile`
  std::bitset<10001> g_codes;  // the codes of the control, ten times each; all where it has no list
  std::bitset<16> lacking;     // kinds of statements that the control does not have, or
  std::bitset<16> unheard_of;  // that no source tells of, which are lacking too
  std::vector<std::string> names;      // of variables used by name
  std::int32_t locals = 34;            // the locals of one level, #0 included
  std::int32_t locals_per_level = 33;  // as a level's image counts them
  std::int32_t commons = 0;
  std::int32_t elements = 0;  // of the arrays of one level
  std::unordered_map<std::string, std::int32_t>
      hidden_locals;                       // the first of each, by what they are for
  std::vector<std::vector<double>> lists;  // numbers of which an expression chooses one
  std::vector<SourceFile> files;
  std::vector<std::string> folders{""};  // of the control; the first is none that is known
  std::int32_t call_path = -1;  // among the commons: the text of the folder that a program adds to
                                // those that are searched; -1: the control has no such statement
  LargeVector<Program> programs;
  LargeVector<Block> blocks;
  LargeVector<Block> variants;
  LargeVector<Cell> cells;
  CodeLists code_lists;
  std::shared_ptr<const CodeMeanings> meanings;  // on the control's own kind of machine
  OpenTable<ExpressionCell> expressions;  // one after the other; a number is where one begins
  LargeVector<CallRecord> calls;
  std::vector<JumpRecord> jumps;
  LargeVector<Argument> arguments;
  std::vector<FormalParameter> formal_parameters;  // one program's after the other's
  LargeVector<Statement> statements;
  std::vector<HCode> h_codes;
  std::vector<OWord> o_words;
  std::vector<std::string> labels{""};  // the first is none
  std::unordered_map<std::string, std::uint32_t> label_places;
  std::vector<LabelledHead> heads;  // by label, then by address
  std::vector<NamedVariable> named_variables;
  std::unordered_map<std::string, std::uint32_t> named_places;
  std::array<std::unordered_map<std::int32_t, std::uint32_t>, 2>
      named_at;                // locals, commons by index
  std::int32_t returned = -1;  // among the commons: what the last subprogram returned, and whether
  std::vector<DefinedVariable> defined_variables;             // one program's after the other's
  std::vector<DefinedVariable> shared_variables;              // of all programs
  std::vector<std::pair<std::int32_t, double>> first_values;  // of commons, when a run begins
  Texts texts;                                                // the first is empty
  std::vector<StructureMark> structures;  // of programs whose jumps are computed, by address
  std::vector<cncsub::ParallelAssign> parallel_assigns;
  std::vector<Print> prints;
  std::vector<Select> selects;
  std::vector<Fault> faults;
  std::vector<Drop> drops;  // in the order of their blocks' data
  LargeVector<SequenceEntry> sequence;
  std::array<ProgramIndex, 2> by_number, by_name;  // of the memory, of the external device

  Expression expression(std::uint32_t number) const {
    return Expression(expressions.data() + number);
  }
  /// Return the named variable that lies there; null where none does.
  const NamedVariable* named(bool common, std::int32_t index) const {
    const auto found = named_at[common ? 1 : 0].find(index);
    return found == named_at[common ? 1 : 0].end() ? nullptr : &named_variables[found->second];
  }
  VariablePlace place(std::int64_t number) const;
  /// Return whether a program can name this variable: one from 1 to `last`, or a common.
  bool can_name(std::int64_t number, std::int64_t last) const;

  /// Return the fault of a statement of this kind at `at`; nothing where the control has it.
  std::optional<Fault> lacks(StatementKind kind, std::uint32_t at) const {
    if (!lacking.test(static_cast<std::size_t>(kind))) return std::nullopt;
    return lacking_fault(kind, at);
  }
  Fault lacking_fault(StatementKind kind, std::uint32_t at) const;

  /// Return whether a jump leads into a control structure that it does not stand in, in a program
  /// whose jumps are computed.
  bool leads_inside(Address from, Address to) const;
  /// Return the innermost program that holds a block.
  std::int32_t program_at(Address address) const;
  /// Return the label that is this number; OWord::kNone where no block has it.
  std::uint32_t label(std::int64_t number) const;
  /// Return the nearest head of a subprogram from an address on, in the same file.
  Address head_from(std::uint32_t label, Address from) const;
  /// Return the nearest one after a block.
  Address head_behind(std::uint32_t label, Address at) const;
  /// Return the codes of a block that are written as numbers.
  CodeList codes_of(const Block& block) const;
  /// Return the name of a program, with its folder where a program of another folder has the name.
  std::string name_of(const Program& program) const;
  std::string bare_name_of(const Program& program) const;
  std::string name_of(std::int32_t program) const {
    return name_of(programs[static_cast<std::size_t>(program)]);
  }
  std::string_view comment_of(const Program& program) const;
  std::string_view text_of(const Block& block, const Program& program) const;
  /// Return the words as they are written, of the first 65,535 bytes.
  std::vector<WrittenWord> words_of(const Block& block, const Program& program) const;

  /// Return the program that runs where none is named: the first one of the memory, or the first
  /// that is named as a main program. kNoProgram where there is none.
  std::int32_t main_program() const;
  /// Return the program of a number or name; kNoProgram where there is none.
  std::int32_t find(std::int64_t number, bool external = false) const;
  std::int32_t find(std::string_view name, bool external = false) const;

  /// Register every program by its number and its name, and the first one of a file by the file's
  /// name. Of several under one name the first counts. `over` may end it.
  void register_programs(const std::function<bool()>& over);

  /// Return what an alarm says where a program has no block of a number.
  std::string no_block(std::int64_t n, const Program& program) const;
  // Return the block N(n) of a program; kNowhere where there is none.
  Address first_of(const Program& program, std::int64_t n) const;
  Address first_from(const Program& program, std::int64_t n, Address from) const;
  Address next_of(const Program& program, std::int64_t n, Address behind) const;
  Address last_of(const Program& program, std::int64_t n, Address before) const;
  Address jump_target(const Program& program, std::int64_t n, Address from) const;
  Address return_target(const Program& program, std::int64_t n, Address call) const;
  /// Return the block of a program that a return names, N10 or a label, in capitals: the nearest
  /// after the call, or else the first; kNowhere where there is none.
  Address named_return_target(const Program& in, std::string_view name, Address call) const;
};

/// Return whether a list of the user's programs has this one: its name leads to it, and it is no
/// program of the control itself.
inline bool is_listed(const Code& code, const Program& program) {
  return program.duplicate_of == kNoProgram && !code.files[program.file].system;
}
/// Return what the assignment of a block with Op::Set or Op::Assign does.
Statement assignment_of(const Code& code, const Block& block);
/// List the kinds of statements that the control does not have.
void list_statements(Code& code);

/// Return the number in O0023, %23, :23 or 23; -1 where the name is none.
std::int64_t number_in(std::string_view name);

/// Return whether a file defines variables for the programs of all others, which are read after it.
bool defines_for_all(const Spelling& spelling, const SourceFile& file);

}  // namespace cncsub
