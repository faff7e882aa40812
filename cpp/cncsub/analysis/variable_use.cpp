#include "cncsub/analysis/variable_use.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "cncsub/code/names.hpp"
#include "cncsub/code/references.hpp"
#include "cncsub/control/variable_table.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

constexpr std::int32_t kFirstNamed = 1 << 30;  // plus its place: a variable with a name

/// Return the name of a variable as programs write it.
std::string written(const Code& code, const std::string& name) {
  return code.spelling->numbered ? "#<" + name + ">" : name;
}

/// Return the bit of a local that has a name.
Bits local_bit(const NamedVariable& of) {
  return of.common || of.index >= kMostBits ? 0 : Bits{1} << of.index;
}

}  // namespace

VariableUses::VariableUses(const Checker& c) : c_(c), programs_(c.flows.size()) {
  for (const NamedVariable& of : c.code.named_variables) named_ |= local_bit(of);
  for (const ProgramFlow& flow : c.flows)
    for (Address at = flow.first(); at < flow.last() && !c.over(); ++at) take(flow, at);
  share();
}

std::int64_t VariableUses::own_number(std::int64_t number) const {
  const VariablePlace place = c_.code.place(number);
  if (place.range == nullptr || !is_alias(*place.range)) return number;
  return place.range->from + (number - place.range->first);
}

Bits VariableUses::bit_of(std::int64_t number, std::vector<std::int32_t>& to) const {
  const VariablePlace place = c_.code.place(number);
  const bool local = place.is_local() && place.index < kMostBits;
  if (local || place.is_common()) to.push_back(static_cast<std::int32_t>(own_number(number)));
  return local ? Bits{1} << place.index : 0;
}

/// Return the bit of a variable that may have a name. Sets `any` where it may be any variable.
Bits VariableUses::bit_of(const VariableReference& of, std::vector<std::int32_t>& to,
                          bool& any) const {
  if (!of.computed && of.number >= 0) return bit_of(of.number, to);
  const std::optional<std::uint32_t> found =
      of.computed ? std::nullopt : place_of_name(c_.code, of.name, of.common);
  any = any || !found;
  if (!found) return 0;
  to.push_back(kFirstNamed + static_cast<std::int32_t>(*found));
  return local_bit(named_variable(to.back()));
}

const NamedVariable& VariableUses::named_variable(std::int32_t number) const {
  return c_.code.named_variables[static_cast<std::size_t>(number - kFirstNamed)];
}

std::int32_t VariableUses::number_of(std::int32_t local) const {
  if ((named_ >> local & 1) == 0) return local;
  const NamedVariable* const found = c_.code.named(false, local);
  return kFirstNamed + static_cast<std::int32_t>(found - c_.code.named_variables.data());
}

std::string VariableUses::name_of(std::int32_t number) const {
  if (number < kFirstNamed) {
    std::string own = sign_ + std::to_string(number);
    for (const PlacedRange& placed : c_.code.variables) {
      const VariableRange& range = placed.range;
      const std::int32_t other = range.first + (number - range.from);
      if (is_alias(range) && other >= range.first && other <= range.last)
        return "#" + std::to_string(other) + " (" + own + ")";
    }
    return own;
  }
  return written(c_.code, named_variable(number).name);
}

bool VariableUses::is_local(std::int32_t number) const {
  if (number < kFirstNamed) return c_.code.place(number).is_local();
  return !named_variable(number).common;
}

/// Return whether a condition of the block compares with #0.
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

/// Return whether a block writes a variable alone in a word, or copies it. Without a value the
/// control leaves out the word, and the copy has no value.
bool is_alone(const Block& block, std::string_view written) {
  if (is_words(block.op)) return written.find_first_of("[+*/") == std::string_view::npos;
  const bool assigns = block.op == Op::Set || block.op == Op::Assign;
  return assigns && written.find_first_of("[+*/-") == std::string_view::npos;
}

/// Return whether a block uses no variable: a move, a fault, or words without variables.
bool uses_none(const Code& code, const Block& block) {
  if (block.op == Op::Linear || block.op == Op::Arc || block.op == Op::Fault) return true;
  return block.op == Op::Words && (block.flags & Block::kCodeExpression) == 0 &&
         ((block.flags & Block::kHasExtra) == 0 || code.cells[block.data].extra.expressions == 0);
}

}  // namespace

void VariableUses::take(const ProgramFlow& flow, Address at) {
  const Block& block = c_.code.blocks[at];
  if (uses_none(c_.code, block)) return;
  const References of = references_of(c_.code, block, flow.program());
  if (of.reads.empty() && of.writes.empty()) return;
  VariableUse use;
  use.tests = tests_vacancy(block);
  LocalUse& program = programs_[static_cast<std::size_t>(flow.program())];
  const bool left_out = c_.code.control->macros.vacant_address.value == VacantAddress::Ignored;
  const bool prints = block.op >= Op::Print && block.op <= Op::NameVariables;
  const std::string_view text = c_.code.files[c_.program(flow.program()).file].text.view();
  for (const VariableReference& each : of.reads) {
    const Bits own = bit_of(each, use.reads, use.any);
    if (each.asked) program.tested |= own;
    use.read_locals |= prints ? own & ~named_ : own;  // a vacant one is printed as such
    const std::string_view written = std::string_view(text).substr(each.place.at, each.place.width);
    if (left_out && is_alone(block, written)) use.word_locals |= own;
  }
  for (const VariableReference& each : of.writes) {
    use.written_locals |= bit_of(each, use.writes, use.any);
    const std::string_view written = std::string_view(text).substr(each.place.at, each.place.width);
    if (written.size() > 1 && upper(written[0]) == 'R' && is_digit(written[1])) sign_ = 'R';
  }
  program.reads |= use.read_locals;
  program.again |= program.writes & use.written_locals;
  program.writes |= use.written_locals;
  program.any = program.any || use.any;
  if (use.tests) program.tested |= use.read_locals;
  uses_.emplace(at, std::move(use));
}

/// Add what subprograms do with locals to their callers, whose locals they share. Called programs
/// come before their callers, so that only programs that call each other are visited again.
void VariableUses::share() {
  for (const auto& group : c_.groups.groups) {
    std::vector<std::uint32_t> waiting = group;
    std::unordered_set<std::uint32_t> waits(group.begin(), group.end());
    while (!waiting.empty() && !c_.over()) {
      const std::uint32_t program = waiting.back();
      waiting.pop_back();
      waits.erase(program);
      if (!take_called(program)) continue;
      for (const CallEdge* edge : c_.callers_of(static_cast<std::int32_t>(program))) {
        const auto caller = static_cast<std::uint32_t>(edge->caller);
        if (c_.groups.of[caller] == c_.groups.of[program] && waits.insert(caller).second)
          waiting.push_back(caller);
      }
    }
  }
}

/// Add what the subprograms of a program do with its locals; return whether that is new.
bool VariableUses::take_called(std::uint32_t program) {
  LocalUse& caller = programs_[program];
  const LocalUse before = caller;
  for (const CallEdge& edge : c_.flows[program].calls()) {
    if (edge.macro) continue;
    const LocalUse& of = of_program(edge.called);
    caller.reads |= of.reads;
    caller.again |= of.again | (caller.writes & of.writes);
    caller.writes |= of.writes;
    caller.tested |= of.tested;
    caller.any = caller.any || of.any;
  }
  return caller != before;
}

TextPlace VariableUses::place_of(Address at, std::int32_t number) const {
  const Block& block = c_.code.blocks[at];
  const References of = references_of(c_.code, block, c_.code.program_at(at));
  const std::string name = name_of(number);
  for (const VariableReference& each : of.reads) {
    const bool named = each.number < 0 && !each.computed && name == written(c_.code, each.name);
    const bool same = !each.computed && each.number >= 0 && own_number(each.number) == number;
    if (same || named) return each.place;
  }
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
  check_commons(c, uses);
}

}  // namespace cncsub
