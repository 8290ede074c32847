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

    /** The level; nothing when the file has an error. */
    public Optional<Level> level() {
        return level;
    }

    /** The file as it stands, also with errors, to be read only; nothing when it is no JSON. */
    public Optional<JsonNode> document() {
        return document.map(Document::root);
    }

    /** The problems in the order of the file; after the first hundred, how many there are more. */
    public List<Problem> problems() {
        return problems.inOrder();
    }

    /** How many errors there are, also those that are not told. */
    public int errors() {
        return problems.errors();
    }

    public boolean hasErrors() {
        return problems.hasErrors();
    }

    /**
     * Adds an error that only playing the level can show; to be told of a level that was read.
     *
     * @param pointer JSON pointer of the value at fault
     */
    public void error(String pointer, Fault fault) {
        document.ifPresent(at -> at.error(pointer, () -> fault));
    }
}
