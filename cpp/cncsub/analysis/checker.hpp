// The parts of a check: each looks at all programs and adds what it finds.
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

/// The calls of each program, in the order of the blocks that call: as many as there are calls, so
/// that each is only pointed to.
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

/// What the parts look at, and where their findings go.
class Checker {
 public:
  Checker(const Code& code, std::int32_t main, const std::string& machine,
          InterruptCheck& interrupt);

  const Code& code;
  std::int32_t main;
  MachineType machine;
  GCodes g_codes;
  std::vector<ProgramFlow> flows;
  Groups groups;            // of programs that call each other
  std::vector<bool> named;  // programs that a call names which leads nowhere
  /// A program in which blocks may be meant that nothing reaches, for what a block of it or of
  /// another one says that is refused or dropped.
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
  /// Whether a program is a part of another one, whose blocks are looked at with that.
  bool inside(const ProgramFlow& flow) const {
    return program(flow.program()).inside != kNoProgram;
  }
  /// The calls that lead to a program.
  std::span<const CallEdge* const> callers_of(std::int32_t index) const {
    return callers_.of(static_cast<std::size_t>(index));
  }
  bool is_called(std::int32_t index) const { return !callers_of(index).empty(); }
  /// Whether a program other than itself calls it.
  bool is_called_by_another(std::int32_t index) const {
    return called_by_another_[static_cast<std::size_t>(index)];
  }
  /// Whether somebody wants the check to end; `blocks` were looked at since the last question.
  bool over(std::size_t blocks = 1) const {
    return interrupt_.requested(blocks * InterruptCheck::kBlock);
  }

  /// What is wrong at a place. Where a finding has the same cause, in the program or for what the
  /// control refuses in the memory, the place becomes one of that finding: what is set in the
  /// answer then goes nowhere, but for its edits.
  Finding& found(Check check, Address block, TextPlace place, std::string detail);
  /// What the control says is wrong, with its alarm.
  Finding& refused(Check check, Address block, Fault fault);
  /// Whether a cause is known that only its finder can name. Then the place is one of its finding;
  /// otherwise the next finding is the first of this cause.
  bool known(Check check, const std::string& cause, Address block, TextPlace place);

  /// The findings, each with the calls that lead to it.
  std::vector<Finding> take();

 private:
  Finding& add(Check check, const std::string& cause, Address block, TextPlace place);
  bool ignored(Check check, Address block, TextPlace place);
  void keep_edits();
  std::string scope_of(Check check, Address block) const;

  InterruptCheck& interrupt_;
  Callers callers_;
  std::vector<bool> called_by_another_;
  std::vector<Finding> findings_;
  std::unordered_map<std::string, std::size_t> causes_;  // of the findings, by rule and scope
  std::string next_cause_;                               // that `known` was asked for
  std::vector<IgnoredLines> ignored_;                    // by file
  Finding spare_;                                        // for what is a place of another finding
  std::size_t spare_of_ = 0;                             // its place behind 1; 0: it goes nowhere
};

/// Faults, codes, calls and variables that the control refuses.
void check_refusals(Checker& c);
/// Where calls, jumps and returns lead.
void check_targets(Checker& c);
/// What is reached, and how programs end.
void check_reach(Checker& c);
/// How deep calls go, and circles of calls.
void check_nesting(Checker& c);
/// Modes that called programs leave on.
void check_modes(Checker& c);
/// Locals, arguments and commons.
void check_variables(Checker& c);
/// Branches and loops of labels that are not closed.
void check_labels(Checker& c);
/// Logic that binds otherwise than it looks.
void check_logic(Checker& c);
/// Values that people trip over.
void check_values(Checker& c);
/// Canned cycles that drill nothing, or not as often as is written.
void check_drilling(Checker& c);
/// Loops that count in fractions.
void check_counting(Checker& c);
/// Inputs that are read before the blocks above have run.
void check_read_ahead(Checker& c);
/// What a control reads otherwise than it looks: codes of one group, semicolons, small letters.
void check_writing(Checker& c);

/// The blocks that one block is, as the switches or a condition choose. What it is in a program
/// that a code has called, where no code calls, is left out: that it does not call is its purpose.
template <class Look>
void each_variant(const Code& code, const Block& block, const Look& look) {
  look(block);
  if (block.op == Op::IfThen)
    each_variant(code, code.variants[code.statements[block.aux].then], look);
  if (block.op == Op::Select) {
    const Select& variant = code.selects[block.aux];
    each_variant(code, code.variants[variant.first], look);
    if (variant.address == 0) each_variant(code, code.variants[variant.second], look);
  }
  if (block.op == Op::ParallelAssign && code.parallel_assigns[block.aux].words != OWord::kNone)
    each_variant(code, code.variants[code.parallel_assigns[block.aux].words], look);
}

/// Whether a block, or one that it may be, calls with the locals of its program.
inline bool calls_subprogram(const Code& code, const Block& block) {
  bool calls = false;
  each_variant(code, block, [&](const Block& of) { calls |= of.op == Op::Call; });
  return calls;
}

/// The M code of a block that calls, jumps or returns on other controls only; -1 where it has none.
/// M97 and M198 without P may be anything.
int plain_code(const Checker& c, const Block& block);

/// Whether a program that begins at a block is one of a label, which endsub and return end.
inline bool begins_with_label(const Code& code, Address first) {
  return code.blocks[first].op == Op::OWord &&
         code.o_words[code.blocks[first].aux].kind == OWordKind::Sub;
}

/// Whether a program that nothing else ends has G99 alone as its last block, which means M99.
bool means_m99(const Checker& c, const ProgramFlow& flow);

/// The G codes of a block that are written as numbers, ten times each.
template <class Take>
void each_g(const Code& code, const Block& block, const Take& take) {
  if (block.g_count == 0) return;
  const CodeList list = code.codes_of(block);
  for (const int g : list.g()) take(g);
}

/// The M codes of a block that are written as numbers and call nothing.
template <class Take>
void each_m(const Code& code, const Block& block, const Take& take) {
  if (block.m_count == 0) return;
  const CodeList list = code.codes_of(block);
  for (const int m : list.m()) take(m);
}

}  // namespace cncsub
