// Skip signals: which there are, and what was reported of them before the run.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cncsub {

/// A set of skip signals, a bit for each: 1 to 8, and those of G36 and G37, one for X, Y and Z
/// each.
using SignalMask = std::uint32_t;
constexpr SignalMask kAnySignal = ~SignalMask{0};
constexpr int kArrivalSignal = 9;  // of X
constexpr int kSkipSignals = kArrivalSignal + 3;
constexpr SignalMask signal_bit(int signal) { return SignalMask{1} << signal; }

/// The report of a skip signal on the path of one block.
struct SkipSignal {
  enum class Comes : std::uint8_t { AtFraction, AtCoordinate, Never } comes = Comes::AtFraction;
  double value = 0;  // of the path, or in work coordinates, mm
  int axis = 0;
};

/// The reports of the signals that a block watches, and the signals of which no report is left.
struct ReportedSkips {
  std::vector<SkipSignal> reported;
  SignalMask open = 0;
};

/// The reports of each signal, block after block, and of any signal (0); and how many of them are
/// used up.
struct SkipLists {
  using Next = std::array<std::size_t, kSkipSignals>;
  const std::array<std::vector<SkipSignal>, kSkipSignals>* lists = nullptr;
  const Next* used = nullptr;  // before this block
  std::optional<Next> taken;   // with what this block takes, where it takes any

  /// Return whether anything was reported of any signal.
  bool any() const;
  /// Take the next report of these signals. What is reported of any signal comes first.
  ReportedSkips take(SignalMask signals);
};

}  // namespace cncsub
