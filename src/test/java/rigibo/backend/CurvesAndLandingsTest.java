package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.SplittableRandom;

/**
 * Bodies in contact whose normal turns along their way, and whose corners land, against the
 * formulas of constrained motion. Nothing bounces, and energy is never above the start.
 */
class CurvesAndLandingsTest {

    private static final double G = 9.81;

    /** Of energy, by its start: what a step's sums round. */
    private static final double ROUND_OFF = 1e-12;

    private static final Material SMOOTH = new Material(1, 0, 0);
    private static final Material ROUGH = new Material(1, 3, 0);

    private static Pool pool(Preset preset) {
        return new Pool(Scenes.usualWithoutSleep(), preset.accuracy);
    }

    private static double energy(RigidBody body) {
        return body.kineticEnergy() + body.mass() * G * body.y();
    }

    /**
     * Of a substep of h seconds at v the way is straight and foreseen to second order: the error of
     * the gap is vt²·h·v/ρ², and friction moves nothing. With v up to 3 m/s and ρ over 1.2 m that
     * is a few µm at GAME.
     */
    @ParameterizedTest
    @CsvSource({"GAME, true", "GAME, false", "FINE, true", "EXACT, true", "EXACT, false"})
    void discFollowsARoundHill(Preset preset, boolean turns) {
        SplittableRandom random = new SplittableRandom(7);
        int asked = 0;
        for (int i = 0; i < 20; i++) {
            double hill = random.nextDouble(1, 4);
            double radius = random.nextDouble(0.2, 0.6);
            double speed = random.nextDouble(0.5, 0.9) * Math.sqrt(G * (hill + radius));
            Pool pool =
                    turns
                            ? pool(preset)
                            : new Pool(
                                    Scenes.usualWithoutSleep().without(Rotation.class),
                                    preset.accuracy);
            pool.add(BodyDefinition.fixed(new Circle(hill)).material(SMOOTH));
            RigidBody disc =
                    pool.add(
                            BodyDefinition.dynamic(new Circle(radius))
                                    .at(0, hill + radius)
                                    .velocity(Math.min(3, speed), 0)
                                    .material(SMOOTH));
            double start = energy(disc);
            double released = disc.mass() * (speed * speed / 2 + G * (hill + radius));
            // It leaves where g·cos θ = v²/ρ, and v² = v0² + 2gρ(1 − cos θ).
            double v0 = disc.velocityX();
            double reach = hill + radius;
            double leaves = (v0 * v0 / (G * reach) + 2) / 3;
            while (disc.y() / Math.hypot(disc.x(), disc.y()) > leaves + 0.05) {
                pool.step(Scenes.DT);
                double gap = Math.hypot(disc.x(), disc.y()) - reach;
                assertThat(gap).isEqualTo(0, within(2e-4 * radius));
                assertThat(energy(disc) - start).isLessThan(ROUND_OFF * released);
                // Nothing rubs: all of it is kept but for the error of second order.
                assertThat(energy(disc) - start).isGreaterThan(-2e-4 * released);
                asked++;
            }
        }
        assertThat(asked).isGreaterThan(100);
    }

    /**
     * At a concave kink of δ between two plates, whose corner lies in the other or flush with it, a
     * smooth disc keeps the part of its velocity along the next plate: it loses sin²δ of its energy
     * of motion, wherever in a step it comes there.
     */
    @ParameterizedTest
    @EnumSource(names = {"GAME", "FINE", "EXACT"})
    void discKeepsItsWayAlongTheNextPlate(Preset preset) {
        SplittableRandom random = new SplittableRandom(11);
        for (int i = 0; i < 40; i++) {
            double kink = Math.toRadians(random.nextDouble(2, 20));
            double radius = random.nextDouble(0.1, 0.5);
            double overlap = i % 2 == 0 ? 0 : random.nextDouble(0.05, 0.3);
            Pool pool = pool(preset);
            pool.add(
                    BodyDefinition.fixed(Polygon.box(20, 1))
                            .at(-10 + overlap, -0.5)
                            .material(SMOOTH));
            double cos = Math.cos(kink);
            double sin = Math.sin(kink);
            pool.add(
                    BodyDefinition.fixed(Polygon.box(20, 1))
                            .at((10 - overlap) * cos + 0.5 * sin, (10 - overlap) * sin - 0.5 * cos)
                            .angle(kink)
                            .material(SMOOTH));
            double speed = random.nextDouble(1, 4);
            RigidBody disc =
                    pool.add(
                            BodyDefinition.dynamic(new Circle(radius))
                                    .at(-random.nextDouble(0.5, 0.8), radius)
                                    .velocity(speed, 0)
                                    .material(SMOOTH));
            double start = energy(disc) - disc.mass() * G * radius;
            while (disc.x() < 0.1) {
                pool.step(Scenes.DT);
                assertThat(disc.velocityX()).isPositive();
            }
            double lost = start + disc.mass() * G * radius - energy(disc);
            // Second order in the substep's kick, gh against v·sin δ, and what is seen as landed.
            assertThat(lost / start).isEqualTo(sin * sin, within(0.02 * sin * sin + 2e-4));
        }
    }

    /** ω⁺/ω⁻ = 1 − (3/2)·sin²α, tan α = width/height: angular momentum about the new corner. */
    @ParameterizedTest
    @CsvSource({"GAME, 0.01", "FINE, 0.005", "EXACT, 0.005"})
    void blockThatRocksKeepsItsShareOfSpin(Preset preset, double off) {
        SplittableRandom random = new SplittableRandom(13);
        for (int i = 0; i < 20; i++) {
            double height = random.nextDouble(0.5, 3);
            double width = height * random.nextDouble(0.2, 0.5);
            double alpha = Math.atan(width / height);
            double half = Math.hypot(width, height) / 2;
            double lean = alpha * random.nextDouble(0.3, 0.7);
            Pool pool = pool(preset);
            pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5).material(ROUGH));
            RigidBody block =
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(width, height))
                                    .at(
                                            half * Math.sin(alpha - lean),
                                            half * Math.cos(alpha - lean))
                                    .angle(lean)
                                    .material(ROUGH));
            double low = block.mass() * G * height / 2;
            double start = energy(block) - low;
            while (block.angle() > 0) {
                pool.step(Scenes.DT);
                assertThat(energy(block) - low).isLessThan(start * (1 + ROUND_OFF));
            }
            double kept = Math.sqrt((energy(block) - low) / start);
            double truth = 1 - 1.5 * Math.sin(alpha) * Math.sin(alpha);
            assertThat(kept).isEqualTo(truth, within(off * truth));
        }
    }
}
