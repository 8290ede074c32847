package rigibo.lab.child;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

import java.util.Map;

class FieldsTest {

    private enum Kind {
        CALM,
        WILD
    }

    private record Inner(long count, Kind kind) {}

    private record Outer(
            int steps, Inner inner, double share, double[] nanos, Map<String, Double> errors) {}

    private record Named(String name, double value, String unit) {}

    private static final Outer OUTER =
            new Outer(
                    3,
                    new Inner(1L << 60, Kind.WILD),
                    1 / 3.0,
                    new double[] {1, 0.1, -1e300},
                    Map.of("lean, m", 0.25));

    /** Every double is the one it was: Java writes as many digits as tell it from all others. */
    @Test
    void recordIsReadAsItWasWritten() {
        Outer read = Fields.parse(Outer.class, Fields.line(OUTER));
        assertThat(read).usingRecursiveComparison().isEqualTo(OUTER);
        for (double value : new double[] {1 / 0.0, Double.NaN, -0.0}) {
            Named named = new Named("", value, "m/s²");
            assertThat(Fields.parse(Named.class, Fields.line(named))).isEqualTo(named);
        }
    }

    @Test
    void whatIsEmptyStaysEmpty() {
        Outer empty = new Outer(0, new Inner(0, Kind.CALM), 0, new double[0], Map.of());
        Outer read = Fields.parse(Outer.class, Fields.line(empty));
        assertThat(read).usingRecursiveComparison().isEqualTo(empty);
    }

    @Test
    void valuesOfARecordWithinStandInItsPlace() {
        assertThat(Fields.of(OUTER)).startsWith(3, 1L << 60, Kind.WILD, 1 / 3.0).hasSize(6);
    }

    @Test
    void lineOfAnotherLengthOrKindIsRefused() {
        String line = Fields.line(OUTER);
        String[] others = {line.substring(0, line.lastIndexOf('\t')), line + "\t1", "x\t" + line};
        for (String other : others) {
            assertThatThrownBy(() -> Fields.parse(Outer.class, other))
                    .isInstanceOf(IllegalArgumentException.class)
                    .hasMessage("not a line of Outer: '" + other + "'");
        }
    }
}
