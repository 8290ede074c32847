package rigibo.backend.law;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.Pool;
import rigibo.backend.StepReport;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Bodies alone in space: what one gains the others lose. */
class MomentumLawTest {

    private static final int SCENES = 300;

    /** One second: every body has met the others in the middle and left. */
    private static final int STEPS = 60;

    private static final double SPEED = 8;

    /** Share of a scene's angular momenta; the worst seed measured is 116 at GAME: 3.4e-3. */
    private static final double NEAR = 1e-2;

    private static final Effects SPACE =
            Effects.of(
                    new Contacts(),
                    new Rotation(),
                    new Friction(),
                    new Restitution(),
                    new ContinuousImpacts());

    @ParameterizedTest
    @EnumSource(Preset.class)
    void momentumIsKeptToRoundOff(Preset preset) {
        Laws.hold(1, SCENES, seed -> scene(seed, preset), MomentumLawTest::momentumKept);
    }

    /**
     * To round-off, until bodies stay in touch: a blow in flight acts on both at one point. DRAFT
     * has none: its blows are those of a substep's straight lines, not of the turning bodies.
     */
    @ParameterizedTest
    @EnumSource(value = Preset.class, names = "DRAFT", mode = EnumSource.Mode.EXCLUDE)
    void angularMomentumIsKeptToRoundOffInFlight(Preset preset) {
        Laws.hold(1, SCENES, seed -> scene(seed, preset), MomentumLawTest::angularMomentumKept);
    }

    /**
     * A pile takes overlap back by moving bodies, which moves their momenta sideways, and its blows
     * act where the points were at the substep's begin: angular momentum is kept as well as places
     * are.
     */
    @ParameterizedTest
    @EnumSource(value = Preset.class, names = "DRAFT", mode = EnumSource.Mode.EXCLUDE)
    void angularMomentumInPilesIsKeptAsWellAsPlaces(Preset preset) {
        Laws.hold(1, SCENES, seed -> scene(seed, preset), MomentumLawTest::angularMomentumNear);
    }

    private static RandomScene scene(long seed, Preset preset) {
        Draw draw = new Draw(seed);
        List<BodyDefinition> bodies = new ArrayList<>();
        for (double[] place : draw.places(draw.whole(2, 12), 0.5, 0.5)) {
            BodyDefinition body =
                    BodyDefinition.dynamic(draw.shape(draw.between(0.15, 0.5)))
                            .at(place[0], place[1])
                            .angle(draw.between(-3, 3))
                            .material(draw.material());
            bodies.add(draw.thrownInwards(body, SPEED));
        }
        return new RandomScene(seed, SPACE, preset.accuracy, STEPS, bodies);
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
