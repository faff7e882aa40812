// Frames: CTRANS(X,10), FRAME1[X,TR], $P_UIFR[1]. [SONE p.631-640]
#include "cncsub/dialect/sinumerik/frames.hpp"

#include <algorithm>
#include <iterator>

#include "cncsub/code/frame_parts.hpp"
#include "cncsub/dialect/sinumerik/operands.hpp"

namespace cncsub::sinumerik {

namespace {

Read fails(bool /*said*/) { return std::nullopt; }

/// A function that makes a frame of axes and their values.
struct FrameFunction {
  std::string_view name;
  FramePart part;
};
constexpr FrameFunction kFunctions[] = {
    {"CTRANS", FramePart::Shift}, {"CFINE", FramePart::Fine},     {"CROT", FramePart::Rotation},
    {"CSCALE", FramePart::Scale}, {"CMIRROR", FramePart::Mirror}, {"CRPL", FramePart::Rotation}};
constexpr FrameFunction kParts[] = {{"TR", FramePart::Shift},
                                    {"FI", FramePart::Fine},
                                    {"RT", FramePart::Rotation},
                                    {"SC", FramePart::Scale},
                                    {"MI", FramePart::Mirror}};

const FrameFunction* function_named(std::string_view name) {
  const auto* const of = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                      [name](const auto& known) { return known.name == name; });
  return of == std::end(kFunctions) ? nullptr : of;
}

/// A frame of the control, by its place among those of its kind. [MD840, framevar.svar]
struct FrameVariable {
  std::string_view name;
  VariableKind kind;
  FrameInForce which = FrameInForce::Other;
  bool read_only = false;
};
constexpr FrameVariable kVariables[] = {
    {"P_UIFR", VariableKind::StoredFrame},
    {"P_IFRAME", VariableKind::FrameInForce, FrameInForce::Settable},
    {"P_PFRAME", VariableKind::FrameInForce, FrameInForce::Program},
    {"P_BFRAME", VariableKind::FrameInForce, FrameInForce::Basic},
    {"P_ACTBFRAME", VariableKind::FrameInForce, FrameInForce::Basic, true},
    {"P_ACTFRAME", VariableKind::FrameInForce, FrameInForce::Whole, true},
    {"P_SETFR", VariableKind::FrameInForce},
    {"P_SETFRAME", VariableKind::FrameInForce},
    {"P_EXTFR", VariableKind::FrameInForce},
    {"P_EXTFRAME", VariableKind::FrameInForce},
    {"P_PARTFR", VariableKind::FrameInForce},
    {"P_PARTFRAME", VariableKind::FrameInForce},
    {"P_TOOLFR", VariableKind::FrameInForce},
    {"P_TOOLFRAME", VariableKind::FrameInForce},
    {"P_WPFR", VariableKind::FrameInForce},
    {"P_WPFRAME", VariableKind::FrameInForce},
    {"P_TRAFR", VariableKind::FrameInForce},
    {"P_TRAFRAME", VariableKind::FrameInForce},
    {"P_CYCFR", VariableKind::FrameInForce},
    {"P_CYCFRAME", VariableKind::FrameInForce}};

const FrameVariable* variable_named(std::string_view name) {
  const auto* const of = std::find_if(std::begin(kVariables), std::end(kVariables),
                                      [name](const auto& known) { return known.name == name; });
  return of == std::end(kVariables) ? nullptr : of;
}

/// Return the number of the first variable of a kind; -1 where the control has none.
std::int32_t first_of(const OpenExpression& open, VariableKind kind) {
  for (const PlacedRange& placed : open.to.code().variables)
    if (placed.range.kind == kind) return placed.range.first;
  return -1;
}

/// Return what marks in the block that it has assigned a frame of the control.
constexpr std::int32_t kAnyFrame = -(1 << 30);

bool take(OpenExpression& open, char c, std::uint32_t at) {
  if (open.line.take(c)) return true;
  const Cause cause = c == ','               ? Cause::MissingComma
                      : c == '(' || c == '[' ? Cause::BracketNotOpened
                                             : Cause::BracketNotClosed;
  return open.wrong(cause, std::string(1, c) + " is missing", at);
}

/// Read an axis, or what gives one.
bool read_axis(OpenExpression& open, int depth) {
  const std::uint32_t at = open.line.offset();
  const Read read = read_value(open, depth + 1);
  if (!read) return false;
  open.constant.reset();
  return *read == Type::Axis || open.wrong(Cause::TypeMismatch, "an axis is missing", at);
}

bool read_number_of(OpenExpression& open, int depth) {
  const std::uint32_t at = open.line.offset();
  const Read read = read_value(open, depth + 1);
  if (!read) return false;
  open.constant.reset();
  return is_number(*read) || open.wrong(Cause::TypeMismatch, "a number is missing", at);
}

/// Read X,TR] after the bracket or the index before it.
bool read_part(OpenExpression& open, FramePart& part, int depth) {
  if (!read_axis(open, depth)) return false;
  if (!take(open, ',', open.line.offset())) return false;
  const std::uint32_t at = open.line.offset();
  const std::string name = capitals(open.line.name());
  open.line.pass(name.size());
  const auto* const of = std::find_if(std::begin(kParts), std::end(kParts),
                                      [&](const auto& known) { return known.name == name; });
  if (of == std::end(kParts))
    return open.wrong(Cause::ExpressionFormat, "a part of a frame is TR, FI, RT, SC or MI", at);
  part = of->part;
  return take(open, ']', open.line.offset());
}

/// Read the same, and push that part of the frame that was read last. `at`: where this stands.
Read push_part(OpenExpression& open, std::uint32_t at, int depth) {
  FramePart part{};
  if (!read_part(open, part, depth)) return std::nullopt;
  open.to.expressions().emit({Ins::FramePart, 0, at, static_cast<double>(part)});
  return Type::Real;
}

/// Read the index of a frame of the work systems.
bool read_index(OpenExpression& open, int depth) {
  if (!take(open, '[', open.line.offset())) return false;
  const std::uint32_t at = open.line.offset();
  if (!read_number_of(open, depth)) return false;
  const double frames = open.to.control().motion.max_extra_systems.value;
  open.to.expressions().emit({Ins::Index, 0, at, frames});
  return true;
}

/// Return whether a part of the frame is read or written: take the comma or the bracket before it.
bool takes_part(OpenExpression& open, const FrameVariable& of, bool& whole, std::uint32_t at) {
  if (of.kind != VariableKind::StoredFrame) {
    whole = !open.line.take('[');
    return true;
  }
  whole = open.line.take(']');
  return whole || take(open, ',', at);
}

/// Read the plane of CRPL as it stands, and push the axis across it: 0 is the plane in force, 1 to
/// 3 are those of G17 to G19. [840Dk p.2-45; 828Db p.728]
bool push_axis_of_plane(OpenExpression& open) {
  const std::uint32_t at = open.line.offset();
  const std::string_view digits = open.line.take_digits();
  if (digits.empty()) return open.not_computed("CRPL of a computed plane", at);
  if (digits.size() != 1 || digits[0] > '3')
    return open.wrong(Cause::ValueOutOfRange, "a plane of CRPL is 0 to 3", at);
  if (digits[0] != '0') {
    open.emit(Ins::Constant, '4' - digits[0]);
    return true;
  }
  open.emit(Ins::Constant, 20);  // G17 is across Z, the third axis
  constexpr int kPlane = 6;      // the G group of the planes
  open.emit(Ins::Variable, first_of(open, VariableKind::ModalCode) + kPlane - 1);
  open.emit(Ins::Subtract);
  return true;
}

/// Read CRPL(0,30) after its bracket, a frame that turns in a plane.
Read read_rotation_in_plane(OpenExpression& open, int depth) {
  const std::uint32_t at = open.line.offset();
  if (!push_axis_of_plane(open) || !take(open, ',', at) || !read_number_of(open, depth))
    return std::nullopt;
  open.to.expressions().emit({Ins::AxisOfFrame, 0, at, static_cast<double>(FramePart::Rotation)});
  open.emit(Ins::OverFrame);
  open.constant.reset();
  return take(open, ')', open.line.offset()) ? Read(Type::Frame) : std::nullopt;
}

}  // namespace

bool is_frame_function(std::string_view name) { return function_named(name) != nullptr; }

Read read_frame_function(OpenExpression& open, std::string_view name, int depth) {
  const FramePart part = function_named(name)->part;
  const std::uint32_t at = open.line.offset();
  open.line.pass(name.size());
  if (!take(open, '(', at)) return std::nullopt;
  open.constant.reset();
  open.emit(Ins::Constant, 0);
  if (name == "CRPL") return read_rotation_in_plane(open, depth);
  if (open.line.take(')')) return Type::Frame;
  do {
    const std::uint32_t axis_at = open.line.offset();
    if (!read_axis(open, depth)) return std::nullopt;
    if (part == FramePart::Mirror) {
      open.emit(Ins::Constant, 1);
    } else if (!take(open, ',', axis_at) || !read_number_of(open, depth)) {
      return std::nullopt;
    }
    open.to.expressions().emit({Ins::AxisOfFrame, 0, axis_at, static_cast<double>(part)});
    open.emit(Ins::OverFrame);
  } while (open.line.take(','));
  open.constant.reset();
  return take(open, ')', open.line.offset()) ? Read(Type::Frame) : std::nullopt;
}

Read read_frame_part(OpenExpression& open, int depth) {
  const std::uint32_t at = open.line.offset();
  open.constant.reset();
  return open.line.take('[') ? push_part(open, at, depth) : Type::Frame;
}

bool write_frame_part(OpenExpression& open, const Instruction& frame, Value& value) {
  const std::uint32_t at = open.line.offset();
  FramePart part{};
  open.to.expressions().begin();
  open.to.expressions().emit(frame);
  if (!take(open, '[', at) || !read_part(open, part, 0)) return false;
  if (!open.line.take('=')) return open.wrong(Cause::MissingEquals, "a value is missing", at);
  if (!read_number_of(open, 0)) return false;
  open.to.expressions().emit({Ins::AxisOfFrame, 0, at, static_cast<double>(part)});
  open.emit(Ins::OverFrame);
  const std::uint32_t width = open.line.width_from(at);
  value = {true, 0, open.to.expressions().end(at, width), at, width};
  return true;
}

bool is_frame_variable(std::string_view name) {
  return name == "P_UIFRNUM" || variable_named(name) != nullptr;
}

std::string name_of_frame(VariableKind kind, std::int32_t index) {
  if (kind == VariableKind::FrameNumber) return "$P_UIFRNUM";
  for (const FrameVariable& of : kVariables) {
    if (of.kind != kind) continue;
    std::string name = "$" + std::string(of.name);
    if (kind == VariableKind::StoredFrame) return name + "[" + std::to_string(index) + "]";
    if (static_cast<std::int32_t>(of.which) == index) return name;
  }
  return "";
}

std::vector<std::string_view> frames_of_no_machine() {
  std::vector<std::string_view> names;
  for (const FrameVariable& of : kVariables)
    if (of.kind == VariableKind::FrameInForce && of.which == FrameInForce::Other)
      names.push_back(of.name);
  return names;
}

Read read_control_frame(OpenExpression& open, std::string_view name, std::uint32_t at, int depth) {
  open.constant.reset();
  if (open.assigned.contains(kAnyFrame)) return fails(late(open, at));
  if (name == "P_UIFRNUM") {
    open.emit(Ins::Variable, first_of(open, VariableKind::FrameNumber));
    return Type::Int;
  }
  const FrameVariable& of = *variable_named(name);
  const std::int32_t first = first_of(open, of.kind);
  if (of.kind == VariableKind::StoredFrame) {
    if (!read_index(open, depth)) return std::nullopt;
    open.emit(Ins::AddConstant, 1);
    open.emit(Ins::VariableAt, first);
  } else {
    open.emit(Ins::Variable, first + static_cast<int>(of.which));
  }
  bool whole = false;
  if (!takes_part(open, of, whole, at)) return std::nullopt;
  return whole ? Type::Frame : push_part(open, at, depth);
}

bool assign_control_frame(OpenExpression& open, std::string_view name, std::uint32_t at,
                          Statement& statement) {
  const FrameVariable* const of = variable_named(name);
  if (of == nullptr || of->read_only)
    return open.wrong(Cause::VariableWriteProtected, "$" + std::string(name) + " is only read", at);
  const std::int32_t first = first_of(open, of->kind);
  statement.variable_at = at;
  statement.index =
      first + (of->kind == VariableKind::StoredFrame ? 0 : static_cast<int>(of->which));
  statement.target = Statement::Target::Variable;
  if (of->kind == VariableKind::StoredFrame) {
    open.to.expressions().begin();
    if (!read_index(open, 0)) return false;
    statement.target = Statement::Target::VariableAt;
    statement.variable = open.to.expressions().end(at, open.line.width_from(at));
  }
  bool whole = false;
  FramePart part{};
  if (!takes_part(open, *of, whole, at)) return false;
  open.to.expressions().begin();
  if (!whole && !read_part(open, part, 0)) return false;
  statement.variable_width = open.line.width_from(at);
  if (!open.line.take('=')) return open.wrong(Cause::MissingEquals, "a value is missing", at);
  statement.at = open.line.offset();
  if (!whole) {
    if (!read_number_of(open, 0)) return false;
    open.to.expressions().emit({Ins::AxisOfFrame, 0, at, static_cast<double>(part)});
  } else {
    const Read read = read_value(open, 0);
    if (!read) return false;
    if (*read != Type::Frame)
      return open.wrong(Cause::TypeMismatch, "a frame is given to a frame only", statement.at);
  }
  statement.width = open.line.width_from(statement.at);
  statement.expression = open.to.expressions().end(statement.at, statement.width);
  open.assigned.insert(kAnyFrame);
  return true;
}

}  // namespace cncsub::sinumerik
