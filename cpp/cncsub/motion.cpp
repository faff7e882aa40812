#include "cncsub/motion.hpp"

#include <charconv>

#include "cncsub/fault_words.hpp"
#include "cncsub/motion_facts.hpp"
#include "cncsub/rule_lists.hpp"

namespace cncsub {
namespace {

MachineType machine_of(const Control& control, const std::string& name) {
  const auto& names = options<MachineType>();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i].slug == name) return static_cast<MachineType>(i);
  return control.machine.value;
}

void fill(Axes& axes, const std::map<char, double>& values) {
  for (const auto& [name, value] : values)
    if (const int axis = axis_of(name); axis >= 0) axes[static_cast<std::size_t>(axis)] = value;
}

constexpr int kLargestOffset = 9999;  // no table of offsets is longer, whatever a rule says

void fill(std::vector<double>& table, const std::map<int, double>& values) {
  for (const auto& [number, value] : values) {
    if (number < 0 || number > kLargestOffset) continue;
    if (table.size() <= static_cast<std::size_t>(number))
      table.resize(static_cast<std::size_t>(number) + 1);
    table[static_cast<std::size_t>(number)] = value;
  }
}

struct GroupName {
  std::string_view name;
  Group group;
  int mill, lathe;  // #4000 + this
};
// [REG; lathe 1.3]
constexpr GroupName kGroupNames[] = {
    {"motion", Group::Motion, 1, 1},
    {"plane", Group::Plane, 2, 16},
    {"distance", Group::Distance, 3, 3},
    {"stroke", Group::Stroke, 4, 9},
    {"feed", Group::Feed, 5, 5},
    {"units", Group::Units, 6, 6},
    {"radius", Group::Radius, 7, 7},
    {"length", Group::Length, 8, 0},
    {"cycle", Group::Cycle, 9, 10},
    {"return", Group::Return, 10, 11},
    {"scaling", Group::Scaling, 11, 0},
    {"macro", Group::Macro, 12, 12},
    {"surface", Group::Surface, 13, 2},
    {"work", Group::Work, 14, 14},
    {"path", Group::Path, 15, 0},
    {"rotation", Group::Rotation, 16, 0},
    {"polar", Group::Polar, 17, 0},
    {"mirror", Group::Mirror, 22, 0},
    {"turret", Group::Turret, 0, 4},
    {"fluctuation", Group::Fluctuation, 0, 8},
    {"polar-milling", Group::PolarMilling, 0, 21},
};

void number_groups(MotionFacts& facts, const std::string& changes) {
  for (const GroupName& g : kGroupNames) {
    int number = facts.lathe() ? g.lathe : g.mill;
    const std::string key = std::string(g.name) + "=";
    const auto found = (" " + changes).find(" " + key);
    if (found != std::string::npos)
      std::from_chars(changes.data() + found + key.size(), changes.data() + changes.size(), number);
    facts.group_numbers[at(g.group)] = number;
  }
}

OffsetTables tables_of(const Setup& setup, const Control& control) {
  OffsetTables tables;
  const auto rows = [](std::int32_t most) {
    return static_cast<std::size_t>(std::min(most, kLargestOffset));
  };
  tables.extra.resize(rows(control.max_extra_systems.value));
  for (const auto& [name, values] : setup.work_offsets) {
    const int system = system_of(name);
    if (system >= 0 && system < 7) fill(tables.work[static_cast<std::size_t>(system)], values);
    if (system > 100 && system - 101 < static_cast<int>(tables.extra.size()))
      fill(tables.extra[static_cast<std::size_t>(system - 101)], values);
  }
  const auto numbers = rows(control.max_offset_number.value) + 1;
  for (auto* table : {&tables.length, &tables.length_wear, &tables.radius, &tables.radius_wear})
    table->resize(numbers);
  fill(tables.length, setup.length_offsets);
  fill(tables.radius, setup.radius_offsets);
  tables.length_wear.resize(tables.length.size());
  tables.radius_wear.resize(tables.radius.size());
  for (const auto& [number, tool] : setup.tools) {
    ToolOffsets& entry = tables.tools[number];
    fill(entry.value, tool.values);
    entry.tip = tool.tip;
    entry.radius = tool.radius;
  }
  return tables;
}

}  // namespace

std::vector<std::string_view> group_names() {
  std::vector<std::string_view> names;
  for (const GroupName& g : kGroupNames) names.push_back(g.name);
  return names;
}

int system_of(const std::string& name) {
  if (name == "EXT") return 0;
  if (name.size() == 3 && name[0] == 'G' && name[1] == '5' && name[2] >= '4' && name[2] <= '9')
    return name[2] - '3';
  const auto p = name.find('P');
  if (name.rfind("G54.1", 0) != 0 || p == std::string::npos) return -1;
  int number = 0;
  std::from_chars(name.data() + p + 1, name.data() + name.size(), number);
  return number > 0 && number <= 9999 ? 100 + number : -1;
}

MotionFacts::MotionFacts(std::shared_ptr<const Control> c, const Setup& setup)
    : control(std::move(c)),
      machine(machine_of(*control, setup.machine)),
      codes(*control, machine),
      axis_order(machine == MachineType::Mill ? "XYZABCUVW" : "XZYCABUVW"),
      diameters(machine == MachineType::Mill ? 0 : 1),
      increment(setup.increment > 0 ? setup.increment : 0.001),
      chamfers(control->chamfer_words.value, lathe()),
      rounds(control->round_words.value, lathe()),
      angles(control->angle_words.value, lathe()) {
  number_groups(*this, control->modal_groups.value);
  rapid.fill(control->rapid_rate.value);
  fill(rapid, setup.rapid);
  for (const auto& [number, values] : setup.reference) fill(reference[number], values);
  refused = refused_causes(*control);
  list_conflicts();
  homed = !setup.reference.empty() || !control->home_needed.value;
  for (const auto& [name, range] : setup.limits)
    if (axis_of(name) >= 0) limits.push_back({axis_of(name), range.first, range.second});
}

Motion::Motion(std::shared_ptr<const Control> control, const Setup& setup)
    : facts_(std::make_shared<MotionFacts>(std::move(control), setup)),
      tables_(std::make_shared<OffsetTables>(tables_of(setup, *facts_->control))) {
  line_codes_ = {facts_->codes.of(Meaning::Rapid), facts_->codes.of(Meaning::Line),
                 facts_->codes.of(Meaning::Cw), facts_->codes.of(Meaning::Ccw)};
  for (int i = 0; i < 3; ++i) {
    s_.half[static_cast<std::size_t>(i)] = facts_->share(i) * facts_->share(i);
    const double rate = facts_->rapid[static_cast<std::size_t>(i)];
    s_.rapid_seconds[static_cast<std::size_t>(i)] = rate > 0 ? facts_->share(i) * 60 / rate : 0;
  }
  power_on();
  s_.offset = zero_offset();
  s_.work = Axes{} - s_.offset;
  fill(s_.work, setup.start);
  for (const auto& [name, range] : setup.area)
    if (const int axis = axis_of(name); axis >= 0 && axis < 3) {
      s_.area.low[static_cast<std::size_t>(axis)] = range.first;
      s_.area.high[static_cast<std::size_t>(axis)] = range.second;
      s_.area.known = true;
    }
  s_.tool_at = machine_point();
  settle();
}

void Motion::power_on() {
  const Control& c = *facts_->control;
  const bool lathe = facts_->lathe();
  const auto wake = [this](Meaning meaning) {
    const GCode code = facts_->codes.of(meaning);
    if (code.code >= 0) s_.modal[at(code.group)] = code;
  };
  for (const Meaning meaning :
       {c.power_on_line.value ? Meaning::Line : Meaning::Rapid,
        lathe ? Meaning::PlaneZX : Meaning::PlaneXY,
        c.power_on_incremental.value ? Meaning::Incremental : Meaning::Absolute,
        !lathe || c.power_on_per_minute.value ? Meaning::PerMinute : Meaning::PerRevolution,
        Meaning::SpindleSpeed, Meaning::Metric, Meaning::RadiusOff, Meaning::LengthOff,
        Meaning::CycleOff, Meaning::ReturnInitial, Meaning::ScalingOff, Meaning::MacroOff,
        Meaning::Work1, Meaning::PathCut, Meaning::RotationOff, Meaning::PolarOff,
        Meaning::MirrorOff, c.power_on_stroke_check.value ? Meaning::StrokeOn : Meaning::StrokeOff})
    wake(meaning);
  s_.plane = lathe ? 18 : 17;
  s_.incremental = s_.modal[at(Group::Distance)].meaning == Meaning::Incremental;
  s_.feed = c.power_on_feed.value;
  MultipleData& data = s_.multiple;
  data.finish_passes = c.thread_passes.value;
  data.chamfer = c.thread_chamfer.value;
  data.angle = c.thread_angle.value;
  data.least_cut = c.thread_least_cut.value * 1e-3;
  data.allowance = c.thread_allowance.value * 1e-3;
  data.retract = c.groove_retract.value * 1e-3;
}

std::optional<Fault> Motion::execute(const NcWords& words, std::uint32_t step, Moves* moves,
                                     Outcome& outcome, Outside& outside) {
  if (s_.plain) s_.tool_at = machine_point();
  const MotionState before = s_;
  s_.plain = false;  // from here on tool_at is kept
  const std::size_t rows = moves != nullptr ? moves->size() : 0;
  outcome = {};
  old_offsets_.clear();
  old_tools_.clear();
  auto wrong = run(words, step, moves, outcome, outside);
  if (!wrong && words.stops) {
    settle();
    wrong = end_waiting(step, moves);
  }
  if (wrong) {
    s_ = before;
    put_back();
    if (moves != nullptr) moves->truncate(rows);
    outcome = {};
    return wrong;
  }
  settle();
  return std::nullopt;
}

Motion::Result Motion::run(const NcWords& words, std::uint32_t step, Moves* moves, Outcome& outcome,
                           Outside& outside) {
  BlockWords block{words, step, moves, outcome, outside, {}, false, in_cycle(), false};
  const bool corner_waits = !s_.held.corner.empty(), angle_waits = s_.angled.waiting;
  if (auto wrong = read(block)) return wrong;
  if (auto wrong = check(block)) return wrong;
  if (block.uncomputed >= 0) return fault_of(block.uncomputed, Cause::CodeNotComputed, block);
  if (auto wrong = set_modes(block)) return wrong;
  const Axes length_before = s_.length;
  if (auto wrong = set_length(block)) return wrong;
  if (auto wrong = set_radius(block)) return wrong;
  if (auto wrong = set_longer(block)) return wrong;
  const Meaning once = block.meaning(Group::OneShot);
  if (!goes_with_motion(block, once) && once != Meaning::Ignored) {
    take_motion_code(block);  // it holds for the blocks behind
    if (auto wrong = one_shot(block)) return wrong;
  } else if (once != Meaning::Ignored && !block.consumed) {
    if (auto wrong = motion(block)) return wrong;
  }
  if (auto wrong = move_by_length(block, length_before)) return wrong;
  if (auto wrong = check_angle(block, angle_waits)) return wrong;
  if (corner_waits && !block.submitted) return fault(Cause::CornerNoMove, block);
  // A coordinate system that has been set counts as a move. [source 003, G20 G21 G22]
  if (block.submitted || block.has(Group::Work) || once == Meaning::SetCoordinate ||
      once == Meaning::Local)
    s_.moved_before = true;
  if (!in_range(s_.work) || !in_range(s_.offset) || !in_range(s_.length) || !in_range(s_.skip) ||
      !in_range(std::array{s_.feed, s_.speed, s_.surface_speed, s_.max_speed, s_.polar_angle}))
    return out_of_range(block.words.at);
  return count_idle(block);
}

/// Finds the meanings of the G codes; of two of a group the later counts.
Motion::Result Motion::read(BlockWords& block) const {
  const Control& c = *facts_->control;
  for (int i = 0; i < block.words.g_count; ++i) {
    const int written = block.words.g[static_cast<std::size_t>(i)];
    const GCode code = facts_->codes.find(written);
    if (written == 110 && !s_.data_set && facts_->refuses(Cause::DataEndFirst))
      return fault_of(written, Cause::DataEndFirst, block);
    if (code.meaning == Meaning::Neutral) continue;
    if (code.meaning == Meaning::None) return fault_of(written, Cause::GCodeNotAvailable, block);
    if (code.meaning == Meaning::Unknown) return fault_of(written, Cause::CodeNotKnown, block);
    const bool unmeasured =
        code.meaning == Meaning::MeasureTool && c.measuring.value == Measuring::None;
    if (code.meaning == Meaning::Uncomputed || unmeasured) {
      block.uncomputed = written;
      continue;
    }
    GCode& place = block.codes[at(code.group)];
    if (place.code >= 0 && code.group != Group::OneShot &&
        c.repeated_address.value == RepeatedAddress::Alarm)
      return fault_of(written, Cause::AddressGivenTwice, block);
    for (int j = 0; j < i && place.code >= 0; ++j)
      if (block.words.g[static_cast<std::size_t>(j)] == place.code && place.code != code.code)
        block.outcome.dropped_codes |= static_cast<std::uint16_t>(1u << j);
    place = code;
  }
  return std::nullopt;
}

/// What may not stand together, before anything changes.
Motion::Result Motion::check(const BlockWords& block) const {
  const Control& c = *facts_->control;
  if ((block.words.whole >> kPointedH & 1) != 0 && facts_->machine != MachineType::LatheA)
    return fault_at('H', Cause::IllegalDecimalPoint, block, "H takes no decimal point");
  if (block.has(Group::Units) && c.unit_change.value != UnitChange::Anywhere) {
    const bool shares = c.unit_change.value == UnitChange::Alone && block.words.g_count > 1;
    if (s_.moved_before || shares || (block.words.mask & ~bit('N')) != 0)
      return fault(Cause::UnitChangeLate, block);
  }
  if (!s_.held.corner.empty() && block.has(Group::Plane)) return fault(Cause::CornerPlane, block);
  if (compensating() && block.has(Group::Plane) &&
      block.codes[at(Group::Plane)].code != s_.plane * 10)
    return fault(Cause::CompensationPlane, block);
  return check_conflicts(block);
}

Motion::Result Motion::set_modes(BlockWords& block) {
  for (const Group group : {Group::Plane, Group::Distance, Group::Stroke, Group::Feed, Group::Units,
                            Group::Return, Group::Macro, Group::Surface, Group::Path, Group::Turret,
                            Group::Fluctuation, Group::PolarMilling})
    if (block.has(group)) s_.modal[at(group)] = block.codes[at(group)];
  if (block.has(Group::Plane)) s_.plane = block.codes[at(Group::Plane)].code / 10;
  const bool surface = s_.modal[at(Group::Surface)].meaning == Meaning::SurfaceSpeed;
  // G97 without S keeps the speed that there is. [TDi 25 note 4]
  if (s_.surface && !surface && (s_.work[0] != 0 || s_.max_speed > 0))
    if (const double last = spindle_at(move_state(), std::fabs(s_.work[0])); last > 0)
      s_.speed = last;
  s_.surface = surface;
  const Meaning units = s_.modal[at(Group::Units)].meaning;
  s_.unit = units == Meaning::Inch ? kInch : units == Meaning::Pulses ? facts_->increment : 1;
  s_.incremental = s_.modal[at(Group::Distance)].meaning == Meaning::Incremental;
  if (block.meaning(Group::Stroke) == Meaning::StrokeOn) {
    set_area(block);
    block.consumed = true;
    if (area_is_empty() && facts_->refuses(Cause::StrokeArea))
      return fault(Cause::StrokeArea, block);
  }
  if (auto wrong = set_feed(block)) return wrong;
  set_lead(block);
  if (auto wrong = set_spindle(block)) return wrong;
  if (auto wrong = set_tool(block)) return wrong;
  if (auto wrong = select_work(block)) return wrong;
  if (block.has(Group::Polar)) {
    s_.modal[at(Group::Polar)] = block.codes[at(Group::Polar)];
    s_.polar_known = false;
  }
  return set_turned(block);
}

Motion::Result Motion::set_feed(const BlockWords& block) {
  if (!block.words.has('F')) return std::nullopt;
  const Control& c = *facts_->control;
  if (c.lead_apart.value && cuts_thread(block)) return std::nullopt;
  const Meaning once = block.meaning(Group::OneShot);
  if (c.skip_own_feed.value && (once == Meaning::Skip || once == Meaning::MeasureTool))
    return std::nullopt;
  return feed_of(block, s_.feed);
}

/// F of a block as a feed.
Motion::Result Motion::feed_of(const BlockWords& block, double& feed) const {
  const double value = raw(block, 'F');
  const bool times = s_.modal[at(Group::Feed)].meaning == Meaning::InverseTime;
  double unit = times ? 1 : s_.unit;  // times a minute have no unit of length
  if (!times && (block.words.whole & bit('F')) != 0 &&
      facts_->control->whole_numbers.value == WholeNumbers::Increments)
    unit *= feed_increment();
  const int most = facts_->control->max_feed.value;
  if (value < 0 || (most > 0 && value * unit > most)) return fault(Cause::FeedOutOfRange, block);
  feed = value * unit;
  return std::nullopt;
}

/// What F1 without a point is. [fanuc 5.9]
double Motion::feed_increment() const {
  const bool per_minute = s_.modal[at(Group::Feed)].meaning != Meaning::PerRevolution;
  return (per_minute ? 1 : 0.01) * (g20() ? 0.01 : 1);
}

Motion::Result Motion::set_spindle(const BlockWords& block) {
  if (block.words.has('S')) {
    const double value = raw(block, 'S');
    if (block.meaning(Group::OneShot) == Meaning::SetCoordinate)
      s_.max_speed = value;
    else
      (s_.surface ? s_.surface_speed : s_.speed) = value;
  }
  for (int i = 0; i < block.words.m_count; ++i) {
    const int m = block.words.m[static_cast<std::size_t>(i)];
    if (m >= 3 && m <= 5) s_.spindle = m;
    if (m == 6) s_.tool = s_.t;
    if (m == 29) s_.rigid_waits = facts_->refuses(Cause::RigidMove);
  }
  if (block.has(Group::Cycle)) s_.rigid = std::exchange(s_.rigid_waits, false);
  return std::nullopt;
}

/// Whether a block's motion is made in spite of its one-shot code.
bool Motion::goes_with_motion(const BlockWords& block, Meaning once) const {
  switch (once) {
    case Meaning::None:
    case Meaning::ExactStop:
    case Meaning::Lengthen:
    case Meaning::Shorten:
    case Meaning::LengthenTwice:
    case Meaning::ShortenTwice:
      return true;
    case Meaning::OneWay:
      return !block.has(Group::Motion) && (in_cycle() || block.has(Group::Cycle));
    default:
      return false;
  }
}

Motion::Result Motion::one_shot(BlockWords& block) {
  switch (block.meaning(Group::OneShot)) {
    case Meaning::Dwell:
      return dwell(block);
    case Meaning::SetData:
      return set_data(block);
    case Meaning::CheckReference:
      return check_reference(block);
    case Meaning::Reference:
      return reference(block, 1);
    case Meaning::SecondReference:
      return reference(block, 2);
    case Meaning::FromReference:
      return from_reference(block);
    case Meaning::Skip:
      return skip(block);
    case Meaning::MeasureTool:
      return measure_tool(block);
    case Meaning::OneWay:
      return one_way(block);
    case Meaning::Local:
      return set_local(block);
    case Meaning::Machine:
      return machine_move(block);
    case Meaning::SetCoordinate:
      return set_coordinate(block);
    case Meaning::ClearCoordinate:
      return clear_coordinate(block);
    case Meaning::Finish:
    case Meaning::RoughTurn:
    case Meaning::RoughFace:
    case Meaning::RoughPattern:
      return contour(block, block.meaning(Group::OneShot));
    case Meaning::PeckFace:
    case Meaning::PeckTurn:
      return grooving(block, block.meaning(Group::OneShot));
    case Meaning::MultipleThread:
      return multiple_thread(block);
    default:
      return std::nullopt;
  }
}

void Motion::take_motion_code(const BlockWords& block) {
  if (!block.has(Group::Motion)) return;
  // The taper of a turning cycle ends with it. [TA 6 note 2]
  if (block.meaning(Group::Motion) != s_.modal[at(Group::Motion)].meaning) s_.turn = {};
  s_.modal[at(Group::Motion)] = block.codes[at(Group::Motion)];
  end_cycles();
}

Motion::Result Motion::motion(BlockWords& block) {
  take_motion_code(block);
  if (block.has(Group::Cycle)) {
    if (auto wrong = enter_cycle(block)) return wrong;
  }
  if (in_cycle()) return facts_->lathe() ? drilling_cycle(block) : canned_cycle(block);
  const Meaning meaning = s_.modal[at(Group::Motion)].meaning;
  switch (meaning) {
    case Meaning::Cw:
    case Meaning::Ccw:
      return arc(block, meaning);
    case Meaning::ThreePoints:
    case Meaning::ThreePointsAbsolute:
      return arc_by_points(block, meaning);
    case Meaning::TurnCycle:
    case Meaning::ThreadCycle:
    case Meaning::FaceCycle:
    case Meaning::TapCycle:
      return turning_cycle(block, meaning);
    case Meaning::Thread:
    case Meaning::VariableThread:
      return thread(block, meaning);
    default:
      return straight(block, meaning);
  }
}

Motion::Result Motion::need_feed(const BlockWords& block, Meaning meaning) const {
  if (meaning == Meaning::Rapid) return std::nullopt;
  if (s_.feed <= 0) return fault(Cause::NoFeed, block);
  if (lacks_speed()) return fault(Cause::NoSpeed, block);
  return std::nullopt;
}

/// Whether a cut would wait for a spindle that was never told how fast to turn.
bool Motion::lacks_speed() const {
  const bool revolutions =
      s_.surface || s_.modal[at(Group::Feed)].meaning == Meaning::PerRevolution;
  return revolutions && (s_.surface ? s_.surface_speed : s_.speed) <= 0 &&
         facts_->refuses(Cause::NoSpeed);
}

Motion::Result Motion::straight(BlockWords& block, Meaning meaning) {
  if (double angle = 0; angle_word(block, angle)) return angled(block, meaning, angle);
  std::uint32_t named = 0;
  const Axes end = end_point(block, named);
  if (named == 0) return std::nullopt;
  if (auto wrong = need_feed(block, meaning)) return wrong;
  const MoveKind kind = meaning == Meaning::Rapid ? MoveKind::Rapid : MoveKind::Feed;
  Piece piece = make_piece(block, kind, end, named);
  if (auto wrong = corner_words(block, piece)) return wrong;
  return move(block, piece);
}

/// A corner written with C or U alone, or an angle with A, is no move of that axis.
bool Motion::corner_address(char name) const {
  if (name != 'U' && ((name != 'C' && name != 'A') || !facts_->lathe())) return false;
  return ((facts_->chamfers.mask | facts_->rounds.mask | facts_->angles.mask) & bit(name)) != 0;
}

/// The end point that the words name; the axes without a word stay.
namespace {

/// What a lathe with G code system A writes for increments.
constexpr std::pair<char, char> kIncrements[] = {{'U', 'X'}, {'W', 'Z'}, {'V', 'Y'}, {'H', 'C'}};

}  // namespace

std::string Motion::axes_of(std::uint32_t mask) const {
  const bool lathe_a = facts_->machine == MachineType::LatheA;
  std::string names = "XYZ";
  for (const char name : kAxisNames.substr(3, lathe_a ? 3 : 6))
    if ((mask & bit(name)) != 0) names += name;
  if (lathe_a && (mask & bit('H')) != 0 && (mask & bit('C')) == 0) names += 'C';
  return names;
}

Axes Motion::target(BlockWords& block, std::uint32_t& named) {
  Axes end = turned() ? turned_back(s_.work) : s_.work;
  const bool lathe_a = facts_->machine == MachineType::LatheA;
  // Only a cut has corners: elsewhere C is an axis.
  const Meaning motion = s_.modal[at(Group::Motion)].meaning;
  const bool cuts = motion == Meaning::Line || motion == Meaning::Cw || motion == Meaning::Ccw;
  const bool corners =
      cuts && !in_cycle() && goes_with_motion(block, block.meaning(Group::OneShot));
  for (int i = 0; i < (lathe_a ? 6 : kAxes); ++i) {
    const char name = kAxisNames[static_cast<std::size_t>(i)];
    if (!block.words.has(name) || (corners && corner_address(name))) continue;
    named |= axis_bit(i);
    end[i] = number(block, name) + (s_.incremental ? end[i] : 0);
  }
  for (const auto& [letter, name] : kIncrements) {
    const int axis = axis_of(name);
    if (!lathe_a || !block.words.has(letter)) continue;
    if ((named & axis_bit(axis)) != 0) {
      block.outcome.drop(bit(letter));
      continue;
    }
    named |= axis_bit(axis);
    end[axis] += number(block, letter);
  }
  if (s_.modal[at(Group::Polar)].meaning == Meaning::PolarOn) polar_target(block, end, named);
  if (turned()) turn_point(end, named);
  return end;
}

/// The end point of a move that G45 to G48 may make longer.
Axes Motion::end_point(BlockWords& block, std::uint32_t& named) {
  const Axes end = target(block, named);
  return lengthened(block, end, named);
}

Motion::Result Motion::dwell(BlockWords& block) {
  const NcWords& w = block.words;
  double seconds = 0;
  const Control& c = *facts_->control;
  for (const char letter : c.dwell_words.value) {
    if (!w.has(letter)) continue;
    const bool increments =
        c.dwell_x_increments.value || c.whole_numbers.value == WholeNumbers::Increments;
    const bool milliseconds =
        letter == 'P' ? !c.dwell_p_seconds.value : increments && (w.whole & bit(letter)) != 0;
    seconds = raw(block, letter);
    const bool point = letter == 'P' && ((w.whole | w.computed) & bit('P')) == 0;
    if (point && c.dwell_point.value == DwellPoint::Cut) seconds = std::floor(seconds);
    const bool counts_seconds = point && c.dwell_point.value == DwellPoint::Seconds;
    if (milliseconds && !counts_seconds) seconds *= 0.001;
    for (const char other : c.dwell_words.value)
      if (other != letter) block.outcome.drop(bit(other));
    break;
  }
  if (seconds <= 0) return std::nullopt;
  return wait(block, seconds * dwell_part(block));
}

/// How much of a dwell is waited until a skip signal ends it.
double Motion::dwell_part(const BlockWords& block) const {
  const SignalMask signals = signals_of(block);
  double part = 1;
  if (signals != 0 && block.outside.skips)
    for (const SkipSignal& told : block.outside.skips(signals).told)
      if (told.comes == SkipSignal::Comes::AtFraction) part = std::min(part, told.value);
  return part;
}

Fault Motion::fault(Cause cause, const BlockWords& block, std::string detail) const {
  return {cause, block.words.at, 1, std::move(detail)};
}

Fault Motion::fault_at(char address, Cause cause, const BlockWords& block,
                       std::string detail) const {
  Fault wrong = fault(cause, block, std::move(detail));
  wrong.address = address;
  return wrong;
}

Fault Motion::fault_of(int code, Cause cause, const BlockWords& block) const {
  Fault wrong = fault_at('G', cause, block, code_name(code));
  wrong.code = code;
  return wrong;
}

void Motion::point_at_word(std::string_view block, std::uint32_t text, Fault& fault) const {
  cncsub::point_at_word(facts_->codes, block, text, fault);
}

double Motion::raw(const BlockWords& block, char address) const { return block.words[address]; }

/// The value of an axis or length word in mm or degrees.
double Motion::number(const BlockWords& block, char address) const {
  const NcWords& w = block.words;
  double value = w[address];
  const bool rotary = (address >= 'A' && address <= 'C') || (address == 'H');
  const bool pulses = s_.modal[at(Group::Units)].meaning == Meaning::Pulses;
  const double step = pulses ? 1 : facts_->increment * (!rotary && g20() ? 0.1 : 1);
  if ((w.computed & bit(address)) != 0) {
    const double steps = 1 / step;
    value = std::round(value * steps) / steps;
  } else if ((w.whole & bit(address)) != 0 &&
             facts_->control->whole_numbers.value == WholeNumbers::Increments) {
    value = value / (1 / step);
  }
  // Pulses count on every axis, inches on the straight ones alone. [source 003, G20 G21 G22]
  return rotary && !pulses ? value : value * s_.unit;
}

/// Whether the tool stands elsewhere than its offsets say: the next move takes it there.
bool Motion::tool_waits() const {
  const Axes way = machine_point() - s_.tool_at;
  return std::any_of(way.begin(), way.end(), [](double d) { return std::fabs(d) > 1e-9; });
}

/// What the fast path needs to know.
void Motion::settle() {
  if (s_.plain) s_.tool_at = machine_point();
  const Meaning motion = s_.modal[at(Group::Motion)].meaning;
  const Meaning feed = s_.modal[at(Group::Feed)].meaning;
  s_.row_moves = nullptr;
  s_.line = 0;
  while (s_.line < line_codes_.size() && line_codes_[s_.line].meaning != motion) ++s_.line;
  set_seconds_per_mm();
  s_.plain =
      s_.line < line_codes_.size() && !in_cycle() && !compensating() && !s_.angled.waiting &&
      s_.held.corner.empty() && s_.held.radius.empty() && !s_.held.engaged &&
      feed != Meaning::InverseTime && s_.modal[at(Group::Polar)].meaning != Meaning::PolarOn &&
      !turned() && facts_->limits.empty() && !checks_area() && !s_.surface && !lacks_speed() &&
      !s_.tool_pending && !tool_waits() && !s_.rigid_waits && facts_->control->max_feed.value == 0;
}

std::optional<Fault> Motion::finish(std::uint32_t step, Moves* moves) {
  if (s_.plain) return std::nullopt;
  const MotionState before = s_;
  const std::size_t rows = moves != nullptr ? moves->size() : 0;
  auto wrong = end_waiting(step, moves);
  if (wrong) {
    s_ = before;
    if (moves != nullptr) moves->truncate(rows);
  }
  return wrong;
}

Motion::Result Motion::end_waiting(std::uint32_t step, Moves* moves) {
  if (s_.plain) return std::nullopt;
  NcWords words;
  Outcome outcome;
  Outside outside;
  BlockWords block{words, step, moves, outcome, outside, {}, false, false, false};
  if (!s_.held.corner.empty()) {
    block.submitted = false;
    Fault wrong = fault(Cause::CornerNoMove, block);
    wrong.at = s_.held.corner.back().at;
    wrong.address = s_.held.corner.back().corner;
    return wrong;
  }
  if (s_.angled.waiting)
    return Fault{
        .cause = Cause::AngleNoEnd, .at = s_.angled.piece.at, .detail = {}, .address = 'A'};
  auto wrong = flush_radius(moves);
  settle();
  return wrong;
}

void Motion::reset() {
  const Control& c = *facts_->control;
  if (c.clear_on_reset.value) {
    const GCode work = s_.modal[at(Group::Work)], units = s_.modal[at(Group::Units)];
    const double feed = s_.feed;
    power_on();
    s_.modal[at(Group::Work)] = work;
    s_.modal[at(Group::Units)] = units;
    s_.feed = feed;
  }
  s_.modal[at(Group::Radius)] = facts_->codes.of(Meaning::RadiusOff);
  end_cycles();
  s_.held = {};
  s_.angled = {};
  s_.rigid_waits = s_.data_set = false;
  s_.turned = {};
  if (c.clear_local_on_reset.value) {
    s_.local = {};
    refresh_offset();
  }
  s_.moved_before = false;
  settle();
}

bool Motion::in_cycle() const { return s_.cycle.cycle != Meaning::CycleOff; }
bool Motion::compensating() const {
  const Meaning radius = s_.modal[at(Group::Radius)].meaning;
  return radius == Meaning::RadiusLeft || radius == Meaning::RadiusRight;
}
bool Motion::g20() const { return s_.modal[at(Group::Units)].meaning == Meaning::Inch; }

}  // namespace cncsub
