package rigibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.PrintWriter;
import java.io.StringWriter;

class MainTest {
    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        return Main.run(new PrintWriter(out), new PrintWriter(err), arguments);
    }

    @Test
    void helpNamesEveryCommand() {
        assertThat(run("help")).isZero();
        assertThat(out.toString())
                .contains(
                        "Usage: rigibo",
                        "play",
                        "tour",
                        "levels",
                        "replay",
                        "record",
                        "cases",
                        "lab",
                        "bench",
                        "help");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "play",
                "tour",
                "measure",
                "monkey",
                "fuzz",
                "levels",
                "levels check",
                "levels generate",
                "replay",
                "record",
                "cases",
                "lab",
                "bench"
            })
    void everyCommandSaysWhatItTakes(String command) {
        assertThat(run((command + " --help").split(" "))).isZero();
        assertThat(out.toString()).startsWith("Usage: rigibo " + command);
        assertThat(err.toString()).isEmpty();
    }

    @Test
    void unknownCommandIsRefusedWithUsage() {
        assertThat(run("x")).isEqualTo(2);
        assertThat(err.toString()).contains("'x'", "Usage: rigibo");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "play --jump",
                "tour --out",
                "levels",
                "levels dance",
                "levels generate",
                "cases --only",
                "record",
                "record tilt",
                "record tilt --out a.gif --width 5",
                "replay"
            })
    void halfACommandIsRefused(String typed) {
        assertThat(run(typed.split(" "))).isEqualTo(2);
        assertThat(err.toString()).contains("Usage: rigibo");
    }

    @Test
    void casesPrintALineEachAndTheirCountLast() {
        assertThat(run("cases", "--preset", "game", "--only", "5")).isZero();
        assertThat(out.toString()).contains("GAME").endsWith("1 passed, 0 failed\n");
        assertThat(err.toString()).contains("1 of 1 done");
    }

    @ParameterizedTest
    @CsvSource({
        "cases --preset BEST, DRAFT",
        "cases --only 1000, 20/10",
        "cases --csv no/such/place.csv, no/such/place.csv",
        "lab --figures waves, EFFECTS",
        "lab --scenes moon, R1",
        "lab --figures effects --scenes moon, flyers",
        "lab --quick --full, --full",
        "lab --figures effects --runs 0, 1 to 1000",
        "lab --runs many, many",
        "lab --out README.md, not a directory",
        "lab --markdown no/such/place.md, no/such/place.md",
        "levels generate --seed=-1, 0 to 999999999999",
        "levels generate --seed=1000000000000, 0 to 999999999999",
        "levels generate --seed=many, many",
        "levels generate --seed=1 --count=0, 1 to 100000",
        "bench --scenes moon, large-pyramid",
        "bench --engines bullet, rigibo",
        "bench --moving moon, rain-boxes-10",
        "bench --runs 0, 1 to 100",
        "bench --rounds 0, 1 to 100",
        "bench --steps 0, 1 to 100000",
        "bench --steps some, some",
        "bench --csv no/such/place.csv, no/such/place.csv",
        "bench --markdown no/such/place.md, no/such/place.md",
        "bench --out README.md, not a directory"
    })
    void wrongChoiceIsRefusedWithTheRightOnes(String typed, String named) {
        assertThat(run(typed.split(" "))).isEqualTo(2);
        assertThat(err.toString()).contains(option(typed), named);
    }

    /** The last option that was typed, which is the one at fault. */
    private static String option(String typed) {
        String options = typed.substring(typed.lastIndexOf("--"));
        return options.split("[ =]")[0];
    }

    @Test
    void noCommandIsRefusedWithUsage() {
        assertThat(run()).isEqualTo(2);
        assertThat(err.toString()).contains("Usage: rigibo");
    }
}
