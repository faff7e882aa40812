// Blocks that assign and say something besides executing words.
#include <algorithm>
#include <utility>
#include <vector>

#include "cncsub/machine/statements/output.hpp"
#include "cncsub/machine/statements/statements.hpp"
#include "cncsub/machine/values/expressions.hpp"

namespace cncsub {

namespace {

using In = Reference::In;

void remember(Run& run, const Reference& at) {
  const State& s = run.state;
  const double* const value = s.cell(at);
  if (value == nullptr) return;  // it is not assigned either
  const bool reported = at.in == In::Locals && !s.programmed.empty();
  run.block.before_together.variables.push_back(
      {at, *value, reported ? s.programmed[at.index] : std::uint8_t{0}});
}

/// Keep the elements of an array that an assignment is about to change.
void remember_elements(Run& run, const Statement& statement, double place) {
  const ArrayElements all = elements_of(run, statement, place);
  const std::int32_t most = statement.count == 0 ? all.left : std::min(statement.count, all.left);
  for (std::int32_t i = 0; i < most; ++i)
    remember(run, all.first.behind(static_cast<std::size_t>(i)));
}

/// Keep what a system variable may be: an offset, the clock, an image of locals.
void remember_system(Run& run) {
  std::optional<BeforeTogether::System>& system = run.block.before_together.system;
  if (!system) system = {run.state.locals, run.state.system, run.motion};
}

/// Keep what the assignment is about to change; `number`: its variable where that is computed.
void remember(Run& run, const Statement& statement, double number) {
  if (statement.is_element()) return remember_elements(run, statement, number);
  if (statement.target == Statement::Target::VariableAt) return remember_system(run);
  if (const auto variable = variable_of(run, statement)) return remember(run, *variable);
  const bool indirect = statement.target == Statement::Target::Indirect;
  const VariablePlace place =
      run.code->place(indirect ? to_whole<std::int64_t>(number) : statement.index);
  if (place.is_local())
    return remember(run, {In::Locals, run.local_at(run.state.level, place.index)});
  if (place.is_common()) return remember(run, {In::Commons, static_cast<std::size_t>(place.index)});
  remember_system(run);
}

}  // namespace

bool assign_in_parallel(Run& run) {
  const ParallelAssign& all = *std::exchange(run.block.parallel_assign, nullptr);
  const Statement* statements = run.code->statements.data() + all.first_statement;
  std::vector<double> values(all.statements), numbers(all.statements);
  for (std::uint32_t i = 0; i < all.statements; ++i) {
    if (statements[i].is_computed() && !evaluate(run, statements[i].variable, numbers[i]))
      return false;
    if (!evaluate(run, statements[i].expression, values[i])) return false;
  }
  run.block.before_together.messages = run.trace.messages.size();
  for (std::uint32_t i = 0; i < all.statements; ++i) {
    const Statement& statement = statements[i];
    const bool indirect = statement.target == Statement::Target::Indirect;
    remember(run, statement, numbers[i]);
    const bool stored =
        statement.is_element() ? store_elements(run, statement, numbers[i], values[i])
        : indirect ? store_number(run, to_whole<std::int64_t>(numbers[i]), values[i], statement)
                   : store(run, statement, values[i]);
    if (!stored) return false;
  }
  return all.print == OWord::kNone || print(run, run.code->prints[all.print]);
}

}  // namespace cncsub
