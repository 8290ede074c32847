package rigibo.frontend.editor.file;

import rigibo.frontend.document.Cause;
import rigibo.frontend.document.Document;
import rigibo.frontend.document.Fault;
import rigibo.frontend.document.Problems;
import rigibo.frontend.document.ShareCode;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.editor.draft.NewLevel;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.save.SafeFile;

import tools.jackson.databind.JsonNode;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.Normalizer;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** The level files of a player. */
public final class DraftFiles {

    private static final String ENDING = ".json";

    /** A level's id has 40 characters at most; this leaves room for a number. */
    private static final int LONGEST = 36;

    private final Optional<Path> folder;

    /**
     * Files that are saved into a folder, unless they have a place of their own.
     *
     * @param folder which need not exist yet; nothing for a player without files
     */
    public DraftFiles(Optional<Path> folder) {
        this.folder = folder;
    }

    /**
     * Opens a file; where there is none, a new level that will be saved there.
     *
     * @throws IOException when it is no level that can be edited, saying why
     */
    public static DraftFile open(Path file) throws IOException {
        if (!Files.exists(file)) {
            return new DraftFile(NewLevel.draft(), Optional.of(file));
        }
        Draft draft = draft(file.toString(), new LevelLoader().load(file));
        return new DraftFile(draft, Optional.of(file));
    }

    private static Draft draft(String name, LoadedLevel loaded) throws IOException {
        if (loaded.document().isEmpty()) {
            throw new Unreadable(loaded.problems().get(0));
        }
        JsonNode document = loaded.document().get();
        try {
            return Draft.of(document);
        } catch (IllegalArgumentException foreign) {
            Cause cause = Draft.isNewer(document) ? Cause.NEWER : Cause.CONTENT;
            throw Unreadable.of(name, cause, Fault.plain(foreign.getMessage()));
        }
    }

    /**
     * The level of a code, which has no file yet.
     *
     * @throws IOException when it is no code of a level that can be edited, saying why
     */
    public static DraftFile ofCode(String code) throws IOException {
        Problems problems = new Problems(ShareCode.NAME);
        Optional<ShareCode> read = ShareCode.read(code, problems);
        if (read.isEmpty()) {
            throw new Unreadable(problems.inOrder().get(0));
        }
        if (read.get().kind() != ShareCode.Kind.LEVEL) {
            Fault replay = Fault.of("replay", "is that of a replay");
            throw Unreadable.of(ShareCode.NAME, Cause.CONTENT, replay);
        }
        Draft draft =
                draft(ShareCode.NAME, new LevelLoader().parse(ShareCode.NAME, read.get().text()));
        return new DraftFile(draft, Optional.empty());
    }

    /** The player's levels by name, then those of the game. */
    public List<Path> all() throws IOException {
        try {
            Stream<Path> own = folder.stream().flatMap(place -> LevelShelf.own(place).stream());
            return Stream.concat(own, LevelShelf.files().stream()).toList();
        } catch (UncheckedIOException unreadable) {
            throw unreadable.getCause();
        }
    }

    /**
     * Saves a draft to its file. A draft without a file, or with that of a level of the game, gets
     * a new file and a new id.
     *
     * @throws IOException when it cannot be written, or is too large to be read again; the file is
     *     then unchanged
     */
    public DraftFile save(DraftFile from) throws IOException {
        DraftFile into = hasOwn(from) ? identified(from) : named(from.draft());
        byte[] text = into.draft().toString().getBytes(StandardCharsets.UTF_8);
        Path file = into.file().orElseThrow();
        Document.requireReadable(text, file);
        new SafeFile(file).write(text);
        return into;
    }

    private static boolean hasOwn(DraftFile from) throws IOException {
        return from.file().isPresent() && !isOfTheGame(from.file().get());
    }

    /** Whether a file is a level of the game itself. */
    public static boolean isOfTheGame(Path file) throws IOException {
        for (Path level : LevelShelf.files()) {
            boolean isSame =
                    file.getFileSystem().equals(level.getFileSystem())
                            && Files.exists(file)
                            && Files.isSameFile(level, file);
            if (isSame) {
                return true;
            }
        }
        return false;
    }

    /** Progress is kept by ids: two new levels must not share one. */
    private static DraftFile identified(DraftFile from) {
        boolean isNew = from.draft().at("/id").asString(NewLevel.ID).equals(NewLevel.ID);
        String name = from.file().orElseThrow().getFileName().toString();
        return isNew ? from.called(word(name.replaceFirst("\\.[^.]*$", ""))) : from;
    }

    private DraftFile named(Draft draft) throws IOException {
        Path shelf = folder.orElseThrow(() -> new IOException("this player keeps no files"));
        String word = word(draft);
        String id = word;
        int number = 2;
        while (isTaken(shelf, id)) {
            id = word + "-" + number++;
        }
        return new DraftFile(draft, Optional.of(shelf.resolve(id + ENDING))).called(id);
    }

    /** A file name for a draft, as long as no other file has it. */
    public static String nameOf(Draft draft) {
        return word(draft) + ENDING;
    }

    private static String word(Draft draft) {
        return word(draft.at("/title/en").asString(NewLevel.ID));
    }

    private static boolean isTaken(Path shelf, String id) {
        return Files.exists(shelf.resolve(id + ENDING))
                || LevelShelf.files().stream()
                        .anyMatch(
                                level ->
                                        level.getFileName().toString().endsWith("-" + id + ENDING));
    }

    /** A title as an id: small letters and digits, with hyphens between them. */
    static String word(String title) {
        String plain = Normalizer.normalize(title.replace("ß", "ss"), Normalizer.Form.NFD);
        String word =
                plain.replaceAll("\\p{M}", "")
                        .toLowerCase(Locale.ROOT)
                        .replaceAll("[^a-z0-9]+", "-")
                        .replaceAll("^-|-$", "");
        String fitting = word.length() > LONGEST ? word.substring(0, LONGEST) : word;
        String id = fitting.replaceAll("-$", "");
        return id.isEmpty() ? NewLevel.ID : id;
    }
}
