package rigibo.lab.precision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.lab.engine.Line;

import java.util.List;

class FrontTest {

    private static final double FLOOR = 1e-9;

    private static Point point(double error, double cost) {
        return FakePoints.point("a setting", Line.SUBSTEPS, 1, 1.0 / 60, error, cost);
    }

    private final Point cheap = point(1e-2, 1);
    private final Point middle = point(1e-4, 2);
    private final Point fine = point(1e-6, 8);
    private final Point poor = point(1e-3, 4);
    private final Point nearly = point(1e-4, 2.15);
    private final Front front =
            new Front(
                    List.of(
                            fine,
                            poor,
                            cheap,
                            nearly,
                            middle,
                            point(Double.NaN, 0.5),
                            point(1e-8, 0)),
                    FLOOR);

    @Test
    void thoseThatNoneIsPreferredToAreOnIt() {
        assertThat(front.points()).containsExactly(cheap, middle, fine);
    }

    /** 4/2 = 2 and 2.15/2 = 1.075, which is less than 1.1. */
    @Test
    void distanceIsHowManyTimesMoreIsPaid() {
        assertThat(front.excess(poor)).isCloseTo(2, within(1e-9));
        assertThat(front.cheapestAsAccurateAs(poor)).contains(middle);
        assertThat(front.isNear(poor)).isFalse();
        assertThat(front.isNear(nearly)).isTrue();
        assertThat(front.excess(fine)).isCloseTo(1, within(1e-9));
    }

    @Test
    void errorsThatCountAsEqualDoNotPreferOneToAnother() {
        Point exact = point(1e-16, 3);
        Point enough = point(5e-10, 2);
        assertThat(new Front(List.of(exact, enough), FLOOR).points()).containsExactly(enough);
    }
}
