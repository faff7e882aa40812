// Gives values to variables of any kind; some of them raise an alarm or show a message.
#include <algorithm>
#include <cmath>
#include <string>

#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/statements/output.hpp"
#include "cncsub/machine/statements/statements.hpp"
#include "cncsub/machine/values/expressions.hpp"
#include "cncsub/machine/values/variables.hpp"

namespace cncsub {

namespace {

/// Raise the alarm of #3000 = n (TEXT). It is what the block does, so that the block is a step.
bool user_alarm(Run& run, double n, const Statement& statement) {
  const Control& control = run.control();
  const double number = std::round(n);
  const int last = control.macros.user_alarm_last.value;
  if (number < 0 || number > last)
    return alarm(run, {Cause::IllegalUserAlarm, statement.at, statement.width,
                       "a program may raise alarms 0 to " + std::to_string(last)});
  const std::string text = comment_of(run, statement);
  const int own = control.macros.user_alarm_numbers.value;
  const auto counted = own > 0 && number > own ? 0 : to_whole<std::int64_t>(number);
  std::string shown = std::to_string(control.macros.user_alarm_offset.value + counted);
  while (static_cast<int>(shown.size()) < control.user_alarm_digits) shown.insert(0, "0");
  return alarm_of_program(run, statement, text,
                          control.user_alarm_number.empty() ? control.user_alarm_prefix + shown
                                                            : control.user_alarm_number);
}

/// Refuse an assignment to a variable of a program that was left. Return false.
bool is_gone(Run& run, const Statement& statement) {
  return alarm(run, {Cause::CodeNotComputed, statement.variable_at, statement.variable_width,
                     "the program whose variable this is was left"});
}

}  // namespace

std::int64_t number_of_variable(double value) {
  return is_vacant(value) ? 0 : to_whole<std::int64_t>(std::clamp(rounded(value), -1e9, 2e9));
}

std::optional<Reference> variable_of(const Run& run, const Statement& statement) {
  using In = Reference::In;
  const State& s = run.state;
  switch (statement.target) {
    case Statement::Target::Local:
      return Reference{In::Locals, run.local_at(s.level, statement.index)};
    case Statement::Target::Common:
      return Reference{In::Commons, static_cast<std::size_t>(statement.index)};
    case Statement::Target::Referenced: {
      const double of = s.locals[run.local_at(s.level, statement.index)];
      if (!is_vacant(of)) return Reference::of(of);
      return Reference{In::Locals, run.local_at(s.level, statement.number)};
    }
    default:
      return std::nullopt;
  }
}

ArrayElements elements_of(const Run& run, const Statement& statement, double place) {
  using In = Reference::In;
  const auto from = to_whole<std::size_t>(place);  // the indices are inside their extents
  const auto first = static_cast<std::size_t>(statement.index) + from;
  const std::int32_t left = statement.number - static_cast<std::int32_t>(from);
  if (statement.target == Statement::Target::CommonElement) return {{In::Commons, first}, left};
  if (statement.target == Statement::Target::Element)
    return {{In::Elements, run.element_at(first)}, left};
  const double* const of = run.state.locals.data() + run.local_at(run.state.level, statement.index);
  if (is_vacant(of[0])) return {};
  const std::size_t at = from + static_cast<std::size_t>(statement.number);
  return {Reference::of(of[0]).behind(at),
          to_whole<std::int32_t>(of[1]) - static_cast<std::int32_t>(at)};
}

// NOLINTNEXTLINE(readability-function-size): one target after the other
bool store(Run& run, const Statement& statement, double value) {
  State& s = run.state;
  if (std::fabs(value) > kLargest)  // a vacant value compares false
    return alarm(run, {Cause::Overflow, statement.at, statement.width, "the result is too large"});
  const auto put = [&](double& place) {
    if (!(place == value)) ++s.changes;
    place = value;
  };
  switch (statement.target) {
    case Statement::Target::Local:
      put(s.locals[run.local_at(s.level, statement.index)]);
      if (!s.programmed.empty()) s.programmed[run.local_at(s.level, statement.index)] = 0;
      return true;
    case Statement::Target::Common:
      put(s.commons[static_cast<std::size_t>(statement.index)]);
      return true;
    case Statement::Target::Variable:
      return store_number(run, statement.index, value, statement);
    case Statement::Target::Indirect: {
      double number = 0;
      if (!evaluate(run, statement.variable, number)) return false;
      return store_number(run, number_of_variable(number), value, statement);
    }
    case Statement::Target::Referenced: {
      const auto variable = variable_of(run, statement);
      double* const cell = variable ? s.cell(*variable) : nullptr;
      if (cell != nullptr) put(*cell);
      return cell != nullptr || is_gone(run, statement);
    }
    case Statement::Target::Element:
    case Statement::Target::CommonElement:
    case Statement::Target::ReferencedElement: {
      double place = 0;
      return evaluate(run, statement.variable, place) &&
             store_elements(run, statement, place, value);
    }
    case Statement::Target::VariableAt: {
      double index = 0;
      return evaluate(run, statement.variable, index) &&
             store_number(run, statement.index + to_whole<std::int64_t>(index), value, statement);
    }
    case Statement::Target::None:
      break;
  }
  return true;
}

bool store_elements(Run& run, const Statement& statement, double place, double value) {
  if (std::fabs(value) > kLargest)
    return alarm(run, {Cause::Overflow, statement.at, statement.width, "the result is too large"});
  const auto [first, left] = elements_of(run, statement, place);
  const std::int32_t count = statement.count == 0 ? left : statement.count;
  if (left < count)
    return alarm(run, {Cause::ArrayElement, statement.variable_at, statement.variable_width,
                       "the array ends before the last value"});
  if (count <= 0) return true;
  const double* const last = run.state.cell(first.behind(static_cast<std::size_t>(count) - 1));
  if (last == nullptr) return is_gone(run, statement);
  std::fill_n(run.state.cell(first), count, value);
  ++run.state.changes;
  return true;
}

bool store_number(Run& run, std::int64_t number, double value, const Statement& statement) {
  const VariablePlace place = run.code->place(number);
  if (run.observer != nullptr && !place.is_local() && !place.is_common())
    run.observer->assigned.push_back({number, value, comment_of(run, statement)});
  if (place.range != nullptr && place.kind == VariableKind::UserAlarm)
    return user_alarm(run, is_vacant(value) ? 0 : value, statement);
  if (place.range != nullptr && place.kind == VariableKind::Message) {
    say(run, comment_of(run, statement));
    return wait_for_operator(run, run.code->spelling->name_of_variable(*run.code->control, number));
  }
  if (auto fault = write_variable(run, number, value)) {
    fault->at = statement.variable_at;
    fault->width = statement.variable_width;
    return alarm(run, *fault);
  }
  ++run.state.changes;
  return true;
}

}  // namespace cncsub
