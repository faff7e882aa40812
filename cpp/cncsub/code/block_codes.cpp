#include "cncsub/code/block_codes.hpp"

#include <algorithm>

namespace cncsub {
namespace {

bool is_computed(const Control& c, Meaning meaning) {
  if (meaning == Meaning::MeasureTool) return c.motion.measuring.value != Measuring::None;
  return meaning != Meaning::Uncomputed;
}

/// Return whether a code is that of a plain move.
bool is_of_move(const CodeMeanings& meanings, const GCode& code) {
  return is_neutral(code.meaning) ||
         (code.group == Group::Motion && code.meaning >= Meaning::Rapid &&
          code.meaning <= Meaning::Ccw && meanings.g.of(code.meaning).code == code.code);
}

/// Return why a code alarms wherever it stands; nothing where it does not.
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

/// Take a code. Return false where it alarms: the codes after it are not looked at.
bool BlockCodes::take(std::size_t place, const CodeMeanings& meanings) {
  const Control& c = meanings.control;
  const int written = g_codes[place];
  const GCode code = meanings.g.find(written);
  all.set(at(code.meaning));
  const auto refused = [&](Cause cause) {
    wrong = written;
    why = cause;
    return of_move = false;
  };
  if (code.meaning == Meaning::DataEnd && c.common.refuses.value.has(Cause::DataEndFirst) &&
      data_end < 0)
    data_end = written;
  if (const auto cause = refusal(code.meaning)) return refused(*cause);
  of_move = of_move && is_of_move(meanings, code);
  if (is_neutral(code.meaning)) return true;
  if (!is_computed(c, code.meaning)) {
    uncomputed = written;
    return true;
  }
  GCode& kept = of[at(code.group)];
  if (kept.code >= 0) {
    of_move = false;
    if (code.group != Group::OneShot && c.reading.repeated_address.value == RepeatedAddress::Alarm)
      return refused(Cause::AddressGivenTwice);
    if (changes_shift(code.meaning)) return true;  // both do what they say
    if (kept.code != code.code && !changes_shift(kept.meaning)) drop(kept.code, place);
  }
  kept = code;
  groups |= bit(code.group);
  return true;
}

/// Drop a code that stands before a place: it does not count.
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

/// Return where a list stands in the table, or would.
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
