package rigibo.backend.law;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What holds for sharp bodies holds for capsules and for polygons with round corners. */
class RoundedLawTest {

    private static final Seeds SEEDS = Seeds.upTo(150);

    /** Of what a polygon reaches, how much is its rounding. */
    private static final double ROUNDING = 0.2;

    /**
     * In no step more than the share of what there was at the start. At DRAFT what turns fast sinks
     * in and is lifted: one scene in 150 has more than a thousandth then.
     */
    @ParameterizedTest
    @CsvSource({"DRAFT, 1e-2", "GAME, 1e-3", "FINE, 1e-3", "EXACT, 1e-3"})
    void pilesGainNoEnergy(Preset preset, double limit) {
        Laws.hold(
                SEEDS,
                seed -> rounded(Surroundings.tray(seed, preset.accuracy)),
                (scene, asked) -> gainsAtMost(limit, scene, asked),
                new Quota(4000, "loaded contacts in piles"));
    }

    /** No deeper than 2 % of the smallest width; without bounces, which DRAFT does not look for. */
    @ParameterizedTest
    @EnumSource(value = Preset.class, names = "DRAFT", mode = EnumSource.Mode.EXCLUDE)
    void fewHardlySinkIn(Preset preset) {
        Laws.hold(
                SEEDS,
                seed -> rounded(Surroundings.landing(seed, preset.accuracy, 3)),
                RoundedLawTest::isShallow,
                new Quota(1400, "contacts begun"));
    }

    @ParameterizedTest
    @EnumSource(Preset.class)
    void aRestoredPoolGoesOnAlike(Preset preset) {
        Laws.hold(
                Seeds.upTo(30),
                seed -> rounded(Surroundings.tray(seed, preset.accuracy)),
                RoundedLawTest::goesOnAlike,
                new Quota(30, "snapshots"));
    }

    private static Optional<String> gainsAtMost(double limit, RandomScene scene, Asked asked) {
        Pool pool = scene.pool();
        Energy energy = new Energy(pool);
        for (int i = 0; i < scene.steps(); i++) {
            pool.step(RandomScene.DT);
            energy.note();
            asked.more(Contacts.loadedInPiles(pool));
        }
        return asked.atMost(limit, energy.mostGainedShare(), "energy gained in a step");
    }

    private static Optional<String> isShallow(RandomScene scene, Asked asked) {
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
        return asked.atMost(0.02, deepest / width, "overlap in smallest widths");
    }

    private static Optional<String> goesOnAlike(RandomScene scene, Asked asked) {
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

    /** The scene with capsules and round corners in place of every body that moves. */
    private static RandomScene rounded(RandomScene scene) {
        List<BodyDefinition> bodies = new ArrayList<>();
        for (BodyDefinition body : scene.bodies()) {
            boolean isFixed = body.type() != BodyType.DYNAMIC;
            bodies.add(isFixed ? body : body.shape(rounded(body.shape(), bodies.size())));
        }
        return scene.bodies(bodies);
    }

    private static Shape rounded(Shape shape, int index) {
        double reach = shape.boundingRadius();
        Outline outline = shape.outline();
        if (outline.isDisc() || index % 3 == 0) {
            return new Capsule(0.6 * reach, 0.4 * reach);
        }
        double[] corners = ((Polygon) shape).stated();
        for (int i = 0; i < corners.length; i++) {
            corners[i] *= 1 - ROUNDING;
        }
        return Polygon.of(corners).rounded(ROUNDING * reach);
    }
}
