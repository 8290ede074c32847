package rigibo.frontend.editor.file;

import rigibo.frontend.document.Cause;
import rigibo.frontend.document.Document;
import rigibo.frontend.document.FileText;
import rigibo.frontend.document.Problem;
import rigibo.frontend.document.Problems;
import rigibo.frontend.document.Value;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.save.SafeFile;

import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Drafts that were left unsaved, one file each, until their author saves or discards them. */
public final class Unsaved {

    private static final String ENDING = ".unsaved.json";

    private final Path folder;
    private final List<IOException> trouble = new ArrayList<>();

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

    /** The draft that was left last, of those that can be read; damaged ones are set aside. */
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

    private Optional<Left> read(Path kept) {
        Problems problems = new Problems(kept.toString());
        try {
            Optional<Left> left = parse(FileText.bytes(kept), problems, kept);
            if (problems.hasErrors()) {
                putAside(kept, problems.inOrder().get(0));
            }
            return left;
        } catch (IOException locked) {
            trouble.add(locked);
            return Optional.empty();
        }
    }

    /**
     * The draft that a file holds; nothing where it is a newer game's, which will offer it again,
     * and nothing after telling why there is none.
     */
    static Optional<Left> parse(byte[] bytes, Problems problems, Path kept) {
        return FileText.decode(bytes, problems)
                .flatMap(text -> Document.parse(text, problems))
                .filter(document -> !Draft.isNewer(document.node("/level")))
                .flatMap(Unsaved::draft)
                .map(draft -> new Left(draft, kept));
    }

    private static Optional<DraftFile> draft(Document document) {
        Value json = document.value().object();
        json.required("level").object();
        String file = json.optional("file").text("");
        try {
            Optional<Path> own = file.isEmpty() ? Optional.empty() : Optional.of(Path.of(file));
            return document.hasErrors()
                    ? Optional.empty()
                    : Optional.of(new DraftFile(Draft.of(document.node("/level")), own));
        } catch (InvalidPathException foreign) {
            String words = "is no file of this system: " + foreign.getReason();
            document.error(Cause.CONTENT, "/file", () -> words);
            return Optional.empty();
        } catch (IllegalArgumentException foreign) {
            document.error(Cause.CONTENT, "/level", foreign::getMessage);
            return Optional.empty();
        }
    }

    private void putAside(Path damaged, Problem first) {
        try {
            SafeFile.setAside(damaged);
            trouble.add(Unreadable.setAside(first));
        } catch (IOException readOnly) {
            trouble.add(new Unreadable(first));
        }
    }

    /** The problems found while reading. */
    public List<IOException> trouble() {
        return List.copyOf(trouble);
    }

    /**
     * Keeps a draft.
     *
     * @param at where it was kept before, to be replaced; nothing for one that was not
     * @return where it is kept
     * @throws IOException when it cannot be written, or is too large to be read again
     */
    public Path keep(DraftFile draft, Optional<Path> at) throws IOException {
        ObjectNode document = JsonNodeFactory.instance.objectNode();
        draft.file().ifPresent(file -> document.put("file", file.toAbsolutePath().toString()));
        document.set("level", draft.draft().document());
        Path kept = at.isPresent() ? at.get() : free();
        byte[] text = document.toString().getBytes(StandardCharsets.UTF_8);
        Document.requireReadable(text, kept);
        new SafeFile(kept).write(text);
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
