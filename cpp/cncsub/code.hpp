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
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control.hpp"
#include "cncsub/large_pages.hpp"
#include "cncsub/number.hpp"
#include "cncsub/rule_lists.hpp"

namespace cncsub {

using Address = std::uint32_t;
constexpr Address kNowhere = 0xffffffff;
constexpr std::int32_t kNoProgram = -1;

/// The value of #0 and of a variable never set. Arithmetic never produces a NaN, so every NaN is
/// vacant.
constexpr double kVacant = std::numeric_limits<double>::quiet_NaN();
inline bool is_vacant(double value) { return std::isnan(value); }
/// The largest value that a variable or a word takes.
constexpr double kLargest = 1e47;

/// A number has no more digits than these, whatever a rule says: a double holds no more.
constexpr int kMostDigits = 15;
inline int most_digits(const Control& control) {
  return std::min<int>(control.max_digits.value, kMostDigits);
}

/// The largest G (ten times) or M code that a block can hold.
constexpr double kLargestCode = 1e9;

/// What is wrong with a block, and where in its file.
struct Fault {
  Cause cause{};
  std::uint32_t at = 0;     // byte offset in the file's text
  std::uint32_t width = 1;  // bytes; 0 = the name, number or sign that stands there
  std::string detail;
  Address block = kNowhere;  // the block it stands in; otherwise the one that is being executed
  std::array<char, 2> direction{};  // "X+", where the control may have a number for each
  char address = 0;                 // of the word that is wrong, where `at` does not say it
  int code = -1;                    // or that G code, ten times its number
};

// ---- expressions ----

enum class Ins : std::uint8_t {
  Constant,
  Local,
  LocalRaw,
  Common,
  CommonRaw,
  Variable,
  VariableRaw,
  Indirect,
  IndirectRaw,
  Add,
  Subtract,
  Multiply,
  Divide,
  AddConstant,
  SubtractConstant,
  MultiplyConstant,
  DivideConstant,
  Modulo,
  And,
  Or,
  Xor,
  Negate,
  Equal,
  NotEqual,
  Greater,
  Less,
  GreaterEqual,
  LessEqual,
  BothTrue,
  EitherTrue,
  OneTrue,
  Not,
  Sin,
  Cos,
  Tan,
  Asin,
  Acos,
  Atan,
  Atan2,
  Sqrt,
  Abs,
  Round,
  RoundWord,
  CutWord,
  Fix,
  Fup,
  Ln,
  Exp,
  Pow,
  Bin,
  Bcd,
  Adp,
  Parameter,
  Sign,
  Random,
  RandomBetween,
  Programmed,
  Named,
  End
};

struct Instruction {
  Ins op = Ins::End;
  std::uint8_t address = 0;  // RoundWord: the word's address
  std::uint32_t at = 0;      // where in the text, for a fault; of a variable: its index
  double value = 0;          // a constant; of a variable: its number
};

/// An expression. Most are one value, or one operation on two, and need no instructions: `form`
/// says so.
struct Expression {
  std::uint32_t first = 0;  // into Code::instructions
  std::uint32_t at = 0;
  std::uint32_t width = 1;
  enum class Form : std::uint8_t { Long, One, Two } form = Form::Long;
  Ins op = Ins::End;  // of Two
  struct Load {
    enum class From : std::uint8_t { Constant, Local, Common } from = From::Constant;
    bool raw = false;  // a vacant variable stays vacant
    std::uint32_t index = 0;
    double value = 0;
  };
  std::array<Load, 2> loads{};
};

/// A value in a block: absent, written as a number, or an expression.
struct Operand {
  enum class Kind : std::uint8_t { Absent, Constant, Expression } kind = Kind::Absent;
  bool bracketed = false;    // P[#100]
  bool whole = false;        // a number without a decimal point
  bool fine = false;         // a number with more than three decimals
  std::uint8_t digits = 0;   // without leading zeros
  std::uint8_t written = 0;  // with them
  std::uint32_t expression = 0;
  double value = 0;
  std::uint32_t at = 0;
  std::uint32_t width = 1;

  bool present() const { return kind != Kind::Absent; }
};

// ---- blocks ----

enum class Op : std::uint8_t {
  Words,        // NC words only
  Linear,       // words: G00 or G01 with nothing but X, Y, Z and F, the case that must be fast
  Round,        // words: G02 or G03 with nothing but X, Y, Z, F and a centre
  Call,         // words, then a subprogram call (aux: call)
  MacroCall,    // G65 and macro calls by code (aux: call)
  ModalCall,    // G66, G66.1 and modal calls by code (aux: call)
  CancelModal,  // G67, with words
  Return,       // words, then M99 (aux: call; P and L are its operands)
  Jump,         // words, then M97 (aux: statement)
  EndProgram,   // words, then M02 or M30
  Assign,       // aux: statement
  Goto,         // aux: statement
  IfGoto,       // aux: statement
  IfThen,       // aux: statement
  If,
  Else,
  EndIf,  // aux: statement; If: to = behind ELSE or ENDIF
  While,
  Do,
  EndDo,  // aux: statement; While: to = behind END; EndDo: to = the WHILE or DO
  HCode,  // G65 H (aux: statement)
  Print,  // DPRNT, BPRNT (aux: print)
  OpenOutput,
  CloseOutput,
  NameVariables,  // SETVN (aux: statement)
  Choose,  // aux: variant: which of two blocks this one is, by the skip switches or by who called
  Fault,   // aux: fault
  EndOfRecord,  // behind the last block of every program
};

/// A block of words and nothing else.
constexpr bool is_words(Op op) { return op <= Op::Round; }

/// A word's cell: its value, or the number of its expression.
union Cell {
  double value;
  struct {
    std::uint32_t
        expressions;      // of a block's extra cell: the addresses whose cell is an expression
    std::uint32_t whole;  // and those whose number has no point; and kPointedH
  } extra;
  std::uint64_t expression;
};

// Addresses in a block's mask: bit 0 is A, bit 25 Z; then the two-character addresses.
constexpr int kCommaC = 26, kCommaR = 27, kCommaA = 28, kCommaD = 29;
constexpr int kAddresses = 30;
constexpr int kPointedH = 30;  // no address, a mark: H has a point that only an increment takes
constexpr std::uint32_t bit(char address) { return 1u << (address - 'A'); }

/// One block. Its words follow in `Code::cells` from `data`: the extra cell (if has_extra), the G
/// codes, the M codes (one cell each, or an expression), then the values of the mask's addresses in
/// alphabetical order.
struct Block {
  std::uint32_t text = 0;  // where it starts in its file
  std::uint32_t line = 0;  // 1-based
  std::int32_t n = -1;
  std::uint32_t data = 0;
  std::uint32_t mask = 0;
  std::uint32_t aux = 0;
  Op op = Op::Words;
  std::uint8_t g_count = 0;
  std::uint8_t m_count = 0;
  std::uint8_t flags = 0;
  std::uint16_t skip = 0;    // bit k: not executed when switch k is on
  std::uint16_t length = 0;  // bytes of text, at most 65535

  static constexpr std::uint8_t kHasExtra = 1;
  static constexpr std::uint8_t kCodeExpression =
      2;  // a G or M is an expression: its cell holds -1 - expression
  static constexpr std::uint8_t kSecondG = 4;  // Linear: G01 is written; Round: G03
  static constexpr std::uint8_t kNoG = 8;      // Linear and Round: no G is written
  static constexpr std::uint8_t kDrops = 16;   // words that do not count: Code::drops
};

/// The words of a block, ready to be executed.
struct NcWords {
  std::uint32_t mask = 0;
  std::uint32_t whole = 0;     // written as a number without a point; and kPointedH
  std::uint32_t computed = 0;  // came from a variable or an expression
  std::array<double, kAddresses> value{};
  std::array<int, 12> g{};  // ten times the code: G54.1 is 541
  std::array<int, 6> m{};
  int g_count = 0;
  int m_count = 0;
  bool ends = false;   // M02 or M30 stands in the block
  bool stops = false;  // the run stops behind it: moves that wait for the next one wait no more
  Address at = 0;      // the block, for faults

  bool has(char address) const { return (mask & bit(address)) != 0; }
  double operator[](char address) const { return value[static_cast<std::size_t>(address - 'A')]; }
};

enum class CallKind : std::uint8_t {
  M98,
  M198,
  M97,  // of the own program
  G65,
  G66,
  G661,
  GCode,
  MCode,
  TCode,
  SCode,
  BCode,
  Ascii
};
std::string_view to_string(CallKind kind);
inline bool is_macro(CallKind kind, CodeCallKind code) {
  switch (kind) {
    case CallKind::M98:
    case CallKind::M198:
    case CallKind::M97:
      return false;
    case CallKind::G65:
    case CallKind::G66:
    case CallKind::G661:
      return true;
    default:
      return code != CodeCallKind::Subprogram;
  }
}

struct Argument {
  std::int16_t variable = 0;  // the local it sets
  char address = 0;
  Operand operand;
};

/// What a call says once its operands are known.
struct Target {
  std::int64_t program_number = -1;
  std::int32_t program = kNoProgram;
  Address start = kNowhere;
  std::int32_t start_n = -1;
  std::int32_t repeats = 1;
  bool skipped = false;   // L0
  bool jump = false;      // a MELDAS M98 without P
  bool external = false;  // on the external device
};

struct CallRecord {
  CallKind kind = CallKind::M98;
  CodeCallKind code_kind = CodeCallKind::Subprogram;
  std::int32_t code = 0;      // the calling code: 60 of M60
  std::int32_t variable = 0;  // takes the code's value
  Operand p, l, start, device;
  std::string name;  // <NAME>, P[NAME]
  std::uint32_t name_at = 0, name_width = 1;
  std::int32_t program_number = -1;  // a call by code: the program it is registered for
  std::uint32_t first_argument = 0, arguments = 0;
  std::uint32_t at = 0, width = 1;  // the calling word
  bool macro = false;
  bool constant = false;  // `target` holds for every execution
  Target target;
};

struct Statement {
  std::uint32_t expression = 0;  // the condition, or the value to assign, or the jump's number
  std::uint32_t variable =
      0;  // Assign: an expression that gives the variable's number, when target is Indirect
  enum class Target : std::uint8_t {
    None,
    Local,
    Common,
    Variable,
    Indirect
  } target = Target::None;
  std::int32_t index = 0;   // Local, Common: the place; Variable: the number
  Address to = kNowhere;    // where a jump goes, when known
  Address end = kNowhere;   // Do, While: the address of the END
  std::int32_t number = 0;  // DO m, GOTO n, G65 Hm
  std::uint32_t at = 0, width = 1;
  std::uint32_t variable_at = 0, variable_width = 1;
  std::uint32_t text = 0, text_length = 0;  // the comment of #3000 and #3006
  std::uint32_t then = 0;                   // IfThen: the variant block to execute
  Operand p, q, r;                          // G65 H
};

struct PrintField {
  bool is_variable = false;
  std::string text;
  std::uint32_t expression = 0;
  int whole_digits = 0;
  int decimals = 0;
};

struct Print {
  bool binary = false;
  std::vector<PrintField> fields;
  std::uint32_t at = 0;
};

struct Variant {
  std::uint16_t skip = 0;  // != 0: `second` when one of these switches is on
  char address = 0;  // != 0: `second` when the frame was entered by a code that keeps this address
                     // from calling
  std::uint32_t first = 0;  // into Code::variants
  std::uint32_t second = 0;
};

// ---- programs ----

struct SourceFile {
  std::string name;  // as shown in messages
  std::string stem;  // names the program where the text does not
  std::string text;  // UTF-8
  bool external = false;
  std::int32_t leader = 0;  // how many lines stand before its tape and are no program
};

/// A word that the control reads and does not obey: an M code too many, an address written again.
struct Drop {
  std::uint32_t data = 0;  // of its block
  std::uint32_t at = 0, width = 1;
};

struct SequenceEntry {
  std::int32_t n;
  Address address;
};

/// A program of the memory. Its name and its comment stand in the text: Code::name_of, comment_of.
struct Program {
  static constexpr std::uint32_t kOfFile = 0xffffffff;

  std::int64_t number = -1;             // of O0023, :23, %23
  std::uint32_t name_at = 0;            // in the file
  std::uint32_t name_length = kOfFile;  // kOfFile: the file gives the name
  std::uint32_t comment_at = 0;
  std::uint32_t comment_length = 0;
  std::uint32_t file = 0;
  std::uint32_t line = 0;  // of its head
  std::uint32_t text = 0;  // where its text starts in the file
  std::uint32_t text_end = 0;
  Address first = 0;
  Address last = 0;                               // one behind the last block: the EndOfRecord
  std::uint32_t first_entry = 0, last_entry = 0;  // in Code::sequence, sorted by n, then by address
  std::int32_t duplicate_of = kNoProgram;
};

/// Finds programs by what they are called: the places of programs in one table, hashed. It is given
/// its room once.
class ProgramIndex {
 public:
  void reserve(std::size_t programs);
  /// The program that is `same` among those under this hash, kNoProgram where there is none.
  template <class Same>
  std::int32_t find(std::uint64_t hash, const Same& same) const {
    return slots_.empty() ? kNoProgram : slots_[slot(hash, same)];
  }
  /// As find; where there is none, `program` is added.
  template <class Same>
  std::int32_t find_or_add(std::uint64_t hash, const Same& same, std::int32_t program) {
    std::int32_t& found = slots_[slot(hash, same)];
    return found == kNoProgram ? (found = program, kNoProgram) : found;
  }

 private:
  template <class Same>
  std::size_t slot(std::uint64_t hash, const Same& same) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = (hash * 0x9e3779b97f4a7c15U >> 32) & mask;
    while (slots_[at] != kNoProgram && !same(slots_[at])) at = (at + 1) & mask;
    return at;
  }

  std::vector<std::int32_t> slots_;  // a power of two, at most half of them in use
};

/// Where a variable lives.
struct VariablePlace {
  VariableKind kind = VariableKind::Common;
  std::int32_t index = -1;  // Local: the number itself; Common and Kept: the place among the
                            // commons; else number - first
  const VariableRange* range = nullptr;  // null: there is no such variable
};

/// A range of variables, and where the first of its commons lies.
struct PlacedRange {
  VariableRange range;
  std::int32_t base = 0;
};

struct Code {
  std::shared_ptr<const Control> control;
  std::vector<PlacedRange> variables;  // by number
  bool external_device = false;
  std::bitset<10001> g_codes;  // the codes of the control, ten times each; all where it has no list
  std::bitset<16> lacking;     // kinds of statements that the control does not have, or
  std::bitset<16> unheard_of;  // that no source tells of, which are lacking too
  std::vector<std::string> names;      // of variables used by name
  std::int32_t locals = 34;            // the locals of one level, #0 included
  std::int32_t locals_per_level = 33;  // as a level's image counts them
  std::int32_t commons = 0;
  std::vector<SourceFile> files;
  LargeVector<Program> programs;
  LargeVector<Block> blocks;
  LargeVector<Block> variants;
  LargeVector<Cell> cells;
  std::vector<Instruction> instructions;
  std::vector<Expression> expressions;
  std::vector<CallRecord> calls;
  std::vector<Argument> arguments;
  std::vector<Statement> statements;
  std::vector<Print> prints;
  std::vector<Variant> choices;
  std::vector<Fault> faults;
  std::vector<Drop> drops;  // in the order of their blocks' data
  std::vector<SequenceEntry> sequence;
  std::array<ProgramIndex, 2> by_number, by_name;  // of the memory, of the external device

  VariablePlace place(std::int64_t number) const;

  /// The fault of a statement of this kind at `at`; nothing where the control has it.
  std::optional<Fault> lacks(StatementKind kind, std::uint32_t at) const {
    if (!lacking.test(static_cast<std::size_t>(kind))) return std::nullopt;
    return lacking_fault(kind, at);
  }
  Fault lacking_fault(StatementKind kind, std::uint32_t at) const;
  void list_statements();

  std::int32_t program_at(Address address) const;
  std::string name_of(const Program& program) const;
  std::string_view comment_of(const Program& program) const;
  std::string_view text_of(const Block& block, const Program& program) const;

  /// The program of a number or name, kNoProgram where there is none.
  std::int32_t find(std::int64_t number, bool external = false) const;
  std::int32_t find(std::string_view name, bool external = false) const;

  /// Makes every program known by its number and its name, and the first one of a file by the
  /// file's name; of several under one name the first counts. `over` may end it.
  void register_programs(const std::function<bool()>& over);

  // The block N(n) of a program; kNowhere where there is none.
  Address first_of(const Program& program, std::int64_t n) const;
  Address first_from(const Program& program, std::int64_t n, Address from) const;
  Address next_of(const Program& program, std::int64_t n, Address behind) const;
  Address last_of(const Program& program, std::int64_t n, Address before) const;
  Address jump_target(const Program& program, std::int64_t n, Address from) const;
  Address return_target(const Program& program, std::int64_t n, Address call) const;
};

/// Reads the files into one library of compiled programs. Never fails: what the control would
/// refuse becomes a fault. Without an external device the memory stands in for it: M198 then finds
/// the programs that M98 finds. `interrupted` is asked fifty times a second whether to give up; the
/// result is null then.
std::shared_ptr<const Code> compile(std::shared_ptr<const Control> control,
                                    std::vector<SourceFile> files, bool external_device,
                                    const std::function<bool()>& interrupted = {});
/// The same library with one more program behind the others, the text typed in MDI.
std::shared_ptr<const Code> compile_mdi(const Code& code, const std::string& text,
                                        const std::function<bool()>& interrupted = {});

/// The alarm of a fault in this block; frames are the caller's to add.
Alarm alarm_of(const Code& code, Address address, const Fault& fault);

/// The key under which a program's name is found: upper case, without an extension the control
/// gives its files.
/// The number in O0023, %23, :23 or 23; -1 where the name is none.
std::int64_t number_in(std::string_view name);

}  // namespace cncsub
