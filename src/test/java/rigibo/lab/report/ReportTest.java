package rigibo.lab.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.lab.report.Report.Passage;

import java.util.List;

/** A report reads alike at a terminal and on a page. */
class ReportTest {

    private static final Table TABLE =
            new Table(List.of("engine", "median"), List.of(List.of("ours", "1 ms")));

    @Test
    void oneTableStandsByItself() {
        Report report = Report.of(TABLE, List.of("It is fast."));

        assertThat(report.text())
                .containsExactly("engine  median", "ours      1 ms", "It is fast.");
        assertThat(report.markdown("Measured."))
                .isEqualTo("Measured.\n\n" + TABLE.markdown() + "\nIt is fast.\n");
    }

    @Test
    void passagesSayWhatTheyAreOf() {
        Passage passage = new Passage("heap", "Heap", "a heap", TABLE, List.of());
        Report report = new Report("One round.", List.of(passage));

        assertThat(report.text())
                .containsExactly("heap: a heap", "  engine  median", "  ours      1 ms", "");
        assertThat(report.markdown("Measured."))
                .isEqualTo("Measured.\n\nOne round.\n\n### Heap\n\nA heap.\n\n" + TABLE.markdown());
    }
}
