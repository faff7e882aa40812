// Blocks that assign and say something besides executing words.
#include <algorithm>
#include <utility>
#include <vector>

#include "cncsub/machine/statements/output.hpp"
#include "cncsub/machine/statements/statements.hpp"
#include "cncsub/machine/values/expressions.hpp"

namespace cncsub {

namespace {

using In = BeforeTogether::Variable::In;

void remember(Run& run, In in, std::size_t index) {
  const State& s = run.state;
  const bool reported = in == In::Locals && !s.programmed.empty();
  const double value = (in == In::Locals     ? s.locals
                        : in == In::Elements ? s.elements
                                             : s.commons)[index];
  run.block.before_together.variables.push_back(
      {in, index, value, reported ? s.programmed[index] : std::uint8_t{0}});
}

bool is_element(const Statement& statement) {
  return statement.target == Statement::Target::Element ||
         statement.target == Statement::Target::CommonElement;
}

/// Keep the elements of an array that an assignment is about to change.
void remember_elements(Run& run, const Statement& statement, double place) {
  const auto first = static_cast<std::size_t>(statement.index) + to_whole<std::size_t>(place);
  const bool common = statement.target == Statement::Target::CommonElement;
  const std::int32_t left = statement.number - to_whole<std::int32_t>(place);
  const std::int32_t most = statement.count == 0 ? left : std::min(statement.count, left);
  const auto count = static_cast<std::size_t>(std::max(most, 0));
  for (std::size_t i = first; i < first + count; ++i)
    remember(run, common ? In::Commons : In::Elements, common ? i : run.element_at(i));
}

/// Keep what a system variable may be: an offset, the clock, an image of locals.
void remember_system(Run& run) {
  std::optional<BeforeTogether::System>& system = run.block.before_together.system;
  if (!system) system = {run.state.locals, run.state.system, run.motion};
}

/// Keep what the assignment is about to change; `number`: its variable where that is computed.
void remember(Run& run, const Statement& statement, double number) {
  const auto index = static_cast<std::size_t>(statement.index);
  if (statement.target == Statement::Target::Local)
    return remember(run, In::Locals, run.local_at(run.state.level, statement.index));
  if (statement.target == Statement::Target::Common) return remember(run, In::Commons, index);
  if (is_element(statement)) return remember_elements(run, statement, number);
  if (statement.target == Statement::Target::VariableAt) return remember_system(run);
  const bool indirect = statement.target == Statement::Target::Indirect;
  const VariablePlace place =
      run.code->place(indirect ? to_whole<std::int64_t>(number) : statement.index);
  if (place.is_local())
    return remember(run, In::Locals, run.local_at(run.state.level, place.index));
  if (place.is_common()) return remember(run, In::Commons, static_cast<std::size_t>(place.index));
  remember_system(run);
}

}  // namespace

bool assign_in_parallel(Run& run) {
  const ParallelAssign& all = *std::exchange(run.block.parallel_assign, nullptr);
  const Statement* statements = run.code->statements.data() + all.first_statement;
  std::vector<double> values(all.statements), numbers(all.statements);
  for (std::uint32_t i = 0; i < all.statements; ++i) {
    const bool indirect = statements[i].target >= Statement::Target::Indirect;
    if (indirect && !evaluate(run, statements[i].variable, numbers[i])) return false;
    if (!evaluate(run, statements[i].expression, values[i])) return false;
  }
  run.block.before_together.messages = run.trace.messages.size();
  for (std::uint32_t i = 0; i < all.statements; ++i) {
    const Statement& statement = statements[i];
    const bool indirect = statement.target == Statement::Target::Indirect;
    remember(run, statement, numbers[i]);
    const bool stored =
        is_element(statement) ? store_elements(run, statement, numbers[i], values[i])
        : indirect ? store_number(run, to_whole<std::int64_t>(numbers[i]), values[i], statement)
                   : store(run, statement, values[i]);
    if (!stored) return false;
  }
  return all.print == OWord::kNone || print(run, run.code->prints[all.print]);
}

}  // namespace cncsub
