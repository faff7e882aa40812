// Two runs beside each other, column by column: what `parting_of` looks at.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "parting.hpp"

namespace cncsub::api {

inline constexpr double kNear =
    1e-9;  // mm, degrees, mm/min, s: values that differ by less are alike
inline constexpr double kNearLength = 1e-6;  // mm
inline constexpr std::size_t kWatched = 1000;

inline bool alike(double a, double b) {
  return a == b || std::fabs(a - b) < kNear || (std::isnan(a) && std::isnan(b));
}

inline std::string short_text(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

/// Two runs, and how they are told apart.
class Pair {
 public:
  Pair(const std::array<Side, 2>& sides, const cncsub::Machine& one, const cncsub::Machine& other,
       const Runner& run)
      : sides_(sides), runs_{&one, &other}, run_(run) {}

  std::optional<Parting> earliest();

 private:
  using Does = std::array<std::string, 2>;
  using Column = std::vector<double>;

  const Trace& trace(std::size_t side) const { return runs_[side]->trace(); }
  std::size_t steps(std::size_t side) const { return trace(side).steps.size(); }
  std::size_t moves(std::size_t side) const { return trace(side).moves.size(); }

  void say(std::array<std::int64_t, 2> at, const Does& does);
  std::string side_text(std::size_t side, std::int64_t at, const std::string& does) const;
  std::string summary(std::size_t side) const;

  bool of_moves();
  Column moved(std::size_t side, const std::string& name) const;
  std::string move_text(std::size_t side, std::size_t at, const std::string& column) const;
  void of_lengths();
  void of_codes(char kind);
  void of_messages();
  void of_dwells();
  void of_variables();
  void of_calls();
  void of_steps();
  void of_stop();
  std::vector<std::int32_t> shared_variables() const;
  std::string end_of(std::size_t side, std::int32_t program) const;
  std::vector<Trace::Sent> sent(std::size_t side, char kind) const;

  const std::array<Side, 2>& sides_;
  std::array<const cncsub::Machine*, 2> runs_;
  const Runner& run_;
  std::vector<Parting> found_;
};

}  // namespace cncsub::api
