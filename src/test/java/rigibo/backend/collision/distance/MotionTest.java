package rigibo.backend.collision.distance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Circle;

class MotionTest {

    private static Motion thrown(double drag) {
        Motion motion = Motions.moving(new Circle(1), 2, 3, 7, 9);
        motion.startTime = 0.25;
        motion.accelerationX = 0.5;
        motion.accelerationY = -9.81;
        motion.angle = 0.1;
        motion.spin = 11;
        motion.angularAcceleration = 4;
        motion.drag = drag;
        return motion;
    }

    private static Pose at(Motion motion, double time) {
        Pose pose = new Pose();
        motion.poseAt(time, pose);
        return pose;
    }

    /** x = 2 + 7τ + ¼τ², y = 3 + 9τ − 4.905τ², θ = 0.1 + 11τ + 2τ², with τ = ½ s. */
    @Test
    void withoutDragThePathIsAParabola() {
        Motion motion = thrown(0);
        Pose pose = at(motion, 0.75);

        assertThat(pose.x).isEqualTo(2 + 3.5 + 0.0625);
        assertThat(pose.y).isEqualTo(3 + 4.5 - 9.81 / 8, within(1e-15));
        assertThat(motion.angleAt(0.75)).isEqualTo(0.1 + 5.5 + 0.5);
        assertThat(pose.cos).isEqualTo(Math.cos(6.1), within(2e-16));
        assertThat(motion.velocityXAt(0.75)).isEqualTo(7.25);
        assertThat(motion.velocityYAt(0.75)).isEqualTo(9 - 9.81 / 2);
        assertThat(motion.spinAt(0.75)).isEqualTo(13);
    }

    /** v = a/k + (v₀ − a/k)e^(−kτ), x = x₀ + aτ/k + (v₀ − a/k)(1 − e^(−kτ))/k. */
    @ParameterizedTest
    @ValueSource(doubles = {0.5, 3, 30})
    void withDragThePathIsTheExponentialSolution(double drag) {
        Motion motion = thrown(drag);
        double terminal = -9.81 / drag;
        double decay = Math.exp(-drag * 0.5);
        double y = 3 + terminal * 0.5 + (9 - terminal) * (1 - decay) / drag;

        assertThat(at(motion, 0.75).y).isEqualTo(y, within(2e-14));
        assertThat(motion.velocityYAt(0.75))
                .isEqualTo(terminal + (9 - terminal) * decay, within(2e-14));
    }

    /**
     * To first order in k, drag shortens the path by k(v₀τ²/2 + aτ³/6). The closed form would lose
     * its digits here, since τ − E₁ cancels.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1e-300, 1e-15, 1e-12, 1e-9, 1e-6})
    void slightDragChangesThePathSlightly(double drag) {
        double without = at(thrown(0), 0.75).y;
        double lost = drag * (9 * 0.125 - 9.81 / 48);

        // The rest is of second order in k; the first figure is round-off.
        assertThat(at(thrown(drag), 0.75).y).isEqualTo(without - lost, within(2e-15 + drag * drag));
    }

    /** On either side of the limit between the series and the closed form. */
    @Test
    void pathIsContinuousInTheDrag() {
        double drag = 2.0 / 16;
        double below = at(thrown(drag * (1 - 1e-12)), 0.75).y;
        double above = at(thrown(drag * (1 + 1e-12)), 0.75).y;

        assertThat(above).isEqualTo(below, within(1e-12));
    }
}
