// What two runs move otherwise.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/comparison/pair.hpp"

namespace cncsub {

namespace {

constexpr double kNearLength = 1e-6;  // mm
constexpr double kNearTime = 1e-9;    // s

bool is_whole(std::string_view name) {
  return name == "kind" || name == "plane" || name == "feed_mode" || name == "tool" ||
         name == "h" || name == "d" || name == "skip";
}

/// Return whether a column counts for a move of this kind: the feed of a rapid and the plane of a
/// straight move make no difference.
bool counts(const std::string& name, MoveKind kind) {
  const bool arc = kind == MoveKind::Cw || kind == MoveKind::Ccw;
  if (name == "plane") return arc;
  if (name == "feed" || name == "feed_mode")
    return arc || kind == MoveKind::Feed || kind == MoveKind::Thread;
  return true;
}

/// Return the names of the columns that are compared, in the order in which they are named.
std::vector<std::string> column_names(const std::array<std::string, 2>& axes) {
  constexpr std::string_view kAll = "xyzabcuvw";
  std::vector<std::string> names = {"kind", "plane"};
  for (const std::string& used : axes)
    for (const bool machine : {false, true})
      for (const char axis : kAll) {
        const bool in_use =
            axis >= 'x' || used.find(static_cast<char>(axis & ~0x20)) != std::string::npos;
        const std::string name = (machine ? "m" : "") + std::string(1, axis);
        if (in_use && std::find(names.begin(), names.end(), name) == names.end())
          names.push_back(name);
      }
  for (const char* name :
       {"cx", "cy", "cz", "feed", "feed_mode", "spindle", "tool", "h", "d", "skip"})
    names.emplace_back(name);
  return names;
}

/// Return the first row in which two columns differ, or the end of the shorter one; nothing where
/// they are the same.
std::optional<std::size_t> first_difference(const std::vector<double>& a,
                                            const std::vector<double>& b, double precision) {
  const std::size_t count = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < count; ++i)
    if (!alike(a[i], b[i], precision)) return i;
  return a.size() == b.size() ? std::nullopt : std::optional(count);
}

std::string kind_words(MoveKind kind) {
  constexpr std::array<const char*, 6> kWords = {"a rapid",           "a line at the feed",
                                                 "an arc, clockwise", "an arc, counter-clockwise",
                                                 "a thread",          "a dwell"};
  return kWords[static_cast<std::size_t>(kind)];
}

/// Return what a move does, by the column that differs, and its value as shown.
std::string move_words(const MoveRow& row, const std::string& column, double value,
                       const std::string& shown) {
  if (column == "kind") return " is " + kind_words(row.kind);
  if (column == "skip") return " has skip = " + std::string(to_string(row.skip));
  if (column == "feed_mode") {
    constexpr std::array<const char*, 3> kModes = {"per-minute", "per-revolution", "inverse-time"};
    return std::string(" has the feed mode ") +
           kModes[static_cast<std::size_t>(row.state->feed_mode)];
  }
  if (column == "plane")
    return " is in the plane of G" + std::to_string(static_cast<int>(row.state->plane));
  if (column == "feed" || column == "spindle") return " has the " + column + " " + shown;
  if (column.size() > 1 && column[column.size() - 2] == 'c')
    return " has " + (std::isnan(value) ? "no " + column : column + " = " + shown);
  if (std::isnan(value)) return " has no " + column;
  if (is_whole(column))
    return " has " + column + " = " + std::to_string(static_cast<std::int64_t>(value));
  return " goes to " + column + " = " + shown;
}

}  // namespace

Pair::Column Pair::moved(std::size_t side, const std::string& name) const {
  const Moves& moves = trace(side).moves;
  Column column(moves.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<std::int32_t> whole(moves.size());
  const auto letter = static_cast<char>(name.back() & ~0x20);
  const bool of_axis = name.size() <= 2 && name[0] != 'c' && name != "h" && name != "d";
  if (is_whole(name)) {
    moves.column(name, whole.data(), &interrupt_);
    std::copy(whole.begin(), whole.end(), column.begin());
  } else if (!of_axis || name[0] == 'c' || moves.axes().find(letter) != std::string::npos ||
             letter == 'X' || letter == 'Y' || letter == 'Z') {
    moves.columns({name}, {column.data()}, &interrupt_);
  }
  const bool of_some_kinds = name == "plane" || name == "feed" || name == "feed_mode";
  if (!asked_.two_controls || !of_some_kinds) return column;
  moves.column("kind", whole.data(), &interrupt_);
  for (std::size_t i = 0; i < column.size(); ++i)
    if (!counts(name, static_cast<MoveKind>(whole[i]))) column[i] = 0;
  return column;
}

Pair::Columns Pair::both(const char* name) const {
  Columns columns;
  for (std::size_t side = 0; side < 2; ++side) {
    columns[side].resize(moves(side));
    trace(side).moves.columns({name}, {columns[side].data()}, &interrupt_);
  }
  return columns;
}

/// Return what a move does on each side, by the column that differs.
Pair::Does Pair::moves_text(std::size_t at, const std::string& column) const {
  Does does = {"no further move", "no further move"};
  std::array<double, 2> values{};
  for (std::size_t side = 0; side < 2; ++side)
    if (at < moves(side)) values[side] = moved(side, column)[at];
  const bool in_both = at < moves(0) && at < moves(1);
  for (std::size_t side = 0; side < 2; ++side) {
    if (at >= moves(side)) continue;
    const MoveRow row = trace(side).moves.row(at);
    const double value = column == "feed" ? row.feed : values[side];
    const std::string shown = texts_of(value, in_both ? values[1 - side] : value)[0];
    does[side] = "move " + std::to_string(at) + move_words(row, column, value, shown);
  }
  return does;
}

bool Pair::of_moves() {
  std::optional<std::size_t> at;
  std::string which;
  for (const std::string& name : column_names({trace(0).moves.axes(), trace(1).moves.axes()})) {
    const auto differs = first_difference(moved(0, name), moved(1, name), precision_);
    if (!differs || (at && *differs >= *at)) continue;
    at = differs;
    which = name;
  }
  if (!at) return false;
  Steps where{};
  for (std::size_t side = 0; side < 2; ++side)
    where[side] = *at < moves(side) ? trace(side).moves.row(*at).step : steps(side);
  say(where, moves_text(*at, which), which);
  return true;
}

/// Say where coordinates are the same and lengths are not: X of a mill is no diameter.
void Pair::of_lengths() {
  const Columns lengths = both("length");
  for (std::size_t i = 0; i < std::min(moves(0), moves(1)); ++i) {
    const double near = std::max(kNearLength, precision_ * std::max(lengths[0][i], 1.0));
    if (!(std::fabs(lengths[0][i] - lengths[1][i]) > near)) continue;
    const std::string move = "move " + std::to_string(i) + " is ";
    const auto texts = texts_of(lengths[0][i], lengths[1][i]);
    say({trace(0).moves.row(i).step, trace(1).moves.row(i).step},
        {move + texts[0] + " mm long", move + texts[1] + " mm long"});
    return;
  }
}

/// Say where the moves are the same and one does not take as long. A dwell has a time and no
/// length.
void Pair::of_times() {
  if (asked_.times == Times::None || moves(0) != moves(1)) return;
  const bool all = asked_.times == Times::Moves;
  const Columns times = both("time");
  std::vector<std::int32_t> kinds(moves(0));
  trace(0).moves.column("kind", kinds.data(), &interrupt_);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (!all && kinds[i] != static_cast<std::int32_t>(MoveKind::Dwell)) continue;
    if (!(std::fabs(times[0][i] - times[1][i]) > kNearTime + precision_ * times[0][i])) continue;
    const std::string move = "move " + std::to_string(i);
    say({trace(0).moves.row(i).step, trace(1).moves.row(i).step},
        {move, move + (all ? " with another time" : ", a dwell with another time")});
    return;
  }
}

}  // namespace cncsub
