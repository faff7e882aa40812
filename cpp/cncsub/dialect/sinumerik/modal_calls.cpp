// MCALL, the call after each block that moves, and SETAL, by which a program raises an alarm.
#include <algorithm>
#include <cmath>
#include <utility>

#include "cncsub/dialect/sinumerik/block.hpp"

namespace cncsub::sinumerik {

/// Read MCALL SUB(5), or MCALL, which ends the modal call. [PGZ p.2-48, modal call]
bool BlockReader::modal_call(Block& block, Words& words, std::uint32_t at) {
  line_.pass(5);
  words.modal = at;
  if (line_.at_end()) return true;
  const std::string_view name = line_.name();
  if (name.empty() || is_not_computed(capitals(name)))
    return refuse(block, Cause::StatementFormat, "MCALL without the name of a program", at);
  return call(block, words, name);
}

/// Make the block a modal call, or the end of one.
bool BlockReader::write_modal_call(Block& block, const Words& words) {
  const bool alone = !words.any && words.statements.empty() && !words.print && !words.back;
  if (!alone)
    return refuse(block, Cause::IllegalWordWithCall, "MCALL must be alone in its block",
                  *words.modal);
  to_.words(block, {});
  if (!words.call) {
    block.op = Op::CancelModal;
    return true;
  }
  CallRecord call = *words.call;
  call.code_kind = CodeCallKind::Modal;
  to_.become(block, Op::ModalCall, std::move(call));
  return true;
}

/// Read SETAL(65000). The number of an alarm that the control's own programs raise has its text.
bool BlockReader::raise_alarm(Block& block, Words& words, std::uint32_t at) {
  line_.pass(5);
  Value number;
  if (!line_.take('(')) return refuse(block, Cause::BracketNotOpened, "( is missing", at);
  if (!expression_.value(number)) return refuse(block);
  if (number.computed || line_.peek() != ')')
    return not_computed(block, "SETAL with a computed number, or with a text", at);
  line_.take(')');
  const auto value = to_whole<std::int32_t>(std::clamp(std::round(number.number), 0.0, 99999.0));
  std::string text;
  for (const RaisedAlarm& of : to_.control().raised_alarms)
    if (of.number == value) text = of.text;
  Print print;
  print.alarms = true;
  print.number = std::to_string(value);
  print.at = at;
  print.fields.push_back({.text = text.empty() ? "raised by the program" : std::move(text)});
  words.print = std::move(print);
  return true;
}

}  // namespace cncsub::sinumerik
