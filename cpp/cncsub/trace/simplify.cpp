// The points of a line that are enough for it: Ramer, Douglas and Peucker in windows.
#include <algorithm>
#include <array>
#include <cmath>

#include "cncsub/trace/parts.hpp"
#include "cncsub/trace/polyline.hpp"

namespace cncsub {

namespace {

constexpr std::size_t kWindow = 128;  // points; the worst line costs so much for each of its points

/// A line and the marks of its points.
class Thinner {
 public:
  Thinner(const double* x, const double* y, const double* z, double tolerance, std::uint8_t* keep)
      : x_(x), y_(y), z_(z), most_(tolerance * tolerance), keep_(keep) {}

  /// Mark the points that are needed between two that are kept.
  void window(std::size_t first, std::size_t last) {
    std::size_t open = 0;
    open_[open++] = {first, last};
    while (open > 0) {
      const auto [a, b] = open_[--open];
      const std::size_t far = farthest(a, b);
      if (far == a) continue;
      keep_[far] = 1;
      open_[open++] = {a, far};
      open_[open++] = {far, b};
    }
  }

 private:
  /// Return the point between two others that is farthest from their chord; the first of the two
  /// where none is too far.
  std::size_t farthest(std::size_t a, std::size_t b) const {
    const double wx = x_[b] - x_[a], wy = y_[b] - y_[a], wz = z_[b] - z_[a];
    const double length = wx * wx + wy * wy + wz * wz;
    std::size_t found = a;
    double most = most_;
    for (std::size_t i = a + 1; i < b; ++i) {
      double px = x_[i] - x_[a], py = y_[i] - y_[a], pz = z_[i] - z_[a];
      const double along = px * wx + py * wy + pz * wz;
      const double part = length > 0 ? std::fmin(1, std::fmax(0, along / length)) : 0;
      px -= part * wx;
      py -= part * wy;
      pz -= part * wz;
      const double off = px * px + py * py + pz * pz;
      if (off > most) most = off, found = i;
    }
    return found;
  }

  const double *x_, *y_, *z_;
  double most_;
  std::uint8_t* keep_;
  // Each of the open chords ends where the one below begins, so there are no more chords than
  // points.
  std::array<std::array<std::size_t, 2>, kWindow + 1> open_{};
};

}  // namespace

void thin_piece(const double* x, const double* y, const double* z, const std::int32_t* key,
                std::size_t first, std::size_t last, double tolerance, std::uint8_t* keep) {
  Thinner thinner(x, y, z, tolerance, keep);
  std::fill(keep + first, keep + last, std::uint8_t{0});
  keep[first] = 1;
  for (std::size_t from = first; from + 1 < last;) {
    std::size_t to = from + 1;
    while (to + 1 < last && key[to + 1] == key[to] && to - from < kWindow) ++to;
    keep[to] = 1;
    thinner.window(from, to);
    from = to;
  }
}

void simplify(const double* x, const double* y, const double* z, const std::int32_t* key,
              std::size_t count, double tolerance, std::uint8_t* keep, InterruptCheck* interrupt) {
  in_parts(count, interrupt, [&](std::size_t first, std::size_t last) {
    thin_piece(x, y, z, key, first, last, tolerance, keep);
  });
}

}  // namespace cncsub
