package rigibo.lab.hardcase;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The result of a case's run is kept, and reported in the order of the list. */
class MarginsTest {

    private static final Cases CASES =
            new Cases(List.of("1", "11"), List.of(Preset.DRAFT, Preset.EXACT), Sampling.USUAL);

    @TempDir private Path directory;

    private static Margin margin(double figure, double limit) {
        return new Margin("7", Preset.FINE, new Measure("place", figure, limit, "of way", ""));
    }

    @Test
    void everyRunIsToldInOrder() {
        List<Margin> margins = Margins.of(CASES, directory, words -> {});
        assertThat(margins)
                .extracting(margin -> margin.row() + " " + margin.preset())
                .isEqualTo(CASES.names())
                .containsExactly("1 DRAFT", "1 EXACT", "11 DRAFT", "11 EXACT");
    }

    @Test
    void onlyWhatIsMissingIsRunAgain() throws Exception {
        List<Margin> first = Margins.of(CASES, directory, words -> {});
        Path log = directory.resolve("cases.log");
        List<String> lines = Files.readAllLines(log);
        Files.write(log, lines.subList(0, 3));
        List<String> told = new ArrayList<>();
        assertThat(Margins.of(CASES, directory, told::add)).isEqualTo(first);
        assertThat(told.get(0)).isEqualTo("1 runs to make");
        assertThat(Files.readAllLines(log)).isEqualTo(lines);
    }

    @Test
    void aCasePassesWithinItsLimitAlone() {
        assertThat(margin(1e-3, 0.1).passes()).isTrue();
        assertThat(margin(0.2, 0.1).passes()).isFalse();
        assertThat(margin(Double.NaN, 0.1).passes()).isFalse();
    }
}
