// The offset tables: zero points, lengths and radii of tools, reference points.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cncsub/control/control.hpp"
#include "cncsub/control/edge_datum.hpp"
#include "cncsub/trace/column.hpp"
#include "cncsub/trace/moves.hpp"

namespace cncsub {

/// A value that copies share until one of them changes it.
template <class T>
class Shared {
 public:
  Shared() : value_(std::make_shared<T>()) {}
  Shared(const Shared&) = default;
  /// Nearly always both share one value already, and nothing is counted then.
  Shared& operator=(const Shared& other) {  // NOLINT(bugprone-unhandled-self-assignment): as said
    if (value_ != other.value_) value_ = other.value_;
    return *this;
  }
  ~Shared() = default;

  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }
  /// Return the value to be changed, which no copy shares from now on.
  T& change() {
    if (!is_sole_owner(value_)) value_ = std::make_shared<T>(*value_);
    return *value_;
  }
  bool operator==(const Shared& other) const {
    return value_ == other.value_ || *value_ == *other.value_;
  }

 private:
  std::shared_ptr<T> value_;
};

struct ToolOffsets {  // of a lathe
  Axes value{};
  int tip = 0;
  double radius = 0;

  bool operator==(const ToolOffsets&) const = default;
};

/// The edges of tools where D names one of them, and the names of tools.
struct EdgeTables {
  std::map<std::pair<int, int>, ToolOffsets> offsets;  // by tool and edge, from the second edge on
  std::map<std::int32_t, double> data;                 // by EdgeDatum::number: what programs wrote
  std::map<std::string, int> tools;                    // by their names, in capitals

  bool operator==(const EdgeTables&) const = default;
};

/// The number of the first extra work system: 0 is the external one, 1 to 6 are G54 to G59.
constexpr int kFirstExtra = 7;

struct OffsetTables {
  using Numbers = std::vector<double>;

  Shared<std::array<Axes, kFirstExtra>> work;
  Shared<std::vector<Axes>> extra;                           // G54.1 P1...
  Shared<Numbers> length, length_wear, radius, radius_wear;  // by number
  Shared<std::vector<ToolOffsets>> tools;                    // by number
  Shared<EdgeTables> edges, edges_in_force;                  // as they are, and as D took them
  Shared<std::map<int, Axes>> reference;  // points, by number: machine coordinates
  Shared<std::map<int, double>> angles;   // work systems about Z, degrees, numbered as zero points
  Shared<std::map<int, Axes>> tool_axes;  // lengths of mills along other axes than Z, by number

  /// Return the offsets of H or D, which a variable reads or writes.
  const Shared<Numbers>* of(VariableKind kind) const;
  Shared<Numbers>* of(VariableKind kind) {
    return const_cast<Shared<Numbers>*>(std::as_const(*this).of(kind));
  }
  int last_system() const { return kFirstExtra - 1 + static_cast<int>(extra->size()); }
  const Axes& zero(int system) const;
  Axes& change_zero(int system);
  /// Return the length of a mill's tool along Z, by its number, and the radius.
  double length_of(int number) const;
  double radius_of(int number) const;
  /// Return the offsets of a lathe's tool. The table may end before it: they are zero then.
  const ToolOffsets& tool(int number) const;
  ToolOffsets& change_tool(int number);
  Axes point(int number) const;
  /// Return the number of the tool of a name; 0 where none has it.
  int tool_of(std::string_view name) const;
  void name_tool(int number, std::string_view name);

  bool operator==(const OffsetTables&) const = default;
};

}  // namespace cncsub
