package rigibo.web.game;

import org.teavm.jso.JSBody;
import org.teavm.jso.browser.Storage;
import org.teavm.jso.browser.Window;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Stores the files of a folder in memory in the browser's storage, each under its path, in the
 * formats of the desktop.
 */
final class Keeping {

    /** Time from one look at the files to the next, ms. */
    private static final int PERIOD = 500;

    private final Path folder;
    private final Runnable refused;
    private final Map<Path, FileTime> kept = new HashMap<>();
    private boolean isRefused;

    /**
     * Reads the stored files.
     *
     * @param refused called once if the browser refuses to store more
     */
    Keeping(Path folder, Runnable refused) throws IOException {
        this.folder = folder;
        this.refused = refused;
        Files.createDirectories(folder);
        if (isAllowed()) {
            Storage storage = Storage.getLocalStorage();
            for (int i = 0; i < storage.getLength(); i++) {
                String name = storage.key(i);
                if (name.startsWith(folder + "/")) {
                    Path file = Path.of(name);
                    Files.createDirectories(file.getParent());
                    Files.writeString(file, storage.getItem(name));
                    kept.put(file, Files.getLastModifiedTime(file));
                }
            }
        }
    }

    /** Starts looking for changes. */
    void begin() {
        Window.setInterval(this::keep, PERIOD);
        Window.current().addEventListener("pagehide", event -> keep());
    }

    private void keep() {
        try {
            Set<Path> present = new HashSet<>();
            keep(folder, present);
            for (Path gone : List.copyOf(kept.keySet())) {
                if (!present.contains(gone)) {
                    remove(gone.toString());
                    kept.remove(gone);
                }
            }
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }

    private void keep(Path place, Set<Path> present) throws IOException {
        for (Path file : list(place)) {
            if (Files.isDirectory(file)) {
                keep(file, present);
            } else {
                present.add(file);
                FileTime changed = Files.getLastModifiedTime(file);
                if (!changed.equals(kept.put(file, changed))
                        && !set(file.toString(), Files.readString(file))) {
                    // There may be room later.
                    kept.remove(file);
                    refuse();
                }
            }
        }
    }

    private void refuse() {
        if (!isRefused) {
            isRefused = true;
            refused.run();
        }
    }

    private static List<Path> list(Path place) throws IOException {
        try (Stream<Path> files = Files.list(place)) {
            return files.toList();
        }
    }

    @JSBody(
            script =
                    "try { window.localStorage.length; return true; } catch (denied) { return"
                            + " false; }")
    private static native boolean isAllowed();

    /** Removes an entry; a browser without storage has none. */
    @JSBody(
            params = "name",
            script = "try { window.localStorage.removeItem(name); } catch (denied) {}")
    private static native void remove(String name);

    @JSBody(
            params = {"name", "text"},
            script =
                    "try { window.localStorage.setItem(name, text); return true; }"
                            + " catch (full) { return false; }")
    private static native boolean set(String name, String text);
}
