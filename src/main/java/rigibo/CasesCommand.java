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

/** Runs the hard cases, without a window, and says how far each is from its limit. */
@Command(
        name = "cases",
        description =
                "Runs the hard cases, without a window: a line for each case and preset with the"
                        + " figure that comes nearest to its limit, the limit, how many times the"
                        + " figure fits into it, and the work that was done.")
final class CasesCommand implements Callable<Integer> {

    /** Progress is told this many times in all. */
    private static final int TIMES_TOLD = 20;

    @Option(
            names = "--preset",
            paramLabel = "PRESET",
            split = ",",
            description = "${COMPLETION-CANDIDATES}; all of them unless said otherwise.")
    private List<Preset> presets = List.of(Preset.values());

    @Option(
            names = "--only",
            paramLabel = "ROW",
            split = ",",
            description =
                    "Rows of the list, such as 55 or 20/10, with all their figures. Row 59, an hour"
                        + " of simulated time, and the largest crowds of M1 and M16 run only when"
                        + " they are named here.")
    private List<String> rows = List.of();

    @Option(
            names = "--full",
            description =
                    "Every variant of the cases that have many: a few of each are tried unless it"
                            + " is said. Takes hours.")
    private boolean isFull;

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description = "Draws the variants of such cases, 1 unless said otherwise.")
    private long seed;

    @Option(names = "--csv", paramLabel = "FILE", description = "Writes every figure as CSV.")
    private Path csv;

    @Option(names = "--markdown", paramLabel = "FILE", description = "Writes the page.")
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
        out.flush();
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
        out.flush();
        int before = told * TIMES_TOLD / count;
        told++;
        if (told * TIMES_TOLD / count > before) {
            PrintWriter err = spec.commandLine().getErr();
            err.println(told + " of " + count + " done");
            err.flush();
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

    /** What was asked of this run, as it was typed. */
    private String options() {
        String chosen = rows.isEmpty() ? "" : " --only " + String.join(",", rows);
        boolean isAll = presets.equals(List.of(Preset.values()));
        String names = presets.stream().map(Preset::name).collect(Collectors.joining(","));
        String sample = (isFull ? " --full" : "") + (seed == 1 ? "" : " --seed " + seed);
        return (isAll ? "" : " --preset " + names) + chosen + sample;
    }
}
