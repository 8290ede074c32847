package rigibo.frontend.save;

import tools.jackson.core.JacksonException;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * What became of reading a file.
 *
 * @param state of the file
 * @param value what it tells, when it is whole
 */
record Reading<T>(State state, Optional<T> value) {

    /** The format this version writes; it reads this and all before. */
    static final int NUMBER = 1;

    private static final JsonMapper JSON =
            JsonMapper.builder().enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS).build();

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
            return parse(Files.readAllBytes(file), format);
        } catch (NoSuchFileException none) {
            return without(State.MISSING);
        } catch (IOException locked) {
            return without(State.UNREADABLE);
        }
    }

    private static <T> Reading<T> parse(byte[] bytes, Format<T> format) {
        try {
            JsonNode json = JSON.readTree(bytes);
            return json.required("format").intValue() > NUMBER
                    ? without(State.NEWER)
                    : new Reading<>(State.WHOLE, Optional.of(format.read(json)));
        } catch (JacksonException | IllegalArgumentException damage) {
            return without(State.DAMAGED);
        }
    }

    private static <T> Reading<T> without(State state) {
        return new Reading<>(state, Optional.empty());
    }

    /** A file's bytes that tell a value, as {@link #of} reads it. */
    static <T> byte[] bytes(T value, Format<T> format) {
        ObjectNode json = JSON.createObjectNode().put("format", NUMBER);
        format.write(value, json);
        return JSON.writerWithDefaultPrettyPrinter().writeValueAsBytes(json);
    }
}
