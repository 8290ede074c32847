package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;

/** Walls that move as they are told, and what they meet and carry. */
@Execution(ExecutionMode.CONCURRENT)
class DrivenInPileTest {

    private static final Material ROUGH = new Material(1, 0.6, 0);
    private static final Effects PILES =
            Effects.of(
                    new Gravity(0, -9.81),
                    new Contacts(),
                    new Rotation(),
                    new Friction(),
                    new ContinuousImpacts());

    /**
     * A plate that rises meets a falling box at some time of a step, and both are one pile from
     * then on: the plate's way before that time counts, too. Truth: the box stands on the plate.
     * The deepest overlap is what the two may miss each other by, one tolerance of a metre's body
     * for the impact, and as much again for the overlap that is kept.
     */
    @ParameterizedTest
    @EnumSource(value = Preset.class, names = "DRAFT", mode = EnumSource.Mode.EXCLUDE)
    void plateThatMeetsAFallingBoxCarriesIt(Preset preset) {
        for (int phase = 0; phase < 10; phase++) {
            Pool pool = new Pool(PILES, preset.accuracy);
            pool.add(
                    BodyDefinition.kinematic(Polygon.box(4, 0.2))
                            .at(0, -0.1)
                            .velocity(0, 3)
                            .material(ROUGH));
            RigidBody box =
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(1, 1))
                                    .at(0, 1 + 0.01 * phase)
                                    .material(ROUGH));
            double deepest = 0;
            for (int i = 0; i < 40; i++) {
                deepest = Math.max(deepest, pool.step(Scenes.DT).deepestOverlap());
            }
            double tolerance = preset.accuracy.impactTolerance() + 1e-5;
            assertThat(deepest).as("overlap at phase %d", phase).isLessThan(2 * tolerance);
            double above = box.y() - 0.5 - 3 * pool.time();
            assertThat(Math.abs(above)).as("gap at phase %d", phase).isLessThan(2 * tolerance);
        }
    }

    /**
     * A plate that comes fast and is not foreseen has come in by a whole step's way when it is
     * first seen, a fifth of the box and more. The box has somewhere to go, so it goes along.
     */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void plateThatIsSeenLateTakesTheBoxAlong(Preset preset) {
        for (int speed = 1; speed <= 8; speed *= 2) {
            Effects unforeseen = Effects.of(new Contacts(), new Rotation(), new Friction());
            Pool pool = new Pool(unforeseen, preset.accuracy);
            BodyDefinition plate = BodyDefinition.kinematic(Polygon.box(22, 1)).at(0, -1);
            pool.add(plate.velocity(0, speed));
            RigidBody box = pool.add(BodyDefinition.dynamic(Polygon.box(BOX, BOX)).at(3, 0));
            Scenes.run(pool, 60);
            double above = box.y() - BOX / 2 - (speed * pool.time() - 0.5);
            // A second later e^(−25) of the overlap is left, plus the kept overlap.
            assertThat(above).as("at %d m/s", speed).isEqualTo(0, within(2e-5));
        }
    }

    private static final double HALF = 2.5;
    private static final double THICKNESS = 0.5;
    private static final double BOX = 0.25;
    private static final int ACROSS = 9;
    private static final double SPIN = Math.toRadians(25);

    /**
     * Boxes tumble in a square drum. No force is enough to stop its walls, but none of the boxes is
     * to be taken for crushed by them, for all can give way: none gets out.
     */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void nothingLeavesATurningDrum(Preset preset) {
        Pool pool = new Pool(PILES, preset.accuracy);
        List<RigidBody> walls = new ArrayList<>();
        for (int side = 0; side < 4; side++) {
            walls.add(pool.add(wall(side)));
        }
        for (int i = 0; i < ACROSS * ACROSS; i++) {
            double x = (i % ACROSS - (ACROSS - 1) / 2.0) * 1.6 * BOX;
            double y = (i / ACROSS - (ACROSS - 1) / 2.0) * 1.6 * BOX;
            BodyDefinition box = BodyDefinition.dynamic(Polygon.box(BOX, BOX));
            pool.add(box.at(x, y).material(ROUGH));
        }
        for (int step = 0; step < 240; step++) {
            double from = SPIN * step * Scenes.DT;
            for (int side = 0; side < 4; side++) {
                drive(walls.get(side), side, from, from + SPIN * Scenes.DT);
            }
            pool.step(Scenes.DT);
        }
        double turned = SPIN * pool.time();
        for (RigidBody body : pool.bodies()) {
            if (body.type() == BodyType.DYNAMIC) {
                double x = body.x() * Math.cos(turned) + body.y() * Math.sin(turned);
                double y = body.y() * Math.cos(turned) - body.x() * Math.sin(turned);
                assertThat(Math.max(Math.abs(x), Math.abs(y)))
                        .as("%s within the drum's walls", body)
                        .isLessThan(HALF);
            }
        }
    }

    private static BodyDefinition wall(int side) {
        double out = HALF + THICKNESS / 2;
        return BodyDefinition.kinematic(Polygon.box(2 * (HALF + THICKNESS), THICKNESS))
                .at(out * Math.sin(side * Math.PI / 2), -out * Math.cos(side * Math.PI / 2))
                .angle(side * Math.PI / 2)
                .material(ROUGH);
    }

    /** Along the chord to where the wall is one step later, so that no way adds up. */
    private static void drive(RigidBody wall, int side, double from, double to) {
        double out = HALF + THICKNESS / 2;
        double was = side * Math.PI / 2 + from;
        double is = side * Math.PI / 2 + to;
        wall.velocity(
                out * (Math.sin(is) - Math.sin(was)) / Scenes.DT,
                -out * (Math.cos(is) - Math.cos(was)) / Scenes.DT);
        wall.spin((to - from) / Scenes.DT);
    }
}
