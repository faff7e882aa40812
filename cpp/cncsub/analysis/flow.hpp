// Where a program goes on behind each of its blocks, told by its code without running it.
#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "cncsub/analysis/groups.hpp"
#include "cncsub/code/code.hpp"
#include "cncsub/code/references.hpp"
#include "cncsub/text/interrupt_check.hpp"

namespace cncsub {

/// Why one block follows another.
enum class ExitKind : std::uint8_t {
  Next,      // the block behind it
  Jump,      // GOTO, M97, a branch or a loop
  Computed,  // a jump whose number is computed: every block with a number may be meant
  Returned   // M99 P of a program that the block calls
};
std::string_view to_string(ExitKind kind);

struct Exit {
  Address to = kNowhere;
  ExitKind kind = ExitKind::Next;
};

/// Whether a call says something that is known only when it runs.
bool is_computed(const CallRecord& record);

/// A call whose program is known before anything runs.
struct CallEdge {
  Address from = kNowhere;
  std::int32_t caller = kNoProgram, called = kNoProgram;
  std::uint32_t record = 0;  // into Code::calls
  Address start = kNowhere;  // where the called program begins
  bool macro = false;        // it opens a level of locals
};

/// The ways through one program. The block behind the last one stands for its end, the one behind
/// that for any block with a number: there computed jumps lead, and from there to each of them.
class ProgramFlow {
 public:
  ProgramFlow(const Code& code, std::int32_t program, InterruptCheck& interrupt);

  Address first() const { return first_; }
  Address last() const { return last_; }
  Address anywhere() const { return last_ + 1; }
  std::size_t size() const { return last_ - first_ + 2; }
  std::int32_t program() const { return program_; }
  /// What may follow a block.
  const Exit* begin(Address at) const { return exits_.data() + places_[at - first_]; }
  const Exit* end(Address at) const { return exits_.data() + places_[at - first_ + 1]; }
  /// Whether a block may return to the caller (M99), and whether it may end the run.
  bool returns(Address at) const { return (marks_[at - first_] & kReturns) != 0; }
  bool ends(Address at) const { return (marks_[at - first_] & kEnds) != 0; }
  bool ever_returns() const { return (all_marks_ & kReturns) != 0; }
  bool ever_ends() const { return (all_marks_ & kEnds) != 0; }
  /// Whether it calls a program that nobody knows before it runs, or at a block nobody knows.
  bool calls_computed() const { return (all_marks_ & kCallsComputed) != 0; }
  /// Whether labels lead the way, which are found while it runs.
  bool has_labels() const { return (all_marks_ & kLabels) != 0; }
  bool starts_computed() const { return (all_marks_ & kStartsComputed) != 0; }

  /// The calls of its blocks whose programs are known.
  const std::vector<CallEdge>& calls() const { return calls_; }
  /// The numbers of M99 P, with their blocks; -1 where they are computed.
  struct ReturnTo {
    Address from = kNowhere;
    std::int64_t n = -1;
    TextPlace place;
  };
  const std::vector<ReturnTo>& return_numbers() const { return return_numbers_; }
  /// Blocks at which the program is entered besides its first.
  std::vector<Address>& entries() { return entries_; }
  const std::vector<Address>& entries() const { return entries_; }

  /// Ways that only the callers or the called programs tell; `close` puts them in order.
  void add(Address from, Exit exit) { added_.push_back({from, exit}); }
  void close();

  /// What can be reached, one mark for each block, for the end and for anywhere.
  std::vector<bool> reached() const;
  /// The same where only one block is entered.
  std::vector<bool> reached_from(Address start) const;
  /// The ways the other way round, by places from the first block on.
  Arrows backwards() const;

 private:
  friend class FlowReader;
  std::vector<bool> reached(std::vector<Address> waiting) const;
  static constexpr std::uint8_t kReturns = 1, kEnds = 2, kCallsComputed = 4, kStartsComputed = 8,
                                kLabels = 16;

  const Code& code_;
  std::int32_t program_;
  Address first_, last_;
  std::vector<std::uint32_t> places_;
  std::vector<Exit> exits_;
  std::vector<std::uint8_t> marks_;
  std::uint8_t all_marks_ = 0;
  std::vector<CallEdge> calls_;
  std::vector<ReturnTo> return_numbers_;
  std::vector<Address> entries_;
  std::vector<std::pair<Address, Exit>> added_;
};

/// The ways through all programs of a memory, with those that M99 P of called programs opens.
/// Where it is interrupted, some of them are empty.
std::vector<ProgramFlow> flow_of(const Code& code, InterruptCheck& interrupt);

}  // namespace cncsub
