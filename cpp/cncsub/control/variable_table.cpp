#include "cncsub/control/variable_table.hpp"

#include <algorithm>

#include "cncsub/control/rule_lists.hpp"

namespace cncsub {

namespace {

bool meets(const Span& a, const VariableRange& b) { return a.meets({b.first, b.last}); }

using Spans = std::vector<Span>;
Spans spans_of(const Ranges& list) { return {list.begin(), list.end()}; }

const VariableOption* option_named(const Control& control, std::string_view name) {
  for (const VariableOption& option : control.variable_choices)
    if (option.name == name) return &option;
  return nullptr;
}

/// Return why numbers cannot be commons: they are something else on this control, or with an
/// option.
std::optional<std::string> taken(const Control& control, const Span& span) {
  const auto is = [&span](const VariableRange& range, const std::string& what) {
    const std::int32_t first = std::max(span.first, range.first);
    return span.text() + ": #" + std::to_string(first) + " " + what;
  };
  for (const VariableRange& range : control.variables)
    if (meets(span, range))
      return is(range, range.kind == VariableKind::Vacant  ? "is always vacant"
                       : range.kind == VariableKind::Local ? "is a local variable"
                                                           : "is a system variable of the control");
  for (const VariableOption& option : control.variable_choices)
    for (const VariableRange& range : option.variables)
      if (meets(span, range))
        return is(range, "is a system variable of the control, with the option " + option.name);
  if (control.macros.variable_forms.value.has(VariableForm::Indirect) && span.meets({9000, 9999}))
    return span.text() + ": #9000 to #9999 are #[#0] to #[#999] on this control";
  return std::nullopt;
}

std::optional<std::string> wrong_entry(const Control& control, std::string_view entry) {
  const auto span = Span::read(entry);
  if (!span) {
    std::vector<std::string_view> known;
    for (const VariableOption& option : control.variable_choices)
      if (!option.commons.empty()) known.push_back(option.name);
    return std::string(entry.substr(0, 100)) +
           " is neither a range of numbers nor an option: write 100-199" + near_words(entry, known);
  }
  if (span->last < span->first)
    return span->text() + " ends before it begins: write " + Span{span->last, span->first}.text();
  return taken(control, *span);
}

/// Join spans by number; where options name the same ones, each stands once.
Spans joined(Spans spans) {
  std::sort(spans.begin(), spans.end(),
            [](const Span& a, const Span& b) { return a.first < b.first; });
  Spans whole;
  for (const Span& span : spans)
    if (whole.empty() || span.first > whole.back().last)
      whole.push_back(span);
    else
      whole.back().last = std::max(whole.back().last, span.last);
  return whole;
}

std::optional<std::string> overlap(Spans given) {
  std::sort(given.begin(), given.end(),
            [](const Span& a, const Span& b) { return a.first < b.first; });
  for (std::size_t i = 1; i < given.size(); ++i)
    if (given[i - 1].meets(given[i]))
      return given[i - 1].text() + " and " + given[i].text() + " overlap";
  return std::nullopt;
}

std::optional<std::string> too_many(const Spans& spans) {
  std::int64_t count = 0;
  for (const Span& span : spans) count += std::int64_t{span.last} - span.first + 1;
  if (count <= kMostCommons) return std::nullopt;
  return std::to_string(count) + " variables are more than a run can hold: at most " +
         std::to_string(kMostCommons);
}

/// Return which common is missing of those that the control writes the position of a skip into.
std::optional<std::string> lacking(const Control& control, const Spans& spans) {
  const int first = control.motion.skip_variables.value;
  if (first <= 0 || spans.empty()) return std::nullopt;
  for (int number = first; number < first + kSkipAxes; ++number)
    if (std::none_of(spans.begin(), spans.end(),
                     [number](const Span& span) { return span.has(number); }))
      return "#" + std::to_string(number) + " is missing: G31 writes to it";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> change_commons(const Control& control, Ranges& list,
                                          std::string_view text) {
  if (text.starts_with('=')) text.remove_prefix(1);
  Spans spans, given;
  for (const std::string_view entry : split_entries(text)) {
    const VariableOption* option = option_named(control, entry);
    if (option != nullptr && !option->commons.empty()) {
      const auto of_option = spans_of(option->commons);
      spans.insert(spans.end(), of_option.begin(), of_option.end());
      continue;
    }
    if (auto wrong = wrong_entry(control, entry)) return "commons: " + *wrong;
    if (const auto span = Span::read(entry)) given.push_back(*span);
  }
  if (auto wrong = overlap(given)) return "commons: " + *wrong;
  spans.insert(spans.end(), given.begin(), given.end());
  const Spans all = joined(std::move(spans));
  if (auto wrong = too_many(all)) return "commons: " + *wrong;
  if (auto wrong = lacking(control, all)) return "commons: " + *wrong;
  Ranges changed;
  for (const Span& span : all)
    if (!changed.put(span))
      return "commons: " + std::to_string(all.size()) + " ranges are more than the " +
             std::to_string(SpanEntry::kMost) +
             " that a control can hold: write 100-199, not each number";
  list = changed;
  return std::nullopt;
}

std::optional<std::string> change_variable_options(const Control& control, VariableOptions& list,
                                                   std::string_view text) {
  std::vector<std::string_view> known;
  for (const VariableOption& option : control.variable_choices)
    if (option.commons.empty()) known.push_back(option.name);
  return change_list("variable_options", list, text, [&known](std::string_view entry) {
    return one_of("option that adds variables", entry, known);
  });
}

bool is_fitted(const Control& control, const VariableOption& option) {
  if (option.commons.empty()) {
    const auto fitted = split_entries(control.macros.variable_options.value);
    return std::find(fitted.begin(), fitted.end(), option.name) != fitted.end();
  }
  const Spans held = joined(spans_of(control.macros.commons.value));
  const Spans brings = spans_of(option.commons);
  return std::all_of(brings.begin(), brings.end(), [&held](const Span& span) {
    return std::any_of(held.begin(), held.end(), [&span](const Span& of) {
      return of.first <= span.first && span.last <= of.last;
    });
  });
}

namespace {

Spans spans_brought(const VariableOption& option) {
  Spans spans = spans_of(option.commons);
  for (const VariableRange& range : option.variables) spans.push_back({range.first, range.last});
  return spans;
}

}  // namespace

std::string numbers_of(const VariableOption& option) {
  std::string text;
  for (const Span& span : spans_brought(option)) text += (text.empty() ? "" : " ") + span.text();
  return text;
}

bool is_alias(const VariableRange& range) {
  return range.from > 0 && range.kind == VariableKind::Kept;
}

namespace {

/// Add the names of commons whose commons the control has.
void add_alias(std::vector<VariableRange>& ranges, const VariableRange& alias,
               const Spans& commons) {
  for (const Span& span : commons) {
    VariableRange part = alias;
    part.from = std::max(alias.from, span.first);
    const std::int32_t last = std::min(alias.from + (alias.last - alias.first), span.last);
    part.first = alias.first + (part.from - alias.from);
    part.last = part.first + (last - part.from);
    if (part.first <= part.last) ranges.push_back(part);
  }
}

}  // namespace

std::vector<VariableRange> variable_ranges(const Control& control) {
  std::vector<VariableRange> ranges;
  const Spans commons = spans_of(control.macros.commons.value);
  for (const VariableRange& range : control.variables)
    if (is_alias(range))
      add_alias(ranges, range, commons);
    else
      ranges.push_back(range);
  for (const Span& span : commons) {
    const auto add = [&](std::int32_t first, std::int32_t last, VariableKind kind) {
      VariableRange range;
      range.first = first;
      range.last = last;
      range.kind = kind;
      if (first <= last) ranges.push_back(range);
    };
    add(span.first, std::min(span.last, kFirstKept - 1), VariableKind::Common);
    add(std::max(span.first, kFirstKept), span.last, VariableKind::Kept);
  }
  for (const VariableOption& option : control.variable_choices)
    if (!option.variables.empty() && is_fitted(control, option))
      ranges.insert(ranges.end(), option.variables.begin(), option.variables.end());
  std::sort(ranges.begin(), ranges.end(),
            [](const VariableRange& a, const VariableRange& b) { return a.first < b.first; });
  return ranges;
}

std::string no_variable(const Control& control, std::string_view sign, std::int64_t number) {
  return "there is no " + std::string(sign) + std::to_string(number) + option_with(control, number);
}

std::string option_with(const Control& control, std::int64_t number) {
  if (number < 0 || number > Span::kLargest) return "";
  const auto at = static_cast<std::int32_t>(number);
  for (const VariableOption& option : control.variable_choices)
    for (const Span& span : spans_brought(option))
      if (span.has(at))
        return "; a control with the option " + option.name + " (" + option.meaning +
               ") has it: control.replace(" +
               (option.commons.empty() ? "variable_options" : "commons") + "=\"" + option.name +
               "\")";
  return "";
}

namespace {

/// What is told of a kind: the group in which its variables are shown, and what they hold, or do.
struct KindText {
  VariableKind kind;
  std::string_view group, holds;
};
constexpr KindText kKinds[] = {
    {VariableKind::Vacant, "locals", "is always vacant"},
    {VariableKind::Local, "locals", "a local variable of the program that runs, at its level"},
    {VariableKind::LevelImage, "locals", "the local variables of a level, by its number"},
    {VariableKind::Common, "commons", "a variable of all programs, cleared at power-off"},
    {VariableKind::Kept, "commons", "a variable of all programs, kept at power-off"},
    {VariableKind::Input, "signals", "a signal from the machine, 0 or 1"},
    {VariableKind::InputWord, "signals", "signals from the machine, as one number"},
    {VariableKind::Output, "signals", "a signal to the machine, 0 or 1"},
    {VariableKind::OutputWord, "signals", "signals to the machine, as one number"},
    {VariableKind::UserAlarm, "settings", "raises an alarm of the program, with the text after it"},
    {VariableKind::Milliseconds, "clock", "a clock that counts milliseconds"},
    {VariableKind::Hours, "clock", "a clock that counts hours"},
    {VariableKind::Control1, "settings",
     "switches of the automatic operation: single block, feed hold"},
    {VariableKind::Settings, "settings", "settings of the control, bit by bit"},
    {VariableKind::Message, "settings", "stops the program and shows the text after it"},
    {VariableKind::Mirror, "settings", "the axes that are mirrored, bit by bit"},
    {VariableKind::Restart, "settings", "whether the program is being restarted"},
    {VariableKind::Date, "clock", "the date, as YYYYMMDD"},
    {VariableKind::Time, "clock", "the time of the day, as HHMMSS"},
    {VariableKind::PartsCount, "settings", "a count of parts"},
    {VariableKind::ModalCode, "modes", "the code in force of a G group, before this block"},
    {VariableKind::ModalWord, "modes", "the value in force of an address, before this block"},
    {VariableKind::ActiveCode, "modes", "the code in force of a G group, in this block"},
    {VariableKind::ActiveWord, "modes", "the value in force of an address, in this block"},
    {VariableKind::BlockEnd, "position", "where the block before ended, in work coordinates"},
    {VariableKind::MachinePosition, "position", "where an axis stands, in machine coordinates"},
    {VariableKind::WorkPosition, "position", "where an axis stands, in work coordinates"},
    {VariableKind::SkipPosition, "position", "where the last skip ended, in work coordinates"},
    {VariableKind::SkipTouched, "position", "whether the signal of the last skip came"},
    {VariableKind::MeasuredPosition, "position",
     "where the last skip ended, in the frame of its block"},
    {VariableKind::MeasuredMachine, "position",
     "where the last skip ended, in machine coordinates"},
    {VariableKind::ActiveLength, "tool offsets", "the length offset in force"},
    {VariableKind::ToolLength, "tool offsets", "the length of the tool in the spindle"},
    {VariableKind::ServoError, "position", "how far an axis is behind its command"},
    {VariableKind::WorkOffset, "work offsets", "an offset of a work coordinate system"},
    {VariableKind::AxisWorkOffset, "work offsets",
     "an offset of a work coordinate system, axis by axis"},
    {VariableKind::Shift, "work offsets", "the shift of the coordinates, and whether it counts"},
    {VariableKind::ReferencePoint, "work offsets", "a reference point, in machine coordinates"},
    {VariableKind::MessageSwitch, "settings", "whether messages are shown"},
    {VariableKind::WorkSystem, "work offsets", "which work coordinate system is in force"},
    {VariableKind::ExtraWorkOffset, "work offsets",
     "an offset of a further work coordinate system"},
    {VariableKind::LengthWear, "tool offsets", "the wear of a tool's length"},
    {VariableKind::LengthGeometry, "tool offsets", "the length of a tool"},
    {VariableKind::RadiusWear, "tool offsets", "the wear of a tool's radius"},
    {VariableKind::RadiusGeometry, "tool offsets", "the radius of a tool"},
    {VariableKind::EdgeDatum, "tool offsets", "a datum of an edge of a tool"},
    {VariableKind::ToolName, "tool offsets", "the name of a tool"},
    {VariableKind::ParameterChoice, "settings", "which parameter of the control is read"},
    {VariableKind::ParameterValue, "settings", "the value of the parameter that was chosen"},
    {VariableKind::StoredFrame, "work offsets", "the frame of a work system"},
    {VariableKind::FrameInForce, "work offsets", "a frame in force"},
    {VariableKind::FrameNumber, "work offsets", "which of the stored frames is in force"}};

/// Return whether every kind has its row, in their order.
constexpr bool are_all_told() {
  for (std::size_t i = 0; i < std::size(kKinds); ++i)
    if (kKinds[i].kind != static_cast<VariableKind>(i)) return false;
  return kKinds[std::size(kKinds) - 1].kind == VariableKind::FrameNumber;
}
static_assert(are_all_told());

}  // namespace

std::string_view group_of(VariableKind kind) {
  return kKinds[static_cast<std::size_t>(kind)].group;
}

std::string_view what_it_holds(VariableKind kind) {
  return kKinds[static_cast<std::size_t>(kind)].holds;
}

}  // namespace cncsub
