package rigibo.backend.law;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.ContactEvent;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.StepReport;

import java.util.Optional;

/** Bodies alone in space: what one gains the others lose. */
@Execution(ExecutionMode.CONCURRENT)
class MomentumLawTest {

    private static final Seeds SEEDS = Seeds.upTo(300);

    private static final Quota MEETINGS = new Quota(1500, "contacts begun");

    /** The friction of two bodies that have the most that is drawn, as of {@link Draw}. */
    private static final double MOST_FRICTION = 1.2;

    /** m: places within 10 m, 1.8e-15 m apart, rounded at every step and impact of every body. */
    private static final double STRAIGHT = 1e-11;

    @ParameterizedTest
    @EnumSource(Preset.class)
    void momentumIsKeptToRoundOff(Preset preset) {
        hold(preset, MomentumLawTest::momentumKept, MEETINGS);
    }

    /**
     * To round-off, until bodies stay in touch: an impact in flight acts on both at one point.
     * DRAFT has no such impacts: all are a pile's.
     */
    @ParameterizedTest
    @EnumSource(value = Preset.class, names = "DRAFT", mode = EnumSource.Mode.EXCLUDE)
    void angularMomentumIsKeptToRoundOffInFlight(Preset preset) {
        hold(preset, MomentumLawTest::angularMomentumKept, new Quota(1700, "impacts"));
    }

    /**
     * An impact in a pile acts where the points of both bodies were at the substep's begin, so it
     * turns them by as much too much as they move past each other until its end; a pile that takes
     * overlap back moves bodies, and their momenta with them.
     */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void angularMomentumInPilesIsKeptAsWellAsPlaces(Preset preset) {
        hold(
                preset,
                MomentumLawTest::angularMomentumNear,
                new Quota(260, "loaded contacts in piles"));
    }

    @ParameterizedTest
    @EnumSource(Preset.class)
    void centreOfMassGoesStraightOn(Preset preset) {
        hold(preset, MomentumLawTest::centreStraight, MEETINGS);
    }

    private static void hold(Preset preset, Law law, Quota quota) {
        Laws.hold(SEEDS, seed -> Surroundings.meeting(seed, preset.accuracy), law, quota);
    }

    private static Optional<String> centreStraight(RandomScene scene, Asked asked) {
        Pool pool = scene.pool();
        double[] start = centre(pool);
        double speedX = pool.momentumX() / start[2];
        double speedY = pool.momentumY() / start[2];
        double off = 0;
        for (int i = 0; i < scene.steps(); i++) {
            pool.step(RandomScene.DT);
            asked.more(Contacts.begun(pool));
            double[] now = centre(pool);
            double x = start[0] + speedX * pool.time();
            double y = start[1] + speedY * pool.time();
            off = Math.max(off, Math.hypot(now[0] - x, now[1] - y));
        }
        return asked.atMost(STRAIGHT, off, "centre of mass is off by m");
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

    private static Optional<String> momentumKept(RandomScene scene, Asked asked) {
        Pool pool = scene.pool();
        double x = pool.momentumX();
        double y = pool.momentumY();
        RoundOff roundOff = new RoundOff();
        roundOff.note(pool, 0);
        for (int i = 0; i < scene.steps(); i++) {
            roundOff.note(pool, pool.step(RandomScene.DT).impacts());
            asked.more(Contacts.begun(pool));
        }
        double off = Math.hypot(pool.momentumX() - x, pool.momentumY() - y);
        return asked.atMost(roundOff.ofMomentum(), off, "momentum is off by N·s");
    }

    private static Optional<String> angularMomentumKept(RandomScene scene, Asked asked) {
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
            asked.more(report.impacts());
            roundOff.note(pool, report.impacts());
            off = Math.abs(pool.angularMomentum() - before);
        }
        return asked.atMost(
                roundOff.ofAngularMomentum(), off, "angular momentum is off by kg·m²/s");
    }

    /** In every step, compared with the most that its impacts and its overlap may have changed. */
    private static Optional<String> angularMomentumNear(RandomScene scene, Asked asked) {
        Pool pool = scene.pool();
        RoundOff roundOff = new RoundOff();
        double substep = RandomScene.DT / scene.accuracy().substeps();
        double most = 0;
        for (int i = 0; i < scene.steps(); i++) {
            double before = pool.angularMomentum();
            double fastest = Speeds.fastest(pool);
            double overlap = pool.report().deepestOverlap();
            StepReport report = pool.step(RandomScene.DT);
            roundOff.note(pool, report.impacts());
            if (report.rows() > 0) {
                asked.more(Contacts.loaded(pool));
                // Two points, each no faster than the fastest.
                double past = 2 * Math.max(fastest, Speeds.fastest(pool)) * substep;
                double parted = Math.max(overlap, report.deepestOverlap()) * Speeds.momenta(pool);
                double turned = impacts(pool) * past + parted + roundOff.ofAngularMomentum();
                most = Math.max(most, Math.abs(pool.angularMomentum() - before) / turned);
            }
        }
        return asked.atMost(1, most, "of what impacts may turn, angular momentum is off by");
    }

    /** All impulses of the last step, friction included, N·s. */
    private static double impacts(Pool pool) {
        double normal = pool.contactEvents().stream().mapToDouble(ContactEvent::impulse).sum();
        return normal * Math.hypot(1, MOST_FRICTION);
    }
}
