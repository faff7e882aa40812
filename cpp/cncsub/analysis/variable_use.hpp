// The use of variables by blocks and programs.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "cncsub/analysis/checker.hpp"

namespace cncsub {

/// Variables as bits: a local by its number, others by their places in a list.
using Bits = std::uint64_t;
constexpr std::int32_t kMostBits = 64;

/// The use of variables by one block.
struct VariableUse {
  std::vector<std::int32_t> reads, writes;  // locals and commons by number, then named ones
  Bits read_locals = 0, written_locals = 0;
  // The locals of `read_locals` that stand alone in a word, or that are copied, on a control that
  // leaves out the word of a vacant one.
  Bits word_locals = 0;
  bool tests = false;  // compares with #0: what it reads may be vacant
  bool any = false;    // a number is computed, or a name is used
};

/// The use of locals by one program and by the subprograms that share them.
struct LocalUse {
  Bits reads = 0, writes = 0, tested = 0;
  Bits again = 0;    // the locals of `writes` that several blocks write
  bool any = false;  // any variable may be read or written
  bool operator==(const LocalUse&) const = default;
};

class VariableUses {
 public:
  explicit VariableUses(const Checker& c);

  /// Return the use of a block, null where it uses no variable.
  const VariableUse* of(Address at) const {
    const auto found = uses_.find(at);
    return found == uses_.end() ? nullptr : &found->second;
  }
  const LocalUse& of_program(std::int32_t program) const {
    return programs_[static_cast<std::size_t>(program)];
  }
  /// Return the place of the word or value of a block that reads a variable.
  TextPlace place_of(Address at, std::int32_t number) const;
  /// The locals that have names and no numbers: no argument and no other program sets them.
  Bits named() const { return named_; }
  /// Return the number that stands for a local: its own, or one for its name.
  std::int32_t number_of(std::int32_t local) const;
  /// Return a variable as it is written: #100, #<depth>.
  std::string name_of(std::int32_t number) const;
  /// Return whether a variable belongs to one level of calls.
  bool is_local(std::int32_t number) const;

 private:
  void take(const ProgramFlow& flow, Address at);
  /// Return the same number for a common that has two.
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
  char sign_ = '#';  // the sign before numbers: #1, R1
};

/// Return the calls of a program by their blocks.
std::vector<std::vector<const CallEdge*>> calls_by_block(const ProgramFlow& flow);

/// Check locals without a value, and arguments that nobody gives or reads.
void check_vacant(Checker& c, const VariableUses& uses);
/// Check commons that have no value where a move uses them.
void check_commons(Checker& c, const VariableUses& uses);
/// Check variables that a caller and a called program both use as their own.
void check_overwritten(Checker& c, const VariableUses& uses);

}  // namespace cncsub
