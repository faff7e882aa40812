/* Calls every function of the C face, rightly and wrongly, and frees each handle once. It is built under the sanitizers,
 * which end it where the library reads or frees what is not its own, leaks, or overflows. */
#include <cncsub/cncsub.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failed = 0;

#define EXPECT(claim) \
  do { \
    if (!(claim)) failed = 1, fprintf(stderr, "%s:%d: %s (%s)\n", __FILE__, __LINE__, #claim, cncsub_error()); \
  } while (0)

#define FAR SIZE_MAX

static const double kOdd[] = {0.0, -0.0, -1.0, 1e308, -1e308, 5e-324, 0.5, 1e-9};
static const int64_t kWhole[] = {0, -1, 1, 100, 999999, INT32_MAX, INT32_MIN, INT64_MAX, INT64_MIN};
static const char* const kTexts[] = {"", "=", "=\n=", "\n\n\n", "a", "max_nesting", "max_nesting=", "max_nesting=1=2",
                                     "6050=1e999", "\xff\xfe=\x80", "zero_repeats=once\r\n", "6050=nan"};
enum { ODD = sizeof kOdd / sizeof *kOdd, WHOLE = sizeof kWhole / sizeof *kWhole, TEXTS = sizeof kTexts / sizeof *kTexts };

static cncsub_library* read_text(const char* control, const char* text) {
  const char* name = "job.nc";
  const size_t size = strlen(text);
  return cncsub_library_new(control, 1, &name, &text, &size);
}

/* Read every text of a place, so that a pointer to what is gone is found. */
static size_t look(const cncsub_place* at) { return strlen(at->program) + strlen(at->file); }

static void look_at_run(cncsub_run* run) {
  if (run == NULL) return;
  cncsub_alarm alarm;
  cncsub_call call;
  cncsub_step step;
  cncsub_call_made made;
  cncsub_variable variable;
  size_t seen = strlen(cncsub_run_stop(run)) + strlen(cncsub_run_alarm_word(run)) + strlen(cncsub_run_waiting_for(run));
  if (cncsub_run_alarm(run, &alarm))
    seen += look(&alarm.at) + strlen(alarm.number) + strlen(alarm.cause) + strlen(alarm.text) + strlen(alarm.shown) +
            strlen(alarm.cure);
  for (size_t i = 0; cncsub_run_alarm_call(run, i, &call); ++i) seen += look(&call.at) + strlen(call.kind) + strlen(call.called);
  EXPECT(!cncsub_run_alarm_call(run, FAR, &call));
  for (size_t i = 0; i < cncsub_run_steps(run) && i < 50; ++i)
    if (cncsub_run_step(run, i, &step)) seen += look(&step.at) + strlen(step.text);
  EXPECT(!cncsub_run_step(run, FAR, &step));
  EXPECT(!cncsub_run_step(run, cncsub_run_steps(run), &step));
  for (size_t i = 0; i < cncsub_run_calls(run); ++i)
    if (cncsub_run_call(run, i, &made)) seen += strlen(made.kind) + strlen(made.called);
  EXPECT(!cncsub_run_call(run, FAR, &made));
  EXPECT(!cncsub_run_variable_at(run, 0, &variable)); /* they were not looked for */
  const size_t variables = cncsub_run_variables(run);
  for (size_t i = 0; i < variables; ++i)
    if (cncsub_run_variable_at(run, i, &variable)) seen += strlen(variable.name) + strlen(variable.text);
  EXPECT(!cncsub_run_variable_at(run, FAR, &variable));
  for (size_t i = 0; cncsub_run_message(run, i) != NULL; ++i) seen += strlen(cncsub_run_message(run, i));
  EXPECT(cncsub_run_message(run, FAR) == NULL);
  for (int i = 0; i < WHOLE; ++i) cncsub_run_variable(run, kWhole[i]);
  const size_t moves = cncsub_run_moves(run);
  cncsub_columns columns;
  memset(&columns, 0, sizeof columns);
  EXPECT(cncsub_run_write_moves(run, &columns)); /* nothing is wanted */
  double* const numbers = malloc((moves + 1) * 12 * sizeof(double)); /* exactly as long as is told */
  double** const wanted[] = {&columns.x,  &columns.y,  &columns.z,  &columns.mx,   &columns.my,     &columns.mz,
                             &columns.cx, &columns.cy, &columns.cz, &columns.feed, &columns.length, &columns.time};
  for (size_t i = 0; i < 12; ++i) *wanted[i] = numbers + i * moves;
  columns.kind = malloc((moves + 1) * sizeof(int32_t));
  columns.step = malloc((moves + 1) * sizeof(int64_t));
  EXPECT(cncsub_run_write_moves(run, &columns));
  free(numbers), free(columns.kind), free(columns.step);
  for (int i = 0; i < ODD; ++i) {
    if (kOdd[i] == 5e-324 || kOdd[i] == 1e-9) continue; /* many points, which nothing here is about */
    const size_t points = cncsub_run_path(run, kOdd[i]);
    double* const x = malloc((points + 1) * sizeof(double));
    uint32_t* const move = malloc((points + 1) * sizeof(uint32_t));
    uint8_t* const begins = malloc(points + 1);
    EXPECT(cncsub_run_write_path(run, x, x, x, move, begins));
    EXPECT(cncsub_run_write_path(run, NULL, NULL, NULL, NULL, NULL));
    free(x), free(move), free(begins);
  }
  cncsub_run_path(run, NAN);
  EXPECT(cncsub_run_blocks(run) >= 0 && cncsub_run_length(run) >= 0);
  cncsub_run_time(run);
  EXPECT(seen + 1 > 0);
}

/* What a program is run with, odd values among it. The caller frees it. */
static cncsub_options* odd_options(int which) {
  cncsub_options* const options = cncsub_options_new();
  static const char* const kNames[] = {"start", "max_blocks", "max_cycles", "max_seconds", "optional_stop", "record",
                                       "block_skip", "", "speed", NULL};
  const double value = which < 0 ? 0 : which < ODD ? kOdd[which] : which == ODD ? NAN : INFINITY;
  EXPECT(cncsub_options_number(options, "max_blocks", 500));
  if (which >= 0) {
    cncsub_options_number(options, kNames[which % 10], value);
    cncsub_options_variable(options, which % 2 ? 100 : INT32_MIN, value);
    cncsub_options_signal(options, which % 3 ? 1000 : INT32_MAX, value);
    cncsub_options_work_offset(options, which % 2 ? "G54" : "", which % 3 ? 'X' : '\0', value);
    cncsub_options_length_offset(options, which % 2 ? 1 : INT32_MIN, value);
    cncsub_options_radius_offset(options, which % 2 ? 1 : INT32_MAX, value);
    cncsub_options_start_position(options, which % 2 ? 'Z' : '\xff', value);
    cncsub_options_text(options, which % 2 ? "main" : "", which % 3 ? "" : "O9");
  }
  return options;
}

static void look_at_machine(const cncsub_library* library, const cncsub_options* options) {
  cncsub_machine* const machine = cncsub_library_machine(library, options);
  if (machine == NULL) return;
  cncsub_place next;
  cncsub_call call;
  for (int i = 0; i < WHOLE; ++i) {
    for (int k = 0; k < ODD; ++k) cncsub_machine_set_variable(machine, kWhole[i], kOdd[k]);
    cncsub_machine_set_variable(machine, kWhole[i], NAN);
    cncsub_machine_variable(machine, kWhole[i]);
    cncsub_machine_run_to(machine, "", kWhole[i]);
    cncsub_machine_run_to(machine, "O1", kWhole[i]);
  }
  for (int axis = -128; axis < 128; ++axis) cncsub_machine_position(machine, (char)axis);
  cncsub_machine_next(machine, &next);
  size_t seen = look(&next);
  cncsub_machine_step(machine);
  for (size_t i = 0; cncsub_machine_call(machine, i, &call); ++i) seen += look(&call.at);
  EXPECT(!cncsub_machine_call(machine, FAR, &call));
  cncsub_machine_interrupt(machine); /* the next run, then */
  cncsub_machine_run(machine, 10);
  for (int i = 0; i < WHOLE; ++i) cncsub_machine_run(machine, kWhole[i] > 1000 ? 1000 : kWhole[i]);
  cncsub_run* const so_far = cncsub_machine_so_far(machine);
  cncsub_machine_run(machine, INT64_MAX); /* 500 blocks at most */
  cncsub_machine_next(machine, &next);
  seen += look(&next) + strlen(cncsub_machine_stop(machine));
  cncsub_machine_free(machine); /* what it has told so far is its own */
  look_at_run(so_far);
  cncsub_run_free(so_far);
  EXPECT(seen + 1 > 0);
}

static void look_at_library(cncsub_library* library) {
  if (library == NULL) return;
  cncsub_finding finding;
  size_t seen = 0;
  for (size_t i = 0; cncsub_library_program(library, i) != NULL; ++i) seen += strlen(cncsub_library_program(library, i));
  EXPECT(cncsub_library_program(library, FAR) == NULL);
  EXPECT(!cncsub_library_finding(library, 0, &finding)); /* nothing was looked for */
  for (int twice = 0; twice < 2; ++twice) {
    const size_t findings = cncsub_library_check(library);
    for (size_t i = 0; i < findings; ++i) {
      if (cncsub_library_finding(library, i, &finding))
        seen += look(&finding.at) + strlen(finding.rule) + strlen(finding.severity) + strlen(finding.message);
      seen += strlen(cncsub_library_hint(library, i));
    }
    EXPECT(!cncsub_library_finding(library, FAR, &finding));
    EXPECT(cncsub_library_hint(library, FAR) == NULL);
  }
  for (int i = -1; i < ODD + 2; ++i) {
    cncsub_options* const options = odd_options(i);
    cncsub_run* const run = cncsub_library_run(library, options);
    look_at_run(run);
    cncsub_run_free(run);
    look_at_machine(library, options);
    cncsub_options_free(options);
  }
  EXPECT(seen + 1 > 0);
}

/* Compare a library with itself read for another control; free the libraries before the comparison is looked at. */
static void compare(const char* control, const char* other, const char* text) {
  cncsub_library* const first = read_text(control, text);
  cncsub_library* const second = cncsub_library_for(first, other, NULL);
  cncsub_options* const options = odd_options(-1);
  cncsub_comparison* const comparison = cncsub_compare(first, second, options);
  cncsub_options_free(options);
  cncsub_library_free(first);
  cncsub_library_free(second);
  EXPECT(comparison != NULL);
  if (comparison == NULL) return;
  cncsub_rule rule;
  size_t seen = strlen(cncsub_comparison_what(comparison));
  for (size_t i = 0; cncsub_comparison_rule(comparison, i, &rule); ++i)
    for (int side = 0; side < 2; ++side)
      seen += strlen(rule.name) + strlen(rule.meaning) + strlen(rule.values[side]) + strlen(rule.examples[side]);
  EXPECT(!cncsub_comparison_rule(comparison, FAR, &rule));
  cncsub_run* const one = cncsub_comparison_run(comparison, 0);
  cncsub_run* const two = cncsub_comparison_run(comparison, 1);
  EXPECT(cncsub_comparison_run(comparison, -1) == NULL && cncsub_comparison_run(comparison, INT32_MAX) == NULL);
  EXPECT(cncsub_comparison_step(comparison, 0) >= 0 && cncsub_comparison_step(comparison, 2) == -1);
  cncsub_comparison_free(comparison);
  look_at_run(one);
  look_at_run(two);
  cncsub_run_free(one);
  cncsub_run_free(two);
  EXPECT(seen + 1 > 0);
}

static void refuse_null(void) {
  EXPECT(cncsub_library_new(NULL, 0, NULL, NULL, NULL) == NULL);
  EXPECT(cncsub_library_new("fanuc-0i-f", FAR, NULL, NULL, NULL) == NULL);
  cncsub_library_free(NULL), cncsub_options_free(NULL), cncsub_run_free(NULL);
  cncsub_machine_free(NULL), cncsub_comparison_free(NULL);
  EXPECT(cncsub_library_program(NULL, 0) == NULL && cncsub_library_check(NULL) == 0);
  EXPECT(!cncsub_library_finding(NULL, 0, NULL) && cncsub_library_hint(NULL, 0) == NULL);
  EXPECT(cncsub_library_for(NULL, NULL, NULL) == NULL);
  EXPECT(!cncsub_options_text(NULL, NULL, NULL) && !cncsub_options_number(NULL, NULL, 0));
  EXPECT(!cncsub_options_variable(NULL, 0, 0) && !cncsub_options_signal(NULL, 0, 0));
  EXPECT(!cncsub_options_work_offset(NULL, NULL, 'X', 0) && !cncsub_options_length_offset(NULL, 0, 0));
  EXPECT(!cncsub_options_radius_offset(NULL, 0, 0) && !cncsub_options_start_position(NULL, 'X', 0));
  EXPECT(cncsub_library_run(NULL, NULL) == NULL && cncsub_library_machine(NULL, NULL) == NULL);
  EXPECT(*cncsub_run_stop(NULL) == 0 && !cncsub_run_alarm(NULL, NULL) && *cncsub_run_alarm_word(NULL) == 0);
  EXPECT(!cncsub_run_alarm_call(NULL, 0, NULL) && cncsub_run_blocks(NULL) == 0 && isnan(cncsub_run_variable(NULL, 1)));
  EXPECT(cncsub_run_moves(NULL) == 0 && !cncsub_run_write_moves(NULL, NULL));
  EXPECT(cncsub_run_steps(NULL) == 0 && !cncsub_run_step(NULL, 0, NULL));
  EXPECT(cncsub_run_calls(NULL) == 0 && !cncsub_run_call(NULL, 0, NULL));
  EXPECT(cncsub_run_path(NULL, 1) == 0 && !cncsub_run_write_path(NULL, NULL, NULL, NULL, NULL, NULL));
  EXPECT(cncsub_run_variables(NULL) == 0 && !cncsub_run_variable_at(NULL, 0, NULL));
  EXPECT(cncsub_run_message(NULL, 0) == NULL && *cncsub_run_waiting_for(NULL) == 0);
  EXPECT(cncsub_run_length(NULL) == 0 && cncsub_run_time(NULL) == 0);
  EXPECT(cncsub_compare(NULL, NULL, NULL) == NULL && *cncsub_comparison_what(NULL) == 0);
  EXPECT(cncsub_comparison_step(NULL, 0) == -1 && !cncsub_comparison_rule(NULL, 0, NULL));
  EXPECT(cncsub_comparison_run(NULL, 0) == NULL);
  EXPECT(!cncsub_machine_step(NULL) && !cncsub_machine_run_to(NULL, NULL, 0) && !cncsub_machine_run(NULL, 1));
  cncsub_machine_interrupt(NULL), cncsub_machine_next(NULL, NULL);
  EXPECT(*cncsub_machine_stop(NULL) == 0 && !cncsub_machine_call(NULL, 0, NULL));
  EXPECT(isnan(cncsub_machine_position(NULL, 'X')) && isnan(cncsub_machine_variable(NULL, 1)));
  EXPECT(!cncsub_machine_set_variable(NULL, 1, 1) && cncsub_machine_so_far(NULL) == NULL);
  EXPECT(strstr(cncsub_error(), "NULL") != NULL);
}

int main(void) {
  static const char* const kPrograms[] = {
      "",
      "%",
      "O1\nN10 #100=1\nN20 G65 P2 A3\nN30 G1 X#100 F100\nN40 M30\nO2\nN50 #100=#1*2\nN60 #3000=1(BAD)\nM99\n",
      "O1\nN10 G90 G54 G0 X0 Y0 Z5.\nN20 G1 X10. Y5.5 F200.\nN30 G2 X20. Y5.5 I5. J0\nN35 #3006=1(HELLO)\nN40 M30\n",
      "O1\nN10 M98 P2 L0\nN20 G0 X10\nN30 M98 P20003\nM30\nO2\nM99\nO3\nM99\n",
      "DEF INT SIDES[2]=SET(3,4)\nDEF STRING[8] NAME=\"A\"<<SIDES[1]\nR5=2.5\nG2 X1 I1\nM30\n",
      "O1\nN10 GOTO10\n",
      "O1\nM98 P1\n",
      "((((((((((\n[[[[[[[\nX99999999999999999999999.\nN99999999999\n\xff\xfe\n",
  };
  EXPECT(strlen(cncsub_version()) > 0 && cncsub_abi() == CNCSUB_ABI);
  refuse_null();
  size_t controls = 0;
  for (; cncsub_control(controls) != NULL; ++controls) EXPECT(strlen(cncsub_control_title(controls)) > 0);
  EXPECT(controls > 10 && cncsub_control(FAR) == NULL && cncsub_control_title(FAR) == NULL);
  const char* nothing = NULL;
  const size_t none = 0, huge = SIZE_MAX;
  const char* text = "O1\n";
  EXPECT(cncsub_library_new("", 0, NULL, NULL, NULL) == NULL);
  EXPECT(cncsub_library_new("fanuc-0i-f", 1, &nothing, &nothing, &none) == NULL);
  EXPECT(cncsub_library_new("fanuc-0i-f", 1, &nothing, &text, &huge) == NULL); /* no text is so long */
  cncsub_library* const empty = cncsub_library_new("fanuc-0i-f", 0, NULL, NULL, NULL);
  look_at_library(empty);
  cncsub_library_free(empty);
  cncsub_library* const unnamed = cncsub_library_new("fanuc-0i-f", 1, &nothing, &text, &none);
  look_at_library(unnamed);
  cncsub_library_free(unnamed);
  for (size_t i = 0; i < sizeof kPrograms / sizeof *kPrograms; ++i)
    for (size_t control = i; control < controls; control += 7) {
      cncsub_library* const library = read_text(cncsub_control(control), kPrograms[i]);
      EXPECT(library != NULL);
      look_at_library(library);
      for (int k = 0; k < TEXTS; ++k) {
        cncsub_library* const changed = cncsub_library_for(library, k % 4 ? "fanuc-0i-f" : kTexts[k], kTexts[k]);
        if (changed != NULL) cncsub_library_check(changed);
        cncsub_library_free(changed);
      }
      cncsub_library_free(library);
      compare(cncsub_control(control), cncsub_control((control + i + 1) % controls), kPrograms[i]);
    }
  return failed;
}
