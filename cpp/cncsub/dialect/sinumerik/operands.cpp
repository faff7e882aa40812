#include "cncsub/dialect/sinumerik/operands.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "cncsub/code/foreign_text.hpp"
#include "cncsub/control/variable_table.hpp"
#include "cncsub/dialect/sinumerik/frames.hpp"
#include "cncsub/dialect/sinumerik/keywords.hpp"
#include "cncsub/system/decimal.hpp"

namespace cncsub::sinumerik {

namespace {

Read fails(bool /*said*/) { return std::nullopt; }

/// Read the sign that stands here, NOT or B_NOT, and its operand.
Read read_signed(OpenExpression& open, char sign, std::string_view name, int depth) {
  const std::uint32_t at = open.line.offset();
  open.line.pass(name.empty() ? 1 : name.size());
  const Read of = read_operand(open, depth + 1);
  if (!of) return of;
  if (!is_number(*of)) return fails(open.wrong(Cause::TypeMismatch, no_number(*of), at));
  if (sign == '+') return of;
  if (open.constant && sign == '-') open.constant = -*open.constant;
  if (sign != '-') open.constant.reset();
  open.emit_at(at, sign == '-' ? Ins::Negate : name == "NOT" ? Ins::Not : Ins::BitNot);
  return sign == '-' ? of : name == "NOT" ? Type::Bool : Type::Int;
}

/// Read "TEXT".
Read read_text(OpenExpression& open) {
  const std::uint32_t at = open.line.offset();
  std::string text;
  open.line.pass(1);
  if (!open.line.take_up_to('"', text))
    return fails(open.wrong(Cause::StatementFormat, "the quote is not closed", at));
  push_text(open, text);
  return Type::String;
}

/// Read 'HFF' or 'B101', a number to the base 16 or 2. [840Df p.64, constants]
Read read_based_number(OpenExpression& open) {
  const std::uint32_t at = open.line.offset();
  std::string digits;
  open.line.pass(1);
  const bool closed = open.line.take_up_to('\'', digits);
  const char base = digits.empty() ? '\0' : upper(digits[0]);
  std::uint32_t number = 0;
  const char* const first = digits.data() + std::min<std::size_t>(1, digits.size());
  const char* const last = digits.data() + digits.size();
  const auto read = std::from_chars(first, last, number, base == 'H' ? 16 : 2);
  if (!closed || (base != 'H' && base != 'B') || read.ec != std::errc() || read.ptr != last)
    return fails(open.wrong(Cause::ExpressionFormat, "this is not a number: 'HFF', 'B101'", at));
  open.push_constant(static_cast<double>(static_cast<std::int32_t>(number)));
  return Type::Int;
}

Read read_parameter(OpenExpression& open, int depth) {
  const std::uint32_t at = open.line.offset();
  open.line.pass(1);
  open.constant.reset();
  if (open.line.ahead(0) == '[') {
    if (!read_bracket(open, '[', ']', depth + 1)) return std::nullopt;
    open.constant.reset();
    open.emit_at(at, Ins::Indirect);
    if (open.assigned_any || !open.assigned.empty()) return fails(late(open, at));
    return Type::Real;
  }
  VariablePlace place;
  std::int32_t number = 0;
  if (!parameter_number(open, open.line.take_digits(), at, place, number)) return std::nullopt;
  open.to.expressions().emit(
      {Ins::Common, 0, static_cast<std::uint32_t>(place.index), static_cast<double>(number)});
  if (open.assigned_any || open.assigned.contains(number)) return fails(late(open, at));
  return Type::Real;
}

/// Read the character of a text that stands at an index.
Read read_character(OpenExpression& open, int depth) {
  const std::uint32_t at = open.line.offset();
  if (!read_bracket(open, '[', ']', depth + 1)) return std::nullopt;
  open.constant.reset();
  open.emit_at(at, Ins::CharacterAt);
  return Type::Char;
}

Read read_variable(OpenExpression& open, const Definition& of, std::string_view name, int depth) {
  const std::uint32_t at = open.line.offset();
  open.line.pass(name.size());
  if (of.constant) return open.push_constant(*of.constant), Type::Real;
  if (of.is_array()) {
    if (!read_indices(open, of, depth + 1)) return std::nullopt;
    if (of.reference >= 0)
      open.emit_at(at, Ins::ReferencedElement, of.reference);
    else
      open.emit_at(at, of.global ? Ins::CommonElement : Ins::Element, of.local);
  } else {
    open.to.expressions().emit(reading(of));
  }
  open.constant.reset();
  if (open.assigned.contains(mark_of(of))) return fails(late(open, at));
  if (of.type == Type::String && open.line.peek() == '[') return read_character(open, depth);
  if (of.type == Type::Frame) return read_frame_part(open, depth);
  return of.type;
}

/// Read the letter of an axis.
Read read_axis(OpenExpression& open) {
  open.push_constant(axis_value(open.line.peek()));
  open.line.pass(1);
  return Type::Axis;
}

Read read_name(OpenExpression& open, const std::string& name, int depth) {
  if (const Definition* const of = open.definitions.find(name)) {
    if (of->macro) return fails(open.not_computed("the macro " + name, open.line.offset()));
    return read_variable(open, *of, name, depth);
  }
  if (name[0] == 'R' && (name.size() == 1 ? open.line.ahead(1) == '[' : is_digit(name[1])))
    return read_parameter(open, depth);
  if (name.size() == 1 && axis_value(name[0]) > 0) return read_axis(open);
  if (name == "NO_AXIS") {
    open.line.pass(name.size());
    open.push_constant(0);
    return Type::Axis;
  }
  return read_function(open, name, depth);
}

}  // namespace

Read read_operand(OpenExpression& open, int depth) {
  const std::uint32_t at = open.line.offset();
  if (depth > kDeepest)
    return fails(open.wrong(Cause::BracketsTooDeep,
                            "more brackets inside each other than cncsub reads", at));
  const char c = open.line.peek();
  const std::string name = capitals(open.line.name());
  if (c == '-' || c == '+' || name == "NOT" || name == "B_NOT")
    return read_signed(open, c, name, depth);
  if (c == '(') return read_bracket(open, '(', ')', depth + 1);
  if (is_digit(c) || c == '.') return read_number(open);
  if (c == '\0') return fails(open.wrong(Cause::ExpressionFormat, "a value is missing", at));
  if (c == '$') return read_system_variable(open, depth);
  if (c == '"') return read_text(open);
  if (c == '\'') return read_based_number(open);
  if (c == '<' && open.line.ahead(1) == '<') {  // <<R1 is ""<<R1
    open.push_constant(0);
    return Type::String;
  }
  if (name.empty())
    return fails(open.wrong(Cause::ExpressionFormat, "a value cannot begin like this", at));
  return read_name(open, name, depth);
}

Read read_bracket(OpenExpression& open, char before, char after, int depth) {
  const std::uint32_t at = open.line.offset();
  if (!open.line.take(before))
    return fails(open.wrong(Cause::BracketNotOpened, std::string(1, before) + " is missing", at));
  const Read read = read_value(open, depth);
  if (read && before == '[' && !is_number(*read))
    return fails(open.wrong(Cause::TypeMismatch, "an index is a number", at));
  if (!read || open.line.take(after)) return read;
  return fails(open.wrong(Cause::BracketNotClosed, std::string(1, after) + " is missing", at));
}

namespace {

/// Read a number of so few digits that a quotient of two whole numbers is its nearest double. Take
/// nothing where more stands here.
Read take_short_number(Line& line, double& number) {
  constexpr std::ptrdiff_t kMost = 15;
  const std::string_view here = line.rest();
  if (here.empty() || (!is_digit(here[0]) && here[0] != '.')) return std::nullopt;
  const char* at = here.data();
  const Mantissa read = scan_mantissa(at);
  const std::ptrdiff_t digits = read.whole + read.decimals;
  const auto width = static_cast<std::size_t>(at - here.data());
  if (digits == 0 || digits > kMost || width > here.size()) return std::nullopt;
  if (width < here.size() && upper(*at) == 'E') return std::nullopt;  // 5EX3
  number = static_cast<double>(read.value) / kPowersOfTen[read.decimals];
  line.pass(width);
  return read.point ? Type::Real : Type::Int;
}

}  // namespace

Read take_number(OpenExpression& open, double& number) {
  Line& line = open.line;
  const std::uint32_t at = line.offset();
  if (const Read type = take_short_number(line, number)) return type;
  const std::string text = line.take_number();
  if (text.empty()) return fails(open.wrong(Cause::AddressWithoutValue, "a number is missing", at));
  const auto read = system::parse(text, number);
  if (!read.number || read.length != text.size() || number > kLargest)
    return fails(open.wrong(Cause::ValueOutOfRange, "this is not a number", at));
  return text.find_first_of(".e") == std::string::npos ? Type::Int : Type::Real;
}

Read read_number(OpenExpression& open) {
  double number = 0;
  const Read read = take_number(open, number);
  if (read) open.push_constant(number);
  return read;
}

namespace {

/// Push an extent of an array that is a parameter.
void push_extent(OpenExpression& open, const Definition& of, std::size_t dimension) {
  const auto first = static_cast<std::uint32_t>(of.reference) + 2;
  open.to.expressions().emit({Ins::Local, 0, first + static_cast<std::uint32_t>(dimension), 0});
}

void check_index(OpenExpression& open, const Definition& of, std::size_t dimension,
                 std::uint32_t at) {
  if (of.reference < 0)
    return open.to.expressions().emit(
        {Ins::Index, 0, at, static_cast<double>(of.extents[dimension])});
  push_extent(open, of, dimension);
  open.to.expressions().emit({Ins::IndexBelow, 0, at, 0});
}

void multiply_by_extent(OpenExpression& open, const Definition& of, std::size_t dimension) {
  if (of.reference < 0) return open.emit(Ins::MultiplyConstant, of.extents[dimension]);
  push_extent(open, of, dimension);
  open.emit(Ins::Multiply);
}

}  // namespace

bool read_indices(OpenExpression& open, const Definition& of, int depth) {
  const std::uint32_t at = open.line.offset();
  if (!open.line.take('['))
    return open.wrong(Cause::BracketNotOpened, "[ is missing: the variable is an array", at);
  for (std::size_t i = 0; i < of.dimensions; ++i) {
    if (i > 0 && !open.line.take(','))
      return open.wrong(Cause::MissingComma, "an index is missing", at);
    const std::uint32_t index_at = open.line.offset();
    const Read read = read_value(open, depth);
    if (!read) return false;
    if (!is_number(*read)) return open.wrong(Cause::TypeMismatch, "an index is a number", at);
    check_index(open, of, i, index_at);
    if (i > 0) open.emit(Ins::Add);
    if (i + 1 < of.dimensions) multiply_by_extent(open, of, i + 1);
  }
  if (of.type == Type::Frame && open.line.peek() == ',')
    return open.not_computed("a part of an element of an array of frames", at);
  return open.line.take(']') || open.wrong(Cause::BracketNotClosed, "] is missing", at);
}

bool parameter_number(OpenExpression& open, std::string_view digits, std::uint32_t at,
                      VariablePlace& place, std::int32_t& number) {
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (read.ec == std::errc() && number <= kLastNumber) place = open.to.code().place(number);
  if (place.is_common()) return true;
  if (read.ec != std::errc())
    return open.wrong(Cause::IllegalVariable, "there is no R" + std::string(digits), at);
  return open.wrong(Cause::IllegalVariable, no_variable(open.to.control(), "R", number), at);
}

bool late(OpenExpression& open, std::uint32_t at) {
  return open.wrong(Cause::CodeNotComputed,
                    "a variable that its own block assigns is not computed here", at);
}

// ---- conversions ----

WrittenAs written_as(Type type) {
  switch (type) {
    case Type::String:
      return WrittenAs::Text;
    case Type::Bool:
      return WrittenAs::Truth;
    case Type::Char:
      return WrittenAs::Character;
    case Type::Axis:
      return WrittenAs::Axis;
    default:
      return WrittenAs::Number;
  }
}

void convert_to_text(OpenExpression& open, Type from) {
  if (from == Type::String) return;
  open.constant.reset();
  open.emit(Ins::TextOf, static_cast<int>(written_as(from)));
}

void push_text(OpenExpression& open, const std::string& text) {
  Names& names = open.to.names();
  const bool foreign = open.stands_alone && !open.to.code().texts.find(text);
  if (!foreign) return open.push_constant(names.constant_text(text));
  open.emit(Ins::Constant, names.text(text));
  open.emit(Ins::TextOf, kForeignText);
  open.constant.reset();
}

namespace {

/// Cut a text at the length of its variable.
void cut_text(OpenExpression& open, std::int32_t length) {
  const auto& texts = open.to.code().texts;
  if (open.constant) {
    const std::string text = texts.at(to_whole<std::size_t>(*open.constant));
    const std::size_t cut = bytes_of_first(text, static_cast<std::size_t>(length));
    open.constant = open.to.names().constant_text(text.substr(0, cut));
    return;
  }
  open.emit(Ins::Constant, length);
  open.emit(Ins::TextUpTo);
}

/// Convert a text to a character or a truth: an empty one is FALSE. [840Da p.45, conversions]
bool convert_text(OpenExpression& open, const Definition& to, std::uint32_t at) {
  if (to.type == Type::Char) {
    if (open.constant) {
      const std::string& text = open.to.code().texts.at(to_whole<std::size_t>(*open.constant));
      if (text.empty() || bytes_of_first(text, 1) != text.size())
        return open.wrong(Cause::ValueOutOfRange, "a CHAR is one character", at);
      if (text.size() == 1)
        open.constant = static_cast<unsigned char>(text[0]);
      else
        open.constant.reset();  // its code is known when it runs
    }
    open.emit(Ins::OnlyCharacter);
    return true;
  }
  if (to.type != Type::Bool)
    return open.wrong(Cause::TypeMismatch, "a text is no number: NUMBER makes one of it", at);
  if (open.constant) open.constant = *open.constant != 0 ? 1 : 0;
  open.emit(Ins::Constant, 0);
  open.emit(Ins::NotEqual);
  return true;
}

bool in_range(OpenExpression& open, double first, double last, const char* why, std::uint32_t at) {
  if (!open.constant) return true;
  open.constant = std::round(*open.constant);
  return (*open.constant >= first && *open.constant <= last) ||
         open.wrong(Cause::ValueOutOfRange, why, at);
}

}  // namespace

/// A fraction of a half and more is rounded up; what is not 0 is TRUE. [840Da p.45, conversions]
bool convert(OpenExpression& open, Type from, const Definition& to, std::uint32_t at) {
  if ((from == Type::Axis) != (to.type == Type::Axis))
    return open.wrong(Cause::TypeMismatch, "an axis is given to an AXIS only", at);
  if ((from == Type::Frame) != (to.type == Type::Frame))
    return open.wrong(Cause::TypeMismatch, "a frame is given to a FRAME only", at);
  if (from == Type::String && to.type != Type::String) return convert_text(open, to, at);
  switch (to.type) {
    case Type::Bool:
      if (open.constant) open.constant = *open.constant != 0 ? 1 : 0;
      open.emit(Ins::Constant, 0);
      open.emit(Ins::NotEqual);
      return true;
    case Type::Int:
      if (!in_range(open, -2147483648.0, 2147483647.0, "an INT has 32 bits", at)) return false;
      open.emit(Ins::Integer);
      return true;
    case Type::Char:
      if (!in_range(open, 0, 255, "a CHAR is 0 to 255", at)) return false;
      open.emit(Ins::Character);
      return true;
    case Type::String:
      if (from == Type::Int || from == Type::Real)
        return open.wrong(Cause::TypeMismatch, "a number is no text: << makes one of it", at);
      convert_to_text(open, from);
      cut_text(open, to.length);
      return true;
    default:
      return true;
  }
}

}  // namespace cncsub::sinumerik
