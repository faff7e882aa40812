#include "cncsub/trace/trace.hpp"

#include <algorithm>
#include <utility>

namespace cncsub {

std::size_t Trace::call_row(std::int32_t number) const {
  if (number >= first_call) return carried.size() + static_cast<std::size_t>(number - first_call);
  const auto found = std::lower_bound(carried.begin(), carried.end(), number);
  return static_cast<std::size_t>(found - carried.begin());
}

std::size_t Trace::ended_call(std::size_t index) const {
  for (const std::size_t row : unfinished) {
    if (row > index) break;
    ++index;
  }
  return index;
}

/// Return the step of a move. Moves hold the last 32 bits of their step; a move that was held back
/// may be of an earlier part.
std::int64_t Trace::step_of_move(std::uint32_t step) const {
  constexpr std::uint32_t kBack = 1 << 20;
  const std::uint32_t ahead = step - static_cast<std::uint32_t>(first_step) + kBack;
  return first_step + static_cast<std::int64_t>(ahead) - kBack;
}

const Trace::Step* Trace::find_step(std::int64_t number) const {
  const std::int64_t row = number - first_step;
  if (row >= 0)
    return row < static_cast<std::int64_t>(steps.size()) ? &steps[static_cast<std::size_t>(row)]
                                                         : nullptr;
  const auto found = std::find_if(held.begin(), held.end(),
                                  [&](const HeldStep& step) { return step.number == number; });
  return found == held.end() ? nullptr : &found->step;
}

std::size_t Trace::bytes() const {
  return steps.bytes() + calls.bytes() + arguments.bytes() + moves.bytes() + codes.bytes() +
         messages.bytes() + dropped.bytes() + text + missed_skips.bytes() + changes.bytes() +
         compared.bytes();
}

void Trace::say(std::string message) {
  text += message.size();
  messages.push(std::move(message));
}

void Trace::keep_messages(std::size_t count) {
  for (std::size_t i = count; i < messages.size(); ++i) text -= messages[i].size();
  messages.keep(count);
}

Trace::Mark Trace::mark() const {
  return {.steps = steps.size(),
          .calls = calls.size(),
          .arguments = arguments.size(),
          .codes = codes.size(),
          .messages = messages.size(),
          .missed_skips = missed_skips.size(),
          .dropped = dropped.size(),
          .changes = changes.size(),
          .compared = compared.size(),
          .moves = moves.mark(),
          .watched = watched};
}

void Trace::rewind(const Mark& mark) {
  steps.keep(mark.steps);
  calls.keep(mark.calls);
  arguments.keep(mark.arguments);
  codes.keep(mark.codes);
  keep_messages(mark.messages);
  missed_skips.keep(mark.missed_skips);
  dropped.keep(mark.dropped);
  changes.keep(mark.changes);
  compared.keep(mark.compared);
  moves.rewind(mark.moves);
  watched = mark.watched;
}

Trace Trace::take(const Open& open) {
  Trace rest;
  rest.depth = depth;
  rest.first_step = open.next_step;
  rest.first_move = first_move + static_cast<std::int64_t>(moves.size());
  rest.first_call = call_number(calls.size());
  rest.moves = moves.next_part();
  rest.watched = watched;
  for (Watched& variable : rest.watched) variable.before = variable.now;
  for (const std::uint32_t bits : open.held) {
    const std::int64_t number = step_of_move(bits);
    if (const Step* const step = find_step(number)) rest.held.push_back({number, *step});
  }
  for (const std::int32_t number : open.calls) {
    const std::size_t row = call_row(number);
    CallRow call = calls[row];
    const std::uint32_t first = call.first_argument;
    call.first_argument = static_cast<std::uint32_t>(rest.arguments.size());
    for (std::uint32_t i = 0; i < call.arguments; ++i) rest.arguments.push(arguments[first + i]);
    rest.calls.push(call);
    rest.carried.push_back(number);
    if (!open.last) unfinished.push_back(row);
  }
  return std::exchange(*this, std::move(rest));
}

}  // namespace cncsub
