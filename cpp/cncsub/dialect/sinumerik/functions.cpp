// The functions of expressions.
#include <algorithm>
#include <array>
#include <iterator>

#include "cncsub/dialect/sinumerik/frames.hpp"
#include "cncsub/dialect/sinumerik/keywords.hpp"
#include "cncsub/dialect/sinumerik/operands.hpp"

namespace cncsub::sinumerik {

namespace {

/// A function, the types of its values (N: a number, T: a text, C: a character, A: an axis), and
/// the instruction that is written after the last of them.
struct Function {
  std::string_view name, values;
  Ins op;
  Type type;
};
// [828Dj p.70, MINVAL, MAXVAL and BOUND; 840slj p.84, ROUNDUP; 828Dj p.74, string operations; what
// the others compute is general knowledge]
constexpr Function kFunctions[] = {{"SIN", "N", Ins::Sin, Type::Real},
                                   {"COS", "N", Ins::Cos, Type::Real},
                                   {"TAN", "N", Ins::TangentOf, Type::Real},
                                   {"ASIN", "N", Ins::ArcSineOf, Type::Real},
                                   {"ACOS", "N", Ins::ArcCosineOf, Type::Real},
                                   {"ATAN2", "NN", Ins::ArcTangentOf, Type::Real},
                                   {"SQRT", "N", Ins::Sqrt, Type::Real},
                                   {"ABS", "N", Ins::Abs, Type::Real},
                                   {"TRUNC", "N", Ins::Fix, Type::Real},
                                   {"ROUND", "N", Ins::Round, Type::Real},
                                   {"ROUNDUP", "N", Ins::Ceil, Type::Real},
                                   {"LN", "N", Ins::Ln, Type::Real},
                                   {"EXP", "N", Ins::Exp, Type::Real},
                                   {"POT", "N", Ins::Raise, Type::Real},
                                   {"MINVAL", "NN", Ins::Smaller, Type::Real},
                                   {"MAXVAL", "NN", Ins::Larger, Type::Real},
                                   {"BOUND", "NNN", Ins::Smaller, Type::Real},
                                   {"STRLEN", "T", Ins::TextLength, Type::Int},
                                   {"TOUPPER", "T", Ins::UpperText, Type::String},
                                   {"TOLOWER", "T", Ins::LowerText, Type::String},
                                   {"NUMBER", "T", Ins::NumberInText, Type::Real},
                                   {"ISNUMBER", "T", Ins::IsNumberText, Type::Bool},
                                   {"INDEX", "TC", Ins::FirstPlace, Type::Int},
                                   {"RINDEX", "TC", Ins::LastPlace, Type::Int},
                                   {"MINDEX", "TT", Ins::FirstPlaceOfAny, Type::Int},
                                   {"MATCH", "TT", Ins::FindText, Type::Int},
                                   {"AXSTRING", "A", Ins::TextOf, Type::String}};

Read fails(bool /*said*/) { return std::nullopt; }

/// Read a value of a function, and convert it to the type that the function takes.
bool read_argument(OpenExpression& open, char type, int depth) {
  const std::uint32_t at = open.line.offset();
  const Read read = read_value(open, depth + 1);
  if (!read) return false;
  open.constant.reset();
  const bool number = is_number(*read);
  if (type == 'C' && *read == Type::String) return open.emit_at(at, Ins::OnlyCharacter), true;
  if (type == 'T' && *read == Type::Char) return convert_to_text(open, *read), true;
  const bool fits = type == 'T'   ? *read == Type::String
                    : type == 'A' ? *read == Type::Axis
                                  : number;
  const char* const what = type == 'T'   ? "the function takes a text"
                           : type == 'A' ? "the function takes an axis"
                                         : "the function takes a number";
  return fits || open.wrong(Cause::TypeMismatch, what, at);
}

bool take_comma(OpenExpression& open, std::uint32_t at) {
  return open.line.take(',') || open.wrong(Cause::MissingComma, "another value is missing", at);
}

bool take_close(OpenExpression& open) {
  return open.line.take(')') ||
         open.wrong(Cause::BracketNotClosed, ") is missing", open.line.offset());
}

Read read_values(OpenExpression& open, const Function& of, std::uint32_t at, int depth) {
  for (std::size_t i = 0; i < of.values.size(); ++i) {
    if (i > 0 && !take_comma(open, at)) return std::nullopt;
    if (!read_argument(open, of.values[i], depth)) return std::nullopt;
  }
  if (!take_close(open)) return std::nullopt;
  if (of.op == Ins::Raise) open.emit_at(at, Ins::Constant, 2);  // POT: the square
  open.emit_at(at, of.op, of.op == Ins::TextOf ? static_cast<int>(WrittenAs::Axis) : 0);
  if (of.values.size() == 3) open.emit_at(at, Ins::Larger);  // BOUND: no less than the first
  return of.type;
}

/// Read AXNAME(TEXT), the axis of a name; a name that no axis has is NO_AXIS.
Read read_axis_name(OpenExpression& open, int depth) {
  const auto push = [&](const char* text) {
    push_text(open, text);
    open.constant.reset();  // the value is not this text alone
  };
  push(" X Y Z A B C U V W ");
  push(" ");
  if (!read_argument(open, 'T', depth) || !take_close(open)) return std::nullopt;
  open.emit(Ins::JoinTexts, 0);
  push(" ");
  open.emit(Ins::JoinTexts, 0);
  open.emit(Ins::UpperText);
  open.emit(Ins::FindText);
  open.emit(Ins::DivideConstant, 2);
  open.emit(Ins::Floor);
  open.emit(Ins::AddConstant, 1);
  return Type::Axis;
}

/// Read SUBSTR(TEXT, from), or SUBSTR(TEXT, from, count).
Read read_part(OpenExpression& open, std::uint32_t at, int depth) {
  if (!read_argument(open, 'T', depth) || !take_comma(open, at) || !read_argument(open, 'N', depth))
    return std::nullopt;
  open.emit_at(at, Ins::TextFrom);
  if (open.line.take(',')) {
    if (!read_argument(open, 'N', depth)) return std::nullopt;
    open.emit_at(at, Ins::TextUpTo);
  }
  return take_close(open) ? Read(Type::String) : std::nullopt;
}

/// Read the format of one value: %10.3F. Return nothing where there is none.
std::optional<TextFormat> format_at(std::string_view text, std::size_t& at) {
  TextFormat format;
  const auto number = [&](std::int32_t& of) {
    for (of = 0; at < text.size() && is_digit(text[at]) && of <= TextFormat::kMost; ++at)
      of = of * 10 + (text[at] - '0');
    return of <= TextFormat::kMost;
  };
  ++at;
  if (at < text.size() && is_digit(text[at]) && !number(format.width)) return std::nullopt;
  if (at < text.size() && text[at] == '.') {
    ++at;
    if (!number(format.decimals)) return std::nullopt;
  }
  format.kind = at < text.size() ? upper(text[at]) : '\0';
  ++at;
  const bool known = std::string_view("BCDFEGSX").find(format.kind) != std::string_view::npos;
  return known ? std::optional(format) : std::nullopt;
}

bool is_kind_for(char kind, Type type) {
  if (kind == 'S') return type == Type::String || type == Type::Char || type == Type::Bool;
  if (kind == 'B') return type != Type::Frame;
  return is_number(type);
}

/// Read the next value of SPRINT and write it as its format says.
bool read_formatted(OpenExpression& open, TextFormat format, std::uint32_t at, int depth) {
  if (!take_comma(open, at)) return false;
  const std::uint32_t value_at = open.line.offset();
  const Read read = read_value(open, depth + 1);
  if (!read) return false;
  open.constant.reset();
  if (!is_kind_for(format.kind, *read))
    return open.wrong(Cause::TypeMismatch, "the format is not one of this value", at);
  if (format.kind == 'S') convert_to_text(open, *read);
  open.emit_at(value_at, Ins::FormatText, format.packed());
  return true;
}

/// Read SPRINT("DEPTH %.2F", R1). [840Dg p.94, formatting of strings]
Read read_format(OpenExpression& open, std::uint32_t at, int depth) {
  constexpr int kTexts = 0;  // of JoinTexts: both are texts
  std::string format;
  if (open.line.peek() != '"' || (open.line.pass(1), !open.line.take_up_to('"', format)))
    return fails(open.not_computed("SPRINT without a text as it stands", at));
  const auto push = [&](std::string_view text) { push_text(open, std::string(text)); };
  push("");
  for (std::size_t from = 0; from < format.size();) {
    const std::size_t plain = std::min(format.find('%', from), format.size());
    std::size_t next = plain;
    if (plain > from) {
      push(std::string_view(format).substr(from, plain - from));
    } else if (format.substr(from, 2) == "%%") {
      push("%");
      next = from + 2;
    } else {
      const auto of = format_at(format, next);
      if (!of) return fails(open.not_computed("this format of SPRINT", at));
      if (!read_formatted(open, *of, at, depth)) return std::nullopt;
    }
    open.emit_at(at, Ins::JoinTexts, kTexts);
    open.constant.reset();
    from = next;
  }
  return take_close(open) ? Read(Type::String) : std::nullopt;
}

Read read_constant(OpenExpression& open, double value) {
  open.push_constant(value);
  return Type::Bool;
}

}  // namespace

Read read_function(OpenExpression& open, std::string_view name, int depth) {
  if (is_frame_function(name)) return read_frame_function(open, name, depth);
  const std::uint32_t at = open.line.offset();
  open.line.pass(name.size());
  if (name == "TRUE" || name == "FALSE") return read_constant(open, name == "TRUE" ? 1 : 0);
  const auto* const of = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                      [name](const Function& known) { return known.name == name; });
  const bool known = of != std::end(kFunctions);
  if (!known && name != "SUBSTR" && name != "SPRINT" && name != "AXNAME") {
    if (is_not_computed(name)) return fails(open.not_computed(name, at));
    if (name.size() > 1 && is_keyword(name))
      return fails(open.wrong(Cause::ExpressionFormat,
                              std::string(name) + " is a word of the language, and no value", at));
    return fails(open.wrong(
        Cause::CodeNotComputed,
        std::string(name) + " is not defined in this program, nor in a file of definitions", at));
  }
  if (!open.line.take('(')) return fails(open.wrong(Cause::BracketNotOpened, "( is missing", at));
  if (!known) {
    open.constant.reset();
    if (name == "AXNAME") return read_axis_name(open, depth);
    return name == "SUBSTR" ? read_part(open, at, depth) : read_format(open, at, depth);
  }
  return read_values(open, *of, at, depth);
}

}  // namespace cncsub::sinumerik
