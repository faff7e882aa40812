// The flow of a program: where it goes on after each of its blocks, found without running it.
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

/// The reason why one block follows another.
enum class ExitKind : std::uint8_t {
  Next,      // the block after it
  Jump,      // GOTO, M97, a branch or a loop
  Computed,  // a jump whose target is computed: any block with a number or a label may be it
  Returned   // M99 P, or RET with a block, of a program that the block calls
};
std::string_view to_string(ExitKind kind);

struct Exit {
  Address to = kNowhere;
  ExitKind kind = ExitKind::Next;
};

/// Return whether some value of a call is known only when it runs.
bool is_computed(const CallRecord& record);

/// A call whose program is known before the run.
struct CallEdge {
  Address from = kNowhere;
  std::int32_t caller = kNoProgram, called = kNoProgram;
  std::uint32_t record = 0;  // into Code::calls
  Address start = kNowhere;  // where the called program begins
  bool macro = false;        // it opens a level of locals
};

/// The paths through one program. The place after its last block stands for its end. The place
/// after that stands for any block with a number or a label: computed jumps lead there, and it
/// leads to each of them.
class ProgramFlow {
 public:
  /// `labelled`: the blocks of all programs that have a label, by address.
  ProgramFlow(const Code& code, std::int32_t program, const std::vector<Address>& labelled,
              InterruptCheck& interrupt);

  Address first() const { return first_; }
  Address last() const { return last_; }
  Address anywhere() const { return last_ + 1; }
  std::size_t size() const { return last_ - first_ + 2; }
  std::int32_t program() const { return program_; }
  /// The places that may follow a block.
  const Exit* begin(Address at) const { return exits_.data() + places_[at - first_]; }
  const Exit* end(Address at) const { return exits_.data() + places_[at - first_ + 1]; }
  /// Return whether a block may return to the caller (M99), and whether it may end the run.
  bool returns(Address at) const { return (marks_[at - first_] & kReturns) != 0; }
  bool ends(Address at) const { return (marks_[at - first_] & kEnds) != 0; }
  bool ever_returns() const { return (all_marks_ & kReturns) != 0; }
  bool ever_ends() const { return (all_marks_ & kEnds) != 0; }
  /// Return whether the program calls a program, or a block of one, that is known only when it
  /// runs.
  bool calls_computed() const { return (all_marks_ & kCallsComputed) != 0; }
  /// Return whether labels lead on, whose targets are found at run time.
  bool has_labels() const { return (all_marks_ & kLabels) != 0; }
  bool starts_computed() const { return (all_marks_ & kStartsComputed) != 0; }

  /// The calls of its blocks whose programs are known.
  const std::vector<CallEdge>& calls() const { return calls_; }
  /// The block that a return names: by its number, -1 where it is computed, or by a name. A named
  /// one may go back over several levels, and to the block after the one it names.
  struct ReturnTo {
    Address from = kNowhere;
    std::int64_t n = -1;
    TextPlace place;
    std::string_view name{};
    bool over_levels = false, after = false;
  };
  const std::vector<ReturnTo>& return_numbers() const { return return_numbers_; }
  /// The blocks other than the first at which the program is entered.
  std::vector<Address>& entries() { return entries_; }
  const std::vector<Address>& entries() const { return entries_; }

  /// Add an exit that only the callers or the called programs show; `close` puts these in order.
  void add(Address from, Exit exit) { added_.push_back({from, exit}); }
  void close();

  /// Return what can be reached, one mark for each block, for the end and for `anywhere`.
  std::vector<bool> reached() const;
  /// Return the same for a program that is entered at one block only.
  std::vector<bool> reached_from(Address start) const;
  /// Return the exits in reverse, by places from the first block on.
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

/// Return the paths through all programs of a memory, with those that M99 P of called programs
/// opens. Where it is interrupted, some of them are empty.
std::vector<ProgramFlow> flow_of(const Code& code, InterruptCheck& interrupt);

}  // namespace cncsub
