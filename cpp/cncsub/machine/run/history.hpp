// The way back of a run: snapshots of its state at growing distances, from which it runs again.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "cncsub/machine/run/breakpoints.hpp"
#include "cncsub/machine/state/context.hpp"
#include "cncsub/machine/state/layout.hpp"

namespace cncsub {

/// The state of a run between two blocks, without the rows that it recorded.
struct Snapshot {
  State state;
  Motion motion;
  Trace::Mark recorded;
  std::vector<double> seen;  // of Watched
  std::uint16_t skips = 0;   // of Options
  bool optional_stop = false;
  std::size_t edits = 0;  // how many came before it
  VariableLayout layout;  // of the library that it ran then
  std::int64_t work = 0;  // blocks and moves before it
  std::size_t bytes = 0;
};

/// What somebody changed from outside between two blocks.
struct Edit {
  std::int64_t at = 0;  // so many blocks had been executed
  Address pc = 0;
  std::function<void(Run&)> apply;
  bool typed = false;  // it typed blocks in: a step back to here is a step to before them
};

class History {
 public:
  static constexpr std::size_t kMost = 256;                         // snapshots
  static constexpr std::size_t kMostBytes = std::size_t{48} << 20;  // of all snapshots
  static constexpr std::int64_t kFirstDistance = 1 << 12;           // blocks and moves between two

  /// Keep a snapshot where one is due. Call it between two blocks.
  void note(const Run& run);
  /// Return after how many blocks at most it wants to be called again.
  std::int64_t distance() const { return distance_; }
  /// Remember what changed the run from outside before the block `pc`.
  void edited(const Run& run, Address pc, std::function<void(Run&)> apply, bool typed = false) {
    edits_.push_back({run.state.executed, pc, std::move(apply), typed});
  }
  /// Go back to when so many blocks were executed, which the run has come past; what was edited
  /// after that is forgotten, and blocks that were typed in there are. Return false where
  /// `interrupted` stopped it: the run stands where it stood then.
  bool back(Run& run, std::int64_t step, const std::function<bool()>& interrupted);
  /// Return the last step before the present one at which the breakpoints show a block: the step of
  /// the block where it is a place, or of the block that did it. Where the run stopped with an
  /// alarm that one of them names, it is the present one. -1: none; nothing: `interrupted` stopped
  /// the search.
  std::optional<std::int64_t> last_met(const Run& run, const std::vector<Breakpoint>& list,
                                       const ExpressionList& expressions,
                                       const std::function<bool()>& interrupted) const;

  std::size_t snapshots() const { return snapshots_.size(); }
  std::size_t bytes() const { return bytes_; }

 private:
  void keep(const Run& run, std::size_t edits);
  void thin();
  void replay(Run& run, std::int64_t step, std::size_t& edits,
              const std::function<bool()>& interrupted) const;

  std::vector<std::shared_ptr<const Snapshot>> snapshots_;
  std::vector<Edit> edits_;
  std::int64_t distance_ = kFirstDistance, due_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace cncsub
