package rigibo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

import rigibo.frontend.catalog.Catalog;
import rigibo.lab.ablation.EffectsReport;
import rigibo.lab.ablation.Provenance;
import rigibo.lab.ablation.Question;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
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
                    "${COMPLETION-CANDIDATES}; all of them unless said otherwise. EFFECTS: that"
                            + " undeclared effects cost nothing, what declared ones cost, and what"
                            + " each scene would save without each of its own.")
    private List<Figures> figures = List.of(Figures.values());

    @Option(
            names = "--scenes",
            paramLabel = "SCENE",
            split = ",",
            description = "Which scenes are run; all of them unless said otherwise.")
    private List<String> scenes = Question.sceneNames();

    @Option(
            names = "--runs",
            paramLabel = "N",
            defaultValue = "20",
            description = "Pairs of runs of each comparison, 20 unless said otherwise.")
    private int runs;

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description = "Of the scenes' chance, 1 unless said otherwise.")
    private long seed;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            defaultValue = "build/lab",
            description = "Where everything is written, build/lab unless said otherwise.")
    private Path out;

    @Option(names = "--markdown", paramLabel = "FILE", description = "Writes the page.")
    private Path page;

    @Spec private CommandSpec spec;

    /** What can be measured. */
    enum Figures {
        EFFECTS
    }

    @Override
    public Integer call() {
        requireDirectories();
        EffectsReport report = new EffectsReport(question(), provenance(), this::tell);
        PrintWriter written = spec.commandLine().getOut();
        try {
            report.make(Optional.ofNullable(page)).forEach(written::println);
            written.println("written to " + out.toAbsolutePath().normalize());
            written.flush();
            return 0;
        } catch (IllegalStateException | IOException | UncheckedIOException cause) {
            tell("FAILED: " + cause.getMessage());
            return 1;
        }
    }

    private Question question() {
        try {
            return new Question(scenes, runs, seed, out);
        } catch (IllegalArgumentException refusal) {
            throw new ParameterException(
                    spec.commandLine(), "Invalid value for --" + refusal.getMessage());
        }
    }

    private Provenance provenance() {
        return new Provenance(
                Machine.words(), LocalDate.now().toString(), options(), Catalog.demoEffects());
    }

    /** What was asked of this run, as it was typed. */
    private String options() {
        boolean isAll = scenes.equals(Question.sceneNames());
        return (isAll ? "" : " --scenes " + String.join(",", scenes))
                + (" --runs " + runs)
                + (" --seed " + seed)
                + (page == null ? "" : " --markdown FILE");
    }

    /** It is told at once, not after half an hour of work, that something has nowhere to go. */
    private void requireDirectories() {
        if (Files.exists(out) && !Files.isDirectory(out)) {
            throw refused("--out", out + " is not a directory");
        }
        if (page != null) {
            Path directory = page.toAbsolutePath().getParent();
            if (directory == null || !Files.isDirectory(directory) || Files.isDirectory(page)) {
                throw refused("--markdown", "cannot write a file at " + page);
            }
        }
    }

    private ParameterException refused(String option, String why) {
        return new ParameterException(
                spec.commandLine(), "Invalid value for '" + option + "': " + why);
    }

    private void tell(String words) {
        PrintWriter err = spec.commandLine().getErr();
        err.println(words);
        err.flush();
    }
}
