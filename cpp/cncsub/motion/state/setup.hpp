// The settings of the machine before the run.
#pragma once

#include <map>
#include <string>
#include <utility>

namespace cncsub {

/// The settings of the machine. Lengths are in mm, X of a lathe is a diameter.
struct Setup {
  std::string machine;           // "mill", "lathe-a", "lathe-b"; empty = the control's own
  std::map<char, double> start;  // work coordinates; an axis not named stands at its machine zero
  std::map<std::string, std::map<char, double>> work_offsets;  // "G54", "EXT", "G54.1 P3"
  std::map<int, double> length_offsets, radius_offsets;        // H, D
  struct Edge {
    std::map<char, double> values;
    int tip = 0;
    double radius = 0;
  };
  struct Tool : Edge {
    std::string name;
    std::map<int, Edge> edges;  // where D names one of them: those from the second on
  };
  std::map<int, Tool> tools;  // of a lathe, by offset number; where D names an edge, by T
  std::map<int, std::map<char, double>> reference;   // machine coordinates, 1 = G28
  std::map<char, double> rapid;                      // mm/min
  std::map<char, std::pair<double, double>> limits;  // machine coordinates
  std::map<char, std::pair<double, double>> area;    // of G22, before the program sets it
  double increment = 0.001;                          // the least input increment
};

}  // namespace cncsub
