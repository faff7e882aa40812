// DPRNT and BPRNT, and the G65 H statements of the GSK controls.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>

#include "cncsub/machine.hpp"
#include "cncsub/motion_codes.hpp"

namespace cncsub {

namespace {

/// A value as DPRNT writes it: a sign or a blank, the whole digits with blanks for leading zeros,
/// the decimals. With 6001#1 = 1 the blanks are left out.
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

double angle_of(double degrees) { return degrees * 3.14159265358979323846 / 180.0; }

}  // namespace

/// What the block said and the control did not obey: what was known when the block was read, then
/// G codes, then addresses.
void Machine::tell_dropped(const Block& block, const NcWords& words) {
  if (trace_.depth == Trace::Depth::None) return;
  const auto tell = [&](std::string text) {
    text.erase(text.find_last_not_of(" \t\r") + 1);
    trace_.text += text.size();
    trace_.dropped.push({executed_, pc_, std::move(text)});
  };
  const Program& program = code_->programs[static_cast<std::size_t>(code_->program_at(pc_))];
  const std::string& text = code_->files[program.file].text;
  if ((block.flags & Block::kDrops) != 0) {
    auto drop = std::lower_bound(code_->drops.begin(), code_->drops.end(), block.data,
                                 [](const Drop& d, std::uint32_t data) { return d.data < data; });
    for (; drop != code_->drops.end() && drop->data == block.data; ++drop)
      tell(text.substr(drop->at, drop->width));
  }
  for (int i = 0; i < words.g_count; ++i)
    if ((outcome_.dropped_codes >> i & 1) != 0)
      tell(code_name(words.g[static_cast<std::size_t>(i)]));
  for (std::uint32_t left = outcome_.dropped & words.mask; left != 0; left &= left - 1) {
    const int place = std::countr_zero(left);
    char word[40];
    std::snprintf(word, sizeof word, "%c%.10g", static_cast<char>('A' + place),
                  words.value[static_cast<std::size_t>(place)]);
    tell(word);
  }
}

bool Machine::print(const Print& print) {
  const bool without_blanks = code_->control->parameter("6001#1") != 0;
  std::string line;
  std::size_t left = kLongText;
  for (const PrintField& field : print.fields) {
    if (--left == 0) {
      in_block_ = line.size();
      if (breaks_off()) return false;
      left = kLongText;
    }
    if (!field.is_variable) {
      line += field.text;
      continue;
    }
    double value = 0;
    if (!evaluate(field.expression, value)) return false;
    if (is_vacant(value)) value = 0;
    if (print.binary)
      line += std::to_string(to_whole<std::int64_t>(std::clamp(
          std::round(value * std::pow(10.0, field.decimals)), -2147483648.0, 2147483647.0)));
    else
      line += written(value, field, without_blanks);
  }
  in_block_ = 0;
  say(std::move(line));
  return true;
}

/// The variable that P of a G65 H statement names: `P#100` is #100 itself.
bool Machine::h_variable(const Operand& operand, std::int64_t& number) {
  if (operand.kind != Operand::Kind::Expression) return false;
  const Instruction* at = code_->instructions.data() + code_->expressions[operand.expression].first;
  switch (at->op) {
    case Ins::LocalRaw:
    case Ins::CommonRaw:
    case Ins::VariableRaw:
    case Ins::Local:
    case Ins::Common:
    case Ins::Variable:
      number = to_whole<std::int64_t>(at->value);
      break;
    case Ins::Constant:
      number = 0;
      break;
    default:
      return false;
  }
  if (at[1].op == Ins::IndirectRaw) {  // #9100
    double index = 0;
    if (read(number, index).has_value()) return false;
    number =
        to_whole<std::int64_t>(std::clamp(is_vacant(index) ? 0.0 : std::round(index), 0.0, 1e9));
  }
  return true;
}

bool Machine::h_code(const Statement& h) {
  const auto wrong = [&](Cause cause, const Operand& word, const char* detail) {
    return alarm({cause, word.present() ? word.at : h.at, word.width, detail});
  };
  double q = 0, r = 0;
  if (!operand(h.q, q) || !operand(h.r, r)) return false;
  if (h.q.present() && is_vacant(q) && h.number != 1) q = 0;
  if (h.r.present() && is_vacant(r)) r = 0;
  const int code = h.number;
  if (code == 99) return h_alarm(h);
  if (code >= 80 && code <= 86) {
    if (!h.p.present()) return wrong(Cause::HCodeFormat, h.p, "the jump has no P");
    if (code > 80 && (!h.q.present() || !h.r.present()))
      return wrong(Cause::HCodeOperand, h.q, "the comparison takes Q and R");
    const bool holds = code == 80 || (code == 81 && q == r) || (code == 82 && q != r) ||
                       (code == 83 && q > r) || (code == 84 && q < r) || (code == 85 && q >= r) ||
                       (code == 86 && q <= r);
    if (!holds) return true;
    double n = 0;
    if (!operand(h.p, n)) return false;
    return h_jump(h,
                  is_vacant(n) ? -1 : to_whole<std::int64_t>(std::clamp(std::round(n), -1.0, 2e9)));
  }
  const bool two = (code >= 2 && code <= 5) || (code >= 11 && code <= 13) || code == 23 ||
                   code == 26 || code == 27 || (code >= 31 && code <= 34);
  const bool one = code == 1 || code == 21 || code == 22 || code == 24 || code == 25;
  if (!one && !two)
    return alarm({Cause::IllegalHCode, h.variable_at, h.variable_width, "there is no such H code"});
  std::int64_t target = 0;
  if (!h.p.present() || !h_variable(h.p, target))
    return wrong(Cause::HCodeFormat, h.p, "P names the variable that takes the result");
  if (!h.q.present() || (two && !h.r.present()))
    return wrong(Cause::HCodeOperand, h.q, "an operand is missing");
  double result = 0;
  if (auto cause = h_result(code, q, r, target, result)) return wrong(*cause, h.q, "");
  if (!(std::fabs(result) <= kLargest))
    return wrong(Cause::Overflow, h.q, "the result is too large");
  Statement assign = h;
  assign.target = Statement::Target::Variable;
  assign.variable_at = h.p.at;
  assign.variable_width = h.p.width;
  return store_number(target, result, assign);
}

std::optional<Cause> Machine::h_result(int code, double q, double r, std::int64_t target,
                                       double& result) {
  const auto bits = [](double value) {
    return to_whole<std::int64_t>(std::clamp(std::round(value), -4294967295.0, 4294967295.0));
  };
  switch (code) {
    case 1:
      result = q;
      break;
    case 2:
      result = q + r;
      break;
    case 3:
      result = q - r;
      break;
    case 4:
      result = q * r;
      break;
    case 5:
      if (r == 0) return Cause::DivisionByZero;
      result = q / r;
      break;
    case 11:
    case 12:
    case 13:
      if (!code_->control->negative_logic.value && (q < 0 || r < 0)) return Cause::LogicOfNegative;
      if (code_->control->logic_of_bits.value && ((bits(q) | bits(r)) & ~1) != 0)
        return Cause::LogicOfBits;
      result = static_cast<double>(code == 11   ? bits(q) | bits(r)
                                   : code == 12 ? bits(q) & bits(r)
                                                : bits(q) ^ bits(r));
      break;
    case 21:
      if (q < 0) return Cause::SquareRootOfNegative;
      result = std::sqrt(q);
      break;
    case 22:
      result = std::fabs(q);
      break;
    case 23:
      if (r == 0) return Cause::DivisionByZero;
      result = q - std::trunc(q / r) * r;
      break;
    case 24:
    case 25:
      if (!read_digits(q, code == 24 ? 16 : 10, code == 24 ? 10 : 16, result))
        return Cause::ArgumentOutOfRange;
      break;
    case 26: {
      double old = 0;
      if (r == 0) return Cause::DivisionByZero;
      if (auto fault = read(target, old)) return fault->cause;
      result = (is_vacant(old) ? 0 : old) * q / r;
      break;
    }
    case 27:
      result = std::hypot(q, r);
      break;
    case 31:
      result = q * std::sin(angle_of(r));
      break;
    case 32:
      result = q * std::cos(angle_of(r));
      break;
    case 33:
      if (std::fabs(std::fmod(std::fabs(r), 180.0) - 90.0) < 1e-9) return Cause::TangentInfinite;
      result = q * std::tan(angle_of(r));
      break;
    case 34: {
      if (q == 0 && r == 0) return Cause::DivisionByZero;
      double angle = std::atan2(q, r) / angle_of(1);
      if (code_->control->atan_range.value == AngleRange::FullTurn && angle < 0) angle += 360;
      result = angle;
      break;
    }
    default:
      return Cause::IllegalHCode;
  }
  return std::nullopt;
}

bool Machine::h_jump(const Statement& statement, std::int64_t n) {
  if (!may_jump(statement)) return false;
  const Program& program = code_->programs[static_cast<std::size_t>(frame().program)];
  const Address to = n < 0 ? kNowhere : code_->jump_target(program, n, pc_);
  if (to == kNowhere)
    return alarm({Cause::JumpTargetNotFound, statement.p.at, statement.p.width,
                  "there is no N" + std::to_string(n) + " in " + code_->name_of(program)});
  return jump_to(to);
}

/// G65 H99 P15 (TEXT).
bool Machine::h_alarm(const Statement& h) {
  double n = 0;
  if (!operand(h.p, n)) return false;
  const Control& control = *code_->control;
  const double number = is_vacant(n) ? -1 : std::round(n);
  if (number < 0 || number > 99)
    return alarm({Cause::IllegalUserAlarm, h.p.present() ? h.p.at : h.at, h.p.width,
                  "H99 raises alarms 0 to 99"});
  const Program& program = code_->programs[static_cast<std::size_t>(frame().program)];
  std::string text = code_->files[program.file].text.substr(h.text, h.text_length);
  if (!text.empty() && text[0] == '/') text.erase(0, 1);
  words_done_ = true;
  alarm({Cause::UserAlarm, h.at, h.width, text.empty() ? "raised by the program" : text});
  if (!alarm_) return false;
  alarm_->number = std::to_string(control.h99_offset.value + to_whole<int>(number));
  alarm_->text = text;
  return false;
}

}  // namespace cncsub
