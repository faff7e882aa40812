// What a control and a setup say about the motion, once and for all.
#include "cncsub/motion/facts.hpp"

#include <algorithm>
#include <charconv>

#include "cncsub/control/rule_lists.hpp"

namespace cncsub {
namespace {

MachineType machine_of(const Control& control, const std::string& name) {
  const auto& names = options<MachineType>();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i].slug == name) return static_cast<MachineType>(i);
  return control.motion.machine.value;
}

struct GroupName {
  std::string_view name;
  Group group;
  int mill, lathe;  // #4000 + this
};

// [REG; general knowledge of lathes]
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

/// The place of a corner word in a block's mask, -1 where the machine has none of that name.
int place_of(std::string_view name, bool lathe) {
  if (name == ",C") return kCommaC;
  if (name == ",R") return kCommaR;
  if (name == ",A") return kCommaA;
  const bool of_lathes = name == "A" || name == "C" || name == "R";
  return name.size() != 1 || (of_lathes && !lathe) ? -1 : name[0] - 'A';
}

}  // namespace

void fill(Axes& axes, const std::map<char, double>& values) {
  for (const auto& [name, value] : values)
    if (const int axis = axis_of(name); axis >= 0) axes[static_cast<std::size_t>(axis)] = value;
}

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
      path_codes{codes.of(Meaning::Rapid), codes.of(Meaning::Line), codes.of(Meaning::Cw),
                 codes.of(Meaning::Ccw)},
      axis_order(machine == MachineType::Mill ? "XYZABCUVW" : "XZYCABUVW"),
      diameters(machine == MachineType::Mill ? 0 : 1),
      increment(setup.increment > 0 ? setup.increment : 0.001),
      chamfers(control->motion.chamfer_words.value, lathe()),
      rounds(control->motion.round_words.value, lathe()),
      angles(control->motion.angle_words.value, lathe()),
      skips(*control),
      measuring(measuring_moves(*control)) {
  number_groups(*this, control->motion.modal_groups.value);
  rapid.fill(control->motion.rapid_rate.value);
  fill(rapid, setup.rapid);
  for (const auto& [number, values] : setup.reference) fill(reference[number], values);
  list_conflicts();
  homed = !setup.reference.empty();
  for (const auto& [name, range] : setup.limits)
    if (axis_of(name) >= 0) limits.push_back({axis_of(name), range.first, range.second});
}

CornerWords::CornerWords(std::string_view names, bool lathe) {
  for (const std::string_view name : split_entries(names)) {
    const int place = place_of(name, lathe);
    if (place < 0) continue;
    places.push_back(place);
    mask |= 1u << place;
  }
}

int CornerWords::find(std::uint32_t words) const {
  if ((words & mask) == 0) return -1;
  const auto has = [&](int place) { return (words >> place & 1) != 0; };
  return *std::find_if(places.begin(), places.end(), has);
}

}  // namespace cncsub
