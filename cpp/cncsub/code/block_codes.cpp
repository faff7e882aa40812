#include "cncsub/code/block_codes.hpp"

#include <algorithm>

namespace cncsub {
namespace {

bool is_computed(const Control& c, Meaning meaning) {
  if (meaning == Meaning::MeasureTool) return c.motion.measuring.value != Measuring::None;
  return meaning != Meaning::Uncomputed;
}

/// Whether a code is nothing but a mode to be remembered, as far as that is known without a run.
bool is_plain(const CodeMeanings& meanings, const GCode& code) {
  switch (code.group) {
    case Group::OneShot:
      return code.meaning == Meaning::ExactStop || code.meaning == Meaning::Machine;
    case Group::Motion:
      return code.meaning >= Meaning::Rapid && code.meaning <= Meaning::Ccw &&
             meanings.g.of(code.meaning).code == code.code;
    case Group::Plane:
    case Group::Distance:
    case Group::Return:
    case Group::Work:
      return true;
    case Group::Feed:
      return meanings.control.motion.feed_mode_change.value == FeedModeChange::KeepsFeed;
    case Group::Units:
      return meanings.control.motion.unit_change.value == UnitChange::Anywhere &&
             meanings.control.motion.feed_unit.value == FeedUnit::OfBlock;
    case Group::Radius:
      return code.meaning == Meaning::RadiusOff;
    case Group::Cycle:
      return code.meaning == Meaning::CycleOff;
    case Group::Length:
      return code.which == 0 && meanings.machine == MachineType::Mill;
    default:
      return false;
  }
}

bool is_of_path(const CodeMeanings& meanings, const GCode& code) {
  return code.group == Group::Radius || (code.group == Group::Motion && is_plain(meanings, code));
}

/// Why a code alarms wherever it stands.
std::optional<Cause> refusal(Meaning meaning) {
  if (meaning == Meaning::None) return Cause::GCodeNotAvailable;
  if (meaning == Meaning::Unknown) return Cause::CodeNotKnown;
  return std::nullopt;
}

std::size_t hash(const CodeList& list) {
  std::uint64_t mixed = list.g_count;
  const auto mix = [&mixed](int code) {
    mixed = (mixed ^ static_cast<std::uint32_t>(code)) * 0x9e3779b97f4a7c15U;
    mixed ^= mixed >> 29U;
  };
  for (const int code : list.g()) mix(code);
  for (const int code : list.m()) mix(code);
  return static_cast<std::size_t>(mixed);
}

}  // namespace

BlockCodes::BlockCodes(const CodeList& list, const CodeMeanings& meanings) : CodeList(list) {
  for (std::size_t i = 0; i < g_count && take(i, meanings); ++i) {
  }
  for (const int code : g()) uses |= meanings.uses.of_g(code);
  for (const int code : m()) {
    uses |= meanings.uses.of_m(code);
    roles |= 1U << static_cast<unsigned>(meanings.control.calls.roles.value.of_m(code));
  }
}

/// False where the code alarms: those behind it are not looked at.
bool BlockCodes::take(std::size_t place, const CodeMeanings& meanings) {
  const Control& c = meanings.control;
  const int written = g_codes[place];
  const GCode code = meanings.g.find(written);
  all.set(at(code.meaning));
  const auto refused = [&](Cause cause) {
    wrong = written;
    why = cause;
    return plain = of_path = false;
  };
  if (code.meaning == Meaning::DataEnd && c.common.refuses.value.has(Cause::DataEndFirst) &&
      data_end < 0)
    data_end = written;
  if (const auto cause = refusal(code.meaning)) return refused(*cause);
  plain = plain && (code.meaning == Meaning::Neutral || is_plain(meanings, code));
  of_path = of_path && is_of_path(meanings, code);
  if (is_neutral(code.meaning)) return true;
  if (!is_computed(c, code.meaning)) {
    uncomputed = written;
    of_path = false;
    return true;
  }
  GCode& kept = of[at(code.group)];
  if (kept.code >= 0) {
    plain = of_path = false;
    if (code.group != Group::OneShot && c.reading.repeated_address.value == RepeatedAddress::Alarm)
      return refused(Cause::AddressGivenTwice);
    if (kept.code != code.code) drop(kept.code, place);
  }
  kept = code;
  groups |= bit(code.group);
  return true;
}

/// A code does not count that stands before a place.
void BlockCodes::drop(int tenfold, std::size_t before) {
  for (std::size_t i = 0; i < before; ++i)
    if (g_codes[i] == tenfold) dropped = static_cast<std::uint16_t>(dropped | 1U << i);
}

int CodeLists::keep(const CodeList& list) {
  if (2 * (lists_.size() + 1) > slots_.size()) grow();
  std::int16_t& kept = slots_[slot_of(list)];
  if (kept > 0) return kept - 1;
  if (lists_.size() >= most_) return -1;
  lists_.push_back(list);
  kept = static_cast<std::int16_t>(lists_.size());
  return kept - 1;
}

int CodeLists::keep_single(std::size_t tenfold) {
  CodeList list;
  list.add_g(static_cast<int>(tenfold));
  const int kept = keep(list);
  if (tenfold < singles_.size()) singles_[tenfold] = static_cast<std::int16_t>(kept + 1);
  return kept;
}

/// Where a list stands in the table, or would.
std::size_t CodeLists::slot_of(const CodeList& list) const {
  const std::size_t most = slots_.size() - 1;
  std::size_t slot = hash(list) & most;
  while (slots_[slot] > 0 && lists_[static_cast<std::size_t>(slots_[slot] - 1)] != list)
    slot = (slot + 1) & most;
  return slot;
}

void CodeLists::grow() {
  if (slots_.size() > 2 * kMostLists) return;
  slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), 0);
  for (std::size_t i = 0; i < lists_.size(); ++i)
    slots_[slot_of(lists_[i])] = static_cast<std::int16_t>(i + 1);
}

CodeMeanings::CodeMeanings(const Control& of, MachineType type, const CodeLists& lists,
                           std::span<const WordUse> word_uses)
    : control(of), machine(type), g(of, type), uses(word_uses) {
  blocks.reserve(lists.all().size());
  for (const CodeList& list : lists.all()) blocks.emplace_back(list, *this);
}

}  // namespace cncsub
