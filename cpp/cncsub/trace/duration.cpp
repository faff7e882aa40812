#include "cncsub/trace/duration.hpp"

#include <algorithm>
#include <cmath>

namespace cncsub {

namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

std::string_view to_string(MoveKind kind) {
  switch (kind) {
    case MoveKind::Rapid:
      return "rapid";
    case MoveKind::Feed:
      return "feed";
    case MoveKind::Cw:
      return "cw";
    case MoveKind::Ccw:
      return "ccw";
    case MoveKind::Thread:
      return "thread";
    case MoveKind::Dwell:
      return "dwell";
  }
  return "";
}

std::string_view to_string(SkipMove skip) {
  switch (skip) {
    case SkipMove::No:
      return "no";
    case SkipMove::Touched:
      return "touched";
    case SkipMove::Missed:
      return "missed";
  }
  return "";
}

double spindle_at(double surface_speed, double limit, double diameter) {
  // In the middle only the limit holds; without one the speed is as good as endless.
  const double speed = 1000 * surface_speed / (kPi * std::max(std::fabs(diameter), 1e-3));
  return limit > 0 ? std::min(speed, limit) : speed;
}

double length_of(const Axes& from, const Axes& to, std::uint32_t diameters) {
  double sum = 0;
  for (int i = 0; i < kAxes; ++i) {
    const double d = (to[i] - from[i]) * ((diameters >> i & 1) != 0 ? 0.5 : 1);
    if (i < 3 || i > 5) sum += d * d;
  }
  return std::sqrt(sum);
}

double arc_length(double in_plane, const PlaneAxes& plane, const Axes& from, const Axes& to,
                  std::uint32_t diameters) {
  double sum = in_plane * in_plane;
  for (const int i : {0, 1, 2, 6, 7, 8}) {
    if (i == plane.a || i == plane.b) continue;
    const double d = (to[i] - from[i]) * ((diameters >> i & 1) != 0 ? 0.5 : 1);
    sum += d * d;
  }
  return std::sqrt(sum);
}

double rapid_time(const Axes& from, const Axes& to, const Axes& rapid, std::uint32_t diameters) {
  double longest = 0;
  const int axes = others_stand(from, to) ? 3 : kAxes;
  for (int i = 0; i < axes; ++i) {
    const double share = (diameters >> i & 1) != 0 ? 0.5 : 1;
    if (to[i] != from[i] && rapid[i] > 0)
      longest = std::max(longest, std::fabs(to[i] - from[i]) * share / rapid[i] * 60);
  }
  return longest;
}

namespace {

double thread_time(const TimedMove& move, double spindle, std::uint32_t diameters) {
  double along = 0, degrees = 0;
  for (int i = 0; i < kAxes; ++i) {
    const double d = std::fabs(move.to[i] - move.from[i]) * ((diameters >> i & 1) != 0 ? 0.5 : 1);
    double& longest = i < 3 || i > 5 ? along : degrees;
    longest = std::max(longest, d);
  }
  if (along < kNoLength) along = degrees * move.state.degree;
  const double rate = move.state.feed * spindle;
  return rate > 0 ? along / rate * 60 : 0;
}

/// Return the length along which a feed counts. Of a line: the length, and the degrees of rotary
/// axes, each as long as a unit of the program, a millimetre or an inch. [B-63174EN p.33: FANUC,
/// linear interpolation] Of an arc: what lies in its plane. F is the speed there, a helix goes
/// along.
double path_of(const TimedMove& move) {
  if (move.kind != MoveKind::Feed || others_stand(move.from, move.to)) return move.path;
  double sum = move.path * move.path;
  for (int i = 3; i < 6; ++i) {
    const double turned = (move.to[i] - move.from[i]) * move.state.degree;
    sum += turned * turned;
  }
  return std::sqrt(sum);
}

}  // namespace

double seconds_of(const TimedMove& move, const Axes& rapid, std::uint32_t diameters) {
  if (move.kind == MoveKind::Dwell) return move.dwell;
  if (move.kind == MoveKind::Rapid) return rapid_time(move.from, move.to, rapid, diameters);
  const double diameter = middle_diameter(move.from[0], move.to[0], move.zero);
  const double whole = (diameters & 1) != 0 ? 1 : 2;  // of a mill X is half of the diameter
  const double spindle = turning(spindle_at(move.state, whole * diameter));
  if (move.kind == MoveKind::Thread) return thread_time(move, spindle, diameters);
  double rate = move.state.feed;
  if (move.state.feed_mode == FeedMode::InverseTime) return rate > 0 ? 60 / rate : 0;
  if (move.state.feed_mode == FeedMode::PerRevolution) rate *= spindle;
  return rate > 0 ? path_of(move) / rate * 60 : 0;
}

}  // namespace cncsub
