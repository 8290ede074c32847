package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;

/** Where two parts of a body meet, nothing is felt by what slides over them or stands on them. */
class SeamsOfPartsTest {

    private static final double DT = 1 / 60.0;
    private static final Effects AWAKE = Effects.usual().without(Sleep.class);
    private static final Material SMOOTH = new Material(1, 0, 0);

    /** Boxes of 1 m × 1 m, each put together in another way. */
    enum Made {
        HALVES(strips(1, 1, 2)),
        THREE_STRIPS(strips(1, 1, 3)),
        FOUR_STRIPS(strips(1, 1, 4)),
        OVERLAPPING(
                Compound.of(
                        Part.of(Polygon.box(1, 0.5)).at(0, -0.25),
                        Part.of(Polygon.box(0.6, 1)).at(-0.2, 0),
                        Part.of(Polygon.box(0.6, 1)).at(0.2, 0)));

        private final Compound shape;

        Made(Compound shape) {
            this.shape = shape;
        }
    }

    private static Compound strips(double width, double height, int count) {
        double each = width / count;
        Part[] parts = new Part[count];
        for (int i = 0; i < count; i++) {
            parts[i] = Part.of(Polygon.box(each, height)).at((i + 0.5) * each - width / 2, 0);
        }
        return Compound.of(parts);
    }

    static Stream<Arguments> sliders() {
        List<Arguments> all = new ArrayList<>();
        for (double speed : new double[] {0.3, 1, 3.3, 10}) {
            all.add(Arguments.of("box", Polygon.box(1, 1), 0.5, speed));
            all.add(Arguments.of("halves", strips(1, 1, 2), 0.5, speed));
            all.add(Arguments.of("strips", strips(1, 1, 5), 0.5, speed));
            all.add(Arguments.of("disc", new Circle(0.5), 0.5, speed));
            all.add(Arguments.of("capsule", new Capsule(0.6, 0.2), 0.2, speed));
            all.add(Arguments.of("rounded", Polygon.box(0.8, 0.8).rounded(0.1), 0.5, speed));
        }
        return all.stream();
    }

    /**
     * No force acts along a smooth plane. A slider lies a hundred-thousandth of its width deep in
     * the plank (the overlap that stays at rest); were it to climb out over a corner, that would
     * take g·1e-5 m/v of its speed, 3e-4 m/s at the least speed here; a side that it strikes takes
     * all of it.
     */
    @ParameterizedTest(name = "{0}, {3} m/s")
    @MethodSource("sliders")
    void slidesOverAPlankOfPartsAsOverOnePiece(
            String name, Shape shape, double height, double speed) {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(200, 1)).at(0, -0.5).material(SMOOTH));
        pool.add(
                BodyDefinition.dynamic(strips(30, 1, 17))
                        .at(0, 0.5)
                        .material(SMOOTH.density(1000)));
        RigidBody slider =
                pool.add(
                        BodyDefinition.dynamic(shape)
                                .at(-12.1, 1 + height)
                                .velocity(speed, 0)
                                .material(SMOOTH));
        int steps = (int) Math.min(400, 20 / speed / DT);
        for (int i = 0; i < steps; i++) {
            pool.step(DT);
            assertThat(slider.velocityX()).as("step %d", i).isCloseTo(speed, within(2e-5 * speed));
            assertThat(slider.y()).isCloseTo(1 + height, within(1e-5));
        }
        assertThat(slider.x() + 12.1).as("crossed a seam").isGreaterThan(30 / 17.0);
    }

    /**
     * Every centre is far inside of every support below it, so that the stack stands where it was
     * set down. Limit as of the hard case, which asks whole boxes.
     */
    @ParameterizedTest
    @EnumSource(Made.class)
    void aStackSetDownCarelesslyStands(Made made) {
        for (int seed = 0; seed < 4; seed++) {
            for (int count : new int[] {10, 20}) {
                assertThat(lean(made.shape, count, new SplittableRandom(seed)))
                        .as("seed %d, %d boxes", seed, count)
                        .isLessThan(2e-3);
            }
        }
    }

    /** How far the boxes move aside in ten seconds, m. */
    private static double lean(Shape shape, int count, SplittableRandom random) {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(60, 1)).at(0, -0.5));
        double y = -0.5;
        List<RigidBody> boxes = new ArrayList<>();
        double[] start = new double[count];
        double low = ((Compound) shape).centroidY();
        for (int i = 0; i < count; i++) {
            y += 1 + random.nextDouble(1e-3);
            start[i] = random.nextDouble(-5e-3, 5e-3);
            boxes.add(pool.add(BodyDefinition.dynamic(shape).at(start[i], y + low)));
        }
        for (int i = 0; i < 600; i++) {
            pool.step(DT);
        }
        double most = 0;
        for (int i = 0; i < count; i++) {
            most = Math.max(most, Math.abs(boxes.get(i).x() - start[i]));
        }
        return most;
    }

    /** Each half of a box carries half of its weight, and rubs with half of what holds it. */
    @Test
    void contactsAreToldByPart() {
        Pool pool = new Pool(AWAKE, Accuracy.GAME);
        double slope = 0.2;
        double cos = Math.cos(slope);
        double sin = Math.sin(slope);
        pool.add(BodyDefinition.fixed(Polygon.box(60, 1)).angle(slope).at(sin / 2, -cos / 2));
        pool.add(
                BodyDefinition.dynamic(strips(1, 0.1, 2)).angle(slope).at(-0.05 * sin, 0.05 * cos));
        for (int i = 0; i < 120; i++) {
            pool.step(DT);
        }
        List<double[]> told = new ArrayList<>();
        pool.forEachContact(
                contact -> {
                    assertThat(contact.points).isEqualTo(1);
                    told.add(new double[] {contact.force[0], contact.friction});
                });
        assertThat(told).hasSize(2);
        double weight = 0.1 * 9.81;
        // The lower corner carries more: friction acts half of a height below the centre.
        double moment = weight * sin * 0.05;
        double lower = weight * cos / 2 + moment;
        double upper = weight * cos / 2 - moment;
        assertThat(Math.max(told.get(0)[0], told.get(1)[0])).isCloseTo(lower, within(1e-6));
        assertThat(Math.min(told.get(0)[0], told.get(1)[0])).isCloseTo(upper, within(1e-6));
        for (double[] of : told) {
            double share = of[0] / (weight * cos);
            assertThat(Math.abs(of[1])).isCloseTo(share * weight * sin, within(1e-6));
        }
    }
}
