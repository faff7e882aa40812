// Tool words: T of mills and lathes, length offsets, the radius in force.
#include "cncsub/motion_facts.hpp"

namespace cncsub {

Motion::Result Motion::set_tool(BlockWords& block) {
  if (!block.words.has('T')) return std::nullopt;
  const int t = whole(raw(block, 'T'));
  if (!facts_->lathe()) {
    s_.t = t;
    return std::nullopt;
  }
  const Control& c = *facts_->control;
  const int split = c.tool_offset_digits.value == 1   ? 10
                    : c.tool_offset_digits.value == 3 ? 1000
                                                      : 100;
  const int number = t % split;
  if (number > c.max_offset_number.value)
    return fault(Cause::OffsetNumber, block, "T" + std::to_string(t));
  s_.t = t;
  if (t / split != 0) s_.tool = t / split;
  s_.tool_offset = number;
  const auto found = tables_->tools.find(number);
  const Axes value = number == 0 || found == tables_->tools.end() ? Axes{} : found->second.value;
  if (c.tool_offset.value == ToolOffset::Shift) {
    s_.tool_shift = value;
    refresh_offset();
  } else {
    s_.length = value;
    s_.tool_pending = c.tool_offset.value == ToolOffset::NextMove;
  }
  return std::nullopt;
}

/// G43, G44, G49 and H. A new value counts from this block on, on one axis.
Motion::Result Motion::set_length(BlockWords& block) {
  if (facts_->lathe()) return std::nullopt;
  if (block.meaning(Group::OneShot) == Meaning::MeasureTool) return std::nullopt;  // it takes no H
  const bool h = block.words.has('H');
  if (!h && !block.has(Group::Length)) return std::nullopt;
  if (h) {
    const double number = raw(block, 'H');
    if (number < 0 || number >= static_cast<double>(tables_->length.size()))
      return fault(Cause::OffsetNumber, block);
    s_.h = to_whole<int>(number);
  }
  if (block.has(Group::Length)) s_.modal[at(Group::Length)] = block.codes[at(Group::Length)];
  const Meaning meaning = s_.modal[at(Group::Length)].meaning;
  if (meaning == Meaning::LengthOff) {
    s_.length = {};
    return std::nullopt;
  }
  int axis = s_.length_axis;
  if (block.has(Group::Length))
    if (auto wrong = length_axis(block, axis)) return wrong;
  if (axis != s_.length_axis) s_.length[static_cast<std::size_t>(s_.length_axis)] = 0;
  s_.length_axis = axis;
  const auto number = static_cast<std::size_t>(s_.h);
  const double value = s_.h == 0 ? 0 : tables_->length[number] + tables_->length_wear[number];
  s_.length[static_cast<std::size_t>(axis)] = meaning == Meaning::LengthMinus ? -value : value;
  return std::nullopt;
}

Motion::Result Motion::length_axis(BlockWords& block, int& axis) const {
  switch (facts_->control->length_type.value) {
    case LengthType::Z:
      axis = 2;
      return std::nullopt;
    case LengthType::Normal:
      axis = plane_axes(s_.plane).across;
      return std::nullopt;
    case LengthType::Named:
      for (int i = 0; i < kAxes; ++i)
        if (block.words.has(kAxisNames[static_cast<std::size_t>(i)])) {
          axis = i;
          return std::nullopt;
        }
      return fault(Cause::LengthAxis, block);
  }
  return std::nullopt;
}

/// A changed tool vector moves its axis at once when the block does not move it anyway.
Motion::Result Motion::move_by_length(BlockWords& block, const Axes& before) {
  if (s_.length == before || block.submitted || s_.tool_pending || block.has(Group::OneShot))
    return std::nullopt;
  std::uint32_t named = 0;
  for (int i = 0; i < kAxes; ++i)
    if (s_.length[i] != before[i]) named |= axis_bit(i);
  const bool rapid =
      in_cycle() || s_.modal[at(Group::Motion)].meaning == Meaning::Rapid || s_.feed <= 0;
  if (auto wrong = move(block, rapid ? MoveKind::Rapid : MoveKind::Feed, s_.work, named))
    return wrong;
  block.outcome.moved = true;
  return std::nullopt;
}

Motion::Result Motion::set_radius(BlockWords& block) {
  const Control& c = *facts_->control;
  const bool measures = block.meaning(Group::OneShot) == Meaning::MeasureTool;  // D is its zone
  if (block.words.has('D') && !facts_->lathe() && !measures) {
    const double number = raw(block, 'D');
    if (number < 0 || number >= static_cast<double>(tables_->radius.size()))
      return fault(Cause::RadiusOffsetNumber, block);
    s_.d = to_whole<int>(number);
  }
  if (!block.has(Group::Radius)) return std::nullopt;
  s_.modal[at(Group::Radius)] = block.codes[at(Group::Radius)];
  if (!facts_->lathe() && compensating() && s_.d == 0 && !block.words.has('D') &&
      c.missing_radius_offset.value == MissingOffset::Alarm)
    return fault(Cause::RadiusOffsetNumber, block);
  return std::nullopt;
}

double Motion::radius_value() const {
  if (facts_->lathe()) {
    const auto found = tables_->tools.find(s_.tool_offset);
    return found == tables_->tools.end() ? 0 : found->second.radius;
  }
  const auto number = static_cast<std::size_t>(s_.d);
  return s_.d == 0 || number >= tables_->radius.size()
             ? 0
             : tables_->radius[number] + tables_->radius_wear[number];
}

/// G45 to G48: the move of each named axis gets longer or shorter by an offset, or by twice that.
/// A canned cycle does not take notice of them. [M7 p.242]
Motion::Result Motion::set_longer(BlockWords& block) const {
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
  if (compensating()) return fault(Cause::LongerInCompensation, block);
  const std::string& letters = facts_->control->longer_words.value;
  const bool by_h = letters == "H" || (letters.find('H') != std::string::npos &&
                                       block.words.has('H') && !block.words.has('D'));
  const auto h = static_cast<std::size_t>(s_.h);
  block.longer = times * (!by_h       ? radius_value()
                          : s_.h == 0 ? 0
                                      : tables_->length[h] + tables_->length_wear[h]);
  return std::nullopt;
}

/// The end of a move that G45 to G48 make longer along the way of each axis. An increment of zero
/// goes the way of its sign, an absolute word that moves nothing stays so. [M7 p.242 (3)]
Axes Motion::lengthened(const BlockWords& block, Axes end, std::uint32_t named) const {
  if (block.longer == 0) return end;
  for (int i = 0; i < kAxes; ++i) {
    if ((named >> i & 1) == 0) continue;
    const double way = end[i] - s_.work[i];
    const char name = kAxisNames[static_cast<std::size_t>(i)];
    if (way != 0)
      end[i] += way < 0 ? -block.longer : block.longer;
    else if (s_.incremental && block.words.has(name))
      end[i] += std::signbit(block.words[name]) ? -block.longer : block.longer;
  }
  return end;
}

/// From the centre of the nose to the imaginary tip, which the program moves: tip 3 points to -X
/// and -Z, 8 to -X.
std::array<double, 3> Motion::tip_vector() const {
  static constexpr std::array<std::array<int, 2>, 10> kTips = {
      // X and Z of tips 0 to 9
      {{0, 0}, {1, 1}, {1, -1}, {-1, -1}, {-1, 1}, {0, 1}, {1, 0}, {0, -1}, {-1, 0}, {0, 0}}};
  if (!facts_->lathe() || s_.plane != 18) return {};
  const auto found = tables_->tools.find(s_.tool_offset);
  if (found == tables_->tools.end() || found->second.tip < 0 || found->second.tip > 9) return {};
  const auto& tip = kTips[static_cast<std::size_t>(found->second.tip)];
  return {tip[0] * found->second.radius / facts_->share(0), 0, tip[1] * found->second.radius};
}

}  // namespace cncsub
