package rigibo.backend.law;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.Pool;
import rigibo.backend.effect.Sleep;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.LongFunction;

/** The laws of free bodies also hold for joined ones. */
@Execution(ExecutionMode.CONCURRENT)
class JointedLawTest {

    private static final int FEW = 4;

    /** Half a second: chains that swing multiply what two runs differ by. */
    private static final int STEPS_OF_A_SWING = 30;

    /** In no step more than the share of what there was at the start. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void pilesGainNoEnergy(Preset preset) {
        Laws.hold(
                Seeds.upTo(preset == Preset.EXACT ? 14 : 300),
                trays(preset),
                (scene, asked) -> DressLawTest.gainsAtMost(1e-3, scene, asked),
                new Quota(preset == Preset.EXACT ? 200 : 2250, "loaded contacts in piles"));
    }

    /** A power of two changes no digit. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void smallPilesAreTheSameToTheBit(Preset preset) {
        Laws.hold(
                seeds(preset),
                trays(preset),
                (scene, asked) -> SymmetryLawTest.sameToTheEnd(Symmetry.SMALL, scene, asked),
                new Quota(500, "loaded contacts"));
    }

    /** Tolerances grow with the bodies, and a power of two changes no digit. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void largeAssembliesSwingTheSameToTheBit(Preset preset) {
        holdSwings(preset, (scene, asked) -> swingsAlike(Symmetry.LARGE, 0, scene, asked));
    }

    /**
     * In m. What counts as solved leaves 1e-7 of the fastest speed at GAME and 1e-12 at EXACT, by
     * which two runs may differ: of 10 m/s half a micrometre in half a second, which a chain that
     * swings multiplies by up to a hundred.
     */
    @ParameterizedTest
    @CsvSource({
        "GAME, MIRROR, 1e-4",
        "GAME, QUARTER_TURN, 1e-4",
        "GAME, MOVING, 1e-4",
        "EXACT, MIRROR, 1e-9",
        "EXACT, QUARTER_TURN, 1e-9",
        "EXACT, MOVING, 1e-9"
    })
    void assembliesSwingTheSameSeenOtherwise(Preset preset, Symmetry symmetry, double limit) {
        holdSwings(preset, (scene, asked) -> swingsAlike(symmetry, limit, scene, asked));
    }

    /** In m, as seen otherwise. */
    @ParameterizedTest
    @CsvSource({"GAME, 1e-4", "EXACT, 1e-9"})
    void orderDoesNotMatterToWhatSwings(Preset preset, double limit) {
        holdSwings(preset, (scene, asked) -> swingsInAnyOrder(limit, scene, asked));
    }

    @ParameterizedTest
    @EnumSource(Preset.class)
    void strangersNeverMatter(Preset preset) {
        Laws.hold(
                seeds(preset),
                trays(preset),
                OrderLawTest::sameAmongStrangers,
                new Quota(preset == Preset.EXACT ? 200 : 300, "loaded contacts in piles"));
    }

    @ParameterizedTest
    @EnumSource(Preset.class)
    void aRestoredPoolGoesOnAlike(Preset preset) {
        Laws.hold(
                seeds(preset),
                trays(preset),
                DressLawTest::goesOnAlike,
                new Quota(10, "snapshots"));
    }

    @ParameterizedTest
    @EnumSource(
            value = Preset.class,
            names = {"DRAFT", "GAME", "FINE"})
    void fewThatSleepWouldNotHaveMoved(Preset preset) {
        Laws.hold(
                seeds(preset),
                seed -> Links.on(Surroundings.settling(seed, preset.accuracy, FEW)),
                SleepLawTest::stillWithoutSleep,
                new Quota(14, "bodies asleep"));
    }

    @ParameterizedTest
    @CsvSource({"DRAFT, 1e-2", "GAME, 2e-3", "FINE, 1e-3"})
    void gentleEditsAddNoEnergy(Preset preset, double limit) {
        Laws.hold(
                Seeds.upTo(150),
                seed -> edited(seed, preset),
                (scene, asked) -> EditsLawTest.gentlyEdited(limit, scene, asked),
                new Quota(375, "edits of what touched"));
    }

    @ParameterizedTest
    @EnumSource(Preset.class)
    void bodiesPutIntoOthersArePushedOutWithoutHarm(Preset preset) {
        Laws.hold(
                seeds(preset),
                seed -> edited(seed, preset),
                EditsLawTest::roughlyEdited,
                new Quota(110, "steps that took overlap back"));
    }

    /** Fewer where each takes long. */
    private static void holdSwings(Preset preset, Law law) {
        Laws.hold(seeds(preset), seed -> swinging(seed, preset), law, new Quota(24, "joints"));
    }

    private static LongFunction<RandomScene> trays(Preset preset) {
        return seed -> Links.on(Surroundings.tray(seed, preset.accuracy));
    }

    private static Seeds seeds(Preset preset) {
        return Seeds.upTo(preset == Preset.EXACT ? 14 : 40);
    }

    /** A tray, every other one with sleep. */
    static RandomScene edited(long seed, Preset preset) {
        RandomScene tray = Links.on(Surroundings.tray(seed, preset.accuracy));
        return seed % 2 == 0 ? tray : tray.effects(tray.effects().with(new Sleep()));
    }

    /** What is joined in a tray, at rest, and meets nothing. */
    static RandomScene swinging(long seed, Preset preset) {
        RandomScene tray = Surroundings.tray(seed, preset.accuracy);
        List<BodyDefinition> bodies = new ArrayList<>();
        for (BodyDefinition body : tray.bodies()) {
            bodies.add(body.velocity(0, 0).spin(0).filter(Filter.ALL.group(-1)));
        }
        return Links.carriedAlongOn(tray.bodies(bodies).steps(STEPS_OF_A_SWING));
    }

    static Optional<String> swingsAlike(
            Symmetry symmetry, double limit, RandomScene scene, Asked asked) {
        asked.more(scene.links().size());
        Pool pool = scene.finished();
        Pool other = symmetry.of(scene).finished();
        double off = SymmetryLawTest.difference(symmetry, pool, other);
        return asked.atMost(limit, off, symmetry + ": off by m");
    }

    static Optional<String> swingsInAnyOrder(double limit, RandomScene scene, Asked asked) {
        asked.more(scene.links().size());
        List<BodyDefinition> bodies = new ArrayList<>(scene.bodies());
        List<Link> links = new ArrayList<>(scene.links());
        Draw draw = new Draw(scene.seed());
        draw.shuffle(bodies);
        draw.shuffle(links);
        Pool pool = scene.finished();
        Pool other = scene.bodies(bodies).links(links).finished();
        double off = 0;
        for (int i = 0; i < bodies.size(); i++) {
            State expected = State.of(pool.bodies().get(scene.bodies().indexOf(bodies.get(i))));
            off = Math.max(off, expected.off(State.of(other.bodies().get(i))));
        }
        return asked.atMost(limit, off, "in another order off by m");
    }
}
