package rigibo.fuzz.file;

import rigibo.fuzz.chance.Chance;

import java.util.Locale;
import java.util.stream.Collectors;

/** Values and keys that our writers never produce. */
record Junk(Chance chance) {

    /** The length of a long text, list or number. */
    static final int MOST_CHARACTERS = 400_000;

    private static final int DEEPEST = 20_000;

    String value() {
        return switch (chance.whole(0, 5)) {
            case 0 -> simple();
            case 1 -> number();
            case 2 -> text();
            case 3 -> nested();
            case 4 -> "[" + "0,".repeat(length(2)) + "0]";
            default -> broken();
        };
    }

    private String simple() {
        return chance.oneOf("null", "true", "false", "[]", "{}", "\"\"", "0", "\"a\"", "[[]]");
    }

    private String number() {
        return chance.oneOf(
                "-1",
                "-0.0",
                "1e308",
                "-1e308",
                "1e309",
                "1e-400",
                "4.9e-324",
                "1e999999999",
                "1e-999999999",
                "1e2147483648",
                "2147483648",
                "-2147483649",
                "9223372036854775808",
                "123456789012345678901234567890",
                "0.1e1",
                "1".repeat(length(1)),
                "0." + "1".repeat(length(1)),
                String.valueOf(chance.ofEitherSign(1e-300, 1e300)),
                String.valueOf(chance.whole(-1000, 1000)));
    }

    private String text() {
        return chance.oneOf(
                "\"\\u0000\"",
                "\"\\ud800\"",
                "\"\\n\\t\\\"\"",
                "\"" + "x".repeat(length(1)) + "\"",
                "\"" + "\\u0041".repeat(length(6)) + "\"",
                "\"../../../etc/passwd\"",
                "\"%s %n {0} '{'\"",
                "\"\u202e\u0301\ud83d\ude00\"",
                "\"NaN\"",
                "\"1e5\"");
    }

    private String nested() {
        int depth = (int) chance.ofAnySize(1, DEEPEST);
        return chance.happens(0.5)
                ? "[".repeat(depth) + "]".repeat(depth)
                : "{\"a\":".repeat(depth) + "1" + "}".repeat(depth);
    }

    /** Text that is no JSON. */
    private String broken() {
        return chance.oneOf(
                "NaN",
                "Infinity",
                "01",
                "+1",
                ".5",
                "1.",
                "'a'",
                "undefined",
                "\"\\x\"",
                "\"",
                "/* */ 1",
                "[1,]",
                "{,}",
                "",
                ",",
                "}",
                "[".repeat(length(1)));
    }

    private int length(int charactersEach) {
        return (int) chance.ofAnySize(1, (double) MOST_CHARACTERS / charactersEach);
    }

    /** A key in quotation marks. */
    String key(String usual) {
        String escaped =
                usual.chars()
                        .mapToObj(c -> String.format(Locale.ROOT, "\\u%04x", c))
                        .collect(Collectors.joining());
        String key =
                chance.oneOf(
                        usual.toUpperCase(Locale.ROOT),
                        escaped,
                        "",
                        usual + " ",
                        "\\u0000",
                        "/~0~1",
                        "__proto__",
                        "k".repeat(length(1)));
        return '"' + key + '"';
    }
}
