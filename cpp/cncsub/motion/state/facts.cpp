// What a control and a setup say about the motion, once and for all.
#include "cncsub/motion/state/facts.hpp"

#include <algorithm>
#include <charconv>

#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

void number_groups(MotionFacts& facts) {
  for (const GroupName& g : kGroupNames)
    facts.group_numbers[at(g.group)] = facts.lathe() ? g.lathe : g.mill;
  for (const auto& own : facts.control->motion.modal_groups.value)
    facts.group_numbers[at(own.group)] = own.number;
}

/// Return the place of a corner word in a block's mask, -1 where the machine has none of that name.
int place_of(CornerLetters::Entry word, bool lathe) {
  if (word.comma) return comma_place(word.letter);
  const bool of_lathes = word.letter == 'A' || word.letter == 'C' || word.letter == 'R';
  return of_lathes && !lathe ? -1 : word.letter - 'A';
}

}  // namespace

/// The extra system of the code that leaves the work systems.
constexpr int kNoSystem = 100;

void fill(Axes& axes, const std::map<char, double>& values) {
  for (const auto& [name, value] : values)
    if (const int axis = axis_of(name); axis >= 0) axes[static_cast<std::size_t>(axis)] = value;
}

int system_of(const std::string& name) {
  constexpr std::string_view kExtra = "G54.1 P";
  const auto number_from = [&](std::size_t at) {
    int number = -1;
    const char* const end = name.data() + name.size();
    const auto read = std::from_chars(name.data() + at, end, number);
    return read.ec == std::errc() && read.ptr == end ? number : -1;
  };
  if (name == "EXT") return 0;
  if (name.size() == 3 && name.starts_with("G5") && name[2] >= '4' && name[2] <= '9')
    return name[2] - '3';
  if (name.size() == 4 && name.starts_with("G5")) {  // G505 to G599, and G500
    const int extra = number_from(2);
    if (extra == 0) return 6 + kNoSystem;
    return extra >= 5 ? 6 + extra : -1;
  }
  if (!name.starts_with(kExtra) || name.size() == kExtra.size() || name[kExtra.size()] == '0')
    return -1;
  const int number = number_from(kExtra.size());
  return number > 0 && number <= 9999 ? 6 + number : -1;
}

bool has_system(const Control& control, const std::string& name) {
  const int system = system_of(name);
  if (system < 0) return false;
  const bool by_codes = control.motion.extra_system_codes.value != 0;  // G505
  if (system > 6)
    return (name.size() == 4) == by_codes && system <= 6 + control.motion.max_extra_systems.value;
  // G58 and G59 are no work systems on every control that has G54. One without any stands in the
  // first.
  const GCodes codes(control, control.motion.machine.value);
  const auto is_work = [&](int of) { return codes.find(of * 10 + 530).group == Group::Work; };
  return system <= 1 || is_work(system) || !is_work(1);
}

MotionFacts::MotionFacts(std::shared_ptr<const Control> c, const Setup& setup,
                         std::shared_ptr<const CodeMeanings> of, bool general)
    : control(std::move(c)),
      meanings(std::move(of)),
      machine(meanings->machine),
      codes(meanings->g),
      path_codes{codes.of(Meaning::Rapid), codes.of(Meaning::Line), codes.of(Meaning::Cw),
                 codes.of(Meaning::Ccw)},
      axis_order(machine == MachineType::Mill ? "XYZABCUVW" : "XZYCABUVW"),
      diameters(machine == MachineType::Mill ? 0 : 1),
      increment(setup.increment > 0 ? setup.increment : 0.001),
      chamfers(control->motion.chamfer_words.value, lathe()),
      rounds(control->motion.round_words.value, lathe()),
      angles(control->motion.angle_words.value, lathe()),
      keeps_heading(general || std::any_of(meanings->blocks.begin(), meanings->blocks.end(),
                                           [](const BlockCodes& block) {
                                             return block.all.test(at(Meaning::TangentArc));
                                           })),
      general_only(general || keeps_heading) {
  number_groups(*this);
  constexpr std::uint32_t kOthers = bit('A') | bit('B') | bit('C') | bit('U') | bit('V') | bit('W');
  const std::uint32_t corners = chamfers.mask | rounds.mask | angles.mask;
  if (!lathe()) other_axes = kOthers & ~corners;
  const MotionRules& rules = control->motion;
  for (const Letters* words : {&rules.modal_round_words.value, &rules.modal_corner_feed_words.value,
                               &rules.contour_offset_words.value})
    for (const char name : *words) contour_modes |= bit(name);
  if (machine == MachineType::LatheA) increments = (bit('U') | bit('W')) & ~corners;
  rapid.fill(control->motion.rapid_rate.value);
  fill(rapid, setup.rapid);
  for (const auto& [number, values] : setup.reference) fill(reference[number], values);
  list_conflicts();
  homed = !setup.reference.empty();
  for (const auto& [name, range] : setup.limits)
    if (axis_of(name) >= 0) limits.push_back({axis_of(name), range.first, range.second});
}

CornerWords::CornerWords(const CornerLetters& words, bool lathe) {
  for (const auto& word : words) {
    const int place = place_of(word, lathe);
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
