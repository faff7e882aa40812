// Codes, also of an index: M3, G[8]=2, M[1]=5, S[SPINDLE]=500; tools by their names; and the data
// of tools that a program writes.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "cncsub/control/edge_datum.hpp"
#include "cncsub/control/g_codes.hpp"
#include "cncsub/dialect/sinumerik/code_groups.hpp"
#include "cncsub/dialect/sinumerik/open_block.hpp"

namespace cncsub::sinumerik {

namespace {

/// Write an expression of the instructions of others, and one more.
std::uint32_t joined(Builder& to, std::initializer_list<std::uint32_t> parts, Instruction more) {
  std::vector<Instruction> all;
  for (const std::uint32_t part : parts)
    for (const Instruction each : to.code().expression(part))
      if (each.op != Ins::End) all.push_back(each);
  const Expression first = to.code().expression(*parts.begin());
  const std::uint32_t at = first.at(), width = first.width();
  to.expressions().begin();
  for (const Instruction& each : all) to.expressions().emit(each);
  to.expressions().emit(more);
  return to.expressions().end(at, width);
}

/// Read the index in its brackets.
bool index_of(OpenBlock& open, Block& block, Value& index, std::uint32_t at) {
  open.line.take('[');
  if (!open.expression.value(index)) return open.refuse(block);
  if (!open.line.take(']')) return open.refuse(block, Cause::BracketNotClosed, "] is missing", at);
  return open.line.take('=') || open.refuse(block, Cause::MissingEquals, "= is missing", at);
}

/// Read G[8]=2, the second code of the eighth group.
bool code_of_group(OpenBlock& open, Block& block, Words& words, const Value& index,
                   std::uint32_t at) {
  Value number;
  if (!open.expression.value(number)) return open.refuse(block);
  const int group =
      index.computed ? 0 : to_whole<int>(std::clamp(std::round(index.number), 0.0, 99.0));
  const CodesOfGroup* const of = codes_of_group(group);
  if (of == nullptr)
    return open.not_computed(
        block,
        index.computed ? "a G group of a computed number" : "a code of this G group by its number",
        at);
  if (number.computed) {
    if (!words.take_group(group))
      return open.refuse(block, Cause::GroupGivenTwice, "a second code of its G group", at);
    std::vector<double> list;
    list.reserve(of->codes.size());
    for (const int code : of->codes) list.push_back(code == kNoCode ? kVacant : code / 10.0);
    const Instruction chosen{Ins::Listed, 0, number.at,
                             static_cast<double>(open.to.names().list(std::move(list)))};
    words.list.add_g({true, joined(open.to, {number.expression}, chosen), 0});
    words.any = true;
    return true;
  }
  const double place = std::round(number.number);
  const bool exists = place >= 1 && place <= static_cast<double>(of->codes.size());
  if (!exists)
    return open.refuse(block, Cause::GroupCodeNotAvailable, "no code of the group has this number",
                       at);
  const int code = of->codes[to_whole<std::size_t>(place) - 1];
  if (code == kNoCode) return open.not_computed(block, "this code of its G group", at);
  return add_code(open, block, words, group, code, at);
}

/// Make a value one that counts only where the index is 1, the spindle of the words without one.
Value of_first(OpenBlock& open, const Value& value, const Value& index, std::uint32_t at) {
  Value of = value;
  of.at = at;
  of.width = open.line.width_from(at);
  const Instruction first{Ins::OfFirst, 0, at, static_cast<double>(of.width)};
  of.expression = joined(
      open.to,
      {open.to.expressions().expression_of(value), open.to.expressions().expression_of(index)},
      first);
  of.computed = true;
  return of;
}

}  // namespace

bool value_of_code(OpenBlock& open, Block& block, std::uint32_t at, Value& value) {
  const bool quick = capitals(open.line.name()) == "QU" && open.definitions.find("QU") == nullptr;
  if (quick) {
    open.line.pass(2);
    if (!open.line.take('('))
      return open.refuse(block, Cause::BracketNotOpened, "( is missing", at);
  }
  if (!open.expression.value(value)) return open.refuse(block);
  return !quick || open.line.take(')') ||
         open.refuse(block, Cause::BracketNotClosed, ") is missing", at);
}

/// Take an M code, whose value was read.
bool m_code(OpenBlock& open, Block& block, Words& words, const Value& value) {
  constexpr int kMostM = 5;  // of a block [NCI groups; general knowledge]
  if (words.list.m_count == kMostM)
    return open.refuse(block, Cause::TooManyWords, "more than five M codes", value.at);
  const int code = to_whole<int>(std::clamp(std::round(value.number), -1.0, kLargestCode));
  const Role role = value.computed ? Role::None : open.to.control().calls.roles.value.of_m(code);
  if (role == Role::Return) {
    words.back = value.at;
    return true;
  }
  words.ends = words.ends || role == Role::End;
  words.list.add_m({value.computed, value.expression, value.number});
  return true;
}

bool indexed(OpenBlock& open, Block& block, Words& words, char letter, std::uint32_t at) {
  Value index, value;
  if (letter != 'G' && letter != 'M' && letter != 'S') {
    open.line.pass_brackets('[', ']');
    return open.not_computed(block, "an address with an index", at);
  }
  if (!index_of(open, block, index, at)) return false;
  if (letter == 'G') return code_of_group(open, block, words, index, at);
  if (!value_of_code(open, block, at, value)) return false;
  value.at = at;
  value.width = open.line.width_from(at);
  words.any = true;
  if (!index.computed && std::round(index.number) != 1) return reported(open, words, at);
  if (index.computed) value = of_first(open, value, index, at);
  return letter == 'M' ? m_code(open, block, words, value)
                       : put(open, block, words, letter - 'A', value);
}

bool tool_by_name(OpenBlock& open, Block& block, Words& words, const Value& name,
                  std::uint32_t at) {
  Value tool = name;
  tool.at = at;
  tool.width = open.line.width_from(at);
  const Instruction number{Ins::ToolOfName, 0, at, static_cast<double>(tool.width)};
  tool.expression = joined(open.to, {open.to.expressions().expression_of(name)}, number);
  tool.computed = true;
  return put(open, block, words, 'T' - 'A', tool);
}

bool system_assignment(OpenBlock& open, Block& block, Words& words, std::uint32_t at) {
  const Line before = open.line;
  open.line.pass(1);
  const std::string name = capitals(open.line.name());
  const auto array = system_array_of(open.to, name);
  if (!array && !name.starts_with("TC_")) return open.line = before, false;
  open.line.pass(name.size());
  if (array) {
    Statement statement;
    statement.at = statement.variable_at = at;
    if (!open.expression.system_array(*array, statement)) return open.refuse(block), true;
    words.statements.push_back(statement);
    return true;
  }
  // Other data of tools change nothing that a run computes.
  if (open.line.peek() == '[') open.line.pass_brackets('[', ']');
  Value value;
  Type type = Type::Real;
  if (!open.line.take('=')) {
    open.refuse(block, Cause::MissingEquals, "= is missing", at);
  } else if (!open.expression.value_of_any(value, type)) {
    open.refuse(block);
  } else {
    reported(open, words, at);
  }
  return true;
}

}  // namespace cncsub::sinumerik
