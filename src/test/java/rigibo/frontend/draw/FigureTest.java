package rigibo.frontend.draw;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Convex;
import rigibo.backend.geometry.Polygon;

/** Every convex shape is drawn as a disc, a box or another polygon. */
class FigureTest {

    static Figure of(Convex shape) {
        Figure figure = new Figure();
        figure.of(shape);
        return figure;
    }

    @Test
    void aCapsuleWithoutLengthIsADisc() {
        assertThat(of(new Circle(0.2)).isDisc).isTrue();
        assertThat(of(new Capsule(0, 0.2)).isDisc).isTrue();
        assertThat(of(new Capsule(0, 0.2)).halfWidth).isEqualTo(0.2);
    }

    @Test
    void aBoxIsOneAndItsOutlineTheSame() {
        Polygon box = Polygon.box(2, 1);
        assertThat(of(box).isBox).isTrue();
        assertThat(of(box).polygon).isSameAs(box);
        assertThat(RoundCorners.of(box).corners()).isEqualTo(4);
    }

    /** Half a circle at each end in pieces of 0.16 rad at most: 20 pieces and so 21 corners. */
    @Test
    void aCapsuleIsAPolygonWithRoundEnds() {
        Figure pill = of(new Capsule(1, 0.5));
        assertThat(pill.isDisc).isFalse();
        assertThat(pill.isBox).isFalse();
        assertThat(pill.polygon.corners()).isEqualTo(42);
        assertThat(pill.halfSize()).isCloseTo(0.5, within(0.002));
    }
}
