package rigibo.backend.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CircleTest {

    @Test
    void massAndInertiaAreThoseOfADisc() {
        MassProperties plate = new Circle(2).massProperties(3);

        assertThat(plate.mass()).isEqualTo(3 * Math.PI * 4, within(1e-14));
        assertThat(plate.inertia()).isEqualTo(plate.mass() * 4 / 2, within(1e-14));
        assertThat(plate.centroidX()).isZero();
        assertThat(plate.centroidY()).isZero();
    }

    @Test
    void boundsDoNotDependOnTheAngle() {
        Aabb bounds = new Aabb();
        new Circle(2).bounds(1, -1, 0.6, 0.8, bounds);

        assertThat(bounds.minX).isEqualTo(-1);
        assertThat(bounds.minY).isEqualTo(-3);
        assertThat(bounds.maxX).isEqualTo(3);
        assertThat(bounds.maxY).isEqualTo(1);
    }

    @Test
    void widthIsTheDiameter() {
        assertThat(new Circle(2).smallestWidth()).isEqualTo(4);
        assertThat(new Circle(2).boundingRadius()).isEqualTo(2);
    }

    /** Radii whose area or inertia would be 0 or infinite are refused as well. */
    @ParameterizedTest
    @ValueSource(
            doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY, Double.MIN_VALUE, 1e-170, 1e80})
    void radiiThatMakeNoDiscAreRefused(double radius) {
        assertThatThrownBy(() -> new Circle(radius))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Circle.radius")
                .hasMessageContaining("" + radius);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
    void densitiesThatGiveNoMassAreRefused(double density) {
        assertThatThrownBy(() -> new Circle(1).massProperties(density))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("density");
    }
}
