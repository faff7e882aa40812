// Blocks, and the words that stand in them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "cncsub/code/block_codes.hpp"
#include "cncsub/code/fault.hpp"
#include "cncsub/code/statement.hpp"

namespace cncsub {

enum class Op : std::uint8_t {
  Words,        // NC words only
  Linear,       // words: G00 or G01 with nothing but X, Y, Z and F, the case that must be fast
  Arc,          // words: G02 or G03 with nothing but X, Y, Z, F and a centre
  Call,         // words, then a subprogram call (aux: call)
  MacroCall,    // G65 and macro calls by code (aux: call)
  ModalCall,    // G66, G66.1 and modal calls by code (aux: call)
  CancelModal,  // G67, with words
  RepeatPart,   // REPEAT LABEL (aux: call): blocks of a program once more
  Return,       // words, then M99 (aux: call; P and L are its operands)
  Jump,         // words, then M97 (aux: statement)
  EndProgram,   // words, then M02 or M30
  Set,          // a variable takes a value (aux: expression, data: Assigned)
  Assign,       // the same, where the data do not hold it (aux: statement)
  Goto,         // aux: statement
  IfGoto,       // aux: statement
  IfThen,       // aux: statement
  Switch,       // CASE OF, several IF GOTO (aux: statement, its alternatives follow it)
  If,
  Else,
  EndIf,  // aux: statement; If: to = after ELSE or ENDIF
  While,
  Do,
  For,     // aux: statement; to = after the end, end = at it, then = the first assignment
  EndFor,  // aux: statement; to = the FOR, then = the assignment that counts
  EndDo,   // aux: statement; While: to = after END; EndDo: to = the WHILE or DO
  HCode,   // G65 H (aux: statement)
  Print,   // DPRNT, BPRNT (aux: print)
  OpenOutput,
  CloseOutput,
  NameVariables,   // SETVN (aux: statement)
  OWord,           // aux: o_word
  ParallelAssign,  // aux: parallel_assign: assignments, a message, and words
  Select,          // aux: select: one of two blocks, by the skip switches or by who called
  Fault,           // aux: fault
  EndOfRecord,     // after the last block of every program
};

/// Return whether a block has words and nothing else.
constexpr bool is_words(Op op) { return op <= Op::Arc; }

/// A word's cell: its value, or the number of its expression.
union Cell {
  /// Sets of a block's addresses, as masks.
  struct Extra {
    std::uint32_t expressions;  // those whose cell is an expression
    std::uint32_t whole;        // those whose number has no point; and kPointedH
  };

  double value;
  Extra extra;
  std::uint64_t expression;
};

// Addresses in a block's mask: bit 0 is A, bit 25 Z; then the two-character addresses.
constexpr std::string_view kCommaLetters = "CRAD";  // of ,C ,R ,A ,D
constexpr int kCommaC = 26, kCommaR = 27, kCommaA = 28, kCommaD = 29;
constexpr int kRadius = 30, kAngle = 31;  // @ and ^, a point by polar coordinates
constexpr int kAddresses = 32;
constexpr int kPointedH = 30;  // no address, a mark: H has a point that only an increment takes
constexpr std::uint32_t bit(char address) { return 1u << (address - 'A'); }
/// Return the place of a letter after a comma; -1 where no address is written so.
constexpr int comma_place(char letter) {
  const std::size_t at = kCommaLetters.find(letter);
  return at == std::string_view::npos ? -1 : kCommaC + static_cast<int>(at);
}
// The words of a plain move: its end point, and the centre of an arc.
constexpr std::uint32_t kEndWords = bit('X') | bit('Y') | bit('Z');
constexpr std::uint32_t kCentreWords = bit('I') | bit('J') | bit('K');
/// The words @ and ^: the radius and the angle of a point in G17.
constexpr std::uint32_t kPolarWords = 1u << kRadius | 1u << kAngle;
constexpr std::uint32_t kAxisWords =
    kEndWords | bit('A') | bit('B') | bit('C') | bit('U') | bit('V') | bit('W') | kPolarWords;

/// The form of words that do not follow the mode: sets of a block's addresses.
struct WordForms {
  std::uint32_t absolute = 0, incremental = 0;
  // Of A, B and C, whose words are absolute: bit 0 to 2 the shorter way, 8 to 10 in plus direction,
  // 16 to 18 in minus direction.
  std::uint32_t rotary = 0;

  bool any() const { return (absolute | incremental) != 0; }
  /// Return whether a word is an increment; `mode`: what words without a form are.
  bool is_incremental(std::uint32_t address, bool mode) const {
    return mode ? (absolute & address) == 0 : (incremental & address) != 0;
  }
};

/// One block. Its words follow in `Code::cells` from `data`: the extra cell (if has_extra), the G
/// codes and the M codes (if not listed; one cell each, or an expression), then the values of the
/// mask's addresses in alphabetical order, and two cells of forms (if has_forms).
struct Block {
  std::uint32_t text = 0;  // where it starts in its file
  std::uint32_t line = 0;  // 1-based
  std::int32_t n = -1;
  std::uint32_t data = 0;
  std::uint32_t mask = 0;
  std::uint32_t aux = 0;
  std::uint32_t skip : 12 = 0;  // bit k: not executed when switch k is on; and kPartEnd
  std::uint32_t list : 12 = 0;  // where its codes are in Code::code_lists, if listed
  std::uint32_t g_count : 4 = 0;
  std::uint32_t m_count : 3 = 0;
  Op op = Op::Words;
  std::uint8_t flags = 0;
  std::uint16_t length = 0;  // bytes of text, at most 65535

  /// Of `skip`: a pass of RepeatPart that is on its way to this block ends before it.
  static constexpr std::uint32_t kPartEnd = 1U << 11;
  /// Return whether a switch may skip the block.
  bool can_be_skipped() const { return (skip & ~kPartEnd) != 0; }

  static constexpr std::uint8_t kHasExtra = 1;
  static constexpr std::uint8_t kCodeExpression =
      2;  // a G or M is an expression: its cell holds -1 - expression
  static constexpr std::uint8_t kSecondG = 4;  // Linear: G01 is written; Arc: G03
  static constexpr std::uint8_t kNoG = 8;      // Linear and Arc: no G is written
  static constexpr std::uint8_t kDrops = 16;   // words that do not count: Code::drops
  static constexpr std::uint8_t kHasForms = 64;
  static constexpr std::uint8_t kListed = 32;  // its codes are one of Code::code_lists

  bool has_codes() const { return g_count != 0 || m_count != 0; }
  /// Return how many cells its codes take.
  int code_cells() const {
    return (flags & kListed) != 0 ? 0 : static_cast<int>(g_count + m_count);
  }
  /// Set the codes to a list of Code::code_lists; `number` -1: they are cells.
  void set_codes(int number, std::size_t g, std::size_t m) {
    flags |= number >= 0 ? kListed : std::uint8_t{0};
    list = static_cast<std::uint32_t>(std::max(number, 0)) & (kMostLists - 1);
    g_count = static_cast<std::uint32_t>(g) & 15U;
    m_count = static_cast<std::uint32_t>(m) & 7U;
  }
};
static_assert(kMostLists == 1 << 12 && kGCodesOfBlock < 16 && kMCodesOfBlock < 8,
              "a block holds them");
static_assert(sizeof(Block) == 32);

/// The target of an assignment, as a block keeps it in its `data`: the variable, and where it
/// stands in the block.
struct Assigned {
  Statement::Target target{};
  std::uint32_t index = 0;  // as in Statement; Indirect: how many cells before the value the
                            // expression of the variable's number begins
  std::uint32_t at = 0, width = 1;  // in the block

  static constexpr std::uint32_t kMostIndex = (1U << 14) - 1, kMostPlace = 255;
  bool fits() const {
    return target != Statement::Target::None && target <= Statement::Target::Indirect &&
           index <= kMostIndex && at <= kMostPlace && width <= kMostPlace;
  }

  std::uint32_t data() const { return kind(target) | index << 2 | at << 16 | width << 24; }
  static Assigned of(const Block& block) {
    const std::uint32_t data = block.data;
    return {static_cast<Statement::Target>(kind_of(block) + kLocal), index_of(block),
            data >> 16 & kMostPlace, data >> 24};
  }
  /// Return the assignment as a statement without its width. `value`: where its expression begins;
  /// `text`: where the block begins.
  Statement statement(std::uint32_t value, std::uint32_t text) const {
    Statement of;
    of.expression = value;
    of.target = target;
    if (target == Statement::Target::Indirect)
      of.variable = value - index;
    else
      of.index = static_cast<std::int32_t>(index);
    of.at = of.variable_at = text + at;
    of.variable_width = width;
    return of;
  }
  /// Return 0 for a local, 1 for a common, more for others; `index_of`: the index.
  static std::uint32_t kind_of(const Block& block) { return block.data & 3U; }
  static std::uint32_t index_of(const Block& block) { return block.data >> 2 & kMostIndex; }

 private:
  static constexpr auto kLocal = static_cast<std::uint32_t>(Statement::Target::Local);
  static constexpr std::uint32_t kind(Statement::Target target) {
    return static_cast<std::uint32_t>(target) - kLocal;
  }
};
static_assert(static_cast<int>(Statement::Target::Common) ==
                  static_cast<int>(Statement::Target::Local) + 1 &&
              static_cast<int>(Statement::Target::Indirect) ==
                  static_cast<int>(Statement::Target::Local) + 3);

struct Select {
  std::uint16_t skip = 0;  // != 0: `second` when one of these switches is on
  char address = 0;  // != 0: `second` when the frame was entered by a code that keeps this address
                     // from calling
  bool of_called = false;   // `second` when the program returns at its end and does not end the run
  std::uint32_t first = 0;  // into Code::variants
  std::uint32_t second = 0;
};

/// The largest G (ten times) or M code that a block can hold.
constexpr double kLargestCode = 1e9;

inline const BlockCodes kNoCodes;

/// The words of a block, ready to be executed.
struct NcWords {
  std::uint32_t mask = 0;
  std::uint32_t whole = 0;     // written as a number without a point; and kPointedH
  std::uint32_t computed = 0;  // came from a variable or an expression
  std::array<double, kAddresses> value{};
  WordForms forms;
  const BlockCodes* codes = &kNoCodes;
  bool ends = false;   // M02 or M30 stands in the block
  bool stops = false;  // the run stops after it: moves in the lookahead queue wait no more
  Address at = 0;      // the block, for faults

  bool has(char address) const { return (mask & bit(address)) != 0; }
  bool has_place(int place) const { return (mask >> place & 1) != 0; }
  bool has(Role role) const { return codes->has(role); }
  double operator[](char address) const { return value[static_cast<std::size_t>(address - 'A')]; }
};

}  // namespace cncsub
