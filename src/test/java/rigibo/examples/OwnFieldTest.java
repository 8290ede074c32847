package rigibo.examples;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/** The example of a field of one's own runs, and prints what is true. */
class OwnFieldTest {

    /**
     * With m = 2: x″ = −20x − ½x′, so x = e^(−t/4)(cos wt + sin wt/4w), w² = 20 − 1/16; y″ = −20y,
     * so y = 3/√20·sin √20·t.
     */
    @Test
    void springInHoneyIsWhereItsFormulaSays() {
        double t = 3;
        double w = Math.sqrt(20 - 1.0 / 16);
        double x = Math.exp(-t / 4) * (Math.cos(w * t) + Math.sin(w * t) / (4 * w));
        double y = 3 / Math.sqrt(20) * Math.sin(Math.sqrt(20) * t);
        assertThat(printed()).contains(String.format("%.1f s: (%.3f, %.3f) m", t, x, y));
    }

    private static String printed() {
        PrintStream before = System.out;
        ByteArrayOutputStream printed = new ByteArrayOutputStream();
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
        try {
            OwnField.main(new String[0]);
        } finally {
            System.setOut(before);
        }
        return printed.toString(StandardCharsets.UTF_8);
    }
}
