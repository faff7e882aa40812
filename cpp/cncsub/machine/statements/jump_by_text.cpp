// Jumps to the block that a text names: it is searched for when the jump is made.
#include <algorithm>
#include <charconv>
#include <iterator>
#include <string>
#include <utility>

#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/statements/statements.hpp"
#include "cncsub/machine/values/expressions.hpp"
#include "cncsub/machine/values/texts.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

/// Return the nearest of two blocks in the direction of a search.
Address nearest(Statement::Search search, Address behind, Address before) {
  if (search != Statement::Search::Back && behind != kNowhere) return behind;
  return search != Statement::Search::Forward ? before : kNowhere;
}

/// Return the block of the running program that a text names: N10, 10 or a label.
Address named_block(const Run& run, const std::string& text, Statement::Search search) {
  const Code& code = *run.code;
  const Program& program = run.program();
  const Address pc = run.state.pc;
  const std::size_t digits = text.starts_with('N') ? 1 : 0;
  std::int32_t n = 0;
  const char* const last = text.data() + text.size();
  const auto read = std::from_chars(text.data() + std::min(digits, text.size()), last, n);
  if (read.ec == std::errc() && read.ptr == last && n >= 0)
    return nearest(search, code.next_of(program, n, pc), code.last_of(program, n, pc + 1));
  const auto label = code.label_places.find(text);
  if (label == code.label_places.end()) return kNowhere;
  const auto behind =
      std::upper_bound(code.heads.begin(), code.heads.end(), std::pair(label->second, pc),
                       [](const auto& at, const LabelledHead& of) {
                         return at < std::pair(of.label, Address{of.address});
                       });
  const auto address = [&](auto of, bool exists) {
    const bool own = exists && of->label == label->second && of->address >= program.first &&
                     of->address < program.last;
    return own ? Address{of->address} : kNowhere;
  };
  return nearest(search, address(behind, behind != code.heads.end()),
                 behind == code.heads.begin() ? kNowhere : address(std::prev(behind), true));
}

}  // namespace

bool jump_by_text(Run& run, const Statement& statement) {
  double value = 0;
  if (!evaluate(run, statement.variable, value)) return false;
  const std::string text = capitals(trimmed(text_of(run, value)));
  const Address to = named_block(run, text, statement.search);
  const bool inside = to != kNowhere && run.code->leads_inside(run.state.pc, to);
  if (to != kNowhere && !inside) return jump_to(run, to);
  if (statement.search == Statement::Search::BothOrOn) return true;
  return alarm(run, {Cause::JumpTargetNotFound, statement.variable_at, statement.variable_width,
                     inside ? text + " is inside a control structure, and the jump is outside it"
                            : "no block " + text + " in the direction of the search"});
}

}  // namespace cncsub
