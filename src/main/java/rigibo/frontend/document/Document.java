package rigibo.frontend.document;

import tools.jackson.databind.JsonNode;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;

/**
 * A JSON document and its problems. The place of a value is searched in the text only when a
 * problem is reported there; to store it for every value took a thousand times the size of the
 * file.
 */
public final class Document {

    private final String text;
    private final JsonNode root;
    private final Problems problems;

    private Document(String text, JsonNode root, Problems problems) {
        this.text = text;
        this.root = root;
        this.problems = problems;
    }

    /**
     * Reads the document in a file; returns nothing, after reporting the problem, if there is none.
     */
    public static Optional<Document> read(Path file, Problems problems) {
        return FileText.read(file, problems).flatMap(text -> parse(text, problems));
    }

    /**
     * Refuses text that could not be read again from the file it is meant for.
     *
     * @throws IOException saying what of it is too much
     */
    public static void requireReadable(byte[] text, Path file) throws IOException {
        Problems problems = new Problems(file.toString());
        if (FileText.decode(text, problems).flatMap(one -> parse(one, problems)).isEmpty()) {
            throw new IOException("could not be read again: " + problems.inOrder().get(0));
        }
    }

    /**
     * Reads the document of a text; returns nothing, after reporting the problem, if the text is no
     * JSON.
     */
    public static Optional<Document> parse(String text, Problems problems) {
        return JsonParsing.parse(text, problems).map(root -> new Document(text, root, problems));
    }

    /** The outermost value. */
    public JsonNode root() {
        return root;
    }

    /** The outermost value, for reading it as an expected type. */
    public Value value() {
        return new Value(this);
    }

    /** The value at a pointer, or a missing node if there is none. */
    public JsonNode node(String pointer) {
        return root.at(pointer);
    }

    /**
     * Position at which a value begins; if there is no such value, that of the nearest one around
     * it.
     */
    public Place at(String pointer) {
        return PlaceSearch.of(text, pointer).value();
    }

    /** Reports an error at a pointer; the fault is made only if it is reported. */
    public void error(String pointer, Supplier<Fault> fault) {
        tell(Problem.Severity.ERROR, Cause.CONTENT, () -> pointer, fault);
    }

    /** Reports an error whose cause is more than the value at a pointer. */
    public void error(Cause cause, String pointer, Supplier<String> message) {
        tell(Problem.Severity.ERROR, cause, () -> pointer, () -> Fault.plain(message.get()));
    }

    /** Reports a warning at a pointer. */
    public void warning(String pointer, Supplier<Fault> fault) {
        tell(Problem.Severity.WARNING, Cause.CONTENT, () -> pointer, fault);
    }

    /** Reports an error of what the document contains. */
    void error(Supplier<String> pointer, Supplier<Fault> fault) {
        tell(Problem.Severity.ERROR, Cause.CONTENT, pointer, fault);
    }

    private void tell(
            Problem.Severity severity,
            Cause cause,
            Supplier<String> pointer,
            Supplier<Fault> fault) {
        if (problems.isFull()) {
            problems.count(severity);
        } else {
            String at = pointer.get();
            problems.tell(severity, cause, at(at), at, fault.get());
        }
    }

    /** Whether an error was reported, so that the file cannot be used. */
    public boolean hasErrors() {
        return problems.hasErrors();
    }

    /** The pointers of the problems reported so far. */
    Set<String> faults() {
        return problems.pointers();
    }

    /**
     * Whether there were more problems than are reported, so that {@link #isSpoilt} does not know
     * all of them.
     */
    public boolean hasUntold() {
        return problems.hasUntold();
    }

    /** Whether an error was reported at this pointer or below it. */
    public boolean isSpoilt(String pointer) {
        return problems.spoil(pointer);
    }
}
