#include "cncsub/code/variables_used.hpp"

#include <utility>

namespace cncsub {

namespace {

bool is_local(Ins op) { return op == Ins::Local || op == Ins::LocalRaw; }
bool is_common(Ins op) { return op == Ins::Common || op == Ins::CommonRaw; }
/// Return whether a local is one that no program can name.
bool is_hidden(const Code& code, const Instruction& of) {
  const auto index = static_cast<std::int32_t>(of.at);
  return is_local(of.op) && of.value == 0 && index > code.locals_per_level &&
         code.named(false, index) == nullptr;
}
bool is_indirect(Ins op) { return op == Ins::Indirect || op == Ins::IndirectRaw; }

}  // namespace

/// Return the variable that has a name here, or the one that stands at this place.
VariableReference VariablesUsed::variable(bool common, std::int32_t index, TextPlace place) const {
  VariableReference found;
  found.place = place;
  if (const NamedVariable* const of = code_.named(common, index)) {
    found.name = of->name;
    found.common = common;
    return found;
  }
  found.number = index;
  for (const PlacedRange& placed : code_.variables) {
    const VariableRange& range = placed.range;
    const bool kept = range.kind == VariableKind::Common || range.kind == VariableKind::Kept;
    const std::int64_t behind = index - placed.base;
    if (common && kept && behind >= 0 && behind <= range.last - range.first)
      found.number = range.first + behind;
  }
  return found;
}

VariableReference VariablesUsed::variable(const Instruction& of, bool local,
                                          TextPlace place) const {
  if (of.value == 0) return variable(!local, static_cast<std::int32_t>(of.at), place);
  VariableReference found;
  found.place = place;
  found.number = to_whole<std::int64_t>(of.value);
  return found;
}

/// List the variables that an expression reads.
// NOLINTNEXTLINE(readability-function-cognitive-complexity): one instruction after the other
void VariablesUsed::reads(std::uint32_t expression) {
  const TextPlace place = place_of(expression);
  const Expression of = code_.expression(expression);
  bool named = false;  // the number of the variable that comes next
  for (auto at = of.begin(); at != Expression::end(); ++at) {
    const Instruction here = *at;
    if (std::exchange(named, false) && is_indirect(here.op)) continue;
    VariableReference found;
    found.place = place;
    if (is_local(here.op) || is_common(here.op)) {
      if ((here.value == 0 && here.at == 0) || is_hidden(code_, here)) continue;  // #0
      found = variable(here, is_local(here.op), place);
    } else if (here.op == Ins::Referenced) {
      found = variable(false, to_whole<std::int32_t>(here.value), place);
    } else if (here.op == Ins::Variable || here.op == Ins::VariableRaw) {
      found.number = to_whole<std::int64_t>(here.value);
    } else if (here.op == Ins::NamedLocal || here.op == Ins::NamedCommon) {
      found.name = code_.named_variables[to_whole<std::size_t>(here.value)].name;
      found.common = code_.named_variables[to_whole<std::size_t>(here.value)].common;
    } else if (here.op == Ins::Named) {
      found.name = code_.names[to_whole<std::size_t>(here.value)];
      named = true;
    } else if (is_indirect(here.op)) {
      found.computed = true;
    } else if (here.op == Ins::IsSet && !to_.reads.empty()) {
      to_.reads.back().asked = true;
      continue;
    } else {
      continue;
    }
    to_.reads.push_back(found);
  }
}

void VariablesUsed::operand(const Operand& operand) {
  if (operand.kind == Operand::Kind::Expression) reads(operand.expression);
}

void VariablesUsed::words(const Block& block) {
  if (block.mask == 0 && !block.has_codes()) return;
  const Cell* cell = code_.cells.data() + block.data;
  std::uint32_t expressions = 0;
  if ((block.flags & Block::kHasExtra) != 0) expressions = (cell++)->extra.expressions;
  for (int i = 0; i < block.code_cells(); ++i, ++cell)
    if ((block.flags & Block::kCodeExpression) != 0 && cell->value < 0)
      reads(to_whole<std::uint32_t>(-1.0 - cell->value));
  for (std::uint32_t left = block.mask; left != 0; left &= left - 1, ++cell)
    if ((expressions & left & -left) != 0) reads(static_cast<std::uint32_t>(cell->expression));
}

void VariablesUsed::written(const Statement& statement) {
  using Target = Statement::Target;
  const TextPlace place{statement.variable_at, statement.variable_width};
  VariableReference to;
  to.place = place;
  if (statement.target == Target::Common && statement.index == code_.call_path) return;
  switch (statement.target) {
    case Target::None:
      return;
    case Target::Local:
    case Target::Common:
      to = variable(statement.target == Target::Common, statement.index, place);
      break;
    case Target::Referenced:
      to = variable(false, statement.number, place);
      break;
    case Target::Element:
    case Target::CommonElement:
    case Target::VariableAt:
    case Target::ReferencedElement:
      reads(statement.variable);
      return;
    case Target::Variable:
      to.number = statement.index;
      break;
    case Target::Indirect: {
      const Expression of = code_.expression(statement.variable);
      auto number = of.begin();
      const Instruction first = *number;
      if (first.op == Ins::Named && ++number == Expression::end()) {
        to.name = code_.names[to_whole<std::size_t>(first.value)];
        to.place.width = static_cast<std::uint32_t>(to.name.size()) + 1;
        break;
      }
      reads(statement.variable);
      to.computed = true;
      break;
    }
  }
  to_.writes.push_back(std::move(to));
}

void VariablesUsed::named_by(const Operand& operand) {
  const std::size_t before = to_.reads.size();
  reads(operand.expression);
  const auto from = to_.reads.begin() + static_cast<std::ptrdiff_t>(before);
  to_.writes.insert(to_.writes.end(), from, to_.reads.end());
  to_.reads.erase(from, to_.reads.end());
}

}  // namespace cncsub
