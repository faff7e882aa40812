// Flow words: o1 if, o1 while, o100 sub, o100 call. [gHf, ngc_flowctrl]
#include <algorithm>
#include <cmath>
#include <utility>

#include "cncsub/code/operand_of.hpp"
#include "cncsub/dialect/grblhal/block.hpp"

namespace cncsub::grblhal {

namespace {

using FlowKind = Flow::Kind;

struct FlowName {
  std::string_view name;
  FlowKind kind;
};
// A name that begins another's stands after that one.
constexpr FlowName kNames[] = {{"elseif", FlowKind::ElseIf},
                               {"else", FlowKind::Else},
                               {"endif", FlowKind::EndIf},
                               {"endwhile", FlowKind::EndWhile},
                               {"endrepeat", FlowKind::EndRepeat},
                               {"endsub", FlowKind::EndSub},
                               {"if", FlowKind::If},
                               {"do", FlowKind::Do},
                               {"while", FlowKind::While},
                               {"repeat", FlowKind::Repeat},
                               {"break", FlowKind::Break},
                               {"continue", FlowKind::Continue},
                               {"call", FlowKind::Call},
                               {"return", FlowKind::Return},
                               {"sub", FlowKind::Sub}};

}  // namespace

bool BlockReader::flow_word(Block& block, Flow& flow) {
  flow.at = line_.offset();
  flow.wall = !flow_label(block, flow);
  if (flow.wall) return true;
  for (const FlowName& of : kNames) {
    if (!line_.take(of.name)) continue;
    flow.kind = of.kind;
    flow.width = line_.width_from(flow.at);
    flow.statement.at = flow.at;
    flow.statement.width = flow.width;
    if (!flow_statement(block, flow)) flow.kind = FlowKind::None;
    return true;
  }
  if (line_.take("alarm") || line_.take("error")) {
    refuse(block, Cause::CodeNotComputed, "cncsub does not compute alarms that a program raises",
           flow.at);
    return true;
  }
  flow.wall = true;
  if (line_.at_end() || line_.peek() == ';' || line_.peek() == '(')
    refuse(block, Cause::AddressNotUsable, "nothing uses the O", flow.at);
  else
    refuse(block, Cause::StatementFormat, "no flow word that the control knows", flow.at);
  return true;
}

bool BlockReader::flow_label(Block& block, Flow& flow) {
  line_.take();
  if (line_.take('<')) {
    flow.named = true;
    if (line_.take_up_to('>', flow.label) && flow.label.size() <= 30) return true;
    return refuse(block, Cause::IllegalVariableName, "a name has at most 30 characters", flow.at);
  }
  Value value;
  if (!expression_.value(value)) return refuse(block);
  if (value.computed)
    return refuse(block, Cause::CodeNotComputed, "cncsub does not compute labels", flow.at);
  if (value.number < 0)
    return refuse(block, Cause::IllegalMinusSign, "the label is below zero", flow.at);
  if (std::trunc(value.number) != value.number)
    return refuse(block, Cause::WholeNumberExpected, "the label is not whole", flow.at);
  flow.label = std::to_string(to_whole<std::int64_t>(std::min(value.number, 1e9)));
  return true;
}

bool BlockReader::flow_statement(Block& block, Flow& flow) {
  switch (flow.kind) {
    case FlowKind::If:
    case FlowKind::ElseIf:
    case FlowKind::While:
    case FlowKind::Repeat:
      if (!condition(block, flow)) return false;
      break;
    case FlowKind::EndSub:
    case FlowKind::Return:
      return give_back(block, flow);
    case FlowKind::Call:
      return flow_call(block, flow);
    default:
      break;
  }
  to_.words(block, {});
  return true;
}

bool BlockReader::condition(Block& block, Flow& flow) {
  Value value;
  if (line_.peek() != '[')
    return refuse(block, Cause::GCodeNotAvailable, "a value in brackets must stand here", flow.at);
  if (!expression_.bracketed(value)) return refuse(block);
  flow.statement.expression = to_.expressions().expression_of(value);
  return true;
}

/// Write the end of a subprogram. What it gives back is computed with the caller's variables; in
/// the main program it ends nothing.
bool BlockReader::give_back(Block& block, const Flow& flow) {
  std::vector<Statement> gives;
  Value value;
  if (line_.peek() == '[') {
    if (!expression_.of_caller(value)) return refuse(block);
    gives.push_back(returned(0, to_.expressions().expression_of(value), flow));
  }
  gives.push_back(returned(1, number(gives.empty() ? 0 : 1, flow), flow));
  CallRecord back;
  back.at = flow.at;
  back.width = flow.width;
  Block own = block;
  to_.words(own, {});
  to_.become(own, Op::Return, std::move(back));
  Statement inside;
  inside.at = flow.at;
  inside.width = flow.width;
  inside.expression = to_.expressions().one({Ins::Level, 0, flow.at, 0}, flow.at, flow.width);
  inside.then = to_.keep(own);
  Block if_called = block;
  to_.become(if_called, Op::IfThen, inside);
  to_.parallel_assign(block, gives, nullptr, &if_called);
  return true;
}

std::uint32_t BlockReader::number(double value, const Flow& flow) {
  return to_.expressions().one({Ins::Constant, 0, flow.at, value}, flow.at, flow.width);
}

/// Return an assignment to what was returned: 0 the value, 1 whether there is one.
Statement BlockReader::returned(int place, std::uint32_t expression, const Flow& flow) {
  Statement statement;
  statement.target = Statement::Target::Common;
  statement.index = to_.names().returned() + place;
  statement.expression = expression;
  statement.at = statement.variable_at = flow.at;
  statement.width = statement.variable_width = flow.width;
  return statement;
}

/// Let a line call after it has forgotten what the last call returned.
void BlockReader::forget_and(Block& block, const Flow& flow, const Block& call,
                             std::vector<Statement> statements) {
  for (const int place : {0, 1}) statements.push_back(returned(place, number(0, flow), flow));
  to_.parallel_assign(block, statements, nullptr, &call);
}

/// Return the expressions of the numbered locals; all calls of a file have the same.
const BlockReader::Locals& BlockReader::locals(const Flow& flow) {
  if (locals_.file == to_.program().file) return locals_;
  locals_ = {.file = to_.program().file};
  for (std::int16_t i = 1; i <= kLastLocal; ++i) {
    // Read by its number: a parameter that has no value is no mistake here.
    to_.expressions().begin();
    to_.expressions().emit({Ins::Constant, 0, flow.at, static_cast<double>(i)});
    to_.expressions().emit({Ins::IndirectRaw, 0, flow.at, 0});
    locals_.expressions[static_cast<std::size_t>(i)] = to_.expressions().end(flow.at, flow.width);
  }
  return locals_;
}

/// Let a call hand its numbered locals on, for values that are computed after its return.
void BlockReader::hand_on_locals(std::vector<Argument>& arguments, const Flow& flow,
                                 std::int16_t first) {
  const Locals& own = locals(flow);
  const auto add = [&](std::int16_t number, std::int32_t to) {
    const Value of{.computed = true,
                   .expression = own.expressions[static_cast<std::size_t>(number)],
                   .at = flow.at,
                   .width = flow.width};
    arguments.push_back({to, 0, operand_of(of)});
  };
  for (std::int16_t i = first; i <= kLastLocal; ++i) add(i, i);
  for (std::int16_t i = 1; i <= kLastLocal; ++i) add(i, callers_locals(to_) + i);
}

/// Give a call its arguments, and the other locals of its caller. Calls without an argument share
/// theirs.
void BlockReader::pass(CallRecord& call, std::vector<Argument> arguments, const Flow& flow) {
  const bool none = arguments.empty();
  hand_on_locals(arguments, flow, static_cast<std::int16_t>(arguments.size() + 1));
  call.arguments = static_cast<std::uint32_t>(arguments.size());
  if (none && locals_.arguments) {
    call.first_argument = *locals_.arguments;
    return;
  }
  call.first_argument = to_.next_argument();
  for (const Argument& argument : arguments) to_.keep(argument);
  if (none) locals_.arguments = call.first_argument;
}

/// Write a call: values in brackets for #1, #2 and on; the others keep the caller's.
bool BlockReader::flow_call(Block& block, Flow& flow) {
  CallRecord call;
  call.kind = flow.named ? CallKind::Named : CallKind::OWord;
  call.locals = CallRecord::Locals::Own;
  call.at = flow.at;
  call.width = flow.width;
  if (flow.named) {
    CallExtras& extras = call.extras.make();
    extras.name = flow.label;
    extras.name_at = flow.at + 2;
    extras.name_width = static_cast<std::uint32_t>(flow.label.size());
  }
  std::vector<Argument> arguments;
  while (!line_.at_end() && line_.peek() != ';' && line_.peek() != '(' &&
         arguments.size() < kLastLocal) {
    if (line_.peek() != '[')
      return refuse(block, Cause::GCodeNotAvailable, "a value in brackets must stand here",
                    line_.offset());
    Value value;
    if (!expression_.bracketed(value)) return refuse(block);
    arguments.push_back({static_cast<std::int16_t>(arguments.size() + 1), 0, operand_of(value)});
  }
  pass(call, std::move(arguments), flow);
  flow.call = to_.keep(std::move(call));
  Block own = block;
  to_.words(own, {});
  own.op = Op::Call;
  own.aux = flow.call;
  forget_and(block, flow, own, {});
  return true;
}

}  // namespace cncsub::grblhal
