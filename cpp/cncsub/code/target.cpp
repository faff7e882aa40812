#include "cncsub/code/target.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "cncsub/system/decimal.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

constexpr std::int64_t kCountBase = 10000;  // the last four digits are the program

std::string spell(double value) {
  return system::shortest(value + 0.0);  // nought has no sign
}

Fault fault(Cause cause, const Operand& word, std::string detail) {
  return {cause, word.at, word.width, std::move(detail)};
}
Fault fault(Cause cause, const CallRecord& call, std::string detail) {
  return {cause, call.at, call.width, std::move(detail)};
}

/// Return a text as "P[#100] is 21234". Where the word holds a variable, the message puts it in for
/// the braces as written.
std::string named(const Operand& word, const char* letter, double value) {
  return (word.kind == Operand::Kind::Expression ? "{} is " : std::string(letter) + " is ") +
         spell(value);
}

bool given(const Operand& operand, double value) { return operand.present() && !is_vacant(value); }

/// Return the cause of a count above the largest; one with more digits has a cause of its own.
Cause above(double count, int most) {
  double end = 10;
  while (end <= most) end *= 10;
  return count >= end ? Cause::RepeatCountDigits : Cause::IllegalRepeatCount;
}

/// The words of a call, each read into what it says of the target.
class CallWords {
 public:
  CallWords(const Control& control, const CallRecord& call, const CallOperands& values,
            Target& target)
      : control_(control), call_(call), values_(values), target_(target) {}

  std::optional<Fault> device();
  std::optional<Fault> count();
  std::optional<Fault> start();
  /// `own`: the program that calls.
  std::optional<Fault> program(std::int32_t own);

 private:
  double whole(const Operand& operand, double value) const;
  bool counts_in_l() const;
  std::optional<Fault> block_in_p(std::int32_t own);
  std::optional<Fault> number_in_p();
  std::optional<Fault> count_in_p(std::int64_t p);
  std::optional<Fault> left_out(std::int32_t own);
  Fault wrong_p(Cause cause, const std::string& detail = {}) const {
    return fault(cause, call_.p, named(call_.p, "P", values_.p) + detail);
  }

  const Control& control_;
  const CallRecord& call_;
  const CallOperands& values_;
  Target& target_;
};

/// Return a whole number from a value: written numbers are whole, computed ones are cut or rounded
/// as the control does.
double CallWords::whole(const Operand& operand, double value) const {
  if (operand.kind != Operand::Kind::Expression) return value;
  return control_.calls.call_values.value == CallValues::Cut ? std::trunc(value)
                                                             : std::round(value);
}

std::optional<Fault> CallWords::device() {
  if (!given(call_.device(), values_.device)) return std::nullopt;
  if (values_.device < 0 || values_.device > 4)
    return fault(Cause::ValueOutOfRange, call_.device(), "the device must be 0 to 4");
  target_.external = target_.external || values_.device > 0;
  return std::nullopt;
}

bool CallWords::counts_in_l() const {
  const bool l_counts = call_.macro ||
                        control_.calls.program_word.value != ProgramWord::CountAndNumber ||
                        control_.calls.count_and_l.value != CountAndL::NoL || !call_.name().empty();
  return l_counts && given(call_.l, values_.l);
}

std::optional<Fault> CallWords::count() {
  if (!counts_in_l()) return std::nullopt;
  const double count = whole(call_.l, values_.l);
  const int most = control_.calls.max_repeats.value;
  const char address[] = {call_.extras.get().count, '\0'};
  const auto illegal = [&](Cause cause) {
    return fault(
        cause, call_.l,
        named(call_.l, address, values_.l) + "; the count must be 1 to " + std::to_string(most));
  };
  if (count < 0) return illegal(Cause::IllegalRepeatCount);
  if (count == 0) {
    const ZeroRepeats zero = control_.calls.zero_repeats.value;
    if (zero == ZeroRepeats::Alarm) return illegal(Cause::IllegalRepeatCount);
    target_.skipped = zero == ZeroRepeats::Skip;
    return std::nullopt;
  }
  if (count > most && control_.calls.too_many_repeats.value == TooManyRepeats::Alarm)
    return illegal(above(count, most));
  target_.repeats = count > most ? most : to_whole<std::int32_t>(count);
  return std::nullopt;
}

std::optional<Fault> CallWords::start() {
  if (!given(call_.start(), values_.start)) return std::nullopt;
  const double n = whole(call_.start(), values_.start);
  if (n < 0 || n > control_.reading.max_sequence_number.value)
    return fault(Cause::IllegalSequenceNumber, call_.start(),
                 "the start block is " + spell(values_.start));
  target_.start_n = to_whole<std::int32_t>(n);
  return std::nullopt;
}

std::optional<Fault> CallWords::program(std::int32_t own) {
  if (call_.program_number >= 0) {
    target_.program_number = call_.program_number;
    return std::nullopt;
  }
  if (!call_.name().empty() || call_.name_text().present()) return std::nullopt;
  if (!given(call_.p, values_.p)) return left_out(own);
  const bool names_block =
      call_.kind == CallKind::Local ||
      (control_.calls.program_word.value == ProgramWord::SequenceNumber && !call_.macro);
  return names_block ? block_in_p(own) : number_in_p();
}

/// Take P as a block of the program that calls.
std::optional<Fault> CallWords::block_in_p(std::int32_t own) {
  const double n = whole(call_.p, values_.p);
  if (n < 0) return wrong_p(Cause::IllegalSequenceNumber);
  target_.program = own;
  target_.start_n = to_whole<std::int32_t>(std::min(n, 2e9));
  return std::nullopt;
}

/// Take P as the number of a program. That of a subprogram may hold a repeat count too.
std::optional<Fault> CallWords::number_in_p() {
  const bool macro = call_.macro;
  const double number = whole(call_.p, values_.p);
  const Cause illegal = macro ? Cause::IllegalMacroNumber : Cause::IllegalProgramNumber;
  if (number < 0) return wrong_p(illegal);
  if (call_.p.bracketed && control_.calls.bracket_names.value) {
    if (number >= kCountBase) return wrong_p(illegal, "; a program number has at most 4 digits");
    target_.program_number = to_whole<std::int64_t>(number);
    return std::nullopt;
  }
  const int digits =
      macro ? control_.macros.max_macro_digits.value : control_.calls.max_program_digits.value;
  const bool exact = digits >= 0 && digits < static_cast<int>(std::size(kPowersOfTen));
  const double behind = exact ? kPowersOfTen[digits] : std::pow(10.0, digits);
  if (number >= behind || call_.p.digits > digits)
    return wrong_p(macro ? illegal : Cause::TooManyDigits,
                   "; it has at most " + std::to_string(digits) + " digits");
  if (number == 0 && control_.common.refuses.value.has(Cause::ProgramNumberZero))
    return wrong_p(macro ? illegal : Cause::ProgramNumberZero, "; program numbers start at 1");
  target_.program_number = to_whole<std::int64_t>(number);
  if (macro || control_.calls.program_word.value != ProgramWord::CountAndNumber)
    return std::nullopt;
  return count_in_p(target_.program_number);
}

/// Take what stands before the last four digits of P30002 as a count.
std::optional<Fault> CallWords::count_in_p(std::int64_t p) {
  const std::int64_t count = p / kCountBase;
  if (count == 0 && call_.p.written <= 4) return std::nullopt;
  const bool in_l = counts_in_l();
  if (in_l && control_.calls.count_and_l.value == CountAndL::Alarm)
    return fault(Cause::RepeatGivenTwice, call_.l, "P already gives a repeat count");
  if (count == 0) {
    if (control_.common.refuses.value.has(Cause::IllegalRepeatCount))
      return wrong_p(Cause::IllegalRepeatCount, "; the repeat count in it is 0");
    return std::nullopt;
  }
  if (in_l && control_.calls.count_and_l.value == CountAndL::AllNumber) return std::nullopt;
  target_.program_number = p % kCountBase;
  const int most = control_.calls.max_repeats.value;
  target_.repeats = static_cast<std::int32_t>(std::min<std::int64_t>(count, most));
  if (count > most && control_.calls.too_many_repeats.value == TooManyRepeats::Alarm)
    return wrong_p(above(static_cast<double>(count), most),
                   "; the count in it is above " + std::to_string(most));
  if (target_.program_number == 0 && control_.common.refuses.value.has(Cause::ProgramNumberZero))
    return wrong_p(Cause::ProgramNumberZero, "; program numbers start at 1");
  return std::nullopt;
}

/// Take the program that a call means that names none, or refuse the call.
std::optional<Fault> CallWords::left_out(std::int32_t own) {
  const OmittedProgram rule = control_.calls.omitted_program.value;
  const bool outside = call_.kind == CallKind::External;
  const bool refused = call_.macro || call_.kind == CallKind::Local || outside ||
                       rule == OmittedProgram::Alarm ||
                       (rule == OmittedProgram::OwnFromStart && target_.start_n < 0);
  if (refused) {
    Fault wrong = fault(Cause::ProgramNumberMissing, call_, "the call does not say which program");
    if (outside) wrong.kind = {'E', 'X'};
    return wrong;
  }
  target_.program = own;
  target_.jump = rule == OmittedProgram::Jump;
  return std::nullopt;
}

Fault not_found(const Code& code, const CallRecord& call, const Target& target) {
  const bool named = !call.name().empty();
  const Cause cause = target.external ? Cause::ExternalProgramNotFound
                      : named         ? Cause::NamedProgramNotFound
                                      : Cause::ProgramNotFound;
  const std::string what =
      (named ? named_program(code, call.name()) : "O" + std::to_string(target.program_number)) +
      (!target.external       ? " is not in the memory"
       : code.external_device ? " is not on the external device"
                              : " is not in the memory, and there is no external device") +
      (named && !target.external ? told_elsewhere(code, call.name()) : "");
  if (named) return {cause, call.extras.get().name_at, call.extras.get().name_width, what};
  return call.p.present() ? fault(cause, call.p, what) : fault(cause, call, what);
}

}  // namespace

std::optional<Fault> decode_call(const Code& code, const CallRecord& call,
                                 const CallOperands& operands, std::int32_t own, Target& target) {
  target.external = call.kind == CallKind::External;
  CallWords words(*code.control, call, operands, target);
  if (auto wrong = words.device()) return wrong;
  if (auto wrong = words.count()) return wrong;
  if (auto wrong = words.start()) return wrong;
  return words.program(own);
}

const CallChoice* chosen(const Code& code, const CallRecord& call, const SearchFrom& from) {
  const CallExtras& named = call.extras.get();
  if (named.choices.empty()) return nullptr;
  const std::int32_t program = find_called(code, named.name, named.path, from);
  for (const CallChoice& of : named.choices)
    if (of.program == program) return &of;
  return nullptr;
}

std::optional<Fault> find_target(const Code& code, const CallRecord& call, Target& target,
                                 const SearchFrom& from) {
  if (target.skipped) return std::nullopt;
  if (target.program == kNoProgram) {
    const bool external = target.external && code.external_device;
    if (call.name().empty())
      target.program = code.find(target.program_number, external);
    else if (external)
      target.program = code.find(call.name(), external);
    else
      target.program = find_called(code, call.name(), call.extras.get().path, from);
    if (target.program == kNoProgram) return not_found(code, call, target);
  }
  const Program& program = code.programs[static_cast<std::size_t>(target.program)];
  if (target.start_n < 0) {
    target.start = program.first;
    return std::nullopt;
  }
  target.start = code.first_of(program, target.start_n);
  if (target.start == kNowhere)
    return fault(Cause::StartNotFound,
                 call.start().present() || !call.p.present() ? call.start() : call.p,
                 code.no_block(target.start_n, program));
  return std::nullopt;
}

}  // namespace cncsub
