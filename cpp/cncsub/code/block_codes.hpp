// The G and M codes of a block, and what they mean on one kind of machine: resolved once, when the
// programs are compiled.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "cncsub/code/word_uses.hpp"
#include "cncsub/control/alarm.hpp"
#include "cncsub/control/g_codes.hpp"
#include "cncsub/control/roles.hpp"

namespace cncsub {

constexpr std::size_t at(Group group) { return static_cast<std::size_t>(group); }
constexpr std::uint32_t bit(Group group) { return 1u << at(group); }

// The most G and M codes of a block, and the most lists of them in a library: nothing but an attack
// has more.
constexpr std::size_t kGCodesOfBlock = 12, kMCodesOfBlock = 6, kMostLists = 4096;

/// The codes of a block as they are written, in their order.
struct CodeList {
  std::array<int, kGCodesOfBlock> g_codes{};  // ten times the code: G54.1 is 541
  std::array<int, kMCodesOfBlock> m_codes{};
  std::uint8_t g_count = 0, m_count = 0;

  std::span<const int> g() const { return {g_codes.data(), g_count}; }
  std::span<const int> m() const { return {m_codes.data(), m_count}; }
  void add_g(int tenfold) { g_codes[g_count++] = tenfold; }
  void add_m(int code) { m_codes[m_count++] = code; }
  bool operator==(const CodeList&) const = default;
};

struct CodeMeanings;
using MeaningSet = std::bitset<128>;
constexpr std::size_t at(Meaning meaning) { return static_cast<std::size_t>(meaning); }

/// Return whether it is G92.1 to G92.3, which go with another code that holds for one block. [rs274
/// 2.9]
inline bool changes_shift(Meaning meaning) {
  return meaning == Meaning::ClearShift || meaning == Meaning::SuspendShift ||
         meaning == Meaning::RestoreShift;
}

/// The codes of a block with their meanings. Of two of a group the later counts.
struct BlockCodes : CodeList {
  BlockCodes() = default;
  BlockCodes(const CodeList& list, const CodeMeanings& meanings);

  std::array<GCode, kGroups> of{};  // code -1 where the block has none of the group
  std::uint32_t groups = 0;         // those that it has one of, a bit each
  MeaningSet all;                   // the meanings of all its G codes
  std::uint32_t roles = 0;          // of its M codes, a bit each
  std::uint32_t uses = 0;           // the letters that they use, where unused ones are refused
  std::uint16_t dropped = 0;        // of the G codes, those that do not count: bits by their places
  bool of_move = true;  // each G code is that of a plain move, of which there is one or none
  int uncomputed = -1;  // ten times a G code whose moves the engine does not know
  int data_end = -1;    // ten times one that alarms where no data were begun
  int wrong = -1;       // ten times the first that alarms, and why
  Cause why{};

  bool has(Group group) const { return (groups & bit(group)) != 0; }
  bool has(Role role) const { return (roles >> static_cast<unsigned>(role) & 1) != 0; }
  Meaning meaning(Group group) const { return of[at(group)].meaning; }
  /// Return whether the block has no code but one of a plain move, or none.
  bool only_of_moves() const { return of_move && m_count == 0; }

 private:
  bool take(std::size_t place, const CodeMeanings& meanings);
  void drop(int tenfold, std::size_t before);
};

/// The lists of codes that the blocks of a library have, each of them once.
class CodeLists {
 public:
  /// Return the number of a list; -1 where there are too many: the block keeps its codes itself
  /// then.
  int keep(const CodeList& list);
  /// Return the number of the list of one G code alone, given ten times its number.
  int keep(int tenfold) {
    const auto place = static_cast<std::size_t>(tenfold);
    return place < singles_.size() && singles_[place] > 0 ? singles_[place] - 1
                                                          : keep_single(place);
  }
  /// Let every block keep its codes itself from now on.
  void keep_none() { most_ = 0; }
  std::span<const CodeList> all() const { return lists_; }
  const CodeList& operator[](std::size_t number) const { return lists_[number]; }

 private:
  int keep_single(std::size_t tenfold);
  void grow();
  std::size_t slot_of(const CodeList& list) const;

  std::size_t most_ = kMostLists;
  std::vector<CodeList> lists_;
  std::vector<std::int16_t> slots_;           // by hash, from 1
  std::array<std::int16_t, 1000> singles_{};  // by ten times the code, from 1
};

/// The meanings of G codes on one kind of machine of a control, and so of the lists of a library.
struct CodeMeanings {
  CodeMeanings(const Control& of, MachineType type, const CodeLists& lists,
               std::span<const WordUse> word_uses = {});

  const Control& control;
  MachineType machine;
  GCodes g;
  WordUses uses;
  std::vector<BlockCodes> blocks;  // by the number of their list
};

}  // namespace cncsub
