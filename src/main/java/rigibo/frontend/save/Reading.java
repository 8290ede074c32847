package rigibo.frontend.save;

import rigibo.frontend.document.Document;
import rigibo.frontend.document.FileText;
import rigibo.frontend.document.FormatRule;
import rigibo.frontend.document.Problem;
import rigibo.frontend.document.Problems;
import rigibo.frontend.document.Value;

import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

import java.io.IOException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * The result of reading a file.
 *
 * @param state of the file
 * @param value its content, if it is whole
 * @param problems the reasons why it is damaged or newer
 */
record Reading<T>(State state, Optional<T> value, List<Problem> problems) {

    /** The format this version writes; it reads this and all before. */
    static final int NUMBER = 1;

    private static final JsonMapper JSON = JsonMapper.shared();

    enum State {
        WHOLE,
        MISSING,
        /** Not what any game has written. */
        DAMAGED,
        /** Written by a newer game. */
        NEWER,
        /** There is something that cannot be read, now or by this player. */
        UNREADABLE
    }

    /** Reads a file, whatever is in it. */
    static <T> Reading<T> of(Path file, Format<T> format) {
        try {
            return parse(file.toString(), FileText.bytes(file), format);
        } catch (NoSuchFileException none) {
            return without(State.MISSING, List.of());
        } catch (IOException locked) {
            return without(State.UNREADABLE, List.of());
        }
    }

    /**
     * Reads what a file holds, whatever that is.
     *
     * @param name what messages call it
     */
    static <T> Reading<T> parse(String name, byte[] bytes, Format<T> format) {
        Problems problems = new Problems(name);
        Optional<Document> document =
                FileText.decode(bytes, problems).flatMap(text -> Document.parse(text, problems));
        if (document.filter(json -> FormatRule.isNewer(json, NUMBER)).isPresent()) {
            return without(State.NEWER, problems.inOrder());
        }
        Optional<T> value = document.map(json -> value(json.value(), format));
        return problems.hasErrors()
                ? without(State.DAMAGED, problems.inOrder())
                : new Reading<>(State.WHOLE, value, List.of());
    }

    private static <T> T value(Value json, Format<T> format) {
        json.object().required("format").whole(1, NUMBER, NUMBER);
        return format.read(json);
    }

    private static <T> Reading<T> without(State state, List<Problem> problems) {
        return new Reading<>(state, Optional.empty(), problems);
    }

    /** A file's bytes that tell a value, as {@link #of} reads it. */
    static <T> byte[] bytes(T value, Format<T> format) {
        ObjectNode json = JSON.createObjectNode().put("format", NUMBER);
        format.write(value, json);
        return JSON.writerWithDefaultPrettyPrinter().writeValueAsBytes(json);
    }
}
