// Work coordinates: zero points and shifts, machine coordinates, reference points, data setting.
#include "cncsub/motion_facts.hpp"

namespace cncsub {

/// The way from work to base coordinates: EXT + G54... + G92 + G52, and the tool shift of a lathe.
Axes Motion::zero_offset() const {
  const Axes& system = s_.work_system > 0
                           ? tables_->work[static_cast<std::size_t>(s_.work_system)]
                           : tables_->extra[static_cast<std::size_t>(s_.extra_system - 1)];
  return tables_->work[0] + system + s_.shift + s_.local + s_.tool_shift;
}

/// Takes a changed zero point over: the machine stays, the work coordinates change.
void Motion::refresh_offset() {
  const Axes now = zero_offset();
  if (now == s_.offset) return;
  s_.work = s_.work + (s_.offset - now);
  s_.offset = now;
}

Motion::Result Motion::select_work(BlockWords& block) {
  if (!block.has(Group::Work)) return std::nullopt;
  const Meaning meaning = block.meaning(Group::Work);
  // [TDi 21 note 6: G54 in a block of G50 is ignored]
  if (facts_->lathe() && block.meaning(Group::OneShot) == Meaning::SetCoordinate)
    return std::nullopt;
  int system = static_cast<int>(meaning) - static_cast<int>(Meaning::Work1) + 1;
  if (meaning == Meaning::WorkExtra) {
    const int own = block.codes[at(Group::Work)].system;
    const double p = own > 0 ? own : block.words.has('P') ? raw(block, 'P') : 1;
    if (p < 1 || p > static_cast<double>(tables_->extra.size()))
      return fault(Cause::WorkSystem, block);
    s_.extra_system = to_whole<int>(p);
    system = 0;
  }
  s_.work_system = system;
  s_.modal[at(Group::Work)] = block.codes[at(Group::Work)];
  refresh_offset();
  return std::nullopt;
}

/// G92, and G50 of a lathe: the point gets these coordinates, on the named axes.
Motion::Result Motion::set_coordinate(BlockWords& block) {
  std::uint32_t named = 0;
  const bool incremental = s_.incremental;
  s_.incremental = false;  // also under G91 a setting
  const Axes given = target(block, named);
  s_.incremental = incremental;
  if (named == 0) return std::nullopt;
  if (facts_->lathe() && facts_->control->set_coordinate_alarms.value)
    return fault(Cause::CoordinateSettingRefused, block);
  for (int i = 0; i < kAxes; ++i) {
    if ((named >> i & 1) == 0) continue;
    // What was G52's becomes part of the shift. [TDi 19 note 5]
    s_.shift[i] += s_.work[i] - given[i] + s_.local[i];
    s_.local[i] = 0;
    // The given point is the one without the tool offset. [TDi 18 table]
    if (facts_->control->set_coordinate_without_tool.value) s_.shift[i] += s_.tool_shift[i];
  }
  refresh_offset();
  return std::nullopt;
}

Motion::Result Motion::clear_coordinate(BlockWords& block) {
  for (int i = 0; i < kAxes; ++i)
    if (block.words.has(kAxisNames[static_cast<std::size_t>(i)])) s_.shift[i] = s_.local[i] = 0;
  refresh_offset();
  return std::nullopt;
}

/// G52. U and W of a lathe say the same as X and Z. [TDi 19]
Motion::Result Motion::set_local(BlockWords& block) {
  const bool lathe_a = facts_->machine == MachineType::LatheA;
  for (int i = 0; i < (lathe_a ? 6 : kAxes); ++i)
    if (const char name = kAxisNames[static_cast<std::size_t>(i)]; block.words.has(name))
      s_.local[i] = number(block, name);
  if (lathe_a)
    for (const auto& [letter, axis] : {std::pair{'U', 0}, {'V', 1}, {'W', 2}})
      if (block.words.has(letter)) s_.local[axis] = number(block, letter);
  refresh_offset();
  return std::nullopt;
}

namespace {

/// Adds or stores.
void put(double& place, double value, bool add) { place = add ? place + value : value; }

}  // namespace

Motion::Result Motion::set_data(BlockWords& block) {
  s_.data_set = true;
  const NcWords& w = block.words;
  const Control& c = *facts_->control;
  if (!w.has('L')) {
    if (facts_->lathe()) return set_tool_data(block);
    if (!c.offsets_without_l.value || !w.has('P')) return fault(Cause::G10Word, block);
    if (auto wrong = set_offset_data(block, 12, raw(block, 'P'))) return wrong;
    return set_offset_data(block, 10, raw(block, 'P'));
  }
  const int l = whole(raw(block, 'L'));
  const bool offsets = l >= 10 && l <= 13;
  const bool parameters = l == 50 || (l == 52 && c.parameters_by_l52.value);
  if (l != 2 && l != 20 && !offsets && l != 3 && !parameters && l != 1)
    return fault(Cause::G10L, block);
  if (l == 3 || parameters)
    return std::nullopt;  // tool life and parameters: no motion depends on them
  if (!w.has('P') && l != 2) return fault(Cause::G10Word, block);
  double p = w.has('P') ? raw(block, 'P') : s_.work_system;
  if (offsets || l == 1) return set_offset_data(block, l, p);
  const double last = l == 2 ? 6 : static_cast<double>(tables_->extra.size());
  if (p < (l == 2 ? 0 : 1) || p > last || p != std::floor(p)) {
    if (l != 2 || !c.other_system_is_first.value)
      return fault(l == 2 ? Cause::G10P : Cause::G10System, block);
    p = 1;
  }
  bool named = false;
  for (const char axis : kAxisNames) named = named || w.has(axis);
  if (!named && facts_->refuses(Cause::G10Axis)) return fault(Cause::G10Axis, block);
  OffsetTables& tables = own_tables();
  Axes& values =
      l == 2 ? tables.work[to_whole<std::size_t>(p)] : tables.extra[to_whole<std::size_t>(p) - 1];
  for (int i = 0; i < kAxes; ++i) {
    const char name = kAxisNames[static_cast<std::size_t>(i)];
    if (facts_->machine == MachineType::LatheA && i > 5) continue;
    if (w.has(name)) put(changed(values[i]), number(block, name), s_.incremental);
  }
  if (facts_->machine == MachineType::LatheA)
    for (const auto& [letter, axis] : {std::pair{'U', 0}, {'V', 1}, {'W', 2}})
      if (w.has(letter)) changed(values[static_cast<std::size_t>(axis)]) += number(block, letter);
  refresh_offset();
  return std::nullopt;
}

/// G10 L10 to L13: H and D, geometry and wear.
Motion::Result Motion::set_offset_data(BlockWords& block, int l, double p) {
  if (p < 0 || p >= static_cast<double>(tables_->length.size()))
    return fault(Cause::G10Offset, block);
  if (!block.words.has('R')) return fault(Cause::G10Value, block);
  OffsetTables& tables = own_tables();
  auto& table = l == 10   ? tables.length
                : l == 12 ? tables.radius
                : l == 13 ? tables.radius_wear
                          : tables.length_wear;
  put(changed(table[to_whole<std::size_t>(p)]), number(block, 'R'), s_.incremental);
  return std::nullopt;
}

/// G10 P X Z R Q of a lathe; P over 10000 names the geometry, P0 the work shift.
Motion::Result Motion::set_tool_data(BlockWords& block) {
  const NcWords& w = block.words;
  if (!w.has('P')) return fault(Cause::G10Word, block);
  const int p = whole(raw(block, 'P'));
  const int tool = p % 10000;
  if (p < 0 || p >= 20000 || tool > facts_->control->max_offset_number.value)
    return fault(Cause::G10Offset, block);
  OffsetTables& tables = own_tables();
  ToolOffsets* const entry = p == 0 ? nullptr : &changed_tool(tool);
  Axes& values = p == 0 ? tables.work[0] : entry->value;
  for (const auto& [name, axis] : {std::pair{'X', 0}, {'Y', 1}, {'Z', 2}})
    if (w.has(name))
      put(changed(values[static_cast<std::size_t>(axis)]), number(block, name), s_.incremental);
  for (const auto& [name, axis] : {std::pair{'U', 0}, {'V', 1}, {'W', 2}})
    if (w.has(name)) changed(values[static_cast<std::size_t>(axis)]) += number(block, name);
  if (entry != nullptr && w.has('R')) entry->radius = number(block, 'R');
  if (entry != nullptr && w.has('Q')) entry->tip = whole(raw(block, 'Q'));
  refresh_offset();
  return std::nullopt;
}

/// G53: the named axes go to machine coordinates; the tool length is taken away on them. [0iMB
/// p.228]
Motion::Result Motion::machine_move(BlockWords& block) {
  const Control& c = *facts_->control;
  const bool modal = c.machine_move.value == MachineMove::Modal;
  if (!facts_->homed) return fault(Cause::NotHomed, block);
  if (s_.incremental && !modal) return std::nullopt;
  const Meaning meaning = s_.modal[at(Group::Motion)].meaning;
  const MoveKind kind = modal && meaning != Meaning::Rapid ? MoveKind::Feed : MoveKind::Rapid;
  Axes end = s_.work;
  std::uint32_t named = 0;
  for (int i = 0; i < kAxes; ++i) {
    const char name = kAxisNames[static_cast<std::size_t>(i)];
    if (!block.words.has(name) || (facts_->machine == MachineType::LatheA && i > 5)) continue;
    named |= axis_bit(i);
    if (!s_.incremental) s_.length[i] = 0;
    end[i] = number(block, name) + (s_.incremental ? end[i] : -s_.offset[i]);
  }
  if (named == 0) return std::nullopt;
  if (kind == MoveKind::Feed)
    if (auto wrong = need_feed(block, Meaning::Line)) return wrong;
  s_.held.suspended = !modal;
  auto wrong = move(block, kind, end, named);
  s_.held.suspended = false;
  return wrong;
}

/// G28 and G30: rapid to the intermediate point, rapid to the reference point, the named axes only.
Motion::Result Motion::reference(BlockWords& block, int number_of_point) {
  if (number_of_point == 2) {
    const double p = block.words.has('P') ? raw(block, 'P') : 2;
    if (p < 2 || p > 4) return fault(Cause::ReferenceNumber, block);
    if (!facts_->homed) return fault(Cause::ReferenceNotHomed, block);
    number_of_point = to_whole<int>(p);
  }
  std::uint32_t named = 0;
  const Axes middle = linear_target(block, named);
  if (named == 0) return std::nullopt;
  s_.held.suspended = true;
  if (auto wrong = move(block, MoveKind::Rapid, middle, named)) return wrong;
  s_.middle_known |= named;
  const auto found = facts_->reference.find(number_of_point);
  Axes end = s_.work;
  for (int i = 0; i < kAxes; ++i) {
    if ((named >> i & 1) == 0) continue;
    s_.middle[i] = middle[i] + s_.offset[i];
    s_.length[i] = 0;
    end[i] = (found == facts_->reference.end() ? 0 : found->second[static_cast<std::size_t>(i)]) -
             s_.offset[i];
  }
  auto wrong = move(block, MoveKind::Rapid, end, named);
  s_.held.suspended = false;
  return wrong;
}

/// The end point without polar coordinates, which do not reach into these codes.
Axes Motion::linear_target(BlockWords& block, std::uint32_t& named) {
  const GCode polar = s_.modal[at(Group::Polar)];
  s_.modal[at(Group::Polar)].meaning = Meaning::PolarOff;
  const Axes end = target(block, named);
  s_.modal[at(Group::Polar)] = polar;
  return end;
}

/// G29: over the intermediate point of the last G28 to the point; under G91 the values count from
/// there.
Motion::Result Motion::from_reference(BlockWords& block) {
  std::uint32_t named = 0;
  linear_target(block, named);
  if (s_.middle_known == 0) return fault(Cause::NoIntermediate, block);
  if (named == 0) return std::nullopt;
  Axes middle = s_.work;
  for (int i = 0; i < kAxes; ++i)
    if ((named >> i & 1) != 0 && (s_.middle_known >> i & 1) != 0)
      middle[i] = s_.middle[i] - s_.offset[i];
  if (auto wrong = move(block, MoveKind::Rapid, middle, named)) return wrong;
  const Axes end = linear_target(block, named);
  return move(block, MoveKind::Rapid, end, named);
}

Motion::Result Motion::check_reference(BlockWords& block) {
  std::uint32_t named = 0;
  const Axes end = linear_target(block, named);
  if (named == 0) return std::nullopt;
  if (auto wrong = move(block, MoveKind::Rapid, end, named)) return wrong;
  const auto found = facts_->reference.find(1);
  const Axes machine = machine_point();
  for (int i = 0; i < kAxes; ++i) {
    const double wanted =
        found == facts_->reference.end() ? 0 : found->second[static_cast<std::size_t>(i)];
    if ((named >> i & 1) != 0 && std::fabs(machine[i] - wanted) > facts_->increment / 2)
      return fault(Cause::NotAtReference, block);
  }
  return std::nullopt;
}

/// G60: rapid past the point on the same side every time, then rapid to the point.
Motion::Result Motion::one_way(BlockWords& block) {
  if (block.has(Group::Motion)) s_.modal[at(Group::Motion)] = block.codes[at(Group::Motion)];
  end_cycles();
  std::uint32_t named = 0;
  const Axes end = target(block, named);
  if (named == 0) return std::nullopt;
  const double overrun = facts_->control->one_way_overrun.value * 1e-3;
  Axes past = end;
  for (int i = 0; i < kAxes; ++i)
    if ((named >> i & 1) != 0) past[i] -= overrun;
  if (overrun != 0)
    if (auto wrong = move(block, MoveKind::Rapid, past, named)) return wrong;
  return move(block, MoveKind::Rapid, end, named);
}

}  // namespace cncsub
