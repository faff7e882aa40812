// Texts of expressions that stand in no program: the code has no numbers for them.
#pragma once

namespace cncsub {

/// What Ins::TextOf holds, in place of a WrittenAs, where its value is the place of a text among
/// Code::names: the run gives the text a number when it gets there.
constexpr int kForeignText = 15;

}  // namespace cncsub
