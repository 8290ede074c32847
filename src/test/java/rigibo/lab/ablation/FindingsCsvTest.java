package rigibo.lab.ablation;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.List;

class FindingsCsvTest {

    @Test
    void tableHasALineForEachComparison() {
        List<String> lines = FindingsCsv.lines(Fake.findings());
        assertThat(lines).hasSize(1 + 1 + 4 + 1);
        assertThat(lines).allMatch(line -> line.split(",", -1).length == 14);
        assertThat(lines.get(1)).startsWith("undeclared,flyers,,,5000.0,5010.0,ratio,1.002,");
    }
}
