package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

import rigibo.fuzz.Fuzz;
import rigibo.fuzz.Fuzz.Only;
import rigibo.fuzz.Order;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;

/** Random programs for the engine and mutated files for the game. */
@Command(
        name = "fuzz",
        description =
                "Gives the engine random programs and the game mutated files. Writes down the first"
                        + " that goes wrong: as Java, or as a file.")
final class FuzzCommand implements Callable<Integer> {

    private static final double MINUTES = 10;
    private static final double SOAK_MINUTES = 60;

    @Option(
            names = "--minutes",
            paramLabel = "M",
            description = "How long it tries (default: 10; 60 for SOAK).")
    private Double minutes;

    @Option(
            names = "--programs",
            paramLabel = "N",
            description = "Tries this many programs, in place of --minutes.")
    private Long programs;

    @Option(
            names = "--files",
            paramLabel = "N",
            description = "Tries this many files, in place of --minutes.")
    private Long files;

    @Option(
            names = "--seed",
            paramLabel = "S",
            defaultValue = "1",
            description = "Seed of programs and files (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(
            names = "--first",
            paramLabel = "I",
            defaultValue = "0",
            description =
                    "Number of the seed's first program and file (default: ${DEFAULT-VALUE}).")
    private long first;

    @Option(
            names = "--failures",
            paramLabel = "N",
            defaultValue = "1",
            description = "Ends after this many failures (default: ${DEFAULT-VALUE}).")
    private long failures;

    @Option(
            names = "--only",
            paramLabel = "PART",
            defaultValue = "BOTH",
            description =
                    "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}). SOAK: one pool in which"
                            + " bodies come and go, and whose memory may not grow.")
    private Only only;

    @Spec private CommandSpec spec;

    @Override
    public Integer call() throws InterruptedException {
        if (minutes != null) {
            Options.requireMinutes(spec, "--minutes", minutes);
        }
        requireCount("--programs", programs);
        requireCount("--files", files);
        Fuzz fuzz = new Fuzz(only, Path.of("build", "fuzz"));
        List<String> wrong = fuzz.run(order().failures(failures), this::tell);
        PrintWriter out = spec.commandLine().getOut();
        wrong.forEach(out::println);
        out.println(fuzz.tally() + ": " + (wrong.isEmpty() ? "nothing found" : "FAILED"));
        return wrong.isEmpty() ? 0 : 1;
    }

    private Order order() {
        return programs == null && files == null
                ? Order.minutes(minutes == null ? usualMinutes() : minutes, seed, first)
                : Order.counted(orNone(programs), orNone(files), seed, first);
    }

    private double usualMinutes() {
        return only == Only.SOAK ? SOAK_MINUTES : MINUTES;
    }

    private static long orNone(Long count) {
        return count == null ? 0 : count;
    }

    private void requireCount(String option, Long count) {
        if (count != null && count < 0) {
            throw Options.refused(spec, option, "must be 0 or more, was " + count);
        }
    }

    private void tell(String words) {
        spec.commandLine().getErr().println(words);
    }
}
