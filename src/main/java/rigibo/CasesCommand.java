package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

import rigibo.lab.hardcase.CaseTable;
import rigibo.lab.hardcase.Cases;
import rigibo.lab.hardcase.HardCase;
import rigibo.lab.hardcase.Preset;
import rigibo.lab.hardcase.Sampling;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;

/** Runs the hard cases, and prints how far each is from its limit. */
@Command(
        name = "cases",
        description =
                "Runs the hard cases. Prints a line for each case and preset: the figure nearest to"
                        + " its limit, the limit, the limit divided by the figure, and the work"
                        + " done.")
final class CasesCommand implements Callable<Integer> {

    /** The number of progress messages in a run. */
    private static final int TIMES_TOLD = 20;

    @Option(
            names = "--preset",
            paramLabel = "PRESET",
            split = ",",
            description = "${COMPLETION-CANDIDATES} (default: all).")
    private List<Preset> presets = List.of(Preset.values());

    @Option(
            names = "--only",
            paramLabel = "ROW",
            split = ",",
            description =
                    "Runs only these rows, such as 55 or 20/10, and prints all their figures. Row"
                            + " 59 (an hour of simulated time), M1/…/1500 and M16 run only when"
                            + " they are named here.")
    private List<String> rows = List.of();

    @Option(
            names = "--full",
            description =
                    "Runs every variant of a case; without it, a few of those that have many. Takes"
                            + " hours.")
    private boolean isFull;

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description = "Seed of the variants that are drawn (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(names = "--csv", paramLabel = "FILE", description = "Writes every figure as CSV.")
    private Path csv;

    @Option(
            names = "--markdown",
            paramLabel = "FILE",
            description = "Writes the page, docs/hard-cases.md.")
    private Path page;

    @Spec private CommandSpec spec;

    private int told;

    @Override
    public Integer call() {
        Destination.requireFile(spec, "--csv", csv);
        Destination.requireFile(spec, "--markdown", page);
        Cases cases = choose();
        List<HardCase.Result> results = cases.run(result -> tell(result, cases.count()));
        boolean isWritten = write(results);
        long passed = results.stream().filter(HardCase.Result::passes).count();
        long failed = results.size() - passed;
        PrintWriter out = spec.commandLine().getOut();
        out.println(passed + " passed, " + failed + " failed");
        return isWritten && failed == 0 && passed > 0 ? 0 : 1;
    }

    private Cases choose() {
        try {
            Sampling.Extent extent = isFull ? Sampling.Extent.FULL : Sampling.Extent.SMALL;
            return new Cases(rows, presets, new Sampling(extent, seed));
        } catch (IllegalArgumentException unknown) {
            throw Options.refused(spec, "--only", unknown.getMessage());
        }
    }

    private void tell(HardCase.Result result, int count) {
        PrintWriter out = spec.commandLine().getOut();
        out.println(CaseTable.line(result));
        (rows.isEmpty() ? CaseTable.failures(result) : CaseTable.figures(result))
                .forEach(out::println);
        int before = told * TIMES_TOLD / count;
        told++;
        if (told * TIMES_TOLD / count > before) {
            spec.commandLine().getErr().println(told + " of " + count + " done");
        }
    }

    private boolean write(List<HardCase.Result> results) {
        try {
            if (csv != null) {
                Files.write(csv, CaseTable.csv(results));
            }
            if (page != null) {
                String date = LocalDate.now().toString();
                Files.writeString(page, CaseTable.page(results, options(), Machine.words(), date));
            }
            return true;
        } catch (IOException cause) {
            spec.commandLine().getErr().println("cannot write the table: " + cause);
            return false;
        }
    }

    /** The options as they were typed. */
    private String options() {
        String chosen = rows.isEmpty() ? "" : " --only " + String.join(",", rows);
        boolean isAll = presets.equals(List.of(Preset.values()));
        String names = presets.stream().map(Preset::name).collect(Collectors.joining(","));
        String sample = (isFull ? " --full" : "") + (seed == 1 ? "" : " --seed " + seed);
        return (isAll ? "" : " --preset " + names) + chosen + sample;
    }
}
