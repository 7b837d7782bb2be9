/* Values replaced in JSON: all else stays as it was written. */
#include "check.h"
#include "json_text.h"

#include <stdlib.h>

static void check_with(const char *text, const json_step *steps, size_t count, const char *value, const char *expected)
{
    char *result = json_text_with(text, steps, count, value);
    assert_non_null(result);
    assert_string_equal(result, expected);
    free(result);
}

static void values_are_found_between_all_that_json_allows(void **state)
{
    (void)state;
    static const char text[] =
        "\xef\xbb\xbf { \"a\\\"}]\" : \"[{\\\\\", \"list\":[ [1 ,2], {} , [ { \"x\": true }, -1.5e3 ] ] ,\n\t\"x\" :null}";
    const struct {
        json_step steps[4];
        size_t count;
        const char *value;
    } places[] = {
        {{{.key = "a\\\"}]"}}, 1, "\"[{\\\\\""},
        {{{.key = "list"}, {.index = 0}}, 2, "[1 ,2]"},
        {{{.key = "list"}, {.index = 0}, {.index = 1}}, 3, "2"},
        {{{.key = "list"}, {.index = 1}}, 2, "{}"},
        {{{.key = "list"}, {.index = 2}, {.index = 0}, {.key = "x"}}, 4, "true"},
        {{{.key = "list"}, {.index = 2}, {.index = 1}}, 3, "-1.5e3"},
        {{{.key = "x"}}, 1, "null"},
    };
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        text_span found;
        assert_true(json_text_find(text, places[i].steps, places[i].count, &found));
        assert_int_equal(found.end - found.begin, strlen(places[i].value));
        assert_memory_equal(found.begin, places[i].value, strlen(places[i].value));
    }
    text_span found;
    assert_false(json_text_find(text, &(json_step){.key = "y"}, 1, &found));
    assert_false(json_text_find(text, (json_step[]){{.key = "list"}, {.index = 3}}, 2, &found));
    assert_false(json_text_find(text, (json_step[]){{.key = "x"}, {.index = 0}}, 2, &found));
    assert_false(json_text_find(text, (json_step[]){{.key = "list"}, {.key = "x"}}, 2, &found));
}

/* Whatever ends too early is no JSON, but nothing is read behind its end. */
static void no_text_is_read_beyond_its_end(void **state)
{
    (void)state;
    static const char text[] = "{ \"a\\\"\" : [1, {\"b\": \"\\\\\"}], \"c\": -1 }";
    for (size_t length = 0; length < sizeof text; length++) {
        char *cut = malloc(length + 1);
        assert_non_null(cut);
        memcpy(cut, text, length);
        cut[length] = '\0';
        text_span found;
        json_text_find(cut, (json_step[]){{.key = "a\\\""}, {.index = 1}, {.key = "b"}}, 3, &found);
        json_text_find(cut, (json_step[]){{.key = "c"}}, 1, &found);
        free(json_text_with(cut, (json_step[]){{.key = "d"}}, 1, "2"));
        free(cut);
    }
}

static void what_is_missing_is_added_in_the_manner_of_the_rest(void **state)
{
    (void)state;
    const json_step core[] = {{.key = "a"}, {.key = "core"}};
    check_with("{ \"a\": { \"core\" : 1 } }", core, 2, "0.5", "{ \"a\": { \"core\" : 0.5 } }");
    check_with("{ \"a\": { \"b\": 1 } }", core, 2, "0.5", "{ \"a\": { \"b\": 1, \"core\": 0.5 } }");
    check_with("{ \"a\": {\n  \"b\": [1],\n  \"c\": \"}\"\n } }", core, 2, "0.5",
               "{ \"a\": {\n  \"b\": [1],\n  \"c\": \"}\",\n  \"core\": 0.5\n } }");
    check_with("{\"a\":{}}", core, 2, "0.5", "{\"a\":{\"core\": 0.5}}");
    assert_null(json_text_with("{ \"b\": {} }", core, 2, "0.5"));
    assert_null(json_text_with("{ \"a\": [] }", core, 2, "0.5"));
    assert_null(json_text_with("[1]", &(json_step){.index = 1}, 1, "0.5"));
}

static void numbers_are_short_and_exact(void **state)
{
    (void)state;
    const struct {
        double number;
        const char *text;
    } numbers[] = {{0, "0"}, {-1.5, "-1.5"}, {0.1, "0.1"}, {100000.0000001, "100000.0000001"}, {1e18, "1e+18"}, {250, "250"}};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        char text[JSON_NUMBER_SIZE];
        json_text_number(numbers[i].number, text);
        check_close(strtod(text, NULL), numbers[i].number, 0);
        assert_string_equal(text, numbers[i].text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_are_found_between_all_that_json_allows),
        cmocka_unit_test(no_text_is_read_beyond_its_end),
        cmocka_unit_test(what_is_missing_is_added_in_the_manner_of_the_rest),
        cmocka_unit_test(numbers_are_short_and_exact),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
