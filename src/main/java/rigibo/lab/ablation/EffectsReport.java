package rigibo.lab.ablation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** Measures what declared and undeclared effects cost and writes a table and a page. */
public final class EffectsReport {

    private EffectsReport() {}

    /**
     * Makes the runs that are missing, and writes {@code effects.csv} and the page {@code
     * effects.md} into the question's directory.
     *
     * @param page where the page is written as well
     * @param tell is told how far the runs are
     * @return the main sentences of what was found, a line each
     * @throws IllegalStateException when a run breaks off or a listed class does not exist
     * @throws IOException when something cannot be written
     */
    public static List<String> make(
            Question question, Provenance provenance, Optional<Path> page, Consumer<String> tell)
            throws IOException {
        AblationLab lab = new AblationLab(question);
        lab.run(tell);
        Findings findings = lab.findings();
        Files.write(question.out().resolve("effects.csv"), FindingsCsv.lines(findings));
        String text = new Page(findings, provenance, lab.method()).text();
        Files.writeString(question.out().resolve("effects.md"), text);
        if (page.isPresent()) {
            Files.writeString(page.get(), text);
        }
        return Sentences.of(findings);
    }
}
