package rigibo.backend.law;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.Pool;

import java.util.Optional;

/** What holds for sharp bodies in one piece holds for round ones, and for those in parts. */
class DressLawTest {

    private static final Seeds SEEDS = Seeds.upTo(150);

    /**
     * In no step more than the share of what there was at the start. At DRAFT what turns fast sinks
     * in and is lifted: one scene of 150 has more than a thousandth then. In parts two of 300 have
     * at GAME, 2.3 thousandths at most: they sink in by as much where they are half as wide. Locked
     * ones are solved as joined ones are, with every contact measured anew in each part of a step.
     */
    @ParameterizedTest
    @CsvSource({
        "ROUNDED, DRAFT, 1e-2",
        "ROUNDED, GAME, 1e-3",
        "ROUNDED, FINE, 1e-3",
        "ROUNDED, EXACT, 1e-3",
        "IN_PARTS, DRAFT, 1e-2",
        "IN_PARTS, GAME, 3e-3",
        "IN_PARTS, FINE, 1e-3",
        "IN_PARTS, EXACT, 1e-3",
        "LOCKED, DRAFT, 1e-2",
        "LOCKED, GAME, 1e-3",
        "LOCKED, FINE, 1e-3",
        "LOCKED, EXACT, 1e-4"
    })
    void pilesGainNoEnergy(Dress dress, Preset preset, double limit) {
        Laws.hold(
                SEEDS,
                seed -> dress.on(Surroundings.tray(seed, preset.accuracy)),
                (scene, asked) -> gainsAtMost(limit, scene, asked),
                new Quota(4000, "loaded contacts in piles"));
    }

    /** A power of two changes no digit. */
    @ParameterizedTest
    @CsvSource({"ROUNDED, GAME", "ROUNDED, EXACT", "IN_PARTS, DRAFT", "IN_PARTS, GAME"})
    void smallPilesAreTheSameToTheBit(Dress dress, Preset preset) {
        Laws.hold(
                Seeds.upTo(60),
                seed -> dress.on(Surroundings.tray(seed, preset.accuracy)),
                (scene, asked) -> SymmetryLawTest.sameToTheEnd(Symmetry.SMALL, scene, asked),
                new Quota(5000, "loaded contacts"));
    }

    /** Bodies that others never meet do not matter, to the last bit. */
    @ParameterizedTest
    @CsvSource({
        "ROUNDED, GAME",
        "ROUNDED, EXACT",
        "IN_PARTS, DRAFT",
        "IN_PARTS, GAME",
        "LOCKED, DRAFT",
        "LOCKED, GAME",
        "LOCKED, EXACT"
    })
    void strangersNeverMatter(Dress dress, Preset preset) {
        Laws.hold(
                Seeds.upTo(60),
                seed -> dress.on(Surroundings.tray(seed, preset.accuracy)),
                OrderLawTest::sameAmongStrangers,
                new Quota(1000, "loaded contacts in piles"));
    }

    /** As of sharp bodies in one piece: only what is rounded otherwise differs. */
    @ParameterizedTest
    @CsvSource({"ROUNDED, MIRROR, 1e-11", "LOCKED, MIRROR, 1e-9", "LOCKED, QUARTER_TURN, 1e-9"})
    void fewImpactsAreTheSameSeenOtherwise(Dress dress, Symmetry symmetry, double limit) {
        Laws.hold(
                Seeds.upTo(150),
                seed -> dress.on(Surroundings.meeting(seed, Preset.EXACT.accuracy)),
                (scene, asked) -> SymmetryLawTest.sameInFlight(symmetry, 4, limit, scene, asked),
                new Quota(100, "impacts as of " + symmetry));
    }

    @ParameterizedTest
    @CsvSource({"ROUNDED", "IN_PARTS", "LOCKED"})
    void orderOfBodiesDoesNotMatterInFlight(Dress dress) {
        Laws.hold(
                Seeds.upTo(150),
                seed -> dress.on(Surroundings.meeting(seed, Preset.EXACT.accuracy)),
                OrderLawTest::sameInAnyOrder,
                new Quota(100, "impacts"));
    }

    /**
     * No deeper than 2 % of the smallest width, which is 4 % of a wedge's: it is half as wide.
     * Without bounces, which DRAFT does not look for.
     */
    @ParameterizedTest
    @CsvSource({
        "ROUNDED, GAME, 0.02",
        "ROUNDED, FINE, 0.02",
        "ROUNDED, EXACT, 0.02",
        "IN_PARTS, GAME, 0.04",
        "IN_PARTS, FINE, 0.04",
        "IN_PARTS, EXACT, 0.04"
    })
    void fewHardlySinkIn(Dress dress, Preset preset, double limit) {
        Laws.hold(
                SEEDS,
                seed -> dress.on(Surroundings.landing(seed, preset.accuracy, 3)),
                (scene, asked) -> isShallow(limit, scene, asked),
                new Quota(1400, "contacts begun"));
    }

    @ParameterizedTest
    @CsvSource({
        "ROUNDED, GAME",
        "ROUNDED, EXACT",
        "IN_PARTS, DRAFT",
        "IN_PARTS, GAME",
        "LOCKED, DRAFT",
        "LOCKED, GAME",
        "LOCKED, EXACT"
    })
    void aRestoredPoolGoesOnAlike(Dress dress, Preset preset) {
        Laws.hold(
                Seeds.upTo(30),
                seed -> dress.on(Surroundings.tray(seed, preset.accuracy)),
                DressLawTest::goesOnAlike,
                new Quota(30, "snapshots"));
    }

    static Optional<String> gainsAtMost(double limit, RandomScene scene, Asked asked) {
        Pool pool = scene.pool();
        Energy energy = new Energy(pool);
        for (int i = 0; i < scene.steps(); i++) {
            pool.step(RandomScene.DT);
            energy.note();
            asked.more(Contacts.loadedInPiles(pool));
        }
        return asked.atMost(limit, energy.mostGainedShare(), "energy gained in a step");
    }

    private static Optional<String> isShallow(double limit, RandomScene scene, Asked asked) {
        Pool pool = scene.pool();
        double width =
                scene.bodies().stream()
                        .mapToDouble(body -> body.shape().smallestWidth())
                        .min()
                        .orElseThrow();
        double deepest = 0;
        for (int i = 0; i < scene.steps(); i++) {
            deepest = Math.max(deepest, pool.step(RandomScene.DT).deepestOverlap());
            asked.more(Contacts.begun(pool));
        }
        return asked.atMost(limit, deepest / width, "overlap in smallest widths");
    }

    static Optional<String> goesOnAlike(RandomScene scene, Asked asked) {
        Pool pool = scene.pool();
        for (int i = 0; i < scene.steps() / 2; i++) {
            pool.step(RandomScene.DT);
        }
        Pool restored = Pool.restore(pool.snapshot());
        for (int i = 0; i < 20; i++) {
            pool.step(RandomScene.DT);
            restored.step(RandomScene.DT);
        }
        asked.more(1);
        return restored.stateHash() == pool.stateHash()
                ? Optional.empty()
                : Optional.of("another hash after 20 steps");
    }
}
