// The engine as a C++ library: runs NC programs exactly as a named CNC control would.
//
//   namespace nc = cncsub::api;
//   const auto library = nc::Library::read({{"job.nc", text}}, "fanuc-0i-f");
//   if (!library) return complain(library.error().message);
//   const auto run = library->run();
//   if (run && run->alarm()) std::cerr << run->alarm()->message();
//
// What a caller does wrong (no such control, no such program) is an Error, what a program does
// wrong is an Alarm: neither is an exception, and nothing here aborts. Only memory that is missing
// throws std::bad_alloc. Objects are handles: copies share what they hold. A Library and a Run
// never change and may be used by any number of threads; a Machine belongs to one thread at a time.
//
// Lengths are in mm, angles in degrees, times in seconds; X of a lathe is a diameter. An optional
// number that is empty is a vacant variable, or a block without a sequence number. Texts are UTF-8.
//
// The names of this header change only with the first number of the version (the second,
// before 1.0).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "cncsub/recorded.hpp"

#if defined(_WIN32)
#define CNCSUB_API
#else
#define CNCSUB_API __attribute__((visibility("default")))
#endif

namespace cncsub::api {

/// The version of the library, such as "0.2.0".
CNCSUB_API std::string_view version();

/// What a caller asked for and cannot have.
struct Error {
  std::string option;   // the option that is wrong: "control", "main", "variables"; or empty
  std::string message;  // for people
};

/// A value, or why there is none. As with std::expected, only a result that is true has a value.
template <class Value>
class Result {
 public:
  Result(Value value) : held_(std::move(value)) {}
  Result(Error error) : held_(std::move(error)) {}

  explicit operator bool() const { return held_.index() == 0; }
  Value& operator*() { return *std::get_if<0>(&held_); }
  const Value& operator*() const { return *std::get_if<0>(&held_); }
  Value* operator->() { return std::get_if<0>(&held_); }
  const Value* operator->() const { return std::get_if<0>(&held_); }
  const Error& error() const { return *std::get_if<1>(&held_); }

 private:
  std::variant<Value, Error> held_;
};

// ---- what happened ----

/// An open call, seen from where it was made.
struct Call {
  Place at;
  std::string kind;    // "M98", "G65"
  std::string called;  // the program
  std::int64_t repeat = 1, repeats = 1;
};

/// What stopped a program on the control.
struct Alarm {
  std::string number;  // as on the screen; empty where no source gives one
  std::string text;    // the control's; empty where no source gives one
  std::string cause;   // "program-not-found", the same on every control
  std::string detail, cure;
  Place at;
  std::string word;
  std::uint32_t column = 0;  // from 1, in characters
  std::string shown;         // the lines that the command line shows
  std::vector<Call> stack;   // innermost first

  /// Return what happened, where, the line with the word marked, and the callers.
  const std::string& message() const { return shown; }
};

/// Why a run stopped. Running: it has not.
enum class Stop { Running, End, Alarm, Cycles, Limit, Waiting, Interrupted };
CNCSUB_API std::string_view to_string(Stop stop);  // "end"

/// What `check` finds without running a program.
struct Finding {
  std::string rule, name;  // "CS201", "program-missing"
  std::string severity;    // "error", "warning", "note"
  std::string message, hint;
  Place at;
  std::uint32_t column = 0;
  std::string word;
  std::size_t count = 1;       // of its places
  std::optional<Alarm> alarm;  // that the control raises there
};

// ---- what a run is given ----

using Axis = char;  // 'X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W'
using Point = std::map<Axis, double>;

/// The settings of the machine.
struct Setup {
  std::string machine;  // "mill", "lathe-a", "lathe-b"; empty: the control's own
  Point start;          // work coordinates; else the machine's zero
  std::map<std::string, Point> work_offsets;             // "G54", "EXT", "G54.1 P3"
  std::map<int, double> length_offsets, radius_offsets;  // by their H and D numbers
  std::map<int, Point> reference;                        // machine coordinates; 1 is that of G28
  Point rapid;                                           // mm/min
  std::map<Axis, std::pair<double, double>> limits;      // machine coordinates
};

/// How much of a run is recorded.
enum class Record { Nothing, Calls, Blocks, Moves };

struct Options {
  std::string main;                   // the program that runs; empty: the first one
  std::optional<std::int64_t> start;  // the sequence number to begin at
  std::map<int, std::optional<double>> variables;
  std::map<int, double> signals;  // of the machine, such as #1000
  std::vector<int> block_skip;    // the switches that are on, 1 to 10
  bool optional_stop = false;
  std::int64_t max_cycles = 1;  // of a main program that starts over
  std::int64_t max_blocks = 10'000'000;
  double max_seconds = 0;  // 0: any
  Record record = Record::Moves;
  Setup setup;
};

// ---- reading and running ----

/// A finished run. It never changes.
class CNCSUB_API Run {
 public:
  Stop stop() const;
  /// What is awaited where a run waits: "#1000", "cycle start after M00".
  std::string waiting_for() const;
  std::optional<Alarm> alarm() const;
  std::int64_t blocks() const;

  std::size_t steps() const;           // that were recorded
  Step step(std::size_t index) const;  // an empty one where there is none
  std::size_t moves() const;
  std::size_t calls() const;
  CallMade call(std::size_t index) const;
  double length() const;  // mm
  double time() const;    // s
  /// Write the columns that are not null; each has room for `moves()` values.
  void write_moves(const MoveColumns& columns) const;
  /// Return the path of the tool as points, work coordinates; what is left out lies within
  /// `tolerance` mm.
  Path path(double tolerance) const;
  std::vector<std::string> messages() const;
  Result<std::optional<double>> variable(std::int64_t number) const;
  std::vector<Variable> variables() const;  // those that have values, by number, then by name

  struct Inside;
  explicit Run(std::shared_ptr<const Inside> inside) : inside_(std::move(inside)) {}

 private:
  std::shared_ptr<const Inside> inside_;
};

/// One program on its control, executed block by block. A copy is the same machine; `snapshot`
/// makes another one that stands where this one stands.
class CNCSUB_API Machine {
 public:
  /// Execute one block; return it, or nothing where the run has stopped. A machine that was
  /// interrupted goes on.
  std::optional<Step> step();
  /// Run on until the run stops, or until `pause`, which is asked before each block, returns true.
  void run(const std::function<bool(const Machine&)>& pause = {});
  /// Run on for about so many blocks; return whether the run goes on after them.
  bool run_blocks(std::int64_t blocks);
  /// Run on until the block is the next one: false where the run stopped before. An Error where
  /// there is no such block.
  Result<bool> run_to(const std::string& program, std::int64_t n);
  /// Stop the run, or else the next one; from another thread too. The run stops by Interrupted, and
  /// goes on when it is asked to.
  void interrupt();
  /// Press the reset key: calls are gone, the main program is at its head. What was recorded stays.
  void reset();
  Machine snapshot() const;

  Stop stop() const;
  std::optional<Alarm> alarm() const;
  std::int64_t blocks() const;
  Place next() const;  // the block that is executed next
  std::string next_text() const;
  std::vector<Call> stack() const;  // innermost first
  Point position() const;           // work coordinates
  std::map<std::string, std::string> modal() const;

  /// Read a variable; `level`: of which open level its locals are, -1: the present one.
  Result<std::optional<double>> variable(std::int64_t number, int level = -1) const;
  /// Set a variable; return why it cannot be set.
  std::optional<Error> set_variable(std::int64_t number, std::optional<double> value,
                                    int level = -1);
  std::optional<Error> set_signal(std::int32_t number, double value);
  /// Return what has happened so far as a run, which does not change when the machine goes on.
  Run so_far() const;

  struct Inside;
  explicit Machine(std::shared_ptr<Inside> inside) : inside_(std::move(inside)) {}

 private:
  std::shared_ptr<Inside> inside_;
};

/// A file, or a text with a name: what messages show.
struct Source {
  std::string name;  // "job.nc"
  std::string text;
  bool external = false;  // it is on the external device, for M198
};

/// The programs in a control's memory. Reading never fails for what stands in a program: a block
/// that the control refuses raises its alarm when it is reached.
class CNCSUB_API Library {
 public:
  /// Read texts. `parameters`: the control's, by their numbers as text. `interrupted` is asked
  /// fifty times a second; where it returns true, the result is an Error.
  static Result<Library> read(std::vector<Source> sources, const std::string& control,
                              const std::map<std::string, double>& parameters = {},
                              const std::function<bool()>& interrupted = {});
  /// Read files. Nothing but these is opened.
  static Result<Library> load(const std::vector<std::string>& paths, const std::string& control,
                              const std::map<std::string, double>& parameters = {});

  /// Read the same texts for a control whose rules and parameters are changed: by their names, with
  /// values as Control.to_toml writes them: {"max_nesting", "3"}, {"zero_repeats", "once"}.
  Result<Library> read_for(const std::string& control,
                           const std::map<std::string, std::string>& changes = {}) const;
  const std::string& control() const;
  std::vector<std::string> programs() const;  // of several with one name, the first
  Result<Run> run(const Options& options = {}, const std::function<bool()>& interrupted = {}) const;
  Result<Machine> machine(const Options& options = {}) const;
  std::vector<Finding> check() const;

  struct Inside;
  explicit Library(std::shared_ptr<const Inside> inside) : inside_(std::move(inside)) {}
  const Inside& inside() const { return *inside_; }

 private:
  std::shared_ptr<const Inside> inside_;
};

/// A control that this library knows. Where a control is named, an alias names it too: "fanuc-31i"
/// is "fanuc-30i".
struct Control {
  std::string name, title;  // "fanuc-0i-f", "FANUC Series 0i-F"
};
CNCSUB_API std::vector<Control> controls();

}  // namespace cncsub::api
