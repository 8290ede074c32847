package rigibo.frontend.editor.file;

import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.save.SafeFile;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Drafts that were left without being saved, a file each, until their author saves them or says
 * that they are not wanted.
 */
public final class Unsaved {

    private static final String ENDING = ".unsaved.json";

    private final Path folder;

    /**
     * A draft that was left.
     *
     * @param left the draft, and the file it belongs to
     * @param kept where it is kept
     */
    public record Left(DraftFile left, Path kept) {}

    /** Drafts that are kept in a folder, which need not exist yet. */
    public Unsaved(Path folder) {
        this.folder = folder;
    }

    /** The draft that was left last, of those that can be read. */
    public Optional<Left> last() throws IOException {
        for (Path kept : all()) {
            Optional<Left> left = read(kept);
            if (left.isPresent()) {
                return left;
            }
        }
        return Optional.empty();
    }

    private List<Path> all() throws IOException {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.toString().endsWith(ENDING))
                    .sorted(Comparator.comparing(Unsaved::number).reversed())
                    .toList();
        }
    }

    private static int number(Path kept) {
        String digits = kept.getFileName().toString().replaceFirst("\\D.*", "");
        return digits.isEmpty() || digits.length() > 9 ? 0 : Integer.parseInt(digits);
    }

    private static Optional<Left> read(Path kept) {
        JsonNode document =
                new LevelLoader().load(kept).document().orElse(JsonNodeFactory.instance.nullNode());
        if (!document.path("level").isObject()) {
            return Optional.empty();
        }
        String file = document.path("file").asString("");
        Optional<Path> own = file.isEmpty() ? Optional.empty() : Optional.of(Path.of(file));
        try {
            return Optional.of(
                    new Left(new DraftFile(Draft.of(document.path("level")), own), kept));
        } catch (IllegalArgumentException foreign) {
            // Of a newer game, which will offer it again.
            return Optional.empty();
        }
    }

    /**
     * Keeps a draft.
     *
     * @param at where it was kept before, to be replaced; nothing for one that was not
     * @return where it is kept
     */
    public Path keep(DraftFile draft, Optional<Path> at) throws IOException {
        ObjectNode document = JsonNodeFactory.instance.objectNode();
        draft.file().ifPresent(file -> document.put("file", file.toAbsolutePath().toString()));
        document.set("level", draft.draft().document());
        Path kept = at.isPresent() ? at.get() : free();
        new SafeFile(kept).write(document.toString().getBytes(StandardCharsets.UTF_8));
        return kept;
    }

    private Path free() throws IOException {
        int number = all().stream().mapToInt(Unsaved::number).max().orElse(0) + 1;
        return folder.resolve(number + ENDING);
    }

    /** A draft that need not be kept any more. */
    public void forget(Path kept) throws IOException {
        Files.deleteIfExists(kept);
    }
}
