package rigibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
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
        assertThat(out.toString()).contains("Usage: rigibo", "play", "tour", "levels", "help");
    }

    @Test
    void unknownCommandIsRefusedWithUsage() {
        assertThat(run("dance")).isEqualTo(2);
        assertThat(err.toString()).contains("'dance'", "Usage: rigibo");
    }

    @ParameterizedTest
    @ValueSource(strings = {"play --jump", "tour --out", "levels", "levels dance"})
    void halfACommandIsRefused(String typed) {
        assertThat(run(typed.split(" "))).isEqualTo(2);
        assertThat(err.toString()).contains("Usage: rigibo");
    }

    @Test
    void noCommandIsRefusedWithUsage() {
        assertThat(run()).isEqualTo(2);
        assertThat(err.toString()).contains("Usage: rigibo");
    }
}
