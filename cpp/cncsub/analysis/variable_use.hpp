// What blocks and programs do with variables.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "cncsub/analysis/checker.hpp"

namespace cncsub {

/// Variables as bits: a local by its number; others by their places in a list.
using Bits = std::uint64_t;
constexpr std::int32_t kMostBits = 64;

/// What one block does.
struct VariableUse {
  std::vector<std::int32_t> reads, writes;  // locals and commons by number, those with names behind
  Bits read_locals = 0, written_locals = 0;
  // Those of `read_locals` that a word holds alone, or that are copied, where the control leaves
  // out the word of a vacant one.
  Bits word_locals = 0;
  bool tests = false;  // compares with #0: what it reads may be vacant
  bool any = false;    // a number is computed, or a name is used
};

/// What one program does with locals, with the subprograms that share them.
struct LocalUse {
  Bits reads = 0, writes = 0, tested = 0;
  Bits again = 0;    // of `writes`, those of more than one block
  bool any = false;  // any variable may be read or written
  bool operator==(const LocalUse&) const = default;
};

class VariableUses {
 public:
  explicit VariableUses(const Checker& c);

  /// That of a block, null where it has to do with none.
  const VariableUse* of(Address at) const {
    const auto found = uses_.find(at);
    return found == uses_.end() ? nullptr : &found->second;
  }
  const LocalUse& of_program(std::int32_t program) const {
    return programs_[static_cast<std::size_t>(program)];
  }
  /// The word or value of a block that reads a variable.
  TextPlace place_of(Address at, std::int32_t number) const;
  /// The locals that have names and no numbers: no argument sets them, and no other program.
  Bits named() const { return named_; }
  /// What a local counts as by its bit: its number, or one that stands for its name.
  std::int32_t number_of(std::int32_t local) const;
  /// A variable as it is written: #100, #<depth>.
  std::string name_of(std::int32_t number) const;
  /// Whether a variable belongs to one level of calls.
  bool is_local(std::int32_t number) const;

 private:
  void take(const ProgramFlow& flow, Address at);
  /// The number of a common that has two, always the same one.
  std::int64_t own_number(std::int64_t number) const;
  Bits bit_of(std::int64_t number, std::vector<std::int32_t>& to) const;
  Bits bit_of(const VariableReference& of, std::vector<std::int32_t>& to, bool& any) const;
  const NamedVariable& named_variable(std::int32_t number) const;
  bool tests_vacancy(const Block& block) const;
  void share();
  bool take_called(std::uint32_t program);

  const Checker& c_;
  std::unordered_map<Address, VariableUse> uses_;
  std::vector<LocalUse> programs_;
  Bits named_ = 0;
  char sign_ = '#';  // that numbers are written with: #1, R1
};

/// The calls of a program by their blocks.
std::vector<std::vector<const CallEdge*>> calls_by_block(const ProgramFlow& flow);

/// Locals without a value, arguments that nobody gives or reads.
void check_vacant(Checker& c, const VariableUses& uses);
/// Commons without a value where a move takes them.
void check_commons(Checker& c, const VariableUses& uses);
/// Variables that a caller and a called program both use as their own.
void check_overwritten(Checker& c, const VariableUses& uses);

}  // namespace cncsub
