#include "cncsub/dialect/ngc_values.hpp"

#include <algorithm>

namespace cncsub {

namespace {

// [rs274 2.9; gHx, read_operation_unary, execute_unary]
constexpr NgcFunction kFunctions[] = {{"abs", Ins::Abs},        {"acos", Ins::ArcCosineOf},
                                      {"asin", Ins::ArcSineOf}, {"cos", Ins::CosineOf},
                                      {"exp", Ins::Raise},      {"fix", Ins::Floor},
                                      {"fup", Ins::Ceil},       {"ln", Ins::Ln},
                                      {"round", Ins::Round},    {"sin", Ins::SineOf},
                                      {"sqrt", Ins::Sqrt},      {"tan", Ins::TangentOf}};

// [rs274 2.9; gHx, precedence, ngc_eval_expression]
constexpr OperatorRow kOperators[] = {{"**", 4, Ins::Raise},        {"*", 3, Ins::Multiply},
                                      {"/", 3, Ins::Divide},        {"mod", 3, Ins::PositiveModulo},
                                      {"+", 2, Ins::Add},           {"-", 2, Ins::Subtract},
                                      {"eq", 1, Ins::NearlyEqual},  {"ne", 1, Ins::NearlyNotEqual},
                                      {"ge", 1, Ins::GreaterEqual}, {"gt", 1, Ins::Greater},
                                      {"le", 1, Ins::LessEqual},    {"lt", 1, Ins::Less},
                                      {"and", 0, Ins::BothTrue},    {"or", 0, Ins::EitherTrue},
                                      {"xor", 0, Ins::OneTrue}};

}  // namespace

const std::span<const NgcFunction> ngc_functions = kFunctions;
const std::span<const OperatorRow> ngc_operators = kOperators;

void ngc_push(Builder& to, const BareLine& line, Ins op, double value, std::uint32_t index) {
  const bool indexed = op == Ins::Local || op == Ins::LocalRaw || op == Ins::Common ||
                       op == Ins::CommonRaw || op == Ins::NamedLocal || op == Ins::NamedCommon;
  to.expressions().emit({op, 0, indexed ? index : line.offset(), value});
}

void ngc_push_load(Builder& to, const BareLine& line, std::int64_t number) {
  const VariablePlace place = to.code().place(number);
  const Ins load = place.is_local() ? Ins::Local : place.is_common() ? Ins::Common : Ins::Variable;
  ngc_push(to, line, load, static_cast<double>(number), static_cast<std::uint32_t>(place.index));
}

std::uint32_t ngc_named(Builder& to, const std::string& name) {
  return to.names().variable(name, name.starts_with('_'));
}

const NamedVariable& ngc_variable(Builder& to, const std::string& name) {
  return to.code().named_variables[ngc_named(to, name)];
}

void ngc_push_raw(Builder& to, const BareLine& line, const std::string& name) {
  const NamedVariable& variable = ngc_variable(to, name);
  ngc_push(to, line, variable.common ? Ins::CommonRaw : Ins::LocalRaw, 0,
           static_cast<std::uint32_t>(variable.index));
}

const BuiltIn* find_built_in(std::span<const BuiltIn> all, std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [name](const BuiltIn& of) { return of.name == name; });
  return found == all.end() ? nullptr : &*found;
}

void ngc_push_built_in(Builder& to, const BareLine& line, const BuiltIn& of) {
  for (const BuiltIn::Step& step : of.steps) {
    if (step.op == Ins::End) break;
    if (step.op == Ins::Common)
      ngc_push(to, line, Ins::Common, 0,
               static_cast<std::uint32_t>(to.names().returned() + to_whole<int>(step.value)));
    else
      ngc_push(to, line, step.op, step.value);
  }
}

}  // namespace cncsub
