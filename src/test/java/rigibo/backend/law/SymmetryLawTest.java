package rigibo.backend.law;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.Pool;
import rigibo.backend.setup.Accuracy;

import java.util.Optional;

/**
 * Whoever looks at a scene in another way sees the same happen.
 *
 * <p>Every impact multiplies what two runs differ by, by about the flight before it over the size
 * of the bodies, and much more where they graze. So where round-off differs at all, only a scene's
 * first {@value #FEW} impacts are compared, which at most are one after the other.
 */
class SymmetryLawTest {

    private static final int SCENES = 300;
    private static final int FEW = 4;

    /** Two, for a corner's blows may follow each other closely. */
    private static final int BOUNCES = 2;

    /** What it takes for a tie to come up, which goes by the order of pairs. */
    private static final int MANY = 16;

    /** All that a scene has. */
    private static final int ALL = Integer.MAX_VALUE;

    @ParameterizedTest
    @EnumSource(Preset.class)
    void mirroredDiscsAndBoxesFlyTheSameToTheBit(Preset preset) {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.discsAndBoxes(meeting(seed, preset)),
                scene -> sameInFlight(Symmetry.MIRROR, MANY, 0, scene));
    }

    @ParameterizedTest
    @EnumSource(Preset.class)
    void turnedDiscsFlyTheSameToTheBit(Preset preset) {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.discs(meeting(seed, preset)),
                scene -> sameInFlight(Symmetry.QUARTER_TURN, ALL, 0, scene));
    }

    /**
     * A power of two changes no digit, and all that the engine tolerates scales with the bodies.
     */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void smallBodiesFlyTheSameToTheBit(Preset preset) {
        Laws.hold(
                1,
                SCENES,
                seed -> meeting(seed, preset),
                scene -> sameInFlight(Symmetry.SMALL, ALL, 0, scene));
    }

    @ParameterizedTest
    @EnumSource(Preset.class)
    void smallBodyComesToRestTheSameToTheBit(Preset preset) {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.landing(seed, preset.accuracy, 1),
                scene -> sameToTheEnd(Symmetry.SMALL, scene));
    }

    @ParameterizedTest
    @EnumSource(Preset.class)
    void smallPilesAreTheSameToTheBit(Preset preset) {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.tray(seed, preset.accuracy),
                scene -> sameToTheEnd(Symmetry.SMALL, scene));
    }

    /**
     * At EXACT, in m. Mirrors and turns: polygons begin at another corner, so that their sums round
     * otherwise. Large: the nanometre within which impacts are found is that of a body of a metre
     * for larger ones too, so the original misses by up to a nanometre per impact. Far away: the
     * 1.9 nm between doubles at 10,000 km, rounded to in every step. Moving: places are up to 32 m
     * further, whose doubles are 7e-15 m apart, and times of impact round accordingly.
     */
    @ParameterizedTest
    @CsvSource({
        "MIRROR, 1e-11",
        "QUARTER_TURN, 1e-11",
        "LARGE, 1e-6",
        "FAR_AWAY, 1e-4",
        "MOVING, 1e-10"
    })
    void fewImpactsInSpaceAreTheSame(Symmetry symmetry, double limit) {
        Laws.hold(
                1,
                SCENES,
                seed -> meeting(seed, Preset.EXACT),
                scene -> sameInFlight(symmetry, FEW, limit, scene));
    }

    /**
     * The same for a floor, which MOVING makes kinematic, and gravity, which turns and scales. Far
     * away the worst is seed 65, where a corner's second blow is a grazing one: 1.1e-4 m.
     */
    @ParameterizedTest
    @CsvSource({
        "MIRROR, 1e-11",
        "QUARTER_TURN, 1e-11",
        "LARGE, 1e-6",
        "FAR_AWAY, 1e-3",
        "MOVING, 1e-10"
    })
    void fewBouncesOnAFloorAreTheSame(Symmetry symmetry, double limit) {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.landing(seed, Accuracy.EXACT, 1),
                scene -> sameInFlight(symmetry, BOUNCES, limit, scene));
    }

    @Test
    void manyDiscsSeenFromATrainDoTheSame() {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.discs(meeting(seed, Preset.EXACT)),
                scene -> sameInFlight(Symmetry.MOVING, ALL, 1e-3, scene));
    }

    private static RandomScene meeting(long seed, Preset preset) {
        return Surroundings.meeting(seed, preset.accuracy);
    }

    /** Compares until there were so many impacts, or bodies stay in touch. */
    private static Optional<String> sameInFlight(
            Symmetry symmetry, int mostImpacts, double limit, RandomScene scene) {
        Pool pool = scene.pool();
        Pool other = symmetry.of(scene).pool();
        double off = 0;
        int impacts = 0;
        for (int i = 0; i < scene.steps(); i++) {
            impacts += pool.step(RandomScene.DT).impacts();
            other.step(RandomScene.DT);
            if (impacts > mostImpacts || pool.report().rows() + other.report().rows() > 0) {
                break;
            }
            off = Math.max(off, difference(symmetry, pool, other));
        }
        return Law.atMost(limit, off, symmetry + ": off by m");
    }

    private static Optional<String> sameToTheEnd(Symmetry symmetry, RandomScene scene) {
        Pool pool = scene.finished();
        Pool other = symmetry.of(scene).finished();
        return Law.atMost(0, difference(symmetry, pool, other), symmetry + ": off by m");
    }

    private static double difference(Symmetry symmetry, Pool pool, Pool other) {
        double off = 0;
        for (int i = 0; i < pool.bodies().size(); i++) {
            State expected = symmetry.of(State.of(pool.bodies().get(i)), pool.time());
            State found = State.of(other.bodies().get(i));
            off = Math.max(off, expected.off(found) / symmetry.metre());
        }
        return off;
    }
}
