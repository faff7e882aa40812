// The inputs that a block needs from the machine, and its outcome.
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
/// Return the profile that P and Q of a block name, if its cycle takes one.
std::optional<ProfileNumbers> named_profile(const MotionFacts& facts, const NcWords& words);

struct Profile {
  std::vector<NcWords> blocks;
  std::list<BlockCodes> computed;  // the codes of those of the blocks that compute them
  Address behind = kNowhere;       // the block after the last of them
  bool right_behind = false;       // the first stands right after the cycle
  std::optional<Fault> fault;      // what kept it from being read
};

/// The outcome of a block.
struct MotionOutcome {
  bool moved = false;         // an axis really moved
  bool axis_word = false;     // a motion block with an axis word
  Address behind = kNowhere;  // G71 to G73: the run goes on here, after the profile
  std::int64_t moves = 0;
  SkipMove skip = SkipMove::No;
  bool missed_reference = false;  // G27 has moved elsewhere, which alarms then
  // What the block says and the control does not obey next to other words of the block.
  std::uint32_t dropped = 0;        // addresses, as in a mask
  std::uint16_t dropped_codes = 0;  // the places of G codes among the block's

  void drop(std::uint32_t addresses) { dropped |= addresses; }
};

/// The inputs that a block needs from the machine.
struct MachineInputs {
  const Profile* profile = nullptr;      // the profile that the block names
  SkipLists skips;                       // the workpiece decides what they leave open
  const Workpiece* workpiece = nullptr;  // in machine coordinates
  /// Return whether to break off a block that takes very long; called with `run`, may be null.
  bool (*interrupted)(void* run) = nullptr;
  void* run = nullptr;

  /// Return whether a signal can come: one was reported, or there is a workpiece to touch.
  bool has_signals() const { return skips.any() || workpiece != nullptr; }

  /// Return whether to break off, asked now and then. `work` is what was done since the last call,
  /// a move being 1.
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
