package rigibo.lab.ablation;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Effects;

import java.util.Map;

class PageTest {

    private static final Provenance PROVENANCE =
            new Provenance("a machine", "a day", " --runs 20", Map.of("Crate", Effects.usual()));

    private final String text = new Page(Fake.findings(), PROVENANCE, "the flags").text();

    @Test
    void tellsWhereItComesFrom() {
        assertThat(text)
                .contains("`./rigibo lab --figures effects --runs 20` on a machine, a day.")
                .contains("(`the flags`)", "periods of 30 steps", "of at least 95.9 %");
    }

    @Test
    void undeclaredEffectsAreARatioWithItsInterval() {
        assertThat(text)
                .contains(
                        "| flyers | 41 | 5.00 µs | 5.01 µs | 1.0020 | 1.0020 to 1.0020 | equal"
                                + " within 1 % | 0.00 | yes | yes |")
                .contains("in 1 of 1 scenes its whole interval is within 1 %");
    }

    /** 25 rows at 10 contacts. */
    @Test
    void contactsAreCountedWithTheirRows() {
        assertThat(text).contains("| flyers | 128 | 12 | 10 | 3 | 40 | 25 | 2.50 |");
    }

    /** (2100 − 1100)/100 = 10 ns, (1600 − 1100)/(2100 − 1100) = 0.5, 128 − 64 bits. */
    @Test
    void costIsToldPerUser() {
        assertThat(text)
                .contains(
                        "| 1.00 µs | +100 ns | +110 ns | +600 ns | +1.10 µs | +10.0 ns | 0.50 |"
                                + " 64 |");
    }

    /** (4000 − 3000)/4000. */
    @Test
    void savingNamesWhatIsLeftOutWithIt() {
        assertThat(text).contains("| Gravity, Buoyancy | 1.00 µs | 1.00 µs to 1.00 µs | 25.0 |");
    }

    @Test
    void demosTellTheirStages() {
        assertThat(text).contains("### Crate", "gravity", "put islands to sleep");
    }
}
