package rigibo.backend.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CapsuleTest {

    /** Between a disc and a long rod of 2h × 2r, whose inertia is m·((2h)² + (2r)²)/12. */
    @Test
    void massIsThatOfADiscAndOfARectangle() {
        Capsule capsule = new Capsule(2, 0.5);
        MassProperties plate = capsule.massProperties(3);

        assertThat(plate.mass()).isEqualTo(3 * (4 + Math.PI / 4), within(1e-13));
        double rectangle = 12 * (16 + 1) / 12.0;
        // Each half disc: about its own centroid, 4r/3π from its straight side, and moved.
        double half = 3 * Math.PI / 8;
        double away = 4 * 0.5 / (3 * Math.PI);
        double own = half * 0.25 / 2 - half * away * away;
        double ends = 2 * (own + half * (2 + away) * (2 + away));
        assertThat(plate.inertia()).isEqualTo(rectangle + ends, within(1e-12));
        assertThat(capsule.area()).isEqualTo(4 + Math.PI / 4, within(1e-14));
    }

    @Test
    void withoutLengthItIsADisc() {
        assertThat(new Capsule(0, 0.3).massProperties(7))
                .isEqualTo(new Circle(0.3).massProperties(7));
        assertThat(new Capsule(0, 0.3).outline()).isEqualTo(new Circle(0.3).outline());
    }

    @Test
    void boundsFollowTheAngle() {
        Aabb bounds = new Aabb();
        new Capsule(5, 1).bounds(1, -1, 0.6, 0.8, bounds);

        assertThat(bounds.minX).isEqualTo(1 - 4, within(1e-15));
        assertThat(bounds.maxX).isEqualTo(1 + 4, within(1e-15));
        assertThat(bounds.minY).isEqualTo(-1 - 5, within(1e-15));
        assertThat(bounds.maxY).isEqualTo(-1 + 5, within(1e-15));
        assertThat(new Capsule(5, 1).boundingRadius()).isEqualTo(6);
        assertThat(new Capsule(5, 1).smallestWidth()).isEqualTo(2);
    }

    @ParameterizedTest
    @CsvSource({"-1, 1", "NaN, 1", "Infinity, 1", "1, 0", "1, -1", "1, NaN", "1e200, 1"})
    void sizesThatMakeNoCapsuleAreRefused(double halfLength, double radius) {
        assertThatThrownBy(() -> new Capsule(halfLength, radius))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Capsule");
    }
}
