// What a comparison of two runs asks: which differences count.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace cncsub {

/// Moves, codes, messages and the stop always count. What else does depends on why two runs are
/// compared.
enum class Question : std::uint8_t {
  Versions,  // two versions of programs on one control: a call of O2 that became one of O5
  Controls,  // the same texts on two controls: M98 P51002, five calls on one and an alarm elsewhere
  Rewritten,   // a flat program for another control: it has no calls, and other variables
  Translated,  // programs rewritten for another control: other calls, the same variables
  Flat,        // a flat program for the same control: it takes the same time
  Edited,      // programs with other numbers and names: N10 that became N100
};

/// Return the question of this name, such as "versions".
std::optional<Question> question_named(std::string_view name);

/// What of an alarm counts beside its cause.
enum class AlarmPart : std::uint8_t {
  Cause,    // nothing
  Number,   // PS0076: one control has the same numbers
  Program,  // O1 N10
  Line,     // N10, job.nc:2, whatever a control calls the program
  Edited,   // the line, the program by its name before the edit, and the count of steps
};

/// Which moves have to take the same time.
enum class Times : std::uint8_t {
  None,    // G1 X5. F100 that became F200 differs by its feed
  Dwells,  // G4 P500 of two controls: 0.5 s and 500 s
  Moves,   // all: a flat program
};

struct Asked {
  bool two_controls = false;  // The feed of a rapid, the plane of a straight move and codes that
                              // end a program do not count, lengths do: X of a lathe is a diameter.
  Times times = Times::None;
  bool variables = false;
  bool calls = false;
  bool starts = false;  // of calls: the block that they begin at
  bool levels = false;  // of calls: the level of their locals
  bool places = false;  // A program is compared by its file and last line, not by its name.
  bool steps = false;   // which blocks were executed
  AlarmPart alarm = AlarmPart::Cause;
};

/// Return what counts. `one_language`: both controls read one language. Another one counts heads of
/// programs as blocks, or a call once for each pass, and does the same.
Asked asked(Question question, bool one_language);

}  // namespace cncsub
