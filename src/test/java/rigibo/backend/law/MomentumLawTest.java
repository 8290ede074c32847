package rigibo.backend.law;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.StepReport;

import java.util.Optional;

/** Bodies alone in space: what one gains the others lose. */
class MomentumLawTest {

    private static final int SCENES = 300;

    /** Share of a scene's angular momenta; the worst seed measured is 116 at GAME: 3.4e-3. */
    private static final double NEAR = 1e-2;

    /** m: places within 10 m, 1.8e-15 m apart, rounded at every step and impact of every body. */
    private static final double STRAIGHT = 1e-11;

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

    @ParameterizedTest
    @EnumSource(Preset.class)
    void centreOfMassGoesStraightOn(Preset preset) {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.meeting(seed, preset.accuracy),
                MomentumLawTest::centreStraight);
    }

    private static Optional<String> centreStraight(RandomScene scene) {
        Pool pool = scene.pool();
        double[] start = centre(pool);
        double speedX = pool.momentumX() / start[2];
        double speedY = pool.momentumY() / start[2];
        double off = 0;
        for (int i = 0; i < scene.steps(); i++) {
            pool.step(RandomScene.DT);
            double[] now = centre(pool);
            double x = start[0] + speedX * pool.time();
            double y = start[1] + speedY * pool.time();
            off = Math.max(off, Math.hypot(now[0] - x, now[1] - y));
        }
        return Law.atMost(STRAIGHT, off, "centre of mass is off by m");
    }

    /** x and y of the centre of mass in m, and the mass in kg. */
    private static double[] centre(Pool pool) {
        double x = 0;
        double y = 0;
        double mass = 0;
        for (RigidBody body : pool.bodies()) {
            x += body.mass() * body.x();
            y += body.mass() * body.y();
            mass += body.mass();
        }
        return new double[] {x / mass, y / mass, mass};
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
