// The parts of a check. Each looks at all programs and adds what it finds.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "cncsub/analysis/check.hpp"
#include "cncsub/analysis/flow.hpp"
#include "cncsub/analysis/groups.hpp"
#include "cncsub/analysis/ignored.hpp"
#include "cncsub/code/references.hpp"
#include "cncsub/control/g_codes.hpp"

namespace cncsub {

/// The calls of each program, in the order of the blocks that call. It holds pointers to the calls,
/// which are many.
class Callers {
 public:
  explicit Callers(const std::vector<ProgramFlow>& flows);
  std::span<const CallEdge* const> of(std::size_t program) const {
    return {edges_.data() + first_[program], edges_.data() + first_[program + 1]};
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<const CallEdge*> edges_;
};

/// The input of the parts of a check, and the findings that they add.
class Checker {
 public:
  Checker(const Code& code, const Starts& starts, const std::string& machine,
          InterruptCheck& interrupt);

  const Code& code;
  std::int32_t main;
  MachineType machine;
  GCodes g_codes;
  std::vector<ProgramFlow> flows;
  Groups groups;            // of programs that call each other
  std::vector<bool> named;  // programs named by a call that leads nowhere
  /// A program that may have more reachable blocks than are found: a block that is refused or drops
  /// words may lead into it.
  struct Unsure {
    std::int32_t program;
    Address because;
  };
  std::vector<Unsure> unsure;

  const Program& program(std::int32_t index) const {
    return code.programs[static_cast<std::size_t>(index)];
  }
  const ProgramFlow& flow(std::int32_t index) const {
    return flows[static_cast<std::size_t>(index)];
  }
  /// Return whether a program is a part of another one. Its blocks are checked with that one.
  bool inside(const ProgramFlow& flow) const {
    return program(flow.program()).inside != kNoProgram;
  }
  /// Return the calls that lead to a program.
  std::span<const CallEdge* const> callers_of(std::int32_t index) const {
    return callers_.of(static_cast<std::size_t>(index));
  }
  bool is_called(std::int32_t index) const { return !callers_of(index).empty(); }
  /// Return whether something outside of the memory calls a program: it may be given arguments.
  bool is_entry(std::int32_t index) const { return entered_[static_cast<std::size_t>(index)]; }
  /// Return whether another program calls it.
  bool is_called_by_another(std::int32_t index) const {
    return called_by_another_[static_cast<std::size_t>(index)];
  }
  /// Return whether the check is to stop; `blocks` is how many were visited since the last
  /// question.
  bool over(std::size_t blocks = 1) const {
    return interrupt_.requested(blocks * InterruptCheck::kBlock);
  }

  /// Add a finding at a place. Where an earlier finding has the same cause (in the program, or in
  /// the memory for what the control refuses), the place is added to that one; then only the edits
  /// of the result are used.
  Finding& found(Check check, Address block, TextPlace place, std::string detail);
  /// Add a finding of what the control refuses, with its alarm.
  Finding& refused(Check check, Address block, Fault fault);
  /// Return whether a cause that only the caller can name is known. If so, the place is added to
  /// its finding; if not, the next finding is the first of this cause.
  bool known(Check check, const std::string& cause, Address block, TextPlace place);

  /// Return the findings, each with the calls that lead to it.
  std::vector<Finding> take();

 private:
  Finding& add(Check check, const std::string& cause, Address block, TextPlace place);
  bool ignored(Check check, Address block, TextPlace place);
  void keep_edits();
  std::string scope_of(Check check, Address block) const;

  InterruptCheck& interrupt_;
  Callers callers_;
  std::vector<bool> called_by_another_;
  std::vector<bool> entered_;  // by program: called from outside
  std::vector<Finding> findings_;
  std::unordered_map<std::string, std::size_t> causes_;  // the index of its finding, by cause
  std::string next_cause_;                               // that `known` was given
  std::vector<IgnoredLines> ignored_;                    // by file
  Finding spare_;                                        // for a place added to another finding
  std::size_t spare_of_ = 0;                             // the index of that one plus 1; 0: none
};

/// Check for faults, codes, calls and variables that the control refuses.
void check_refusals(Checker& c);
/// Check the targets of calls, jumps and returns.
void check_targets(Checker& c);
/// Check what is reached and how programs end.
void check_reach(Checker& c);
/// Check how deep calls nest, and circles of calls.
void check_nesting(Checker& c);
/// Check modes that called programs leave on.
void check_modes(Checker& c);
/// Check locals, arguments and commons.
void check_variables(Checker& c);
/// Check branches and loops of labels that are not closed.
void check_labels(Checker& c);
/// Check logic whose precedence is not what it looks.
void check_logic(Checker& c);
/// Check values that people trip over.
void check_values(Checker& c);
/// Check canned cycles that drill nothing, or not as often as is written.
void check_drilling(Checker& c);
/// Check loops that count in fractions.
void check_counting(Checker& c);
/// Check inputs that are read before the blocks above have run.
void check_read_ahead(Checker& c);
/// Check what a control reads otherwise than it looks: codes of one group, semicolons, small
/// letters.
void check_writing(Checker& c);

/// Call `look` with each block that one block is, as the switches or a condition select. In a
/// program that a code has called, no code calls: the block that stands for one there is left out,
/// because its purpose is that it does not call.
template <class Look>
void each_variant(const Code& code, const Block& block, const Look& look) {
  look(block);
  if (block.op == Op::IfThen)
    each_variant(code, code.variants[code.statements[block.aux].then], look);
  if (block.op == Op::Switch)
    for (const Statement& of : alternatives_of(code.statements[block.aux]))
      each_variant(code, code.variants[of.then], look);
  if (block.op == Op::Select) {
    const Select& variant = code.selects[block.aux];
    each_variant(code, code.variants[variant.first], look);
    if (variant.address == 0 && !variant.of_called)
      each_variant(code, code.variants[variant.second], look);
  }
  if (block.op == Op::ParallelAssign && code.parallel_assigns[block.aux].words != OWord::kNone)
    each_variant(code, code.variants[code.parallel_assigns[block.aux].words], look);
}

/// Return whether a block, or one that it may be, calls with the locals of its program.
inline bool calls_subprogram(const Code& code, const Block& block) {
  bool calls = false;
  each_variant(code, block, [&](const Block& of) { calls |= of.op == Op::Call; });
  return calls;
}

/// Return the M code of a block that calls, jumps or returns on other controls only; -1 where it
/// has none. M97 and M198 without P may be anything.
int plain_code(const Checker& c, const Block& block);

/// Return whether a program that begins at a block has a label, so that endsub and return end it.
inline bool begins_with_label(const Code& code, Address first) {
  return code.blocks[first].op == Op::OWord &&
         code.o_words[code.blocks[first].aux].kind == OWordKind::Sub;
}

/// Return whether a program that nothing else ends has G99 alone as its last block, which means
/// M99.
bool means_m99(const Checker& c, const ProgramFlow& flow);

/// Call `take` with each G code of a block that is written as a number, ten times that number.
template <class Take>
void each_g(const Code& code, const Block& block, const Take& take) {
  if (block.g_count == 0) return;
  const CodeList list = code.codes_of(block);
  for (const int g : list.g()) take(g);
}

/// Call `take` with each M code of a block that is written as a number and calls nothing.
template <class Take>
void each_m(const Code& code, const Block& block, const Take& take) {
  if (block.m_count == 0) return;
  const CodeList list = code.codes_of(block);
  for (const int m : list.m()) take(m);
}

}  // namespace cncsub
