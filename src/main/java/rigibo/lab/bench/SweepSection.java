package rigibo.lab.bench;

import rigibo.lab.bench.probe.Sample;
import rigibo.lab.bench.scene.BenchScenes;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.report.Amount;
import rigibo.lab.report.Table;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** The part of the report about the growth of a step's time with the number of bodies. */
final class SweepSection {

    /**
     * The smallest size that is fitted, in discs; in smaller scenes costs that do not depend on the
     * size matter.
     */
    private static final int FIRST_FITTED = 1000;

    private final Results results;
    private final List<String> scenes;
    private final List<String> engines;

    SweepSection(Results results) {
        this.results = results;
        scenes =
                results.runs().stream()
                        .map(Run::scene)
                        .filter(BenchScenes::isSwept)
                        .distinct()
                        .toList();
        engines = scenes.isEmpty() ? List.of() : results.engines(scenes.get(0));
    }

    boolean isEmpty() {
        return scenes.isEmpty();
    }

    /** The median time of a step by size and engine; the last line holds the exponents. */
    Table table() {
        List<List<String>> rows = new ArrayList<>();
        for (String scene : scenes) {
            String discs = String.format(Locale.ROOT, "%,d", BenchScenes.discs(scene));
            rows.add(row(discs, engines.stream().map(engine -> time(scene, engine))));
        }
        Stream<String> exponents = engines.stream().map(e -> Amount.digits(exponent(e)));
        rows.add(row("exponent", exponents));
        return new Table(row("discs", engines.stream()), rows);
    }

    private static List<String> row(String first, Stream<String> more) {
        return Stream.concat(Stream.of(first), more).toList();
    }

    private String time(String scene, String engine) {
        return results.engines(scene).contains(engine)
                ? Amount.time(results.median(scene, engine, Sample::median))
                : "";
    }

    /** The exponent over the sizes from 1,000 on that the engine ran. */
    double exponent(String engine) {
        List<String> fitted =
                scenes.stream()
                        .filter(scene -> BenchScenes.discs(scene) >= FIRST_FITTED)
                        .filter(scene -> results.engines(scene).contains(engine))
                        .toList();
        return Growth.exponent(
                fitted.stream().mapToDouble(BenchScenes::discs).toArray(),
                fitted.stream()
                        .mapToDouble(scene -> results.median(scene, engine, Sample::median))
                        .toArray());
    }

    List<String> sentences() {
        String what =
                "Floods of equal depth and growing width, from the first step until they lie still,"
                        + " in one round. The exponent is that of a step's time as a power of the"
                        + " number of discs, from 1,000 on.";
        if (!engines.contains(RigiBoEngine.NAME)) {
            return List.of(what);
        }
        double ours = exponent(RigiBoEngine.NAME);
        return List.of(
                what,
                String.format(
                        "Our exponent is %s (%s).",
                        Amount.digits(ours), Aims.atMost(Aims.GROWTH, ours)));
    }
}
