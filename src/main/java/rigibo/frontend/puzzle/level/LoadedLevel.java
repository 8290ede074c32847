package rigibo.frontend.puzzle.level;

import rigibo.frontend.document.Document;
import rigibo.frontend.document.Fault;
import rigibo.frontend.document.Problem;
import rigibo.frontend.document.Problems;

import tools.jackson.databind.JsonNode;

import java.util.List;
import java.util.Optional;

/**
 * The result of loading a level file: its problems, and the level unless an error prevents play.
 */
public final class LoadedLevel {

    private final Optional<Level> level;
    private final Optional<Document> document;
    private final Problems problems;

    LoadedLevel(Optional<Level> level, Optional<Document> document, Problems problems) {
        this.level = level;
        this.document = document;
        this.problems = problems;
    }

    /** The level; empty if the file has an error. */
    public Optional<Level> level() {
        return level;
    }

    /** The document of the file, also with errors, read only; empty if it is not JSON. */
    public Optional<JsonNode> document() {
        return document.map(Document::root);
    }

    /** The problems in the order of the file; after the first hundred, the number of the rest. */
    public List<Problem> problems() {
        return problems.inOrder();
    }

    /** The number of errors, including those that are not listed. */
    public int errors() {
        return problems.errors();
    }

    public boolean hasErrors() {
        return problems.hasErrors();
    }

    /**
     * Adds an error that only playing the level shows, for a level that was read.
     *
     * @param pointer JSON pointer of the faulty value
     */
    public void error(String pointer, Fault fault) {
        document.ifPresent(at -> at.error(pointer, () -> fault));
    }
}
