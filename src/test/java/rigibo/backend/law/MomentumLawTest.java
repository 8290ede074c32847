package rigibo.backend.law;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.Pool;
import rigibo.backend.StepReport;

import java.util.Optional;

/** Bodies alone in space: what one gains the others lose. */
class MomentumLawTest {

    private static final int SCENES = 300;

    /** Share of a scene's angular momenta; the worst seed measured is 116 at GAME: 3.4e-3. */
    private static final double NEAR = 1e-2;

    @ParameterizedTest
    @EnumSource(Preset.class)
    void momentumIsKeptToRoundOff(Preset preset) {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.meeting(seed, preset.accuracy),
                MomentumLawTest::momentumKept);
    }

    /**
     * To round-off, until bodies stay in touch: a blow in flight acts on both at one point. DRAFT
     * has none: its blows are those of a substep's straight lines, not of the turning bodies.
     */
    @ParameterizedTest
    @EnumSource(value = Preset.class, names = "DRAFT", mode = EnumSource.Mode.EXCLUDE)
    void angularMomentumIsKeptToRoundOffInFlight(Preset preset) {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.meeting(seed, preset.accuracy),
                MomentumLawTest::angularMomentumKept);
    }

    /**
     * A pile takes overlap back by moving bodies, which moves their momenta sideways, and its blows
     * act where the points were at the substep's begin: angular momentum is kept as well as places
     * are.
     */
    @ParameterizedTest
    @EnumSource(value = Preset.class, names = "DRAFT", mode = EnumSource.Mode.EXCLUDE)
    void angularMomentumInPilesIsKeptAsWellAsPlaces(Preset preset) {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.meeting(seed, preset.accuracy),
                MomentumLawTest::angularMomentumNear);
    }

    private static Optional<String> momentumKept(RandomScene scene) {
        Pool pool = scene.pool();
        double x = pool.momentumX();
        double y = pool.momentumY();
        RoundOff roundOff = new RoundOff();
        roundOff.note(pool, 0);
        for (int i = 0; i < scene.steps(); i++) {
            roundOff.note(pool, pool.step(RandomScene.DT).impacts());
        }
        double off = Math.hypot(pool.momentumX() - x, pool.momentumY() - y);
        return Law.atMost(roundOff.ofMomentum(), off, "momentum is off by N·s");
    }

    private static Optional<String> angularMomentumKept(RandomScene scene) {
        Pool pool = scene.pool();
        double before = pool.angularMomentum();
        double off = 0;
        RoundOff roundOff = new RoundOff();
        roundOff.note(pool, 0);
        for (int i = 0; i < scene.steps(); i++) {
            StepReport report = pool.step(RandomScene.DT);
            if (report.rows() > 0) {
                break;
            }
            roundOff.note(pool, report.impacts());
            off = Math.abs(pool.angularMomentum() - before);
        }
        return Law.atMost(roundOff.ofAngularMomentum(), off, "angular momentum is off by kg·m²/s");
    }

    private static Optional<String> angularMomentumNear(RandomScene scene) {
        Pool pool = scene.pool();
        double before = pool.angularMomentum();
        RoundOff roundOff = new RoundOff();
        roundOff.note(pool, 0);
        for (int i = 0; i < scene.steps(); i++) {
            roundOff.note(pool, pool.step(RandomScene.DT).impacts());
        }
        double off = Math.abs(pool.angularMomentum() - before) / roundOff.angularScale();
        return Law.atMost(NEAR, off, "angular momentum is off by the share");
    }
}
