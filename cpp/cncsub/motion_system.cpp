// What system variables and reports read of the motion state, and write to the offset tables.
#include <atomic>
#include <cstdio>

#include "cncsub/motion_facts.hpp"

namespace cncsub {
namespace {

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

}  // namespace

int Motion::axis_number(int axis) const {
  const std::string& order = facts_->axis_order;
  if (axis < 0 || axis >= static_cast<int>(order.size())) return -1;
  return axis_of(order[static_cast<std::size_t>(axis)]);
}

/// A position as variables show it: in the unit of the program.
double Motion::shown(int axis, const Axes& values) const {
  const int i = axis_number(axis);
  if (i < 0) return 0;
  return is_rotary(i) || !g20() ? values[static_cast<std::size_t>(i)]
                                : values[static_cast<std::size_t>(i)] / kInch;
}

double Motion::modal_code(int group) const {
  for (std::size_t g = 0; g < kGroups; ++g)
    if (facts_->group_numbers[g] == group && group > 0 && s_.modal[g].code >= 0)
      return s_.modal[g].code / 10.0;
  return kVacant;
}

double Motion::modal_word(char address) const {
  switch (address) {
    case 'B':
      return s_.b;
    case 'D':
      return s_.d;
    case 'F':
      return s_.modal[at(Group::Feed)].meaning == Meaning::InverseTime ? s_.feed
                                                                       : s_.feed / s_.unit;
    case 'H':
      return s_.h;
    case 'P':
      return s_.work_system == 0 ? s_.extra_system : 0;
    case 'S':
      return s_.surface ? s_.surface_speed : s_.speed;
    case 'T':
      return s_.t;
    default:
      return kVacant;
  }
}

double Motion::block_end(int axis) const { return shown(axis, s_.work); }

double Motion::machine_position(int axis) const {
  return shown(axis, s_.plain ? machine_point() : s_.tool_at);
}

double Motion::work_position(int axis) const {
  return shown(axis, (s_.plain ? machine_point() : s_.tool_at) - s_.offset);
}

double Motion::skip_position(int axis) const { return shown(axis, s_.skip); }

double Motion::active_length(int axis) const { return shown(axis, s_.length + s_.tool_shift); }

double Motion::work_offset(int system, int axis) const {
  if (system < 0 || system > 6) return 0;
  return shown(axis, tables_->work[static_cast<std::size_t>(system)]);
}

OffsetTables& Motion::own_tables() {
  if (tables_.use_count() > 1) tables_ = std::make_shared<OffsetTables>(*tables_);
  // A copy that another thread has given up has read its last before this one writes.
  std::atomic_thread_fence(std::memory_order_acquire);
  return *tables_;
}

/// An offset of the tables that a block is about to change.
double& Motion::changed(double& place) {
  old_offsets_.emplace_back(&place, place);
  return place;
}

ToolOffsets& Motion::changed_tool(int number) {
  auto& tools = tables_->tools;
  const auto found = tools.find(number);
  old_tools_.emplace_back(number,
                          found == tools.end() ? std::nullopt : std::optional(found->second));
  return tools[number];
}

/// The tables as they were before the block.
void Motion::put_back() {
  for (; !old_offsets_.empty(); old_offsets_.pop_back())
    *old_offsets_.back().first = old_offsets_.back().second;
  for (; !old_tools_.empty(); old_tools_.pop_back()) {
    auto& [number, before] = old_tools_.back();
    if (before)
      tables_->tools[number] = *before;
    else
      tables_->tools.erase(number);
  }
}

void Motion::write(Axes& values, int axis, double value) {
  const int i = axis_number(axis);
  if (i < 0) return;
  values[static_cast<std::size_t>(i)] = is_rotary(i) || !g20() ? value : value * kInch;
  refresh_offset();
  settle();
}

void Motion::set_work_offset(int system, int axis, double value) {
  if (system >= 0 && system <= 6)
    write(own_tables().work[static_cast<std::size_t>(system)], axis, value);
}

double Motion::extra_offset(int p, int axis) const {
  if (p < 1 || p > static_cast<int>(tables_->extra.size())) return 0;
  return shown(axis, tables_->extra[static_cast<std::size_t>(p - 1)]);
}

void Motion::set_extra_offset(int p, int axis, double value) {
  if (p >= 1 && p <= static_cast<int>(tables_->extra.size()))
    write(own_tables().extra[static_cast<std::size_t>(p - 1)], axis, value);
}

double Motion::offset(VariableKind kind, int number) const {
  const std::vector<double>* table = table_of(*tables_, kind);
  if (table == nullptr || number < 0 || number >= static_cast<int>(table->size())) return 0;
  return (*table)[static_cast<std::size_t>(number)] / (g20() ? kInch : 1);
}

void Motion::set_offset(VariableKind kind, int number, double value) {
  auto* table = const_cast<std::vector<double>*>(table_of(own_tables(), kind));
  if (table == nullptr || number < 0 || number >= static_cast<int>(table->size())) return;
  (*table)[static_cast<std::size_t>(number)] = value * (g20() ? kInch : 1);
}

const std::vector<double>* Motion::table_of(const OffsetTables& tables, VariableKind kind) {
  switch (kind) {
    case VariableKind::LengthWear:
      return &tables.length_wear;
    case VariableKind::LengthGeometry:
      return &tables.length;
    case VariableKind::RadiusWear:
      return &tables.radius_wear;
    case VariableKind::RadiusGeometry:
      return &tables.radius;
    default:
      return nullptr;
  }
}

double Motion::scaled(char address, double value) const {
  if (facts_->control->whole_numbers.value != WholeNumbers::Increments) return value;
  if (address == 'F') return value * feed_increment() * 1;
  if (address >= 'A' && address <= 'C') return value / (1 / facts_->increment);
  constexpr std::string_view kLengths = "IJKQRUVWXYZ";
  if (kLengths.find(address) == std::string_view::npos) return value;
  return value / (1 / (facts_->increment * (g20() ? 0.1 : 1)));
}

double Motion::increment(char address) const {
  if (address == 'H') return facts_->machine == MachineType::LatheA ? facts_->increment : 0;
  constexpr std::string_view kLengths = "ABCIJKQRUVWXYZ";
  if (kLengths.find(address) == std::string_view::npos) return 0;
  return facts_->increment * (g20() && address > 'C' ? 0.1 : 1);
}

std::vector<std::pair<std::string, double>> Motion::position() const {
  std::vector<std::pair<std::string, double>> list;
  for (int i = 0; i < kAxes; ++i) {
    const bool always = i < 3 && (i != 1 || !facts_->lathe());
    if (always || s_.work[i] != 0 || (s_.named >> i & 1) != 0)
      list.emplace_back(std::string(1, kAxisNames[static_cast<std::size_t>(i)]), s_.work[i]);
  }
  return list;
}

std::vector<std::pair<std::string, std::string>> Motion::modal() const {
  static constexpr std::pair<const char*, Group> kNames[] = {
      {"motion", Group::Motion},   {"plane", Group::Plane},       {"distance", Group::Distance},
      {"feed_mode", Group::Feed},  {"units", Group::Units},       {"radius", Group::Radius},
      {"length", Group::Length},   {"cycle", Group::Cycle},       {"return", Group::Return},
      {"scaling", Group::Scaling}, {"surface", Group::Surface},   {"work", Group::Work},
      {"path", Group::Path},       {"rotation", Group::Rotation}, {"polar", Group::Polar},
      {"mirror", Group::Mirror},   {"stroke", Group::Stroke}};
  std::vector<std::pair<std::string, std::string>> list;
  for (const auto& [name, group] : kNames) {
    const int code = s_.modal[at(group)].code;
    if (code < 0) continue;
    std::string text = code_name(code);
    if (group == Group::Work && s_.work_system == 0 && s_.modal[at(group)].system == 0)
      text += " P" + std::to_string(s_.extra_system);
    list.emplace_back(name, text);
  }
  for (const char word : {'F', 'S', 'T', 'H', 'D'})
    list.emplace_back(std::string(1, word), number_text(modal_word(word)));
  return list;
}

}  // namespace cncsub
