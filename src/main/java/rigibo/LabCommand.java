package rigibo;

import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

import rigibo.frontend.catalog.Catalog;
import rigibo.lab.ablation.EffectsReport;
import rigibo.lab.ablation.Provenance;
import rigibo.lab.ablation.Question;
import rigibo.lab.engine.Engines;
import rigibo.lab.precision.Environment;
import rigibo.lab.precision.Extent;
import rigibo.lab.precision.Inquiry;
import rigibo.lab.precision.PrecisionStudy;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;

/** Measures accuracy or the cost of effects, and writes tables and figures. */
@Command(
        name = "lab",
        description =
                "Measures accuracy or the cost of effects, and writes tables and figures. An"
                        + " interrupted command continues where it stopped.")
final class LabCommand implements Callable<Integer> {

    @Option(
            names = "--figures",
            paramLabel = "FIGURES",
            split = ",",
            description =
                    "ACCURACY: error and time of every setting and of other engines, for every"
                            + " reference problem. EFFECTS: the cost of effects, declared and"
                            + " undeclared; takes most of an hour (default: ACCURACY).")
    private List<Figures> figures = List.of(Figures.ACCURACY);

    @ArgGroup private Haste haste = new Haste();

    @Option(
            names = "--scenes",
            paramLabel = "SCENE",
            split = ",",
            description = "Problems (R1, R2, ...), or scenes of effects (default: all).")
    private List<String> scenes = List.of();

    @Option(
            names = "--runs",
            paramLabel = "N",
            defaultValue = "20",
            description =
                    "Pairs of runs in each comparison of effects (default: ${DEFAULT-VALUE}).")
    private int runs;

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description =
                    "Seed of random scenes and of the order of runs (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            defaultValue = "build/lab",
            description = "Where everything is written (default: ${DEFAULT-VALUE}).")
    private Path out;

    @Option(
            names = "--markdown",
            paramLabel = "FILE",
            description = "Also writes the page: docs/accuracy.md or docs/effects.md.")
    private Path page;

    @Spec private CommandSpec spec;

    /** What can be measured. */
    enum Figures {
        ACCURACY,
        EFFECTS
    }

    /** How much is measured. */
    private static final class Haste {
        @Option(
                names = "--quick",
                description =
                        "Presets and other engines only: a minute and a half, and some minutes for"
                                + " each of the long problems (default).")
        private boolean isQuick;

        @Option(names = "--full", description = "Sweeps every knob and runs the hard cases: hours.")
        private boolean isFull;
    }

    @Override
    public Integer call() {
        requireScenes();
        requireFiles();
        PrintWriter written = spec.commandLine().getOut();
        try {
            Files.createDirectories(out);
            Engines.missing().forEach(this::tell);
            for (Figures one : figures) {
                make(one).forEach(written::println);
            }
            written.println("written to " + out.toAbsolutePath().normalize());
            return 0;
        } catch (IllegalStateException | IOException | UncheckedIOException cause) {
            tell("FAILED: " + cause.getMessage());
            return 1;
        }
    }

    private List<String> make(Figures one) throws IOException {
        return switch (one) {
            case ACCURACY ->
                    PrecisionStudy.make(
                            inquiry(), environment(), Optional.ofNullable(page), this::tell);
            case EFFECTS ->
                    EffectsReport.make(
                            question(), provenance(), Optional.ofNullable(page), this::tell);
        };
    }

    private Inquiry inquiry() {
        Extent extent = haste.isFull ? Extent.FULL : Extent.QUICK;
        return new Inquiry(asked(Inquiry.problemIds()), extent, seed, out);
    }

    private Question question() {
        try {
            return new Question(asked(Question.sceneNames()), runs, seed, out);
        } catch (IllegalArgumentException refusal) {
            throw new ParameterException(
                    spec.commandLine(), "Invalid value for --" + refusal.getMessage());
        }
    }

    /** The names that were asked for, or all of them. */
    private List<String> asked(List<String> names) {
        return scenes.isEmpty() ? names : names.stream().filter(scenes::contains).toList();
    }

    private Environment environment() {
        return new Environment(
                Machine.words(), Machine.jvm(), "", Machine.commit(), today(), command());
    }

    private Provenance provenance() {
        return new Provenance(Machine.words(), today(), options(), Catalog.demoEffects());
    }

    private static String today() {
        return LocalDate.now().toString();
    }

    private String command() {
        return "./rigibo lab"
                + (haste.isFull ? " --full" : " --quick")
                + (scenes.isEmpty() ? "" : " --scenes " + String.join(",", scenes));
    }

    /** The options of a report of effects, as they were typed. */
    private String options() {
        return (scenes.isEmpty() ? "" : " --scenes " + String.join(",", scenes))
                + (" --runs " + runs)
                + (" --seed " + seed)
                + (page == null ? "" : " --markdown FILE");
    }

    private void requireScenes() {
        List<String> known = new ArrayList<>();
        for (Figures one : figures) {
            known.addAll(one == Figures.EFFECTS ? Question.sceneNames() : Inquiry.problemIds());
        }
        Options.requireKnown(spec, "--scenes", scenes, known);
    }

    /** Refuses what cannot be written before half an hour of work, not after it. */
    private void requireFiles() {
        Destination.requireDirectory(spec, "--out", out);
        Destination.requireFile(spec, "--markdown", page);
        if (page != null && figures.size() > 1) {
            throw Options.refused(spec, "--markdown", "one page holds one kind of figures");
        }
    }

    private void tell(String words) {
        spec.commandLine().getErr().println(words);
    }
}
