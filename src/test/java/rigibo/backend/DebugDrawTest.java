package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.DebugDraw.Layer;
import rigibo.backend.DebugDraw.Look;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Sensors;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** The calls that a pool makes to a debug drawing. */
class DebugDrawTest {

    private static final double STEP = 1.0 / 60;

    /** Keeps what it is told as words, and the area within each outline. */
    private static final class Recorder implements DebugDraw {

        final List<String> words = new ArrayList<>();
        final List<Double> areas = new ArrayList<>();
        double force;

        @Override
        public void outline(RigidBody body, double[] x, double[] y, int points, Look look) {
            words.add("outline " + points + " " + look);
            double twice = 0;
            for (int i = 0; i < points; i++) {
                int next = (i + 1) % points;
                twice += x[i] * y[next] - x[next] * y[i];
            }
            areas.add(twice / 2);
        }

        @Override
        public void joint(Joint joint) {
            words.add("joint");
        }

        @Override
        public void contact(ContactView contact) {
            words.add("contact");
            force += contact.impulse / STEP;
        }

        @Override
        public void centre(RigidBody body, Look look) {
            words.add("centre " + look);
        }

        @Override
        public void bounds(RigidBody body, Aabb bounds) {
            words.add("bounds");
        }
    }

    private final Recorder pen = new Recorder();

    static Stream<Shape> shapes() {
        return Stream.of(
                new Circle(0.7),
                new Capsule(1, 0.3),
                Polygon.box(2, 1),
                Polygon.of(0, 0, 2, 0, 0, 1),
                Polygon.regular(7, 1).rounded(0.4));
    }

    /** Chords lie within the curve: the area is that of the shape, but for a hundredth. */
    @ParameterizedTest
    @MethodSource("shapes")
    void outlinesHaveTheAreaOfTheirShape(Shape shape) {
        Pool pool = new Pool();
        pool.add(BodyDefinition.dynamic(shape).at(3, 2).angle(0.7));
        pool.draw(pen, Layer.SHAPES);
        assertThat(pen.areas).hasSize(1);
        assertThat(pen.areas.get(0) / shape.area()).isBetween(0.99, 1 + 1e-12);
    }

    @Test
    void partsAndEdgesAreDrawnOneByOne() {
        Pool pool = new Pool(Effects.usual().with(new Sensors()), Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Chain.open(4, 0, 2, 1, 0, 0)));
        Part eye = Part.of(new Circle(0.1)).at(2, 0).sensor();
        pool.add(BodyDefinition.dynamic(Compound.of(Part.of(Polygon.box(1, 1)), eye)).at(0, 9));
        pool.draw(pen, Layer.SHAPES);
        assertThat(pen.words)
                .containsExactly(
                        "outline 2 FIXED",
                        "outline 2 FIXED",
                        "outline 4 AWAKE",
                        "outline 32 SENSOR");
    }

    @Test
    void looksTellWhatBodiesDo() {
        Pool pool = new Pool(Effects.usual().with(new Sensors()), Accuracy.GAME);
        Polygon box = Polygon.box(1, 1);
        pool.add(BodyDefinition.kinematic(box).at(0, 0));
        pool.add(BodyDefinition.dynamic(box).at(5, 0).awake(false));
        pool.add(BodyDefinition.dynamic(box).at(10, 0)).disable();
        pool.add(BodyDefinition.fixed(box).at(15, 0).sensor());
        pool.draw(pen, Layer.SHAPES, Layer.CENTRES);
        assertThat(pen.words)
                .containsExactly(
                        "outline 4 DRIVEN",
                        "outline 4 ASLEEP",
                        "outline 4 DISABLED",
                        "outline 4 SENSOR",
                        "centre ASLEEP",
                        "centre DISABLED");
    }

    /** A crate at rest on a floor, hung on a slack rope: the floor carries m·g. */
    @Test
    void layersComeInOrderAndContactsHoldTheLoad() {
        Pool pool = new Pool(Effects.usual().with(new Joints()), Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(9, 1)).at(0, -0.5));
        RigidBody nail = pool.add(BodyDefinition.fixed(new Circle(0.1)).at(3, 3));
        RigidBody crate = pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 0.5).mass(10));
        pool.join(DistanceJoint.rope(nail, 3, 3, crate, 0, 1, 9));
        for (int i = 0; i < 5; i++) {
            pool.step(STEP);
        }
        pool.draw(pen);
        assertThat(pen.words)
                .containsExactly(
                        "bounds",
                        "bounds",
                        "bounds",
                        "outline 4 FIXED",
                        "outline 32 FIXED",
                        "outline 4 AWAKE",
                        "joint",
                        "contact",
                        "centre AWAKE");
        assertThat(pen.force).isCloseTo(10 * 9.81, within(1e-6));
    }

    @Test
    void aPoolWithoutContactsIsDrawn() {
        Pool pool = new Pool(Effects.of(new Gravity(0, -9.81)), Accuracy.GAME);
        pool.add(BodyDefinition.dynamic(new Circle(1)));
        pool.step(STEP);
        pool.draw(pen);
        assertThat(pen.words).containsExactly("bounds", "outline 32 AWAKE", "centre AWAKE");
    }

    @Test
    void thePoolRefusesChangesWhileItIsDrawn() {
        Pool pool = new Pool();
        RigidBody ball = pool.add(BodyDefinition.dynamic(new Circle(1)));
        DebugDraw meddler =
                new DebugDraw() {
                    @Override
                    public void centre(RigidBody body, Look look) {
                        pool.remove(body);
                    }
                };
        assertThatThrownBy(() -> pool.draw(meddler)).isInstanceOf(IllegalStateException.class);
        assertThat(ball.isAlive()).isTrue();
        pool.step(STEP);
    }

    @Test
    void nothingIsRefusedByName() {
        Pool pool = new Pool();
        assertThatThrownBy(() -> pool.draw(null))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Pool.draw pen");
        assertThatThrownBy(() -> pool.draw(pen, (Layer) null))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("Pool.draw layer");
    }
}
