// The parts of expressions, each read into the open expression by a function. Each returns the type
// of the value, or nothing: the fault of the open expression says why.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/dialect/sinumerik/expression.hpp"
#include "cncsub/text/axis_names.hpp"

namespace cncsub::sinumerik {

using Read = std::optional<Type>;

constexpr int kDeepest = 100;                // nested values
constexpr std::int32_t kLastNumber = 99999;  // of a parameter, more than any control has

/// Read operands and the operators between them.
Read read_value(OpenExpression& open, int depth);
/// Read a value with its signs, which bind closest.
Read read_operand(OpenExpression& open, int depth);
/// Read 10, 10.5, .5, or 1.5EX3 for 1500, which is no part of an expression yet.
Read take_number(OpenExpression& open, double& number);
Read read_number(OpenExpression& open);
Read read_bracket(OpenExpression& open, char before, char after, int depth);
/// Read SIN(30), or a constant: TRUE.
Read read_function(OpenExpression& open, std::string_view name, int depth);
/// Read $AA_IW[X], after its $.
Read read_system_variable(OpenExpression& open, int depth);
/// Return the names of the system variables that a run knows, without their $.
std::vector<std::string_view> known_system_variables();
/// Read the indices of an array, in their brackets, as the place of one element.
bool read_indices(OpenExpression& open, const Definition& of, int depth);
/// Read the indices of a system variable, as its number.
bool read_system_array(OpenExpression& open, const SystemArray& of, int depth);
/// Return the place of a parameter R; one that does not exist is a fault.
bool parameter_number(OpenExpression& open, std::string_view digits, std::uint32_t at,
                      VariablePlace& place, std::int32_t& number);

/// Return the name of a system variable by its number among those of the control, $TC_DP3[5,1];
/// empty where the number is that of an R parameter.
std::string name_of_variable(const Control& control, std::int64_t number);

/// Append the conversion of the last value to the type of a variable.
bool convert(OpenExpression& open, Type from, const Definition& to, std::uint32_t at);
/// Append the conversion of the last value, of any type, to a text.
void convert_to_text(OpenExpression& open, Type from);
WrittenAs written_as(Type type);
/// Push a text that stands as it is.
void push_text(OpenExpression& open, const std::string& text);

/// Return whether values of a type are numbers, or can be taken for them.
inline bool is_number(Type type) {
  return type != Type::String && type != Type::Axis && type != Type::Frame;
}
/// Return why a value of a type is no number.
inline const char* no_number(Type type) {
  return type == Type::Axis    ? "an axis is no number"
         : type == Type::Frame ? "a frame is no number"
                               : "a text is no number";
}
/// Return the instruction that reads a variable which is no array.
inline Instruction reading(const Definition& of) {
  const auto local = static_cast<std::uint32_t>(of.local);
  if (of.reference >= 0)
    return {Ins::Referenced, 0, static_cast<std::uint32_t>(of.reference), of.local + 0.0};
  return {of.global ? Ins::Common : Ins::Local, 0, local, 0};
}

/// Return the mark of a variable among what a block has assigned to.
inline std::int32_t mark_of(const Definition& of) {
  constexpr std::int32_t kGlobal = 1 << 29, kArray = 1 << 28;
  return -1 - of.local - (of.global ? kGlobal : of.is_array() ? kArray : 0);
}
constexpr std::int32_t kSystemArray = -2147483647;  // the mark of system variables
/// Write that the block has assigned to what is read here.
bool late(OpenExpression& open, std::uint32_t at);

}  // namespace cncsub::sinumerik
