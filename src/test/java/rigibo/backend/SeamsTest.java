package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/** Fixed bodies side by side are one floor; steps, walls and corners stay what they are. */
class SeamsTest {

    private static final Material SMOOTH = new Material(1, 0, 0);
    private static final double G = 9.81;

    /** Twenty metres of boxes in a row whose upper side passes through the origin. */
    private static void addFloor(Pool pool, BodyDefinition piece, double angle) {
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        for (int i = 0; i < 20; i++) {
            pool.add(piece.at(i * cos + 0.5 * sin, i * sin - 0.5 * cos).angle(angle));
        }
    }

    private static BodyDefinition fixed(double width, double height) {
        return BodyDefinition.fixed(Polygon.box(width, height)).material(SMOOTH);
    }

    private static Pool pool(Accuracy accuracy) {
        return new Pool(Scenes.usualWithoutSleep(), accuracy);
    }

    /** Down a frictionless slope a = g·sin(α); what round-off leaves is far below 1e-6. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void slopeOfBoxesIsAPlane(Preset preset) {
        double angle = Math.toRadians(-20);
        Pool pool = pool(preset.accuracy);
        addFloor(pool, fixed(1, 1), angle);
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        RigidBody box =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.6, 0.4))
                                .at(2 * cos - 0.2 * sin, 2 * sin + 0.2 * cos)
                                .angle(angle)
                                .material(SMOOTH));
        Scenes.run(pool, 150);
        double t = 150 * Scenes.DT;
        double way = Math.hypot(box.x() - 2 * cos + 0.2 * sin, box.y() - 2 * sin - 0.2 * cos);
        assertThat(way).isEqualTo(-G * sin * t * t / 2, within(1e-6 * way));
    }

    /**
     * A kink of the angle δ takes A/(A + B²) of the energy of motion for each of the two corners of
     * a box w × h, B = cos δ − (h/2w)·sin δ and A = sin²δ·(¼ + (w² + h²)/12w²), whether its pieces
     * end where they meet or lie over each other like tiles. A substep may be off by 3 % of that.
     */
    @ParameterizedTest
    @CsvSource({"1, 3", "1, 8", "1.4, 3", "1.4, 8"})
    void kinkOfBoxesTakesWhatAKinkTakes(double lap, double degrees) {
        double kink = Math.toRadians(degrees);
        Pool pool = pool(Accuracy.GAME);
        for (int i = -8; i < 8; i++) {
            double angle = i < 0 ? 0 : kink;
            double along = (i + 0.5) * 0.5;
            double x = along * Math.cos(angle) + 0.2 * Math.sin(angle);
            double y = along * Math.sin(angle) - 0.2 * Math.cos(angle);
            pool.add(fixed(lap * 0.5, 0.4).at(x, y).angle(angle));
        }
        double w = 0.4;
        double h = 0.3;
        RigidBody box =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(w, h))
                                .at(-2, h / 2)
                                .velocity(4, 0)
                                .material(SMOOTH));
        Scenes.run(pool, 50);
        assertThat(box.x()).as("it has passed the kink").isGreaterThan(w);
        double sin = Math.sin(kink);
        double across = sin * sin * (0.25 + (w * w + h * h) / (12 * w * w));
        double along = Math.cos(kink) - h / (2 * w) * sin;
        double corner = across / (across + along * along);
        double left = box.kineticEnergy() / box.mass() + G * (box.y() - h / 2);
        double start = 4 * 4 / 2.0;
        double lost = start * (1 - (1 - corner) * (1 - corner));
        assertThat(start - left).isEqualTo(lost, within(0.03 * lost + 1e-3 * start));
    }

    /** A wall of boxes is as smooth when the weight presses sideways, too. */
    @Test
    void wallOfBoxesIsAPlane() {
        Pool pool =
                new Pool(
                        Scenes.usualWithoutSleep().without(Gravity.class).with(new Gravity(-5, -G)),
                        Accuracy.GAME);
        for (int i = 0; i < 20; i++) {
            pool.add(fixed(1, 1).at(-0.5, -i));
        }
        RigidBody disc =
                pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(0.3, 0).material(SMOOTH));
        Scenes.run(pool, 90);
        double t = 90 * Scenes.DT;
        assertThat(disc.y()).isEqualTo(-G * t * t / 2, within(1e-6));
        assertThat(disc.x()).isEqualTo(0.3, within(1e-6));
    }

    /** Pieces of one platform move together: seen from it, nothing moves. */
    @Test
    void movingPlatformOfBoxesIsAPlane() {
        Pool pool = pool(Accuracy.GAME);
        addFloor(
                pool,
                BodyDefinition.kinematic(Polygon.box(1, 1)).material(SMOOTH).velocity(-1, 0),
                0);
        RigidBody box =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.5, 0.5))
                                .at(3, 0.25)
                                .velocity(3, 0)
                                .material(SMOOTH));
        Scenes.run(pool, 120);
        assertThat(box.velocityX()).isEqualTo(3, within(1e-6));
    }

    /**
     * A step of 1 mm is a step: its side meets the lower corner of a box of 0.5 m. Even if the box
     * were free to turn about that corner it would keep no more than 1 − 1/(1 + 3/2) of its speed.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 0.1})
    void stepStopsWhatSlidesAgainstIt(double height) {
        Pool pool = pool(Accuracy.GAME);
        pool.add(fixed(10, 1).at(-5, -0.5));
        pool.add(fixed(10, 1).at(5, height - 0.5));
        RigidBody box =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.5, 0.5))
                                .at(-1, 0.25)
                                .velocity(2, 0)
                                .material(SMOOTH));
        Scenes.run(pool, 30);
        assertThat(box.velocityX()).isLessThanOrEqualTo(2 * 0.6 + 1e-9);
    }

    /** In the corner between floor and wall a box stands on both its lower corners. */
    @Test
    void boxRestsInACorner() {
        Pool pool = pool(Accuracy.GAME);
        pool.add(fixed(1, 4).at(-0.5, 1));
        pool.add(fixed(10, 1).at(5, -0.5));
        RigidBody box =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.5, 0.5))
                                .at(0.75, 0.25)
                                .velocity(-1, 0)
                                .material(SMOOTH));
        Scenes.run(pool, 120);
        assertThat(box.x()).isEqualTo(0.25, within(1e-3));
        assertThat(box.y()).isEqualTo(0.25, within(1e-4));
        assertThat(box.angle()).isEqualTo(0, within(1e-4));
        assertThat(box.velocityX()).isEqualTo(0, within(1e-6));
    }

    /**
     * A wall that stands on the floor covers a strip of it, yet a wedge whose corner is a little
     * inside the wall still falls on the floor and no further.
     */
    @ParameterizedTest
    @ValueSource(doubles = {1e-4, 1e-3, 3e-3})
    void floorUnderAWallCarries(double inside) {
        double tilt = 0.15;
        double cos = Math.cos(tilt);
        double sin = Math.sin(tilt);
        Pool pool = pool(Accuracy.GAME);
        pool.add(fixed(1, 4).at(-0.5, 2));
        pool.add(fixed(10, 1).at(4, -0.5));
        RigidBody wedge =
                pool.add(
                        BodyDefinition.dynamic(Polygon.of(0, 0, 0.5, 0, 0.1, 0.4))
                                .at(0.2 * cos - 0.4 / 3 * sin - inside, 0.2 * sin + 0.4 / 3 * cos)
                                .angle(tilt)
                                .material(SMOOTH));
        for (int step = 0; step < 60; step++) {
            pool.step(Scenes.DT);
            double corner =
                    wedge.y() - 0.2 * Math.sin(wedge.angle()) - 0.4 / 3 * Math.cos(wedge.angle());
            assertThat(corner).as("step " + step).isEqualTo(0, within(1e-3));
        }
        assertThat(wedge.angle()).isEqualTo(0, within(1e-4));
    }

    /** Both boxes of a seam are met at once, on the one normal they have in common. */
    @Test
    void ballOnASeamReboundsStraightUp() {
        Pool pool = pool(Accuracy.GAME);
        Material elastic = new Material(1, 0.5, 1);
        addFloor(pool, BodyDefinition.fixed(Polygon.box(1, 1)).material(elastic), 0);
        RigidBody ball =
                pool.add(BodyDefinition.dynamic(new Circle(0.25)).at(2.5, 1.25).material(elastic));
        // From 1 m the ball falls for √(2/g) = 0.45 s.
        Scenes.run(pool, 40);
        assertThat(ball.velocityX()).isEqualTo(0, within(1e-9));
        assertThat(ball.velocityY()).isGreaterThan(0);
    }
}
