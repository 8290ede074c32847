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

/** The laboratory, without a window: measures and writes tables and figures. */
@Command(
        name = "lab",
        description =
                "Measures, without a window, and writes tables and figures. Interrupted, it goes"
                        + " on where it was when it is started again.")
final class LabCommand implements Callable<Integer> {

    @Option(
            names = "--figures",
            paramLabel = "FIGURES",
            split = ",",
            description =
                    "${COMPLETION-CANDIDATES}; ACCURACY unless said otherwise. ACCURACY: the error"
                            + " of every setting beside its time, for every reference problem, and"
                            + " of other engines. EFFECTS: that undeclared effects cost nothing,"
                            + " what declared ones cost, and what each scene would save without"
                            + " each of its own; this takes most of an hour.")
    private List<Figures> figures = List.of(Figures.ACCURACY);

    @ArgGroup private Haste haste = new Haste();

    @Option(
            names = "--scenes",
            paramLabel = "SCENE",
            split = ",",
            description =
                    "Which problems (R1 and so on) and scenes are run; all of them unless said"
                            + " otherwise.")
    private List<String> scenes = List.of();

    @Option(
            names = "--runs",
            paramLabel = "N",
            defaultValue = "20",
            description = "Pairs of runs of each comparison of effects, 20 unless said otherwise.")
    private int runs;

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description =
                    "Of the scenes' chance and of the order of runs, 1 unless said otherwise.")
    private long seed;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            defaultValue = "build/lab",
            description = "Where everything is written, build/lab unless said otherwise.")
    private Path out;

    @Option(
            names = "--markdown",
            paramLabel = "FILE",
            description = "Writes the page too, of the one kind of figures that was asked for.")
    private Path page;

    @Spec private CommandSpec spec;

    /** What can be measured. */
    enum Figures {
        ACCURACY,
        EFFECTS
    }

    /** How long it may take. */
    private static final class Haste {
        @Option(
                names = "--quick",
                description =
                        "Presets and other engines only: a minute and a half, and the long"
                                + " problems, which take minutes each. The usual way.")
        private boolean isQuick;

        @Option(
                names = "--full",
                description =
                        "Every knob, carefully, and the hard cases: hours. Of long problems, those"
                                + " of crowds, presets and other engines only, once each.")
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
            written.flush();
            return 0;
        } catch (IllegalStateException | IOException | UncheckedIOException cause) {
            tell("FAILED: " + cause.getMessage());
            return 1;
        }
    }

    private List<String> make(Figures one) throws IOException {
        return switch (one) {
            case ACCURACY ->
                    new PrecisionStudy(inquiry(), environment(), this::tell)
                            .make(Optional.ofNullable(page));
            case EFFECTS ->
                    new EffectsReport(question(), provenance(), this::tell)
                            .make(Optional.ofNullable(page));
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

    /** Those of some names that were asked for: all of them where nothing was said. */
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

    /** What was asked of a report of effects, as it was typed. */
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

    /** It is told at once, not after half an hour of work, that something has nowhere to go. */
    private void requireFiles() {
        Destination.requireDirectory(spec, "--out", out);
        Destination.requireFile(spec, "--markdown", page);
        if (page != null && figures.size() > 1) {
            throw Options.refused(spec, "--markdown", "one page holds one kind of figures");
        }
    }

    private void tell(String words) {
        PrintWriter err = spec.commandLine().getErr();
        err.println(words);
        err.flush();
    }
}
