package rigibo.lab.precision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.lab.engine.Line;

import java.util.List;

class FrontTest {

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
                            point(1e-8, 0)));

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
    void errorsOfRoundingDoNotPreferOneToAnother() {
        Point exact = point(1e-16, 3);
        Point rounded = point(5e-13, 2);
        assertThat(new Front(List.of(exact, rounded)).points()).containsExactly(rounded);
    }

    /**
     * The front keeps a smaller error that costs more, even one that nobody needs: 1e-11 after
     * 1e-10.
     */
    @Test
    void errorsAboveRoundingAreComparedAsTheyAre() {
        Point exact = point(1e-11, 3);
        Point enough = point(1e-10, 2);
        assertThat(new Front(List.of(exact, enough)).points()).containsExactly(enough, exact);
    }
}
