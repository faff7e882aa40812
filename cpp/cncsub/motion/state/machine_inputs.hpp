// What a block needs from around it, and what it came to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/motion/state/signals.hpp"
#include "cncsub/motion/state/workpiece.hpp"
#include "cncsub/trace/moves.hpp"

namespace cncsub {

/// The blocks N(ns) to N(nf), which a cycle follows.
struct ProfileNumbers {
  std::int64_t ns = 0, nf = 0;
};
struct MotionFacts;
/// Of a block with P and Q: the profile that its cycle takes, if it is one that does.
std::optional<ProfileNumbers> named_profile(const MotionFacts& facts, const NcWords& words);

struct Profile {
  std::vector<NcWords> blocks;
  std::list<BlockCodes> computed;  // of those of them that compute their codes
  Address behind = kNowhere;       // the block behind the last of them
  bool right_behind = false;       // the first stands right behind the cycle
  std::optional<Fault> fault;      // what kept it from being read
};

/// What a block came to.
struct MotionOutcome {
  bool moved = false;         // an axis really moved
  bool axis_word = false;     // a motion block with an axis word
  Address behind = kNowhere;  // G71 to G73: the run goes on here, behind the profile
  std::int64_t moves = 0;
  SkipMove skip = SkipMove::No;
  bool missed_reference = false;  // G27 has moved elsewhere, which alarms then
  // What the block says and the control does not obey beside something else of the block.
  std::uint32_t dropped = 0;        // addresses, as in a mask
  std::uint16_t dropped_codes = 0;  // the places of G codes among the block's

  void drop(std::uint32_t addresses) { dropped |= addresses; }
};

/// What a block needs from around it.
struct MachineInputs {
  const Profile* profile = nullptr;      // that the block names
  SkipLists skips;                       // of what they do not tell the workpiece decides
  const Workpiece* workpiece = nullptr;  // in machine coordinates
  /// Whether to break off a block that takes very long, asked of `run`; or nothing.
  bool (*interrupted)(void* run) = nullptr;
  void* run = nullptr;

  /// Whether a signal can come: one was told, or there is a workpiece to touch.
  bool has_signals() const { return skips.any() || workpiece != nullptr; }

  /// Asks that now and then; `work` is what was done since the last time, a move being 1.
  bool over(std::size_t work) {
    worked += work;
    if (worked < kAskWork || interrupted == nullptr) return false;
    worked = 0;
    return interrupted(run);
  }
  static constexpr std::size_t kAskWork = 1 << 14;
  std::size_t worked = 0;
};

}  // namespace cncsub
