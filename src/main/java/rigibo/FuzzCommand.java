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
                "Gives the engine random programs and the game mutated files, and names the first"
                        + " that goes wrong: as Java, or as a file.")
final class FuzzCommand implements Callable<Integer> {

    private static final double MOST_MINUTES = 24 * 60;
    private static final double MINUTES = 10;
    private static final double SOAK_MINUTES = 60;

    @Option(
            names = "--minutes",
            paramLabel = "M",
            description = "How long it tries, 10 unless said otherwise, a soak 60.")
    private Double minutes;

    @Option(
            names = "--soak",
            description =
                    "One pool for hours of its own time: bodies come and go, and nothing may grow.")
    private boolean isSoak;

    @Option(
            names = "--programs",
            paramLabel = "N",
            description = "How many programs are tried, in place of the minutes.")
    private Long programs;

    @Option(
            names = "--files",
            paramLabel = "N",
            description = "How many files are tried, in place of the minutes.")
    private Long files;

    @Option(
            names = "--seed",
            paramLabel = "S",
            defaultValue = "1",
            description = "The same seed tries the same, 1 unless said otherwise.")
    private long seed;

    @Option(
            names = "--first",
            paramLabel = "I",
            defaultValue = "0",
            description = "The first of the seed's programs and files that is tried.")
    private long first;

    @Option(
            names = "--failures",
            paramLabel = "N",
            defaultValue = "1",
            description = "After how many failures it ends, 1 unless said otherwise.")
    private long failures;

    @Option(
            names = "--only",
            paramLabel = "PART",
            defaultValue = "BOTH",
            description = "engine, files or soak; engine and files unless said otherwise.")
    private Only only;

    @Spec private CommandSpec spec;

    @Override
    public Integer call() throws InterruptedException {
        if (minutes != null && !(minutes > 0 && minutes <= MOST_MINUTES)) {
            String range = "must be more than 0 and at most " + (int) MOST_MINUTES;
            throw Options.refused(spec, "--minutes", range + ", was " + minutes);
        }
        requireCount("--programs", programs);
        requireCount("--files", files);
        Fuzz fuzz = new Fuzz(isSoak ? Only.SOAK : only, Path.of("build", "fuzz"));
        List<String> wrong = fuzz.run(order().failures(failures), this::tell);
        PrintWriter out = spec.commandLine().getOut();
        wrong.forEach(out::println);
        out.println(fuzz.tally() + ": " + (wrong.isEmpty() ? "nothing found" : "FAILED"));
        out.flush();
        return wrong.isEmpty() ? 0 : 1;
    }

    private Order order() {
        return programs == null && files == null
                ? Order.minutes(minutes == null ? usualMinutes() : minutes, seed, first)
                : Order.counted(orNone(programs), orNone(files), seed, first);
    }

    private double usualMinutes() {
        return isSoak ? SOAK_MINUTES : MINUTES;
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
        PrintWriter err = spec.commandLine().getErr();
        err.println(words);
        err.flush();
    }
}
