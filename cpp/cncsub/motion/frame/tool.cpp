// Tool words: T of mills and lathes, length offsets, the radius in force.
#include <algorithm>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

Result length_axis(MotionView m, BlockWords& block, int& axis) {
  switch (m.facts.control->motion.length_type.value) {
    case LengthType::Z:
    case LengthType::Shift:
      axis = 2;
      return std::nullopt;
    case LengthType::Normal:
      axis = plane_axes(m.state.plane).across;
      return std::nullopt;
    case LengthType::Named:
      for (int i = 0; i < kAxes; ++i)
        if (block.words.has(kAxisNames[static_cast<std::size_t>(i)])) {
          axis = i;
          return std::nullopt;
        }
      return fault_at({.groups = bit(Group::Length)}, Cause::LengthAxis, block);
  }
  return std::nullopt;
}

/// Take the length from axis words (G43.1), or add them to the one in force (G43.2).
void give_length(MotionContext& m, BlockWords& block, bool add) {
  Axes length = in_machine(m.state, m.state.length);
  for (std::size_t i = 0; i < length.size(); ++i)
    if (const char name = kAxisNames[i]; block.words.has(name)) {
      length[i] = number(m, block, name) + (add ? length[i] : 0);
      // A motion code of the block takes these words too. [rs274 2.9]
      block.consumed = !block.has(Group::Motion) && !block.has(Group::Cycle);
    }
  m.state.length = in_frame(m.state, length);
}

/// Set the length on all axes, where it shifts the work coordinates.
void shift_by_length(MotionContext& m, bool add) {
  const Axes length = in_frame(m.state, length_of_tool(m.state, m.state.h));
  m.state.length = add ? m.state.length + length : length;
}

/// Read the number of the offset: that of H, or of the tool where the control takes it without H.
Result take_h(MotionContext& m, const BlockWords& block) {
  if (block.words.has('H')) {
    const double number = counted(m, block.words, 'H');
    if (number < 0 || number >= static_cast<double>(m.state.tables.length->size()))
      return fault_at('H', Cause::OffsetNumber, block);
    m.state.h = to_whole<int>(number);
  }
  if (is_of_tool(m, block, 'H')) m.state.h = offset_of_tool(m.state, *m.state.tables.length);
  return std::nullopt;
}

/// Take the length where it shifts the work coordinates: H does nothing without its code.
Result take_shifting_length(MotionContext& m, BlockWords& block) {
  if (!block.has(Group::Length)) return std::nullopt;
  if (compensates_behind(m, block))
    return fault_at({.groups = bit(Group::Length)}, Cause::CompensationShift, block);
  if (auto wrong = take_h(m, block)) return wrong;
  const GCode& code = block.code(Group::Length);
  m.state.modal[at(Group::Length)] = code;
  if (code.meaning == Meaning::LengthOff)
    m.state.length = {};
  else if (code.variant == 1 || (code.variant == 2 && !block.words.has('H')))
    give_length(m, block, code.variant == 2);
  else
    shift_by_length(m, code.variant == 2);
  return std::nullopt;
}

/// Take the length of G43, G44, G49 and H.
Result take_length(MotionContext& m, BlockWords& block) {
  if (m.facts.lathe()) return std::nullopt;
  if (block.meaning(Group::OneShot) == Meaning::MeasureTool) return std::nullopt;  // it takes no H
  const bool h = block.words.has('H');
  if (!h && !block.has(Group::Length)) return std::nullopt;
  if (m.facts.control->motion.length_type.value == LengthType::Shift)
    return take_shifting_length(m, block);
  if (auto wrong = take_h(m, block)) return wrong;
  if (block.has(Group::Length)) m.state.modal[at(Group::Length)] = block.code(Group::Length);
  const Meaning meaning = m.state.modal[at(Group::Length)].meaning;
  if (meaning == Meaning::LengthOff) {
    m.state.length = {};
    return std::nullopt;
  }
  int axis = m.state.length_axis;
  if (block.has(Group::Length))
    if (auto wrong = length_axis(m, block, axis)) return wrong;
  if (axis != m.state.length_axis)
    m.state.length[static_cast<std::size_t>(m.state.length_axis)] = 0;
  m.state.length_axis = axis;
  const int form = block.has(Group::Length) ? block.code(Group::Length).variant : 0;
  if (form == 1 || (form == 2 && !h)) {
    give_length(m, block, form == 2);
    return std::nullopt;
  }
  const double value = m.state.h == 0 ? 0 : m.state.tables.length_of(m.state.h);
  if (form == 2) {
    m.state.length[static_cast<std::size_t>(axis)] += value;
    return std::nullopt;
  }
  m.state.length[static_cast<std::size_t>(axis)] = meaning == Meaning::LengthMinus ? -value : value;
  return std::nullopt;
}

}  // namespace

int offset_of_tool(const MotionState& state, const std::vector<double>& offsets) {
  return state.tool > 0 && static_cast<std::size_t>(state.tool) < offsets.size() ? state.tool : 0;
}

bool is_of_tool(MotionView m, const BlockWords& block, char letter) {
  return m.facts.control->motion.missing_radius_offset.value == MissingOffset::Tool &&
         (!block.words.has(letter) || block.words[letter] == 0);
}

Result set_tool(MotionContext& m, BlockWords& block) {
  if (!block.words.has('T')) return std::nullopt;
  const int t = whole(std::round(block.words['T']));  // as the code that is sent
  if (t < 0 && m.facts.refuses(Cause::ValueOutOfRange))
    return fault_at('T', Cause::ValueOutOfRange, block, "the number of a tool is not below zero");
  if (!m.facts.lathe()) {
    m.state.t = t;
    return std::nullopt;
  }
  const Control& c = *m.facts.control;
  const int split = c.turning.tool_offset_digits.value == 1   ? 10
                    : c.turning.tool_offset_digits.value == 3 ? 1000
                                                              : 100;
  const int number = t % split;
  if (number > c.motion.max_offset_number.value)
    return fault_at('T', Cause::OffsetNumber, block, "T" + std::to_string(t));
  m.state.t = t;
  if (t / split != 0) m.state.tool = t / split;
  m.state.tool_offset = number;
  const Axes value = number == 0 ? Axes{} : m.state.tables.tool(number).value;
  if (c.turning.tool_offset.value == ToolOffset::Shift) {
    m.state.tool_shift = value;
    refresh_offset(m.state);
  } else {
    m.state.length = value;
    m.state.tool_pending = c.turning.tool_offset.value == ToolOffset::NextMove;
  }
  return std::nullopt;
}

namespace {

// The data of an edge: three lengths, the radius, and the wear of each. [general knowledge of the
// SINUMERIK 840D: $TC_DP3 to $TC_DP6, $TC_DP12 to $TC_DP15]
constexpr int kEdgeType = 1, kEdgeLength = 3, kEdgeRadius = 6, kToWear = 9;

/// Return what a program has written as a datum of an edge, as D took it; nothing where it has not.
std::optional<double> written_datum(const EdgeTables& all, EdgeDatum of) {
  const auto found = all.data.find(of.number());
  return found == all.data.end() ? std::nullopt : std::optional(found->second);
}

/// Return the length of an edge that is counted as this one along its axis: the first lies across
/// the plane. [general knowledge of the SINUMERIK 840D: tools for milling]
int axis_of_length(Plane plane, int length) {
  const PlaneAxes axes = plane_axes(plane);
  return length == 0 ? axes.across : length == 1 ? axes.b : axes.a;
}

/// Return the offsets of an edge that the setup gives.
const ToolOffsets& edge_of(const OffsetTables& tables, int tool, int edge) {
  static constexpr ToolOffsets kNone;
  if (edge == 1) return tables.tool(tool);
  const auto found = tables.edges->offsets.find({tool, edge});
  return found == tables.edges->offsets.end() ? kNone : found->second;
}

/// Return the radius of an edge by the setup: that of its own, or by the number of the tool.
double radius_by_setup(const OffsetTables& tables, int tool, int edge) {
  if (const double own = edge_of(tables, tool, edge).radius; own != 0 || edge != 1) return own;
  const bool listed = static_cast<std::size_t>(tool) < tables.radius->size();
  return listed ? tables.radius_of(tool) : 0;
}

/// Return the lengths of an edge by the setup: its own, or the one by the number of the tool along
/// the axis across the plane. The setup gives its own ones on the axes of G17: its Z is the first
/// length, which lies across the plane in force.
Axes length_by_setup(const OffsetTables& tables, Plane plane, int tool, int edge) {
  const Axes& own = edge_of(tables, tool, edge).value;
  Axes length{};
  if (own != Axes{} || edge != 1) {
    length = own;
    for (int i = 0; i < 3; ++i)
      length[static_cast<std::size_t>(axis_of_length(plane, i))] =
          own[static_cast<std::size_t>(axis_of_length(Plane::XY, i))];
    return length;
  }
  if (static_cast<std::size_t>(tool) < tables.length->size())
    length[static_cast<std::size_t>(plane_axes(plane).across)] = tables.length_of(tool);
  return length;
}

/// Return the radius of the edge in force.
double radius_of_edge(const MotionState& state) {
  if (state.tool <= 0) return 0;
  const double radius = radius_by_setup(state.tables, state.tool, state.d);
  const EdgeTables& all = *state.tables.edges_in_force;
  if (all.data.empty()) return radius;
  const EdgeDatum own{kEdgeRadius, state.d, state.tool};
  const EdgeDatum wear{kEdgeRadius + kToWear, state.d, state.tool};
  return written_datum(all, own).value_or(radius) + written_datum(all, wear).value_or(0);
}

/// Return the length of the edge in force on all axes.
Axes length_of_edge(const MotionState& state) {
  if (state.d == 0 || state.tool <= 0) return {};
  Axes length = length_by_setup(state.tables, state.plane, state.tool, state.d);
  const EdgeTables& all = *state.tables.edges_in_force;
  if (all.data.empty()) return length;
  for (int i = 0; i < 3; ++i) {
    double& of = length[static_cast<std::size_t>(axis_of_length(state.plane, i))];
    of = written_datum(all, {kEdgeLength + i, state.d, state.tool}).value_or(of) +
         written_datum(all, {kEdgeLength + kToWear + i, state.d, state.tool}).value_or(0);
  }
  return length;
}

/// Return whether anything is known of an edge.
bool is_known(const OffsetTables& tables, int tool, int edge) {
  if (edge == 1 || tables.edges->offsets.contains({tool, edge})) return true;
  const auto& data = tables.edges->data;
  return std::any_of(data.begin(), data.end(), [&](const auto& of) {
    const EdgeDatum datum = EdgeDatum::of(of.first);
    return datum.tool == tool && datum.edge == edge;
  });
}

/// Take the data of the edge that D names, or the tool change.
Result take_edge(MotionContext& m, const BlockWords& block) {
  MotionState& s = m.state;
  if (block.words.has(Role::ToolChange)) s.d = 1;
  if (block.words.has('D')) {
    const double edge = counted(m, block.words, 'D');
    if (edge < 0 || edge > m.facts.control->motion.max_offset_number.value)
      return fault_at('D', Cause::OffsetNumber, block);
    s.d = to_whole<int>(edge);
  }
  s.tables.edges_in_force = s.tables.edges;
  if (s.d == 0 || s.tool <= 0) return std::nullopt;
  const bool has_offsets = length_by_setup(s.tables, s.plane, s.tool, 1) != Axes{} ||
                           radius_by_setup(s.tables, s.tool, 1) != 0;
  if (!is_known(s.tables, s.tool, s.d) && has_offsets)
    return fault_at('D', Cause::CodeNotComputed, block,
                    "the setup does not give edge " + std::to_string(s.d) + " of tool " +
                        std::to_string(s.tool) + ": give it under edges");
  constexpr double kTurning = 500, kAfterTurning = 600;
  const double type = written_datum(*s.tables.edges, {kEdgeType, s.d, s.tool}).value_or(0);
  if (type >= kTurning && type < kAfterTurning)
    return fault_at('D', Cause::CodeNotComputed, block,
                    "cncsub does not compute the data of a turning tool that a program writes");
  return std::nullopt;
}

}  // namespace

Result set_edge(MotionContext& m, const BlockWords& block) {
  MotionState& s = m.state;
  if (block.words.has(Role::ToolChange) || block.words.has('D'))
    if (auto wrong = take_edge(m, block)) return wrong;
  const Axes length = length_of_edge(s);
  if (length == s.length) return std::nullopt;
  if (moves_wait(s))
    return fault_at('D', Cause::CodeNotComputed, block,
                    "cncsub does not compute a change of the tool length while a radius is "
                    "compensated or a corner waits");
  s.work = s.work + (s.length - length);
  s.length = length;
  s.row_moves = nullptr;
  return std::nullopt;
}

double datum_of_edge(MotionView m, std::int32_t number) {
  const OffsetTables& tables = m.state.tables;
  const EdgeDatum of = EdgeDatum::of(number);
  if (const auto written = written_datum(*tables.edges, of)) return *written;
  if (of.datum == kEdgeRadius) return radius_by_setup(tables, of.tool, of.edge);
  const int length = of.datum - kEdgeLength;
  if (length < 0 || length > 2) return 0;
  const Axes lengths = length_by_setup(tables, m.state.plane, of.tool, of.edge);
  return lengths[static_cast<std::size_t>(axis_of_length(m.state.plane, length))];
}

Result set_length(MotionContext& m, BlockWords& block) {
  const Axes before = m.state.length;
  if (auto wrong = take_length(m, block)) return wrong;
  if (m.facts.control->motion.length_type.value == LengthType::Shift)
    m.state.work = m.state.work + (before - m.state.length);
  return std::nullopt;
}

double radius_value(MotionView m) {
  if (m.facts.lathe()) return m.state.tables.tool(m.state.tool_offset).radius;
  if (m.state.modal[at(Group::Radius)].variant == 1) return m.state.given_radius;
  if (m.state.d == 0) return 0;
  if (m.facts.control->motion.tool_edges.value) return radius_of_edge(m.state);
  const double offset = m.state.tables.radius_of(m.state.d);
  return m.facts.control->motion.radius_offset_diameter.value ? offset / 2 : offset;
}

Result set_longer(MotionView m, BlockWords& block) {
  double times = 0;
  switch (block.meaning(Group::OneShot)) {
    case Meaning::Lengthen:
      times = 1;
      break;
    case Meaning::Shorten:
      times = -1;
      break;
    case Meaning::LengthenTwice:
      times = 2;
      break;
    case Meaning::ShortenTwice:
      times = -2;
      break;
    default:
      return std::nullopt;
  }
  if (compensating(m.state)) return fault(Cause::LongerInCompensation, block);
  const Letters& letters = m.facts.control->motion.longer_words.value;
  const bool by_h =
      letters.has('H') && (!letters.has('D') || (block.words.has('H') && !block.words.has('D')));
  block.axis_extension = times * (!by_h            ? radius_value(m)
                                  : m.state.h == 0 ? 0
                                                   : m.state.tables.length_of(m.state.h));
  return std::nullopt;
}

Axes lengthened(MotionView m, const BlockWords& block, Axes end, std::uint32_t named) {
  for (int i = 0; i < kAxes; ++i) {
    if ((named >> i & 1) == 0) continue;
    const double way = end[i] - m.state.work[i];
    const char name = kAxisNames[static_cast<std::size_t>(i)];
    if (way != 0)
      end[i] += way < 0 ? -block.axis_extension : block.axis_extension;
    else if (m.state.incremental && block.words.has(name))
      end[i] += std::signbit(block.words[name]) ? -block.axis_extension : block.axis_extension;
  }
  return end;
}

std::array<double, 3> tip_vector(MotionView m) {
  static constexpr std::array<std::array<int, 2>, 10> kTips = {
      // X and Z of tips 0 to 9
      {{0, 0}, {1, 1}, {1, -1}, {-1, -1}, {-1, 1}, {0, 1}, {1, 0}, {0, -1}, {-1, 0}, {0, 0}}};
  if (!m.facts.lathe() || m.state.plane != Plane::ZX) return {};
  const ToolOffsets& tool = m.state.tables.tool(m.state.tool_offset);
  if (tool.tip < 0 || tool.tip > 9) return {};
  const auto& tip = kTips[static_cast<std::size_t>(tool.tip)];
  return {tip[0] * tool.radius / m.facts.share(0), 0, tip[1] * tool.radius};
}

}  // namespace cncsub
