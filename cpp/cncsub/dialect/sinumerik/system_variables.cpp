// System variables, $AA_IW[X] and others, as far as a run knows what they hold.
#include <algorithm>
#include <charconv>
#include <iterator>

#include "cncsub/control/edge_datum.hpp"
#include "cncsub/dialect/sinumerik/frames.hpp"
#include "cncsub/dialect/sinumerik/operands.hpp"
#include "cncsub/text/axis_names.hpp"

namespace cncsub::sinumerik {

namespace {

/// A system variable of one number among the variables of the control, or of several by an index.
struct SystemVariable {
  std::string_view name;
  VariableKind kind;
  enum class By : std::uint8_t { Nothing, Axis, Number, Group } by;
  char address = 0;  // of an active word
  // A part of the number that the control keeps: over `divisor`, and the rest of a hundred.
  double divisor = 0;
};
using By = SystemVariable::By;

// [NCI, actual_position.mpf; general knowledge of the SINUMERIK 840D]
constexpr SystemVariable kVariables[] = {{"AA_IW", VariableKind::WorkPosition, By::Axis},
                                         {"AA_IM", VariableKind::MachinePosition, By::Axis},
                                         {"P_EP", VariableKind::BlockEnd, By::Axis},
                                         {"P_TOOLNO", VariableKind::ActiveWord, By::Nothing, 'T'},
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

/// A G group whose number is not that of the group on other controls.
struct GGroup {
  std::string_view number;
  int modal;  // among the groups of ModalCode
  int first;  // the code before the first one of the group
};
// The plane; G40 to G42; G90 and G91. [NCI groups]
constexpr GGroup kGroups[] = {{"6", 2, 16}, {"7", 7, 39}, {"14", 3, 89}};

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

/// Read $P_GG[6], the place of the code in force among those of its group, and push it.
bool push_group(OpenExpression& open, std::int32_t first, std::uint32_t at) {
  if (!open.line.take('['))
    return open.wrong(Cause::BracketNotOpened, "[ is missing: the variable has an index", at);
  open.line.peek();
  const std::string number(open.line.take_digits());
  if (!open.line.take(']')) return open.wrong(Cause::BracketNotClosed, "] is missing", at);
  for (const GGroup& group : kGroups) {
    if (number != group.number) continue;
    open.emit_at(at, Ins::Variable, first + group.modal - 1);
    open.emit(Ins::SubtractConstant, group.first);
    return true;
  }
  return open.wrong(Cause::CodeNotComputed, "a run does not know $P_GG[" + number + "]", at);
}

/// Read $TC_DP3[5,1], whose name is passed.
Read read_datum(OpenExpression& open, const ToolDatum& of, int depth) {
  if (!read_tool_datum(open, of, depth + 1)) return std::nullopt;
  open.constant.reset();
  open.emit(Ins::Indirect);
  if (open.assigned.contains(kToolData)) {
    late(open, open.line.offset());
    return std::nullopt;
  }
  return Type::Real;
}

}  // namespace

std::optional<ToolDatum> tool_datum_of(const Builder& to, std::string_view name) {
  constexpr std::string_view kEdge = "TC_DP", kName = "TC_TP2";
  const auto first = [&to](VariableKind kind) {
    for (const PlacedRange& placed : to.code().variables)
      if (placed.range.kind == kind) return placed.range.first;
    return -1;
  };
  if (name == kName && first(VariableKind::ToolName) >= 0)
    return ToolDatum{first(VariableKind::ToolName), false};
  std::int32_t datum = 0;
  const char* const last = name.data() + name.size();
  if (!name.starts_with(kEdge) || first(VariableKind::EdgeDatum) < 0) return std::nullopt;
  const auto read = std::from_chars(name.data() + kEdge.size(), last, datum);
  if (read.ec != std::errc() || read.ptr != last || datum < 1 || datum >= EdgeDatum::kData)
    return std::nullopt;
  return ToolDatum{first(VariableKind::EdgeDatum) + EdgeDatum{datum, 0, 0}.number(), true};
}

bool read_tool_datum(OpenExpression& open, const ToolDatum& of, int depth) {
  Definition indices;
  indices.dimensions = of.of_edge ? 2 : 1;
  indices.extents = {EdgeDatum::kTools, EdgeDatum::kEdges};
  if (!read_indices(open, indices, depth)) return false;
  open.emit(Ins::AddConstant, of.first);
  return true;
}

std::vector<std::string_view> known_system_variables() {
  std::vector<std::string_view> names{"PI"};
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
  if (is_frame_variable(name)) return read_control_frame(open, name, at, depth);
  if (const auto datum = tool_datum_of(open.to, name); datum && datum->of_edge)
    return read_datum(open, *datum, depth);
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
    return of->kind == VariableKind::Input || of->kind == VariableKind::Output ? Type::Bool
                                                                               : Type::Real;
  }
  return push_variable(open, *of, range->first, at);
}

}  // namespace cncsub::sinumerik
