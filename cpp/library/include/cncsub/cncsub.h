/* The engine for every language that calls C: Rust, C#, Go, Delphi, JavaScript, Python's ctypes.
 *
 * Handles are opaque; each `..._new` and `..._run` gives one that its `..._free` takes back. Texts
 * are UTF-8 and end in a zero byte; one that is returned belongs to its handle and holds until the
 * handle is freed or the same function is called on it again. Numbers that are absent (a vacant
 * variable, a block without a sequence number) are NaN, or -1. A function that can be refused
 * returns 0, or NULL, and `cncsub_error` says why; so it is with a NULL that is no NULL by what its
 * function says. Nothing here throws or aborts. A library and a run may be used by many threads, a
 * machine by one at a time, and so is every handle that a function takes without const; the text
 * of an error belongs to the thread.
 *
 * A struct and a function never change: what comes later comes as a function, or a struct, of its
 * own. So what was compiled for CNCSUB_ABI 1 runs on, and where that is ever broken the number
 * grows; compare it with cncsub_abi() where the library is loaded at run time. */
#ifndef CNCSUB_H
#define CNCSUB_H

#include <stddef.h>
#include <stdint.h>

#define CNCSUB_ABI 1

#if defined(_WIN32)
#define CNCSUB_C
#else
#define CNCSUB_C __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct cncsub_library cncsub_library;
typedef struct cncsub_options cncsub_options;
typedef struct cncsub_run cncsub_run;
typedef struct cncsub_machine cncsub_machine;
typedef struct cncsub_comparison cncsub_comparison;

/* A place: a block of a program and the line of its file. */
typedef struct cncsub_place {
  const char *program, *file;
  int64_t n;     /* -1: no sequence number */
  uint32_t line; /* from 1 */
} cncsub_place;

typedef struct cncsub_alarm {
  const char* number; /* as on the screen; "" where no source gives one */
  const char* cause;  /* "program-not-found" */
  const char* text;   /* the control's */
  const char* shown;  /* what happened, where, the line with the word marked, the callers */
  const char* cure;
  cncsub_place at;
  uint32_t column; /* from 1, in characters */
} cncsub_alarm;

typedef struct cncsub_call {
  cncsub_place at;
  const char *kind, *called; /* "G65", "O2" */
  int64_t repeat, repeats;
} cncsub_call;

typedef struct cncsub_finding {
  const char *rule, *severity, *message; /* "CS201", "error", ... */
  cncsub_place at;
  uint32_t column;
} cncsub_finding;

/* A block that was executed. */
typedef struct cncsub_step {
  cncsub_place at;
  const char* text;
  int32_t depth;   /* open calls */
  int32_t skipped; /* its condition did not hold */
} cncsub_step;

/* A call as it is recorded; steps are those of `cncsub_run_step`. */
typedef struct cncsub_call_made {
  const char *kind, *called;
  int64_t parent;  /* the call in which it was made; -1: the main program */
  int64_t start_n; /* -1: its first block */
  int64_t repeats;
  int64_t caller_step, first_step, last_step; /* -1: it did not end */
} cncsub_call_made;

/* A variable that has a value. */
typedef struct cncsub_variable {
  int64_t number;   /* -1: it has a name */
  const char* name; /* "SIDES[1]", or "" */
  double value;     /* NaN: it is a text */
  const char* text; /* as people read it */
} cncsub_variable;

/* A rule or a parameter as two controls have it. */
typedef struct cncsub_rule {
  const char *name, *meaning;
  const char *values[2], *examples[2];
} cncsub_rule;

/* Columns of `cncsub_run_moves` values each; NULL: not wanted. Lengths in mm, times in s. */
typedef struct cncsub_columns {
  double *x, *y, *z;    /* ends, work coordinates */
  double *mx, *my, *mz; /* ends of the tool, machine coordinates */
  double *cx, *cy, *cz; /* centres of arcs, NaN elsewhere */
  double *feed, *length, *time;
  int32_t* kind; /* 0 rapid, 1 feed, 2 clockwise, 3 counterclockwise, 4 thread, 5 dwell */
  int64_t* step;
} cncsub_columns;

CNCSUB_C const char* cncsub_version(void);
CNCSUB_C int32_t cncsub_abi(void);
/* Why the last call of this thread was refused. */
CNCSUB_C const char* cncsub_error(void);
/* The name of a control by its place from 0 on; NULL after the last one. */
CNCSUB_C const char* cncsub_control(size_t index);

CNCSUB_C const char* cncsub_control_title(size_t index);

/* Read `count` texts with their names and sizes in bytes. */
CNCSUB_C cncsub_library* cncsub_library_new(const char* control, size_t count,
                                            const char* const* names, const char* const* texts,
                                            const size_t* sizes);
CNCSUB_C void cncsub_library_free(cncsub_library* library);
CNCSUB_C const char* cncsub_library_program(const cncsub_library* library, size_t index);
/* Look for what is wrong without running; return how many findings there are. */
CNCSUB_C size_t cncsub_library_check(cncsub_library* library);
CNCSUB_C int32_t cncsub_library_finding(const cncsub_library* library, size_t index,
                                        cncsub_finding* to);

/* What helps against a finding; "" where nothing is known. */
CNCSUB_C const char* cncsub_library_hint(const cncsub_library* library, size_t index);
/* Read the same texts for a control; `changes` are its rules and parameters that differ, a line
 * `name=value` each, or NULL. */
CNCSUB_C cncsub_library* cncsub_library_for(const cncsub_library* library, const char* control,
                                            const char* changes);

CNCSUB_C cncsub_options* cncsub_options_new(void);
CNCSUB_C void cncsub_options_free(cncsub_options* options);
/* "main" takes a text; "start", "max_blocks", "max_cycles", "max_seconds", "optional_stop",
 * "record" (0 to 3: nothing, calls, blocks, moves), "block_skip" (a switch that is on) take
 * numbers. */
CNCSUB_C int32_t cncsub_options_text(cncsub_options* options, const char* name, const char* value);
CNCSUB_C int32_t cncsub_options_number(cncsub_options* options, const char* name, double value);
CNCSUB_C int32_t cncsub_options_variable(cncsub_options* options, int32_t number, double value);
CNCSUB_C int32_t cncsub_options_signal(cncsub_options* options, int32_t number, double value);
CNCSUB_C int32_t cncsub_options_work_offset(cncsub_options* options, const char* system, char axis,
                                            double value);
CNCSUB_C int32_t cncsub_options_length_offset(cncsub_options* options, int32_t number,
                                              double value);
CNCSUB_C int32_t cncsub_options_radius_offset(cncsub_options* options, int32_t number,
                                              double value);
/* Where the tool stands at the start, work coordinates; else at the machine's zero. */
CNCSUB_C int32_t cncsub_options_start_position(cncsub_options* options, char axis, double value);

/* `options` may be NULL. */
CNCSUB_C cncsub_run* cncsub_library_run(const cncsub_library* library,
                                        const cncsub_options* options);
CNCSUB_C void cncsub_run_free(cncsub_run* run);
/* "end", "alarm", "cycles", "limit", "waiting", "interrupted" */
CNCSUB_C const char* cncsub_run_stop(const cncsub_run* run);
/* Return 0 where the run had none. */
CNCSUB_C int32_t cncsub_run_alarm(const cncsub_run* run, cncsub_alarm* to);
/* The word that the alarm names; "" where it is of the whole block, or there was none. */
CNCSUB_C const char* cncsub_run_alarm_word(const cncsub_run* run);
CNCSUB_C int32_t cncsub_run_alarm_call(const cncsub_run* run, size_t index, cncsub_call* to);
CNCSUB_C int64_t cncsub_run_blocks(const cncsub_run* run);
/* NaN: the variable is vacant, and `cncsub_error` is empty; or it was refused. */
CNCSUB_C double cncsub_run_variable(const cncsub_run* run, int64_t number);
CNCSUB_C size_t cncsub_run_moves(const cncsub_run* run);
CNCSUB_C int32_t cncsub_run_write_moves(const cncsub_run* run, const cncsub_columns* columns);

CNCSUB_C size_t cncsub_run_steps(const cncsub_run* run);
CNCSUB_C int32_t cncsub_run_step(cncsub_run* run, size_t index, cncsub_step* to);
CNCSUB_C size_t cncsub_run_calls(const cncsub_run* run);
CNCSUB_C int32_t cncsub_run_call(cncsub_run* run, size_t index, cncsub_call_made* to);
/* Find the path as points, within `tolerance` mm; return how many there are. Then write them:
 * coordinates (radii on a diameter axis), their moves, and where no line leads to a point. */
CNCSUB_C size_t cncsub_run_path(cncsub_run* run, double tolerance);
CNCSUB_C int32_t cncsub_run_write_path(const cncsub_run* run, double* x, double* y, double* z,
                                       uint32_t* move, uint8_t* begins);
/* Find the variables that have values where the run stopped; return how many there are. */
CNCSUB_C size_t cncsub_run_variables(cncsub_run* run);
CNCSUB_C int32_t cncsub_run_variable_at(const cncsub_run* run, size_t index, cncsub_variable* to);
/* What the program said, from index 0 on; NULL after the last one. */
CNCSUB_C const char* cncsub_run_message(cncsub_run* run, size_t index);
/* "#1000", "cycle start after M00"; "" where the run does not wait. */
CNCSUB_C const char* cncsub_run_waiting_for(cncsub_run* run);
CNCSUB_C double cncsub_run_length(const cncsub_run* run);
CNCSUB_C double cncsub_run_time(const cncsub_run* run);

/* Compare what two libraries do: the same texts, read for two controls. `what` is "" where they do
 * the same; `step`: where side 0 or 1 parts; the rules that make it, from index 0 on. */
CNCSUB_C cncsub_comparison* cncsub_compare(const cncsub_library* first,
                                           const cncsub_library* second,
                                           const cncsub_options* options);
CNCSUB_C void cncsub_comparison_free(cncsub_comparison* comparison);
CNCSUB_C const char* cncsub_comparison_what(const cncsub_comparison* comparison);
CNCSUB_C int64_t cncsub_comparison_step(const cncsub_comparison* comparison, int32_t side);
CNCSUB_C int32_t cncsub_comparison_rule(const cncsub_comparison* comparison, size_t index,
                                        cncsub_rule* to);
CNCSUB_C cncsub_run* cncsub_comparison_run(const cncsub_comparison* comparison, int32_t side);

CNCSUB_C cncsub_machine* cncsub_library_machine(const cncsub_library* library,
                                                const cncsub_options* options);
CNCSUB_C void cncsub_machine_free(cncsub_machine* machine);
/* Execute one block; return 0 where the run has stopped. */
CNCSUB_C int32_t cncsub_machine_step(cncsub_machine* machine);
CNCSUB_C int32_t cncsub_machine_run_to(cncsub_machine* machine, const char* program, int64_t n);
/* Run on for about so many blocks; return 1 where the run goes on after them. */
CNCSUB_C int32_t cncsub_machine_run(cncsub_machine* machine, int64_t blocks);
/* May be called by another thread while the machine runs. */
CNCSUB_C void cncsub_machine_interrupt(cncsub_machine* machine);
CNCSUB_C const char* cncsub_machine_stop(
    const cncsub_machine* machine); /* "running" while it runs */
CNCSUB_C void cncsub_machine_next(cncsub_machine* machine, cncsub_place* to);
/* An open call, innermost first; return 0 after the last one. */
CNCSUB_C int32_t cncsub_machine_call(cncsub_machine* machine, size_t index, cncsub_call* to);
CNCSUB_C double cncsub_machine_position(const cncsub_machine* machine, char axis);
/* NaN as in `cncsub_run_variable`; the locals are those of the present level. */
CNCSUB_C double cncsub_machine_variable(const cncsub_machine* machine, int64_t number);
CNCSUB_C int32_t cncsub_machine_set_variable(cncsub_machine* machine, int64_t number, double value);
/* What has happened so far. */
CNCSUB_C cncsub_run* cncsub_machine_so_far(const cncsub_machine* machine);

#ifdef __cplusplus
}
#endif

#endif
