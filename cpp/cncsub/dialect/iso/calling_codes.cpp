#include "cncsub/dialect/iso/calling_codes.hpp"

#include <algorithm>
#include <cmath>

#include "cncsub/control/code_calls.hpp"

namespace cncsub {

CallingCodes::CallingCodes(const Code& code) {
  each_code_call(*code.control,
                 [&](const CodeCall& list, std::int32_t number, std::int32_t program) {
                   if (list.form == CodeCall::Form::Switch)
                     add_letter(list.address, {.kind = list.kind,
                                               .program = program,
                                               .variable = list.variable,
                                               .by_name = calls_by_name(list)});
                   else
                     add_code(code, list, number, program);
                 });
  for (const CodeCall& list : code.control->code_calls)
    if (calls_all(list))
      all_.push_back({list.address,
                      static_cast<double>(list.first_code),
                      list.last_code + 1.0,
                      {.kind = list.kind, .variable = list.variable, .by_name = true}});
  for (const auto& entry : code.control->calls.registered_codes.value) add_registered(code, entry);
}

/// Add what a rule registers, within the limits that the control sets for the address.
void CallingCodes::add_registered(const Code& code, const RegisteredCodes::Entry& entry) {
  const auto& lists = code.control->code_calls;
  const auto own = std::find_if(lists.begin(), lists.end(), [&entry](const CodeCall& list) {
    return list.address == entry.letter;
  });
  CodeCall list = own == lists.end() ? CodeCall{} : *own;
  list.address = entry.letter;
  list.kind = entry.kind;
  if (entry.code == 0)
    add_letter(list.address, {list.kind, entry.program, list.variable});
  else
    add_code(code, list, entry.code, entry.program);
}

void CallingCodes::add_code(const Code& code, const CodeCall& list, std::int32_t number,
                            std::int32_t program) {
  RegisteredCall call{.kind = list.kind,
                      .program = program,
                      .variable = list.variable,
                      .by_name = calls_by_name(list)};
  if (list.address == '@') {  // the parameter holds a letter, and every code of it calls
    call.ascii = true;
    if (number >= 'A' && number <= 'Z') add_letter(static_cast<char>(number), call);
    return;
  }
  const bool g = list.address == 'G';
  if (g && number < 0) {  // a negative G code calls modally
    number = -number;
    const bool every = !list.every_block.empty() && code.control->parameter(list.every_block) != 0;
    call.kind = every ? CodeCallKind::ModalEveryBlock : CodeCallKind::Modal;
  }
  const std::int64_t tenths = list.tenths_of(number);
  if (tenths < std::max(std::int64_t{list.first_code} * 10, std::int64_t{1}) ||
      tenths > std::int64_t{list.last_code} * 10)
    return;
  const bool listed = tenths < static_cast<std::int64_t>(code.g_codes.size());
  if (g && listed && code.g_codes.test(static_cast<std::size_t>(tenths)) && !list.own_codes) return;
  call.refused = listed && list.refused.has(static_cast<int>(tenths));
  codes_.emplace(key(list.address, tenths), call);
}

void CallingCodes::add_letter(char address, const RegisteredCall& call) {
  of_letters_.push_back(call);
  letters_[place(address)] = of_letters_.size();
}

bool CallingCodes::any(char address) const {
  return letters_[place(address)] != 0 ||
         std::any_of(all_.begin(), all_.end(),
                     [&](const AllCodes& all) { return all.address == address; }) ||
         std::any_of(codes_.begin(), codes_.end(),
                     [&](const auto& code) { return code.first >> kAddress == address; });
}

const RegisteredCall* CallingCodes::find(char address, double code) const {
  if (letters_[place(address)] != 0) return &of_letters_[letters_[place(address)] - 1];
  for (const AllCodes& all : all_)
    if (all.address == address && code >= all.first && code < all.behind) return &all.call;
  if (codes_.empty() || code < 0 || code > 1e9) return nullptr;
  const double tenths = std::round(code * 10);
  if (code != tenths / 10) return nullptr;
  const auto found = codes_.find(key(address, to_whole<std::int64_t>(tenths)));
  return found == codes_.end() ? nullptr : &found->second;
}

}  // namespace cncsub
