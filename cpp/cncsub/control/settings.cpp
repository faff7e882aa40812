#include "cncsub/control/settings.hpp"

#include "cncsub/text/number.hpp"

namespace cncsub {
namespace {

int whole(double v) { return to_whole<int>(v, -2'000'000'000, 2'000'000'000); }
int thousandths(double v) { return whole(v < 0 ? v * 1000 - 0.5 : v * 1000 + 0.5); }

}  // namespace

Setting number(RuleOf<int> rule) {
  return {rule.name, [=](Control& c, double v) { rule.in(c).value = whole(v); }};
}

Setting number(RuleOf<int> rule, int for_zero) {
  return {rule.name, [=](Control& c, double v) { rule.in(c).value = v > 0 ? whole(v) : for_zero; }};
}

Setting micrometres(RuleOf<int> rule) {
  return {rule.name, [=](Control& c, double v) { rule.in(c).value = thousandths(v); }};
}

Setting micrometres_unless_zero(RuleOf<int> rule) {
  return {rule.name, [=](Control& c, double v) {
            if (v > 0) rule.in(c).value = thousandths(v);
          }};
}

Setting code_of(Role role, int usual) {
  return {rule::roles.name, [=](Control& c, double v) {
            Roles& roles = c.calls.roles.value;
            if (const auto before = roles.code_of(role)) roles.set(*before, Role::None);
            const int code = v > 0 && v < 1000 ? to_whole<int>(v) : usual;
            roles.set({'M', code * 10}, role);
          }};
}

}  // namespace cncsub
