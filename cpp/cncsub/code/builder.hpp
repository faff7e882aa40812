// Writes neutral code. Nothing else appends to it: a dialect reads text and says here what it
// means.
//
// A block is made in the reader's hands (its text, line and sequence number are the reader's) and
// becomes what it is by one of the calls below; `append` puts it after the others of its program.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/code/expression_writer.hpp"
#include "cncsub/code/names.hpp"
#include "cncsub/system/compiler.hpp"
#include "cncsub/text/interrupt_check.hpp"

namespace cncsub {

/// A value of a word: a number, or an expression that gives it when the block runs.
struct WordValue {
  bool computed;
  std::uint32_t expression;
  double value;
};

/// The words that a block executes. An address stands once, its later value counts.
struct WordList {
  std::array<WordValue, kGCodesOfBlock>
      g;  // NOLINT: the first `g_count`, ten times what is a number
  std::array<WordValue, kMCodesOfBlock> m;   // NOLINT: the first `m_count`
  std::array<WordValue, kAddresses> values;  // NOLINT: those of the mask
  std::uint32_t mask = 0;
  std::uint32_t whole = 0;  // as in NcWords
  WordForms forms;
  int g_count = 0;
  int m_count = 0;

  void add_g(WordValue code) { g[static_cast<std::size_t>(g_count++)] = code; }
  void add_m(WordValue code) { m[static_cast<std::size_t>(m_count++)] = code; }
  /// Set a word. `address`: its place in a mask.
  void set(int address, WordValue value, bool is_whole) {
    const std::uint32_t mark = 1u << address;
    values[static_cast<std::size_t>(address)] = value;
    mask |= mark;
    whole = is_whole ? whole | mark : whole & ~mark;
  }
};

class Builder;

/// Files, or lines in the middle of a file, that were read into a code of their own.
struct Joined {
  Builder& from;
  Code& code;
  std::vector<int>& lists;  // the numbers of its lists of codes in the other code
  bool goes_on = false;     // its first program is the rest of the one that is written there
  std::uint32_t line = 0;   // how many lines of the file stand before it
  double to_come = 0;  // how much is still to be read, as a multiple of what is joined with this
};

/// Return whether what another builder wrote can be put after the blocks of this one.
bool can_join(Builder& to, const Joined& of);
/// Put it there, and leave the other one's code without blocks, to be written anew.
void join(Builder& to, Joined& of);

class Builder {
 public:
  friend struct Joint;  // of `join`

  Builder(Code& code, InterruptCheck& interrupt)
      : code_(code),
        interrupt_(interrupt),
        expressions_(code),
        names_(code),
        first_drop_(code.drops.size()) {}

  const Code& code() const { return code_; }
  const Control& control() const { return *code_.control; }
  InterruptCheck& interrupt() { return interrupt_; }
  ExpressionWriter& expressions() { return expressions_; }
  Names& names() { return names_; }

  // ---- programs ----

  bool in_program() const { return in_program_; }
  /// Return the program that was begun last.
  Program& program() { return code_.programs.back(); }
  /// Begin a program whose first block comes next.
  void begin_program(const Program& program);
  /// End the program where its text ends; its blocks can be found by their numbers from now on.
  void end_program(std::uint32_t text_end, std::uint32_t line);
  /// Take the last program away, with its blocks. `leader`: so many lines at the head of its file
  /// are no program.
  void drop_program(std::int32_t leader = 0);
  /// Add a program that is a part of the one that was ended last, or of another before it.
  void part(const Program& program);

  // ---- blocks, and the records of what they do ----

  Address next_address() const { return static_cast<Address>(code_.blocks.size()); }
  void append(const Block& block) {
    if (block.n >= 0) code_.sequence.push_back({block.n, next_address()});
    code_.blocks.push_back(block);
  }
  Block& block(Address address) { return code_.blocks[address]; }

  /// Keep a record and return its number. A block that is kept so is executed by another one, a
  /// Select or an IfThen.
  template <class Record>
  std::uint32_t keep(Record record) {
    auto& kept = table<Record>();
    kept.push_back(std::move(record));
    return static_cast<std::uint32_t>(kept.size() - 1);
  }
  template <class Record>
  Record& record(std::uint32_t number) {
    return table<Record>()[number];
  }
  /// Make the block do what the record says.
  template <class Record>
  void become(Block& block, Op op, Record record) {
    block.op = op;
    block.aux = keep(std::move(record));
  }
  /// Make the block a fault: the control refuses it when it is reached.
  void refuse(Block& block, Fault fault) { become(block, Op::Fault, std::move(fault)); }
  /// Make the block assignments beside a message and words.
  void parallel_assign(Block& block, const std::vector<Statement>& statements, const Print* print,
                       const Block* words);
  /// Return the place of the next argument; those of one call follow each other.
  std::uint32_t next_argument() const { return static_cast<std::uint32_t>(code_.arguments.size()); }

  /// Return the place of the next parameter that a program declares; those of one follow each
  /// other.
  std::uint32_t next_parameter() const {
    return static_cast<std::uint32_t>(code_.formal_parameters.size());
  }
  /// Add a parameter to those of the program that was begun last.
  void parameter(const FormalParameter& formal) {
    code_.formal_parameters.push_back(formal);
    ++program().parameters;
  }

  /// Keep the control structures of the program that was ended last.
  void structures(const std::vector<StructureMark>& marks) {
    code_.structures.insert(code_.structures.end(), marks.begin(), marks.end());
  }

  // ---- words ----

  /// Give the block its words. One with nothing but a plain move becomes Op::Linear or Op::Arc.
  void words(Block& block, const WordList& words);
  /// Record a word that the control reads and does not obey, of the block whose words come next.
  void drop(std::uint32_t at, std::uint32_t width) { code_.drops.push_back({0, at, width}); }
  /// Give words to a block of whole G codes, perhaps an M code (-1: none), and `values` by letter:
  /// those of the mask, expressions where `extra` says so.
  void plain_words(Block& block, std::span<const int> g, int m, std::uint32_t mask,
                   const Cell::Extra& extra, const std::array<Cell, 26>& values);

 private:
  template <class Record>
  auto& table() {
    if constexpr (std::is_same_v<Record, Block>)
      return code_.variants;
    else if constexpr (std::is_same_v<Record, CallRecord>)
      return code_.calls;
    else if constexpr (std::is_same_v<Record, JumpRecord>)
      return code_.jumps;
    else if constexpr (std::is_same_v<Record, Argument>)
      return code_.arguments;
    else if constexpr (std::is_same_v<Record, Statement>)
      return code_.statements;
    else if constexpr (std::is_same_v<Record, HCode>)
      return code_.h_codes;
    else if constexpr (std::is_same_v<Record, OWord>)
      return code_.o_words;
    else if constexpr (std::is_same_v<Record, ParallelAssign>)
      return code_.parallel_assigns;
    else if constexpr (std::is_same_v<Record, Print>)
      return code_.prints;
    else if constexpr (std::is_same_v<Record, Select>)
      return code_.selects;
    else if constexpr (std::is_same_v<Record, Fault>)
      return code_.faults;
  }

  Code& code_;
  InterruptCheck& interrupt_;
  ExpressionWriter expressions_;
  Names names_;
  bool in_program_ = false;
  std::size_t first_drop_;  // the first drop of the block whose words come next
};

/// Make the block give the value of an expression to a variable.
inline void set(Block& block, const Assigned& to, std::uint32_t expression) {
  block.op = Op::Set;
  block.aux = expression;
  block.data = to.data();
}
/// Make the block execute the assignment of a statement; the block itself holds it where it can.
void assign(Builder& to, Block& block, const Statement& statement);

/// Mark a block of nothing but G00 or G01 (or no G), X, Y, Z and F as a linear move; one with G02
/// or G03 (or no G) and words of a centre as an arc.
inline void mark_move(Block& block, int g) {
  const bool centre = (block.mask & kCentreWords) != 0;
  const bool arc = g < 0 ? centre : g >= 2;
  const std::uint32_t known = kEndWords | bit('F') | (arc ? kCentreWords : 0);
  if (block.mask == 0 || (block.mask & ~known) != 0 || g > 3) return;
  if (arc && !centre) return;
  block.op = arc ? Op::Arc : Op::Linear;
  block.flags |= g < 0 ? Block::kNoG : g % 2 == 1 ? Block::kSecondG : std::uint8_t{0};
}

/// Give a block its codes: one G code, or more.
inline void write_code(Code& code, Block& block, int tenfold) {
  const int number = code.code_lists.keep(tenfold);
  block.set_codes(number, 1, 0);
  if (number < 0) code.cells.push_back({.value = static_cast<double>(tenfold)});
}
void write_codes(Code& code, Block& block, const CodeList& list);

CNCSUB_ALWAYS_INLINE inline void Builder::plain_words(Block& block, std::span<const int> g, int m,
                                                      std::uint32_t mask, const Cell::Extra& extra,
                                                      const std::array<Cell, 26>& values) {
  block.mask = mask;
  block.data = static_cast<std::uint32_t>(code_.cells.size());
  const bool numbers = (extra.expressions | extra.whole) == 0;
  if (!numbers) {
    Cell cell;  // NOLINT: written below
    cell.extra = extra;
    code_.cells.push_back(cell);
    block.flags |= Block::kHasExtra;
  }
  if (g.size() == 1 && m < 0) {
    write_code(code_, block, 10 * g.front());
  } else if (!g.empty() || m >= 0) {
    CodeList list;
    for (const int code : g) list.add_g(10 * code);
    if (m >= 0) list.add_m(m);
    write_codes(code_, block, list);
  }
  for (std::uint32_t left = mask; left != 0; left &= left - 1)
    code_.cells.push_back(values[static_cast<std::size_t>(std::countr_zero(left))]);
  if (numbers && m < 0 && g.size() < 2 && block.code_cells() == 0)
    mark_move(block, g.empty() ? -1 : g.front());
}

}  // namespace cncsub
