// The spelling of what the neutral code reads and writes, by dialect: for checks, fixes, messages
// and flat programs.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cncsub/code/operators.hpp"
#include "cncsub/control/control.hpp"

namespace cncsub {

/// The spelling of a dialect. `comment`, `message`, `head` (of a program; nothing where none has
/// one): what stands around their text. `value`: what stands around a value that counts as
/// computed.
struct Spelling {
  struct Around {
    std::string_view before, behind;
  };
  struct Codes {
    int first = 0, last = -1;
  };
  Around comment, value, message, head;
  // What the name of a main program ends in, after _ or a point; nothing where the first program is
  // the main one.
  std::string_view main_ending{};
  // What the name of a program ends in that a call means, where a main program has the same name.
  std::string_view called_ending{};

  // The names of the control's folders, and what the name of any other one ends in. One that begins
  // as a program's name on the control does is one of them too.
  std::span<const std::string_view> folders{};
  std::string_view folder_ending{};

  // The spelling of expressions.
  Around brackets{"[", "]"};
  /// The operators and how tightly they bind, by the order of logic where a control lets it choose.
  std::span<const OperatorRow> (*operators)(LogicOrder order) = nullptr;
  std::string_view slash_function = "ATAN";  // its second argument stands after a slash
  bool long_numbers = false;  // no rule says how many digits a number in an expression may have
  bool numbered = true;       // variables are assigned by their number: #5221=5
  std::string_view variable = "#";  // what stands before the number of a variable
  // The name of a variable that has no sign before its number: $TC_DP3[5,1]; empty where it has
  // one. Null: all have one.
  std::string (*variable_name)(const Control& control, std::int64_t number) = nullptr;

  /// An address of several characters, and the place in the mask of a block that holds its value.
  struct LongAddress {
    std::string_view name;
    int place;
  };

  /// A word of an axis that stands in brackets after it, POS[X]=5, and how far its place in the
  /// mask is after that of the axis.
  struct IndexedAddress {
    std::string_view name;
    int after = 0;
  };

  Around program_name{"<", ">"};  // what stands around the name of a program that a call names

  // The spelling of words.
  std::span<const LongAddress> long_addresses{};
  std::span<const IndexedAddress> indexed_addresses{};
  // What stands around a value that is a coordinate, or an increment, whatever the mode is: IC(5).
  Around absolute{}, incremental{};
  std::string_view radius = "R";  // the address of an arc's radius
  std::string_view polar{};       // the signs of a point's radius and angle, each an address
  Codes own_m_codes{};            // the M codes that a machine gives a meaning
  // The addresses whose computed value may not be negative: faults of their own tell the others.
  // `signs_by_rule`: only those that take no minus sign on the control.
  std::string_view unsigned_words{};
  bool signs_by_rule = false;
  // How the name of a file ends that defines variables for the programs of all others.
  std::string_view definitions{};
  bool small_letters = true;   // small letters are as good as capitals
  bool ignores_words = false;  // words may be ignored; else one that is dropped is obeyed, and
                               // a run goes on without it
  bool open_comments = false;  // a comment that is not closed may be read
  // Return a written number, without a sign, as the language has it. Null: the nearest of 64 bits.
  double (*read_number)(std::string_view digits) = nullptr;

  /// Return a variable as programs write it: #500, R5, $TC_DP3[5,1].
  std::string name_of_variable(const Control& control, std::int64_t number) const;
  /// Return the number of a variable as programs write it; nothing where the control has none.
  std::optional<std::int64_t> number_of_variable(const Control& control,
                                                 std::string_view name) const;
  /// Return a program's name without what the control puts around it: _N_SHAFT_MPF is SHAFT.
  std::string_view bare_name(std::string_view name) const;
  /// Return the folder of the control that a path names: WKS.DIR/SHAFT.WPD of
  /// /_N_WKS_DIR/_N_SHAFT_WPD/ and of nc/wks.dir/shaft.wpd/; nothing where it names none.
  std::string folder_of(std::string_view path) const;
  /// Return the place of a written address in the mask of a block; -1 where it has none.
  int place_of(std::string_view address) const;
  /// Return the address of a place in the mask as it is written.
  std::string address_of(int place) const;
  /// Return whether the place of a letter is that of a long address: RPL has that of E.
  bool lends(int place) const;
};

/// What parts the names of a path that a call writes, the drive among them.
inline constexpr std::string_view kPathSigns = "/\\:";
/// Return whether the name of a program ends so after _ or a point: SHAFT.MPF, _N_SHAFT_MPF.
bool ends_in(std::string_view name, std::string_view ending);

}  // namespace cncsub
