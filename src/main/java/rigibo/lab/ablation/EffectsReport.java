package rigibo.lab.ablation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/** Measures what declared and undeclared effects cost and writes figures, a table and a page. */
public final class EffectsReport {

    private final Question question;
    private final Provenance provenance;
    private final Consumer<String> tell;

    /**
     * A report.
     *
     * @param tell is told how far the runs are
     */
    public EffectsReport(Question question, Provenance provenance, Consumer<String> tell) {
        this.question = question;
        this.provenance = provenance;
        this.tell = tell;
    }

    /**
     * Makes the runs that are missing and writes {@code effects.csv} and {@code effects.svg} into
     * the question's directory, and the page.
     *
     * @param page where it is written, if it is
     * @return the main sentences of what was found, a line each
     * @throws IllegalStateException when a run breaks off or a listed class does not exist
     * @throws IOException when something cannot be written
     */
    public List<String> make(Optional<Path> page) throws IOException {
        AblationLab lab = new AblationLab(question);
        lab.run(tell);
        Findings findings = lab.findings();
        Files.write(question.out().resolve("effects.csv"), FindingsCsv.lines(findings));
        Files.writeString(
                question.out().resolve("effects.svg"), new EffectsFigure(findings).text());
        List<String> sentences = new ArrayList<>(Sentences.of(findings));
        if (page.isPresent()) {
            Page words = new Page(findings, provenance, lab.method());
            Files.writeString(page.get(), words.text());
        }
        return sentences;
    }
}
