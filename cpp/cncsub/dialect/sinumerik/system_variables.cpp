// System variables, $AA_IW[X] and others, as far as a run knows what they hold.
#include <algorithm>
#include <charconv>
#include <iterator>

#include "cncsub/code/parameters.hpp"
#include "cncsub/control/edge_datum.hpp"
#include "cncsub/dialect/sinumerik/code_groups.hpp"
#include "cncsub/dialect/sinumerik/frames.hpp"
#include "cncsub/dialect/sinumerik/operands.hpp"
#include "cncsub/text/axis_names.hpp"

namespace cncsub::sinumerik {

namespace {

/// A system variable of one number among the variables of the control, or of several by an index.
struct SystemVariable {
  std::string_view name;
  VariableKind kind;
  enum class By : std::uint8_t { Nothing, Axis, Number, Place, Group } by;
  char address = 0;  // of an active word, or what tells variables of a kind apart
  // A part of the number that the control keeps: over `divisor`, and the rest of a hundred.
  double divisor = 0;
};
using By = SystemVariable::By;

// [NCI, actual_position.mpf; general knowledge of the SINUMERIK 840D]
constexpr SystemVariable kVariables[] = {{"AA_IW", VariableKind::WorkPosition, By::Axis},
                                         {"AA_IM", VariableKind::MachinePosition, By::Axis},
                                         {"P_EP", VariableKind::BlockEnd, By::Axis},
                                         {"AA_MW", VariableKind::MeasuredPosition, By::Axis},
                                         {"AA_MM", VariableKind::MeasuredMachine, By::Axis},
                                         {"AC_MEA", VariableKind::SkipTouched, By::Number},
                                         {"AC_MARKER", VariableKind::Kept, By::Place, 'M'},
                                         {"AC_PARAM", VariableKind::Kept, By::Place, 'P'},
                                         {"P_TOOLNO", VariableKind::ToolLength, By::Nothing, 'T'},
                                         {"P_TOOLP", VariableKind::ActiveWord, By::Nothing, 'T'},
                                         {"P_TOOL", VariableKind::ActiveWord, By::Nothing, 'D'},
                                         {"P_F", VariableKind::ActiveWord, By::Nothing, 'F'},
                                         {"P_S", VariableKind::ActiveWord, By::Nothing, 'S'},
                                         {"P_GG", VariableKind::ModalCode, By::Group},
                                         {"A_IN", VariableKind::Input, By::Number},
                                         {"A_OUT", VariableKind::Output, By::Number},
                                         {"A_MONTH", VariableKind::Date, By::Nothing, 0, 100},
                                         {"A_DAY", VariableKind::Date, By::Nothing, 0, 1},
                                         {"A_HOUR", VariableKind::Time, By::Nothing, 0, 10000},
                                         {"A_MINUTE", VariableKind::Time, By::Nothing, 0, 100},
                                         {"A_SECOND", VariableKind::Time, By::Nothing, 0, 1}};

/// Return the range of the control's variables that holds a system variable; null where it has
/// none.
const VariableRange* range_of(const OpenExpression& open, const SystemVariable& of) {
  for (const PlacedRange& placed : open.to.code().variables)
    if (placed.range.kind == of.kind && placed.range.address == of.address) return &placed.range;
  return nullptr;
}

/// Read the index of a system variable, and push its value.
bool push_indexed(OpenExpression& open, const SystemVariable& of, std::int32_t first,
                  std::uint32_t at, int depth) {
  if (!open.line.take('['))
    return open.wrong(Cause::BracketNotOpened, "[ is missing: the variable has an index", at);
  const Read read = read_value(open, depth + 1);
  if (!read) return false;
  const bool axis = *read == Type::Axis;
  if (axis != (of.by == By::Axis) || *read == Type::String || *read == Type::Frame)
    return open.wrong(Cause::TypeMismatch, axis ? "the index is a number" : "the index is an axis",
                      at);
  if (!open.line.take(']')) return open.wrong(Cause::BracketNotClosed, "] is missing", at);
  open.emit_at(at, Ins::VariableAt, first);
  return true;
}

/// The groups whose code in force a run knows. [NCI groups]
constexpr int kKnownGroups[] = {1, 6, 7, 8, 13, 14, 15, 18, 29};
constexpr int kFeedGroup = 15,
              kSurfaceGroup = 30;  // G96 is one of the feeds there, and no feed here

/// Read $P_GG[6], the place of the code in force among those of its group, and push it.
bool push_group(OpenExpression& open, std::int32_t first, std::uint32_t at) {
  if (!open.line.take('['))
    return open.wrong(Cause::BracketNotOpened, "[ is missing: the variable has an index", at);
  open.line.peek();
  const std::string number(open.line.take_digits());
  if (!open.line.take(']')) return open.wrong(Cause::BracketNotClosed, "] is missing", at);
  int group = 0;
  std::from_chars(number.data(), number.data() + number.size(), group);
  if (std::find(std::begin(kKnownGroups), std::end(kKnownGroups), group) == std::end(kKnownGroups))
    return open.wrong(Cause::CodeNotComputed, "a run does not know $P_GG[" + number + "]", at);
  std::vector<double> codes;
  for (const int code : codes_of_group(group)->codes)
    codes.push_back(code == kNoCode ? kVacant : code / 10.0);
  const auto list = static_cast<double>(open.to.names().list(std::move(codes)));
  const auto push = [&](int of) {
    open.emit_at(at, Ins::Variable, first + of - 1);
    open.emit(Ins::PlaceIn, list);
  };
  if (group == kFeedGroup) push(kSurfaceGroup);
  push(group);
  if (group == kFeedGroup) open.emit(Ins::FirstSet);
  return true;
}

/// Read $P_SUBPAR[2], whether the call gives the second parameter of the program, and push it. A
/// level keeps that beside the values of the parameters. [MD840, variables.svar: $P_SUBPAR]
bool push_given(OpenExpression& open, std::uint32_t at) {
  if (!open.line.take('['))
    return open.wrong(Cause::BracketNotOpened, "[ is missing: the variable has an index", at);
  open.line.peek();
  const std::string written(open.line.take_digits());
  const char next = open.line.peek();
  if (written.empty() || next != ']')
    return open.wrong(Cause::CodeNotComputed,
                      "cncsub does not compute $P_SUBPAR of a computed number: write the number",
                      at);
  open.line.take(']');
  std::uint32_t number = 0;
  std::from_chars(written.data(), written.data() + written.size(), number);
  const std::uint32_t parameters = open.to.code().programs.back().parameters;
  if (number < 1 || number > parameters)
    return open.wrong(Cause::CodeNotComputed,
                      "cncsub does not compute $P_SUBPAR[" + written + "] of a program with " +
                          std::to_string(parameters) + " parameters",
                      at);
  Definition given;
  given.local = open.to.names().hidden(std::string(kGivenParameters), kMostGivenParameters) +
                static_cast<std::int32_t>(number) - 1;
  open.to.expressions().emit(reading(given));
  return true;
}

/// Read $TC_DP3[5,1], whose name is passed.
Read read_element(OpenExpression& open, const SystemArray& of, int depth) {
  if (!read_system_array(open, of, depth + 1)) return std::nullopt;
  open.constant.reset();
  open.emit(Ins::Indirect);
  if (open.assigned.contains(kSystemArray)) {
    late(open, open.line.offset());
    return std::nullopt;
  }
  return of.shape.type;
}

/// System variables that a program may write by one index.
struct Written {
  std::string_view name;
  VariableKind kind;
  char address;
  Type type;
  std::int32_t from;  // the index of the first
};
// [general knowledge of the SINUMERIK 840D]
constexpr Written kWritten[] = {{"TC_TP2", VariableKind::ToolName, 0, Type::String, 0},
                                {"AC_MARKER", VariableKind::Kept, 'M', Type::Int, 0},
                                {"AC_PARAM", VariableKind::Kept, 'P', Type::Real, 0},
                                {"A_OUT", VariableKind::Output, 0, Type::Bool, 1}};

}  // namespace

std::optional<SystemArray> system_array_of(const Builder& to, std::string_view name) {
  const auto range_of = [&to](VariableKind kind, char address) -> const VariableRange* {
    for (const PlacedRange& placed : to.code().variables)
      if (placed.range.kind == kind && placed.range.address == address) return &placed.range;
    return nullptr;
  };
  SystemArray array;
  for (const Written& of : kWritten) {
    const VariableRange* const range = of.name == name ? range_of(of.kind, of.address) : nullptr;
    if (range == nullptr) continue;
    array.first = range->first - of.from;
    array.shape.type = of.type;
    array.shape.dimensions = 1;
    array.shape.extents = {range->last - array.first + 1};
    return array;
  }
  constexpr std::string_view kEdge = "TC_DP";
  const VariableRange* const edges = range_of(VariableKind::EdgeDatum, 0);
  std::int32_t datum = 0;
  const char* const last = name.data() + name.size();
  if (!name.starts_with(kEdge) || edges == nullptr) return std::nullopt;
  const auto read = std::from_chars(name.data() + kEdge.size(), last, datum);
  if (read.ec != std::errc() || read.ptr != last || datum < 1 || datum >= EdgeDatum::kData)
    return std::nullopt;
  array.first = edges->first + EdgeDatum{datum, 0, 0}.number();
  array.shape.dimensions = 2;
  array.shape.extents = {EdgeDatum::kTools, EdgeDatum::kEdges};
  return array;
}

bool read_system_array(OpenExpression& open, const SystemArray& of, int depth) {
  if (!read_indices(open, of.shape, depth)) return false;
  open.emit(Ins::AddConstant, of.first);
  return true;
}

std::vector<std::string_view> known_system_variables() {
  std::vector<std::string_view> names{"PI", "P_SUBPAR"};
  for (const SystemVariable& of : kVariables) names.push_back(of.name);
  return names;
}

namespace {

/// Return the name of a variable of the table; nothing where none has the kind of the range.
std::string name_in_table(const VariableRange& range, std::int32_t index) {
  for (const SystemVariable& of : kVariables) {
    if (of.kind != range.kind || of.address != range.address || of.by == By::Group) continue;
    std::string name = "$" + std::string(of.name);
    if (of.by == By::Axis) name += "[" + axis_letter(index + 1) + "]";
    if (of.by == By::Number) name += "[" + std::to_string(index + 1) + "]";
    if (of.by == By::Place) name += "[" + std::to_string(index) + "]";
    return name;
  }
  return "";
}

std::string name_in_range(const VariableRange& range, std::int32_t index) {
  if (range.kind == VariableKind::ToolName) return "$TC_TP2[" + std::to_string(index) + "]";
  if (range.kind == VariableKind::EdgeDatum) {
    const EdgeDatum of = EdgeDatum::of(index);
    return "$TC_DP" + std::to_string(of.datum) + "[" + std::to_string(of.tool) + "," +
           std::to_string(of.edge) + "]";
  }
  std::string frame = name_of_frame(range.kind, index);
  return frame.empty() ? name_in_table(range, index) : frame;
}

}  // namespace

std::string name_of_variable(const Control& control, std::int64_t number) {
  for (const VariableRange& range : control.variables) {
    if (number < range.first || number > range.last) continue;
    std::string name = name_in_range(range, static_cast<std::int32_t>(number - range.first));
    if (!name.empty()) return name;
  }
  return "";
}

namespace {

/// Push the value of a variable that has no index.
Read push_variable(OpenExpression& open, const SystemVariable& of, std::int32_t number,
                   std::uint32_t at) {
  open.emit_at(at, Ins::Variable, number);
  if (of.divisor == 0) return of.address == 'T' || of.address == 'D' ? Type::Int : Type::Real;
  open.emit(Ins::DivideConstant, of.divisor);
  open.emit(Ins::Fix);
  open.emit(Ins::Constant, 100);
  open.emit(Ins::Modulo);
  return Type::Int;
}

}  // namespace

Read read_system_variable(OpenExpression& open, int depth) {
  const std::uint32_t at = open.line.offset();
  open.line.pass(1);
  const std::string name = capitals(open.line.name());
  open.line.pass(name.size());
  if (name == "PI") {
    open.constant.reset();
    open.emit(Ins::Constant, 3.14159265358979323846);
    return Type::Real;
  }
  if (name == "P_SUBPAR") {
    open.constant.reset();
    if (!push_given(open, at)) return std::nullopt;
    return Type::Bool;
  }
  if (is_frame_variable(name)) return read_control_frame(open, name, at, depth);
  const auto array = system_array_of(open.to, name);
  if (array && array->shape.type != Type::String && array->shape.type != Type::Bool)
    return read_element(open, *array, depth);
  const auto* const of = std::find_if(std::begin(kVariables), std::end(kVariables),
                                      [&](const auto& known) { return known.name == name; });
  const VariableRange* const range = of == std::end(kVariables) ? nullptr : range_of(open, *of);
  if (range == nullptr) {
    if (open.line.peek() == '[') open.line.pass_brackets('[', ']');
    open.wrong(Cause::CodeNotComputed, "a run does not know $" + name, at);
    return std::nullopt;
  }
  open.constant.reset();
  if (of->by == By::Group) {
    if (!push_group(open, range->first, at)) return std::nullopt;
    return Type::Int;
  }
  if (of->by != By::Nothing) {
    if (!push_indexed(open, *of, range->first, at, depth)) return std::nullopt;
    open.constant.reset();
    const bool signal = of->kind == VariableKind::Input || of->kind == VariableKind::Output ||
                        of->kind == VariableKind::SkipTouched;
    return signal ? Type::Bool : Type::Real;
  }
  return push_variable(open, *of, range->first, at);
}

}  // namespace cncsub::sinumerik
