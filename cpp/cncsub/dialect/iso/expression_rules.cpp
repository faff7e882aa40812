#include "cncsub/dialect/iso/expression_rules.hpp"

#include <algorithm>
#include <iterator>

namespace cncsub {

namespace {

// The limit of nested brackets, whatever the control allows: nested calls of functions read them.
constexpr int kDeepestBrackets = 64;

constexpr FunctionName kFunctions[] = {{Function::Sin, Ins::Sin},
                                       {Function::Cos, Ins::Cos},
                                       {Function::Tan, Ins::Tan},
                                       {Function::Asin, Ins::Asin},
                                       {Function::Acos, Ins::Acos},
                                       {Function::Atan, Ins::Atan},
                                       {Function::Atan2, Ins::End, Ins::Atan2},
                                       {Function::Sqrt, Ins::Sqrt},
                                       {Function::Sqr, Ins::Sqrt},
                                       {Function::Abs, Ins::Abs},
                                       {Function::Round, Ins::Round},
                                       {Function::Rnd, Ins::Round},
                                       {Function::Fix, Ins::Fix},
                                       {Function::Int, Ins::Fix},
                                       {Function::Fup, Ins::Fup},
                                       {Function::Ln, Ins::Ln},
                                       {Function::Exp, Ins::Exp},
                                       {Function::Pow, Ins::End, Ins::Pow},
                                       {Function::Bin, Ins::Bin},
                                       {Function::Bcd, Ins::Bcd},
                                       {Function::Adp, Ins::Adp},
                                       {Function::Prm, Ins::Parameter, Ins::ParameterBit},
                                       {Function::Sign, Ins::Sign},
                                       {Function::Rand, Ins::Random},
                                       {Function::Srand, Ins::End, Ins::RandomBetween},
                                       {Function::Ar, Ins::Programmed}};

}  // namespace

ExpressionRules::ExpressionRules(const Code& of, bool is_structured)
    : code(of),
      control(*of.control),
      alike(!is_structured && control.macros.logic_order.value == LogicOrder::LikeArithmetic),
      numbers_first(!is_structured &&
                    control.macros.logic_order.value == LogicOrder::LastOfConditions),
      joined(control.macros.conditions.value.has(Condition::Joined)),
      values(is_structured || control.macros.conditions.value.has(Condition::Values)),
      bare(is_structured || control.macros.conditions.value.has(Condition::Bare)),
      symbols(control.macros.conditions.value.has(Condition::Symbols)),
      names(control.macros.variable_forms.value.has(VariableForm::Names)),
      indirect(control.macros.variable_forms.value.has(VariableForm::Indirect)),
      points(control.macros.variable_forms.value.has(VariableForm::Point)),
      distinguishes_vacant(control.macros.vacant_comparison.value ==
                           VacantComparison::Distinguished),
      word_arithmetic(is_structured || control.macros.word_arithmetic.value),
      modulo(has(Function::Mod)),
      most_brackets(is_structured ? kDeepestBrackets
                                  : std::min(control.macros.max_brackets.value, kDeepestBrackets)),
      most_digits(std::min(control.macros.max_constant_digits.value, kMostDigits)),
      structured(is_structured) {
  for (const FunctionName& of_name : kFunctions) {
    const std::string_view name = name_of(of_name.function);
    if (name.size() > kLongest || !has(of_name.function)) continue;
    if (!std::all_of(name.begin(), name.end(), is_letter)) continue;
    std::uint64_t letters = 0;
    for (std::size_t i = 0; i < name.size(); ++i) letters |= letter(name[i]) << 8 * i;
    std::size_t slot = slot_of(letters);
    static_assert(std::size(kFunctions) < kSlots);
    while (short_names_[slot] != 0) slot = (slot + 1) % kSlots;
    short_names_[slot] = letters;
    short_functions_[slot] = &of_name;
  }
}

const FunctionName* ExpressionRules::function(std::string_view name) const {
  for (const FunctionName& f : kFunctions)
    if (name_of(f.function) == name && has(f.function)) return &f;
  if (!control.macros.short_functions.value || name.size() < 2) return nullptr;
  for (const FunctionName& f : kFunctions)
    if (name_of(f.function).starts_with(name) && has(f.function)) return &f;
  return nullptr;
}

}  // namespace cncsub
