#include "cncsub/machine/statements/output.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <utility>

#include "cncsub/control/g_codes.hpp"
#include "cncsub/machine/state/limits.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/values/expressions.hpp"
#include "cncsub/machine/values/texts.hpp"
#include "cncsub/machine/values/variables.hpp"
#include "cncsub/system/decimal.hpp"

namespace cncsub {

namespace {

constexpr double kShown = 1e-4;  // a value below is shown as 0 [rs274 2.9, DEBUG]

/// Return a value as DPRNT writes it: a sign or a blank, the whole digits with blanks for leading
/// zeros, the decimals. Some controls leave the blanks out.
std::string written(double value, const PrintField& field, bool without_blanks) {
  const double scale = std::pow(10.0, field.decimals);
  double units = std::round(std::fabs(value) * scale);
  units = std::fmod(units, std::pow(10.0, field.whole_digits + field.decimals));
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", field.decimals, units / scale);
  std::string digits = text;
  const std::size_t whole = std::min(digits.find('.'), digits.size());
  const bool negative = value < 0 && units != 0;
  if (without_blanks) return (negative ? "-" : "") + digits;
  const auto wanted = static_cast<std::size_t>(std::max(field.whole_digits, 1));
  const std::string blanks = whole < wanted ? std::string(wanted - whole, ' ') : "";
  return (negative ? "-" : " ") + blanks + digits;
}

}  // namespace

void say(Run& run, std::string text) {
  if (text.size() > kLongText) look_soon(run);
  run.trace.say(std::move(text));
  ++run.state.changes;
}

std::string comment_of(const Run& run, const Statement& statement) {
  return std::string(run.code->files[run.program().file].text.view().substr(statement.text,
                                                                            statement.text_length));
}

bool alarm_of_program(Run& run, const Statement& statement, const std::string& text,
                      const std::string& number) {
  run.block.words_done = true;
  alarm(run, {Cause::UserAlarm, statement.at, statement.width,
              text.empty() ? "raised by the program" : text});
  if (run.state.alarm) {
    run.state.alarm->number = number;
    run.state.alarm->text = text;
  }
  return false;
}

void tell_dropped(Run& run, const Block& block, const NcWords& words) {
  if (run.trace.depth == Trace::Depth::None) return;
  const auto tell = [&](std::string text) {
    text.erase(text.find_last_not_of(" \t\r") + 1);
    run.trace.text += text.size();
    run.trace.dropped.push({run.state.executed, run.state.pc, std::move(text)});
  };
  const Program& program =
      run.code->programs[static_cast<std::size_t>(run.code->program_at(run.state.pc))];
  const std::string_view text = run.code->files[program.file].text.view();
  if ((block.flags & Block::kDrops) != 0) {
    auto drop = std::lower_bound(run.code->drops.begin(), run.code->drops.end(), block.data,
                                 [](const Drop& d, std::uint32_t data) { return d.data < data; });
    for (; drop != run.code->drops.end() && drop->data == block.data; ++drop)
      tell(std::string(text.substr(drop->at, drop->width)));
  }
  for (const Drop& drop : run.block.left_out) tell(std::string(text.substr(drop.at, drop.width)));
  for (std::size_t i = 0; i < words.codes->g_count; ++i)
    if ((run.block.outcome.dropped_codes >> i & 1) != 0) tell(code_name(words.codes->g_codes[i]));
  for (std::uint32_t left = run.block.outcome.dropped & words.mask; left != 0; left &= left - 1) {
    const int place = std::countr_zero(left);
    char value[40];
    std::snprintf(value, sizeof value, "%.10g", words.value[static_cast<std::size_t>(place)]);
    const std::string address = run.code->spelling->address_of(place);
    tell(address + (address.size() > 1 ? "=" : "") + value);
  }
}

namespace {

/// Return a value without blanks; one that is vacant or has no room is crossed out.
std::string plainly(double value, int decimals) {
  constexpr int kRoom = 30;  // with the end of the text [rs274 2.9, DEBUG]
  std::array<char, kRoom> text{};
  const double shown = std::fabs(value) < kShown ? 0 : value;
  const int length = std::snprintf(text.data(), text.size(), "%.*f", decimals, shown);
  return is_vacant(value) || length >= kRoom ? "######" : text.data();
}

/// Return a value as a field of the line shows it.
std::string shown(const Run& run, const Print& print, const PrintField& field, double value) {
  if (field.whole_digits == PrintField::kPlain) return plainly(value, field.decimals);
  if (is_vacant(value)) value = 0;
  if (!print.binary)
    return written(value, field, !run.control().macros.prints_leading_blanks.value);
  return std::to_string(to_whole<std::int64_t>(
      std::clamp(std::round(value * std::pow(10.0, field.decimals)), -2147483648.0, 2147483647.0)));
}

/// Evaluate the number of an alarm that a program raises.
bool alarm_number(Run& run, const Print& print, double& number) {
  if (!evaluate(run, print.number, number)) return false;
  number = is_vacant(number) ? 0 : std::round(number);
  return (number >= print.first_number && number <= print.last_number) ||
         alarm(run, {Cause::IllegalUserAlarm, print.at, 0,
                     "a program may raise alarms " + std::to_string(print.first_number) + " to " +
                         std::to_string(print.last_number)});
}

bool is_shown(const Run& run, const Print& print) {
  double value = 1;
  if (print.shown_if != 0) read_variable(run, print.shown_if, run.state.level, value);
  return value > 0;
}

}  // namespace

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one case after the other
bool print(Run& run, const Print& print) {
  if (!is_shown(run, print)) return true;
  double number = 0;
  if (print.last_number > 0 && !alarm_number(run, print, number)) return false;
  std::string line(print.logs() ? print.command : "");  // the text of a log says that it is one
  std::size_t left = kLongText;
  for (const PrintField& field : print.fields) {
    if (--left == 0) {
      run.watch.in_block = line.size();
      if (breaks_off(run)) return false;
      left = kLongText;
    }
    if (!field.is_variable) {
      line += field.text;
      continue;
    }
    double value = 0;
    if (!evaluate(run, field.expression, value)) return false;
    if (run.observer != nullptr) run.observer->printed.push_back(value);
    line += field.is_text ? text_of(run, value) : shown(run, print, field, value);
  }
  if (run.observer != nullptr) run.observer->print = &print;
  run.watch.in_block = 0;
  if (print.last_number > 0) {
    Statement statement;
    statement.at = print.at;
    return alarm_of_program(run, statement, line, system::shortest(number));
  }
  if (print.alarms) {
    Fault fault{Cause::UserAlarm, print.at, 1, line};
    fault.text = std::move(line);
    alarm(run, fault);
    return false;
  }
  say(run, std::move(line));
  return true;
}

}  // namespace cncsub
