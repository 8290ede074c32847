package rigibo.lab.precision;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;
import rigibo.lab.precision.probe.Patience;

import java.util.List;
import java.util.stream.Stream;

class ExamTest {

    private static final Engine ENGINE = new RigiBoEngine();

    private static List<String> measured(String... names) {
        List<Setting> settings =
                Stream.of(names).map(name -> Engines.setting(ENGINE, name)).toList();
        return new Exam("R2", ENGINE, settings, Patience.NONE)
                .measured().stream().map(Setting::name).toList();
    }

    /** All of them are what GAME is made of. */
    @Test
    void settingUnderSeveralNamesIsRunOnce() {
        assertThat(
                        measured(
                                "GAME",
                                "step, 1/60 s",
                                "substeps 4",
                                "passes 1",
                                "impact tolerance 1e-04",
                                "impacts a pair 16",
                                "search ITP",
                                "contact solver DIRECT",
                                "correction SOFT"))
                .containsExactly("GAME");
    }

    @Test
    void anotherStepOrAnotherKnobIsAnotherSetting() {
        String[] names = {"DRAFT", "GAME", "step, 1/120 s", "step, by RK4, 1/60 s", "substeps 8"};
        assertThat(measured(names)).containsExactly(names);
    }
}
