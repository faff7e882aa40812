// Two runs beside each other, column by column: what `parting_of` looks at.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/comparison/parting.hpp"

namespace cncsub {

/// Return whether two values are the same: they differ by less than a billionth (of mm, degrees,
/// mm/min, s), or than the numbers of a language tell apart.
bool alike(double a, double b, double precision);

/// Return two values as texts, with as many digits as tell them apart.
std::array<std::string, 2> texts_of(double a, double b);

/// Two runs, and how they are told apart.
class Pair {
 public:
  Pair(Question question, const Sides& sides, InterruptCheck& interrupt, const Renamed& renamed);

  std::optional<Parting> earliest();

 private:
  using Steps = std::array<std::int64_t, 2>;
  using Does = std::array<std::string, 2>;
  using Column = std::vector<double>;
  using Columns = std::array<Column, 2>;

  const Trace& trace(std::size_t side) const { return sides_[side].run->trace(); }
  const Code& code(std::size_t side) const { return sides_[side].code(); }
  std::int64_t steps(std::size_t side) const {
    return static_cast<std::int64_t>(trace(side).steps.size());
  }
  std::size_t moves(std::size_t side) const { return trace(side).moves.size(); }

  void say(const Steps& at, const Does& does, const std::string& column = "");
  std::string side_text(std::size_t side, std::int64_t at, const std::string& does) const;

  bool of_moves();
  Column moved(std::size_t side, const std::string& name) const;
  Columns both(const char* name) const;
  Does moves_text(std::size_t at, const std::string& column) const;
  void of_lengths();
  void of_times();
  void of_codes(char kind);
  void of_messages();
  std::int64_t step_of_message(std::size_t side, std::size_t at) const;
  std::vector<std::int32_t> variables_apart() const;
  void of_variables();
  void of_renumbered_variables();
  void of_calls();
  void of_steps();
  void of_stop();
  bool is_same_stop() const;
  bool is_same_alarm(const Alarm& one, const Alarm& other) const;
  std::string called(std::size_t side, const std::string& name) const;
  std::string program(std::size_t side, std::int32_t number) const;
  std::vector<Trace::Sent> sent(std::size_t side, char kind) const;

  const Sides& sides_;
  InterruptCheck& interrupt_;
  const Renamed& renamed_;
  Question question_;
  Asked asked_;
  double precision_;  // of the language that tells fewer numbers apart; 0: both tell the same
  std::vector<Parting> found_;
};

}  // namespace cncsub
