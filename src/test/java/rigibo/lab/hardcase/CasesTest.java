package rigibo.lab.hardcase;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

class CasesTest {

    private static final List<Preset> ALL = List.of(Preset.values());

    private static List<String> namesOf(List<HardCase.Result> results) {
        return results.stream()
                .map(result -> result.hardCase().row() + " " + result.preset())
                .toList();
    }

    private static Cases cases(List<String> rows, List<Preset> presets) {
        return new Cases(rows, presets, Sampling.USUAL);
    }

    @Test
    void rowsAreUnique() {
        assertThat(Stream.concat(HardCases.all().stream(), HardCases.longRuns().stream()))
                .extracting(HardCase::row)
                .doesNotHaveDuplicates();
    }

    @Test
    void resultsComeInTheOrderOfTheListAndOfThePresets() {
        List<HardCase.Result> told = new ArrayList<>();
        Cases cases = cases(List.of("13", "5"), List.of(Preset.GAME, Preset.DRAFT));
        List<HardCase.Result> results = cases.run(told::add);
        assertThat(namesOf(results)).containsExactly("5 GAME", "5 DRAFT", "13 GAME", "13 DRAFT");
        assertThat(told).isEqualTo(results);
        assertThat(results).allMatch(HardCase.Result::passes);
        assertThat(cases.count()).isEqualTo(4);
    }

    @Test
    void rowMeansAllItsPartsAndNothingThatOnlyBeginsLikeIt() {
        assertThat(cases(List.of("20/10"), ALL).count()).isEqualTo(4);
        assertThat(cases(List.of("5"), ALL).count()).isEqualTo(4);
        int parts = cases(List.of("20"), List.of(Preset.EXACT)).count();
        assertThat(parts)
                .isEqualTo(
                        (int)
                                HardCases.all().stream()
                                        .filter(one -> one.row().startsWith("20/"))
                                        .count());
    }

    @Test
    void presetIsNotCountedWhereItIsTooFast() {
        assertThat(cases(List.of("20/50"), ALL).count()).isEqualTo(2);
    }

    @Test
    void longRunsComeOnlyWhenNamed() {
        List<String> rows = HardCases.longRuns().stream().map(HardCase::row).toList();
        assertThat(cases(rows, List.of(Preset.GAME)).count()).isEqualTo(rows.size());
        assertThat(cases(List.of(), List.of(Preset.EXACT)).count())
                .isEqualTo(HardCases.all().size());
    }

    @Test
    void unknownRowIsRefusedWithThoseThereAre() {
        assertThatThrownBy(() -> cases(List.of("5", "1000"), ALL))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'1000'")
                .hasMessageContaining("20/10");
    }

    @Test
    void brokenRunIsAFailureThatSaysWhy() {
        HardCase.Result result =
                HardCases.all().get(0).broken(Preset.GAME, new IllegalStateException("why"));
        assertThat(result.passes()).isFalse();
        assertThat(CaseTable.line(result)).startsWith("FAIL").contains("runs that broke off");
        assertThat(CaseTable.failures(result)).singleElement().asString().contains("why");
    }

    @Test
    void lineShowsTheFigureThatComesNearestToItsLimit() {
        List<Measure> measures =
                List.of(
                        new Measure("far", 1, 100, "m", "here"),
                        new Measure("near", 2, 3, "m", "there"),
                        new Measure("only told", 9, Double.POSITIVE_INFINITY, "m", ""));
        HardCase first = HardCases.all().get(0);
        HardCase.Result result = new HardCase.Result(first, Preset.GAME, measures, CaseWork.NONE);
        assertThat(CaseTable.line(result)).startsWith("ok").contains("near", "x 1.50", "rows 0");
        assertThat(CaseTable.failures(result)).isEmpty();
        assertThat(CaseTable.csv(List.of(result)))
                .hasSize(1 + measures.size())
                .allMatch(line -> line.replaceAll("\"[^\"]*\"", "").split(",", -1).length == 15);
        assertThat(CaseTable.page(List.of(result), " --only 1", "machine", "day"))
                .contains("1 passed, 0 failed", "| near | 2 m | 3 | 1.50 |", "cases --only 1 ");
    }
}
