package rigibo.backend.law;

import org.junit.jupiter.api.Disabled;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;

import java.util.Optional;

/** Bodies do not sink into each other. */
class OverlapLawTest {

    private static final int SCENES = 300;

    /** Share of a scene's smallest width. */
    private static final double DEEPEST = 0.02;

    @ParameterizedTest
    @EnumSource(Preset.class)
    void oneBodyDoesNotSinkIntoAFloor(Preset preset) {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.landing(seed, preset.accuracy, 1),
                OverlapLawTest::shallow);
    }

    @Disabled(
            "a light body between a heavy one and the floor: deeper at GAME in 3 of 300 scenes "
                    + "(worst 0.17, seed 247), at DRAFT in 5, at FINE and EXACT in 6")
    @ParameterizedTest
    @EnumSource(Preset.class)
    void fewBodiesDoNotSinkIntoEachOther(Preset preset) {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.landing(seed, preset.accuracy, 3),
                OverlapLawTest::shallow);
    }

    @Disabled(
            "bodies that strike a pile at speed: deeper in 26 to 37 of 300 scenes at every preset "
                    + "(GAME: 27, worst 1.1, seed 41)")
    @ParameterizedTest
    @EnumSource(Preset.class)
    void bodiesThrownAtEachOtherDoNotSinkIn(Preset preset) {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.meeting(seed, preset.accuracy),
                OverlapLawTest::shallow);
    }

    private static Optional<String> shallow(RandomScene scene) {
        Pool pool = scene.pool();
        double width =
                pool.bodies().stream()
                        .map(RigidBody::shape)
                        .mapToDouble(shape -> shape.smallestWidth())
                        .min()
                        .orElse(1);
        double deepest = 0;
        for (int i = 0; i < scene.steps(); i++) {
            deepest = Math.max(deepest, pool.step(RandomScene.DT).deepestOverlap());
        }
        return Law.atMost(DEEPEST, deepest / width, "overlap as a share of the smallest width");
    }
}
