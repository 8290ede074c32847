package rigibo.backend.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Wind;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;

/** F = −½·ρ·c·A·|u|·u with A read off the drawing. All within some units in the last place. */
class AirDragForceTest {

    private static final double ROUND_OFF = 1e-13;
    private static final AirDrag AIR = new AirDrag(1.2, 0.5);
    private static final double HALF = 1.2 * 0.5 / 2;
    private static final Wind CALM = new Wind(0, 0);

    /** Sides 3 east and 4 north of the right angle; not its own mirror image. */
    private static final Polygon TRIANGLE = Polygon.of(0, 0, 3, 0, 0, 4);

    /**
     * Its extent across a direction: 4 across x, 3 across y, the height 3·4/5 across the long side,
     * that side itself across its normal. Across (1, 1) the corners lie at 0, −3/√2 and 4/√2,
     * across its mirror image (1, −1) at 0, 3/√2 and 4/√2.
     */
    @ParameterizedTest(name = "along ({0}, {1}) it is {2} m wide")
    @CsvSource({
        "1, 0, 4",
        "0, 1, 3",
        "-3, 4, 2.4",
        "4, 3, 5",
        "1, 1, 4.949747468305833",
        "1, -1, 2.82842712474619"
    })
    void aTriangleIsAsWideAsItLooksFromWhereItGoes(double x, double y, double width) {
        for (double angle : new double[] {0, 0.3, 2, -1.1}) {
            for (double speed : new double[] {10, -10, 0.1}) {
                Instant at = Instants.of(TRIANGLE, angle);
                double scale = speed / Math.hypot(x, y);
                at.velocityX = scale * (Math.cos(angle) * x - Math.sin(angle) * y);
                at.velocityY = scale * (Math.sin(angle) * x + Math.cos(angle) * y);
                new AirDragForce(AIR, CALM).add(at);

                double strength = HALF * width * Math.abs(speed);
                double most = strength * Math.abs(speed);
                assertThat(at.accelerationX)
                        .as("x, turned by %s, at %s m/s", angle, speed)
                        .isEqualTo(-strength * at.velocityX, within(ROUND_OFF * most));
                assertThat(at.accelerationY)
                        .as("y, turned by %s, at %s m/s", angle, speed)
                        .isEqualTo(-strength * at.velocityY, within(ROUND_OFF * most));
                assertThat(at.angularAcceleration).isZero();
            }
        }
    }

    @Test
    void aDiscIsAsWideAsItsDiameter() {
        Instant at = Instants.of(new Circle(0.5), 2, 1, 0.7);
        at.velocityX = 3;
        at.velocityY = -4;
        new AirDragForce(AIR, CALM).add(at);

        assertThat(at.accelerationX).isEqualTo(-HALF * 5 * 3 / 2, within(ROUND_OFF));
        assertThat(at.accelerationY).isEqualTo(HALF * 5 * 4 / 2, within(ROUND_OFF));
    }

    /** Half of the wind blows at 2 s. */
    @Test
    void theAirMovesWithTheGust() {
        Wind gusty = new Wind(8, 6, time -> time / 4);
        Instant at = Instants.of(new Circle(0.5), 0);
        at.time = 2;
        at.velocityX = 1;
        at.velocityY = -1;
        new AirDragForce(AIR, gusty).add(at);

        assertThat(at.accelerationX).isEqualTo(HALF * 5 * 3, within(ROUND_OFF));
        assertThat(at.accelerationY).isEqualTo(HALF * 5 * 4, within(ROUND_OFF));
    }

    /** There is no direction to be wide across. */
    @Test
    void whatGoesWithTheWindFeelsNothing() {
        Instant at = Instants.of(TRIANGLE, 0.3);
        at.velocityX = 8;
        at.velocityY = 6;
        new AirDragForce(AIR, new Wind(8, 6)).add(at);

        assertThat(at.accelerationX).isZero();
        assertThat(at.accelerationY).isZero();
    }

    @Test
    void addsToWhatIsThere() {
        Instant at = Instants.of(new Circle(0.5), 0);
        at.velocityX = 1;
        at.accelerationX = 7;
        at.accelerationY = 8;
        new AirDragForce(AIR, CALM).add(at);

        assertThat(at.accelerationX).isEqualTo(7 - HALF, within(ROUND_OFF));
        assertThat(at.accelerationY).isEqualTo(8);
    }
}
