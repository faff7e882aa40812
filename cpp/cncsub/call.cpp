#include "cncsub/call.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace cncsub {

namespace {

constexpr std::int64_t kCountBase = 10000;  // the last four digits are the program

std::string spell(double value) {
  std::array<char, 40> text{};
  // Nought has no sign.
  const auto done = std::to_chars(text.data(), text.data() + text.size(), value + 0.0);
  return {text.data(), done.ptr};
}

Fault fault(Cause cause, const Operand& word, std::string detail) {
  return {cause, word.at, word.width, std::move(detail)};
}
Fault fault(Cause cause, const CallRecord& call, std::string detail) {
  return {cause, call.at, call.width, std::move(detail)};
}

/// "P[#100] is 21234": the word as written where it holds a variable; the message puts it in for
/// the braces.
std::string named(const Operand& word, const char* letter, double value) {
  return (word.kind == Operand::Kind::Expression ? "{} is " : std::string(letter) + " is ") +
         spell(value);
}

bool given(const Operand& operand, double value) { return operand.present() && !is_vacant(value); }

/// A whole number from a value: written numbers are whole, computed ones are cut or rounded as the
/// control does.
double whole(const Control& control, const Operand& operand, double value) {
  if (operand.kind != Operand::Kind::Expression) return value;
  return control.call_values.value == CallValues::Cut ? std::trunc(value) : std::round(value);
}

/// A count above the largest: one with more digits than that has, where the largest is 9999.
Cause above(double count, int most) {
  double end = 10;
  while (end <= most) end *= 10;
  return count >= end ? Cause::RepeatCountDigits : Cause::IllegalRepeatCount;
}

std::optional<Fault> repeats(const Control& control, const CallRecord& call, double value,
                             Target& target) {
  const double count = whole(control, call.l, value);
  const std::string says = named(call.l, "L", value);
  const int most = control.max_repeats.value;
  if (count < 0)
    return fault(Cause::IllegalRepeatCount, call.l,
                 says + "; the count is 1 to " + std::to_string(most));
  if (count == 0) {
    switch (control.zero_repeats.value) {
      case ZeroRepeats::Once:
        return std::nullopt;
      case ZeroRepeats::Skip:
        target.skipped = true;
        return std::nullopt;
      case ZeroRepeats::Alarm:
        return fault(Cause::IllegalRepeatCount, call.l,
                     says + "; the count is 1 to " + std::to_string(most));
    }
  }
  if (count > most) {
    if (control.too_many_repeats.value == TooManyRepeats::Alarm)
      return fault(above(count, most), call.l,
                   says + "; the count is 1 to " + std::to_string(most));
    target.repeats = most;
    return std::nullopt;
  }
  target.repeats = to_whole<std::int32_t>(count);
  return std::nullopt;
}

/// The number of a program in P. A call of a subprogram may hold a repeat count in it.
std::optional<Fault> program_number(const Control& control, const CallRecord& call, double value,
                                    bool count_in_l, Target& target) {
  const double number = whole(control, call.p, value);
  const std::string says = named(call.p, "P", value);
  const Cause illegal = call.macro ? Cause::IllegalMacroNumber : Cause::IllegalProgramNumber;
  if (number < 0) return fault(illegal, call.p, says);
  const int digits = call.macro ? control.max_macro_digits.value : control.max_program_digits.value;
  if (call.p.bracketed && control.bracket_names.value) {
    if (number >= kCountBase)
      return fault(illegal, call.p, says + "; a program number has at most 4 digits");
    target.program_number = to_whole<std::int64_t>(number);
    return std::nullopt;
  }
  if (number >= std::pow(10.0, digits) || call.p.digits > digits)
    return fault(call.macro ? illegal : Cause::TooManyDigits, call.p,
                 says + "; it has at most " + std::to_string(digits) + " digits");
  if (number == 0 && !control.zero_numbers.value)
    return fault(call.macro ? illegal : Cause::ProgramNumberZero, call.p,
                 says + "; programs are numbered from 1");
  const auto p = to_whole<std::int64_t>(number);
  target.program_number = p;
  if (call.macro || control.program_word.value != ProgramWord::CountAndNumber || p < kCountBase) {
    const bool zeros = !call.macro && control.program_word.value == ProgramWord::CountAndNumber &&
                       call.p.written > 4;
    if (zeros && count_in_l && control.count_and_l.value == CountAndL::Alarm)
      return fault(Cause::RepeatGivenTwice, call.l, "P gives a repeat count already");
    if (zeros && control.zero_count_alarms.value)
      return fault(Cause::IllegalRepeatCount, call.p, says + "; the repeat count in it is 0");
    return std::nullopt;
  }
  if (count_in_l) {
    switch (control.count_and_l.value) {
      case CountAndL::Alarm:
        return fault(Cause::RepeatGivenTwice, call.l, "P gives a repeat count already");
      case CountAndL::AllNumber:
        return std::nullopt;
      case CountAndL::NoL:
        break;
    }
  }
  target.program_number = p % kCountBase;
  const std::int64_t count = p / kCountBase;
  target.repeats =
      static_cast<std::int32_t>(std::min<std::int64_t>(count, control.max_repeats.value));
  if (count > control.max_repeats.value && control.too_many_repeats.value == TooManyRepeats::Alarm)
    return fault(above(static_cast<double>(count), control.max_repeats.value), call.p,
                 says + "; the count in it is above " + std::to_string(control.max_repeats.value));
  if (target.program_number == 0 && !control.zero_numbers.value)
    return fault(Cause::ProgramNumberZero, call.p, says + "; programs are numbered from 1");
  return std::nullopt;
}

}  // namespace

std::optional<Fault> decode_call(const Code& code, const CallRecord& call,
                                 const CallOperands& operands, std::int32_t own, Target& target) {
  const Control& control = *code.control;
  const bool by_code = call.program_number >= 0;
  target.external = call.kind == CallKind::M198;
  if (given(call.device, operands.device)) {
    if (operands.device < 0 || operands.device > 4)
      return fault(Cause::ValueOutOfRange, call.device, "the device is 0 to 4");
    target.external = target.external || operands.device > 0;
  }
  const bool l_counts = call.macro || control.program_word.value != ProgramWord::CountAndNumber ||
                        control.count_and_l.value != CountAndL::NoL || !call.name.empty();
  const bool count_in_l = l_counts && given(call.l, operands.l);
  if (count_in_l)
    if (auto wrong = repeats(control, call, operands.l, target)) return wrong;
  if (given(call.start, operands.start)) {
    const double n = whole(control, call.start, operands.start);
    if (n < 0 || n > control.max_sequence_number.value)
      return fault(Cause::IllegalSequenceNumber, call.start,
                   "the start block is " + spell(operands.start));
    target.start_n = to_whole<std::int32_t>(n);
  }
  if (by_code) {
    target.program_number = call.program_number;
    return std::nullopt;
  }
  if (!call.name.empty()) return std::nullopt;
  const bool local = call.kind == CallKind::M97;
  if (given(call.p, operands.p)) {
    if (local || (control.program_word.value == ProgramWord::SequenceNumber && !call.macro)) {
      const double n = whole(control, call.p, operands.p);
      if (n < 0) return fault(Cause::IllegalSequenceNumber, call.p, named(call.p, "P", operands.p));
      target.program = own;
      target.start_n = to_whole<std::int32_t>(std::min(n, 2e9));
      return std::nullopt;
    }
    return program_number(control, call, operands.p, count_in_l, target);
  }
  const bool start = target.start_n >= 0;
  if (!call.macro && !local) {
    switch (control.omitted_program.value) {
      case OmittedProgram::Alarm:
        break;
      case OmittedProgram::OwnFromStart:
        if (!start) break;
        target.program = own;
        return std::nullopt;
      case OmittedProgram::Own:
        target.program = own;
        return std::nullopt;
      case OmittedProgram::Jump:
        target.program = own;
        target.jump = true;
        return std::nullopt;
    }
  }
  return fault(Cause::ProgramNumberMissing, call, "the call does not say which program");
}

std::optional<Fault> find_target(const Code& code, const CallRecord& call, Target& target) {
  if (target.skipped) return std::nullopt;
  const bool external = target.external && code.external_device;
  const Operand& word = call.p.present() ? call.p : call.start;
  if (target.program == kNoProgram) {
    const bool by_name = !call.name.empty();
    target.program =
        by_name ? code.find(call.name, external) : code.find(target.program_number, external);
    if (target.program == kNoProgram) {
      const Cause cause = target.external ? Cause::ExternalProgramNotFound
                          : by_name       ? Cause::NamedProgramNotFound
                                          : Cause::ProgramNotFound;
      const std::string what =
          by_name ? "<" + call.name + ">" : "O" + std::to_string(target.program_number);
      const std::string where =
          external ? " is not on the external device" : " is not in the memory";
      if (by_name) return Fault{cause, call.name_at, call.name_width, what + where};
      if (call.p.present()) return fault(cause, call.p, what + where);
      return fault(cause, call, what + where);
    }
  }
  const Program& program = code.programs[static_cast<std::size_t>(target.program)];
  if (target.start_n < 0) {
    target.start = program.first;
    return std::nullopt;
  }
  target.start = code.first_of(program, target.start_n);
  if (target.start == kNowhere)
    return fault(Cause::StartNotFound, call.start.present() ? call.start : word,
                 "there is no N" + std::to_string(target.start_n) + " in " + code.name_of(program));
  return std::nullopt;
}

}  // namespace cncsub
