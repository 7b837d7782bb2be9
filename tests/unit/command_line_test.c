/* The command line: the forms that an option may have, and what is left after them. */
#include "check.h"
#include "command_line.h"

#include <stdbool.h>
#include <stdio.h>

typedef struct parsed {
    bool ok;
    char message[200];
    int count; /* of the arguments that are no options */
    char *arguments[8];
    const char *output;
    bool flag;
} parsed;

/* Reads a NULL-terminated list of arguments. */
static parsed parse(const char *const *arguments)
{
    parsed result = {.arguments = {(char *)"program"}};
    const command_option options[] = {{"output", 'o', read_text, &result.output, NULL}, {"flag", 0, NULL, &result.flag, NULL}};
    const command_program program = {"program", "", options, 2};
    int count = 1;
    for (; arguments[count - 1]; count++)
        result.arguments[count] = (char *)arguments[count - 1];
    result.ok = command_line_read(&count, result.arguments, &program, result.message, sizeof result.message);
    result.count = count - 1;
    return result;
}

#define PARSE(...) parse((const char *const[]){__VA_ARGS__, NULL})

static void a_value_may_be_apart_or_attached(void **state)
{
    (void)state;
    const parsed results[] = {PARSE("--output", "x"), PARSE("--output=x"), PARSE("-o", "x"), PARSE("-ox")};
    for (int i = 0; i < 4; i++) {
        assert_true(results[i].ok);
        assert_string_equal(results[i].output, "x");
        assert_int_equal(results[i].count, 0);
    }
    parsed empty = PARSE("--output=");
    assert_true(empty.ok);
    assert_string_equal(empty.output, "");
}

static void options_may_stand_between_the_other_arguments(void **state)
{
    (void)state;
    parsed result = PARSE("a", "--flag", "b", "-o", "--flag", "-", "c");
    assert_true(result.ok && result.flag);
    assert_string_equal(result.output, "--flag");
    assert_int_equal(result.count, 4);
    const char *const left[] = {"a", "b", "-", "c"};
    for (int i = 0; i < 4; i++)
        assert_string_equal(result.arguments[1 + i], left[i]);
}

static void after_two_dashes_there_are_no_options(void **state)
{
    (void)state;
    parsed result = PARSE("--", "--flag", "-o");
    assert_true(result.ok && !result.flag && !result.output);
    assert_int_equal(result.count, 2);
    assert_string_equal(result.arguments[1], "--flag");
}

static void what_is_no_option_is_named(void **state)
{
    (void)state;
    const struct {
        parsed result;
        const char *message;
    } cases[] = {
        {PARSE("--flags"), "--flags: is not an option; see program --help"},
        {PARSE("--fla"), "--fla: is not an option; see program --help"},
        {PARSE("--flag=1"), "--flag=1: is not an option; see program --help"},
        {PARSE("--help=please"), "--help=please: is not an option; see program --help"},
        {PARSE("-z"), "-z: is not an option; see program --help"},
        {PARSE("--output"), "--output: needs a value; see program --help"},
        {PARSE("-o"), "-o: needs a value; see program --help"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        assert_false(cases[i].result.ok);
        assert_string_equal(cases[i].result.message, cases[i].message);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_value_may_be_apart_or_attached),
        cmocka_unit_test(options_may_stand_between_the_other_arguments),
        cmocka_unit_test(after_two_dashes_there_are_no_options),
        cmocka_unit_test(what_is_no_option_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
