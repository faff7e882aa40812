#include "cncsub/machine/together.hpp"

#include <utility>
#include <vector>

#include "cncsub/machine/expressions.hpp"
#include "cncsub/machine/output.hpp"
#include "cncsub/machine/run.hpp"
#include "cncsub/machine/statements.hpp"

namespace cncsub {

bool run_together(Run& run, const Block& block) {
  const Together& all = run.code->together[block.aux];
  run.block.together = &all;
  bool done = false;
  if (all.words != Labelled::kNone) {
    done = dispatch(run, run.code->variants[all.words]);
  } else if (set_together(run)) {
    if (block.n >= 0) run.state.last_n = block.n;
    record_step(run);
    run.state.pc = run.block.next;
    done = true;
  }
  run.block.together = nullptr;
  return done;
}

bool set_together(Run& run) {
  const Together& all = *std::exchange(run.block.together, nullptr);
  const Statement* statements = run.code->statements.data() + all.first_statement;
  std::vector<double> values(all.statements), numbers(all.statements);
  for (std::uint32_t i = 0; i < all.statements; ++i) {
    const bool indirect = statements[i].target == Statement::Target::Indirect;
    if (indirect && !evaluate(run, statements[i].variable, numbers[i])) return false;
    if (!evaluate(run, statements[i].expression, values[i])) return false;
  }
  for (std::uint32_t i = 0; i < all.statements; ++i) {
    const Statement& statement = statements[i];
    const bool indirect = statement.target == Statement::Target::Indirect;
    const bool stored =
        indirect ? store_number(run, to_whole<std::int64_t>(numbers[i]), values[i], statement)
                 : store(run, statement, values[i]);
    if (!stored) return false;
  }
  return all.print == Labelled::kNone || print(run, run.code->prints[all.print]);
}

}  // namespace cncsub
