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
        assertThat(err.toString()).contains(typed.split(" ")[1], named);
    }

    @Test
    void noCommandIsRefusedWithUsage() {
        assertThat(run()).isEqualTo(2);
        assertThat(err.toString()).contains("Usage: rigibo");
    }
}
