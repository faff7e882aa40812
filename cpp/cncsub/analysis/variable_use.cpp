#include "cncsub/analysis/variable_use.hpp"

#include <string>
#include <string_view>
#include <utility>

#include "cncsub/code/references.hpp"

namespace cncsub {

VariableUses::VariableUses(const Checker& c) : c_(c), programs_(c.flows.size()) {
  for (const ProgramFlow& flow : c.flows)
    for (Address at = flow.first(); at < flow.last(); ++at) take(flow, at);
  share();
}

Bits VariableUses::bit_of(std::int64_t number, std::vector<std::int32_t>& to) const {
  const VariablePlace place = c_.code.place(number);
  const bool local = place.is_local() && place.index < kMostBits;
  if (local || place.is_common()) to.push_back(static_cast<std::int32_t>(number));
  return local ? Bits{1} << place.index : 0;
}

/// Whether a condition of the block compares with #0.
bool VariableUses::tests_vacancy(const Block& block) const {
  bool tests = false;
  each_variant(c_.code, block, [&](const Block& of) {
    if (of.op != Op::IfGoto && of.op != Op::IfThen && of.op != Op::If && of.op != Op::While) return;
    for (const Instruction at : c_.code.expression(c_.code.statements[of.aux].expression))
      tests = tests || (at.op == Ins::Constant && is_vacant(at.value));
  });
  return tests;
}

namespace {

/// A word or a copy of a variable: without a value the word is not there, and the copy has none.
bool is_alone(const Block& block, std::string_view written) {
  if (is_words(block.op)) return written.find_first_of("[+*/") == std::string_view::npos;
  const bool assigns = block.op == Op::Set || block.op == Op::Assign;
  return assigns && written.find_first_of("[+*/-") == std::string_view::npos;
}

}  // namespace

void VariableUses::take(const ProgramFlow& flow, Address at) {
  const Block& block = c_.code.blocks[at];
  const bool plain = block.op == Op::Linear || block.op == Op::Arc || block.op == Op::Fault;
  const bool words =
      block.op == Op::Words && (block.flags & Block::kCodeExpression) == 0 &&
      ((block.flags & Block::kHasExtra) == 0 || c_.code.cells[block.data].extra.expressions == 0);
  if (plain || words) return;
  const References of = references_of(c_.code, block, flow.program());
  if (of.reads.empty() && of.writes.empty()) return;
  VariableUse use;
  use.tests = tests_vacancy(block);
  const std::string& text = c_.code.files[c_.program(flow.program()).file].text;
  for (const VariableReference& each : of.reads) {
    use.any = use.any || each.computed || each.number < 0;
    const Bits own = each.number < 0 ? 0 : bit_of(each.number, use.reads);
    use.read_locals |= own;
    const std::string_view written = std::string_view(text).substr(each.place.at, each.place.width);
    const bool alone = is_alone(block, written);
    if (alone) use.word_locals |= own;
  }
  for (const VariableReference& each : of.writes) {
    use.any = use.any || each.computed || each.number < 0;
    if (each.number >= 0) use.written_locals |= bit_of(each.number, use.writes);
  }
  LocalUse& own = programs_[static_cast<std::size_t>(flow.program())];
  own.reads |= use.read_locals;
  own.again |= own.writes & use.written_locals;
  own.writes |= use.written_locals;
  own.any = own.any || use.any;
  if (use.tests) own.tested |= use.read_locals;
  uses_.emplace(at, std::move(use));
}

/// A subprogram has the locals of its caller: what it does is done by the caller too.
void VariableUses::share() {
  std::vector<std::int32_t> waiting;
  waiting.reserve(c_.flows.size());
  for (const ProgramFlow& flow : c_.flows) waiting.push_back(flow.program());
  while (!waiting.empty()) {
    const std::int32_t program = waiting.back();
    waiting.pop_back();
    const LocalUse of = of_program(program);
    for (const CallEdge& edge : c_.callers[static_cast<std::size_t>(program)]) {
      if (edge.macro) continue;
      LocalUse& caller = programs_[static_cast<std::size_t>(edge.caller)];
      const LocalUse before = caller;
      caller.reads |= of.reads;
      caller.again |= of.again | (caller.writes & of.writes);
      caller.writes |= of.writes;
      caller.tested |= of.tested;
      caller.any = caller.any || of.any;
      if (caller != before) waiting.push_back(edge.caller);
    }
  }
}

/// The word or value of a block that reads a variable.
TextPlace VariableUses::place_of(Address at, std::int32_t number) const {
  const Block& block = c_.code.blocks[at];
  const References of = references_of(c_.code, block, c_.code.program_at(at));
  for (const VariableReference& each : of.reads)
    if (each.number == number) return each.place;
  return {block.text, block.length};
}

std::vector<std::vector<const CallEdge*>> calls_by_block(const ProgramFlow& flow) {
  std::vector<std::vector<const CallEdge*>> calls(flow.size());
  for (const CallEdge& edge : flow.calls()) calls[edge.from - flow.first()].push_back(&edge);
  return calls;
}

void check_variables(Checker& c) {
  if (c.code.control->lacks(RuleGroup::MacroRules) != nullptr) return;
  const VariableUses uses(c);
  check_vacant(c, uses);
  check_overwritten(c, uses);
}

}  // namespace cncsub
