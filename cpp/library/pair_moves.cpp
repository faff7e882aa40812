// What two runs move otherwise.
#include <limits>
#include <optional>
#include <string_view>

#include "pair.hpp"

namespace cncsub::api {

namespace {

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
        const bool in_use = axis >= 'x' || used.find(static_cast<char>(axis & ~0x20)) != used.npos;
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
                                            const std::vector<double>& b) {
  const std::size_t count = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < count; ++i)
    if (!alike(a[i], b[i])) return i;
  return a.size() == b.size() ? std::nullopt : std::optional(count);
}

std::string kind_words(MoveKind kind) {
  constexpr std::array<const char*, 6> kWords = {"a rapid",           "a line at the feed",
                                                 "an arc, clockwise", "an arc, counter-clockwise",
                                                 "a thread",          "a dwell"};
  return kWords[static_cast<std::size_t>(kind)];
}

}  // namespace

Pair::Column Pair::moved(std::size_t side, const std::string& name) const {
  const Moves& moves = trace(side).moves;
  Column column(moves.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<std::int32_t> whole(moves.size());
  const auto letter = static_cast<char>(name.back() & ~0x20);
  const bool of_axis = name.size() <= 2 && name[0] != 'c' && name != "h" && name != "d";
  if (is_whole(name)) {
    moves.column(name, whole.data());
    std::copy(whole.begin(), whole.end(), column.begin());
  } else if (!of_axis || name[0] == 'c' || moves.axes().find(letter) != std::string::npos ||
             letter == 'X' || letter == 'Y' || letter == 'Z') {
    moves.columns({name}, {column.data()});
  }
  if (name != "plane" && name != "feed" && name != "feed_mode") return column;
  moves.column("kind", whole.data());
  for (std::size_t i = 0; i < column.size(); ++i)
    if (!counts(name, static_cast<MoveKind>(whole[i]))) column[i] = 0;
  return column;
}

std::string Pair::move_text(std::size_t side, std::size_t at, const std::string& column) const {
  if (at >= moves(side)) return "no further move";
  const std::string move = "move " + std::to_string(at);
  const MoveRow row = trace(side).moves.row(at);
  if (column == "kind") return move + " is " + kind_words(row.kind);
  if (column == "skip") return move + " has skip = " + std::string(cncsub::to_string(row.skip));
  if (column == "feed_mode") {
    constexpr std::array<const char*, 3> kModes = {"per-minute", "per-revolution", "inverse-time"};
    return move + " has the feed mode " + kModes[static_cast<std::size_t>(row.state->feed_mode)];
  }
  const double value = column == "plane"  ? static_cast<double>(row.state->plane)
                       : column == "feed" ? row.feed
                                          : moved(side, column)[at];
  const std::string shown = short_text(value);
  if (column == "plane") return move + " is in the plane of G" + shown;
  if (column == "feed" || column == "spindle") return move + " has the " + column + " " + shown;
  if (column.size() > 1 && column[column.size() - 2] == 'c')
    return move + " has " + (std::isnan(value) ? "no " + column : column + " = " + shown);
  if (std::isnan(value)) return move + " has no " + column;
  const bool goes = !is_whole(column);
  return move + (goes ? " goes to " : " has ") + column + " = " + shown;
}

bool Pair::of_moves() {
  std::optional<std::size_t> at;
  std::string which;
  for (const std::string& name : column_names({trace(0).moves.axes(), trace(1).moves.axes()})) {
    const auto differs = first_difference(moved(0, name), moved(1, name));
    if (!differs || (at && *differs >= *at)) continue;
    at = differs;
    which = name;
  }
  if (!at) return false;
  std::array<std::int64_t, 2> where{};
  Does does;
  for (std::size_t side = 0; side < 2; ++side) {
    where[side] = *at < moves(side) ? trace(side).moves.row(*at).step
                                    : static_cast<std::int64_t>(steps(side));
    does[side] = move_text(side, *at, which);
  }
  say(where, does);
  return true;
}

/// Say where coordinates are the same and lengths are not: X of a mill is no diameter.
void Pair::of_lengths() {
  std::array<Column, 2> lengths;
  for (std::size_t side = 0; side < 2; ++side) {
    lengths[side].resize(moves(side));
    trace(side).moves.columns({"length"}, {lengths[side].data()});
  }
  for (std::size_t i = 0; i < std::min(moves(0), moves(1)); ++i) {
    if (!(std::fabs(lengths[0][i] - lengths[1][i]) > kNearLength)) continue;
    const std::string move = "move " + std::to_string(i) + " is ";
    say({trace(0).moves.row(i).step, trace(1).moves.row(i).step},
        {move + short_text(lengths[0][i]) + " mm long",
         move + short_text(lengths[1][i]) + " mm long"});
    return;
  }
}

void Pair::of_dwells() {
  if (moves(0) != moves(1)) return;
  std::array<Column, 2> times{Column(moves(0)), Column(moves(0))};
  for (std::size_t side = 0; side < 2; ++side)
    trace(side).moves.columns({"time"}, {times[side].data()});
  std::vector<std::int32_t> kinds(moves(0));
  trace(0).moves.column("kind", kinds.data());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] != static_cast<std::int32_t>(MoveKind::Dwell)) continue;
    if (!(std::fabs(times[0][i] - times[1][i]) > kNear)) continue;
    const std::string move = "move " + std::to_string(i);
    say({trace(0).moves.row(i).step, trace(1).moves.row(i).step},
        {move, move + ", a dwell with another time"});
    return;
  }
}

}  // namespace cncsub::api
