// The folders of a control in which programs lie, and the search of a call along them.
//
// A control without a search path has one memory: folders make no difference there. On one that has
// a search path, a program whose folder nothing tells may lie in any of them. It is found after
// those of the folder of the main program.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/code/code.hpp"

namespace cncsub {

/// Where a search begins: the main program, and the path of the folder that a program has added.
/// `added_unknown`: before a run, where some program adds one, it may be any folder.
struct SearchFrom {
  std::int32_t main = kNoProgram;
  std::string_view added{};
  bool added_unknown = false;
};

/// Return the program that a name means in a call, with what stands before it there; kNoProgram
/// where none of the searched folders has it.
std::int32_t find_called(const Code& code, std::string_view name, std::string_view path,
                         const SearchFrom& from);
/// Return the programs of a name that a call may mean, by the main program.
std::vector<std::int32_t> programs_named(const Code& code, std::string_view name);
/// Return whether a call means the same program, or none, under each main program.
bool means_one(const Code& code, std::string_view name, std::string_view path);
/// Return where the calls of a program begin their search as far as is known before it runs: it is
/// a main program itself, or one that the main program of the memory calls.
SearchFrom known_search(const Code& code, std::int32_t program);
/// Return the folders, not searched, in which a program of the name lies: ` (it is in CUS.DIR)`.
std::string told_elsewhere(const Code& code, std::string_view name);

/// Return the place in the search path of the folder of a program, -1 where it is none of the
/// path's.
int place_in_path(const Code& code, const Program& program);
/// Return the folder of the control in which a program lies; empty where nothing tells it.
std::string folder_of(const Code& code, const Program& program);
/// Return whether two folders are the same one, of which either may lack what it lies in.
bool is_same_folder(std::string_view one, std::string_view other);
/// Return whether a program is named as a main program.
bool is_main(const Code& code, const Program& program);

}  // namespace cncsub
