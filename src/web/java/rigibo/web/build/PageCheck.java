package rigibo.web.build;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Plays the page like players: levels by touch, one made in the editor, one made by chance, with a
 * screen reader, without a server and without features that browsers may lack. The page must not
 * write to the console, nor load anything from outside its folder.
 */
final class PageCheck {

    private final Browser browser;
    private final Path folder;
    private final Path pictures;

    /** Plays the page of a folder in Chromium; keeps pictures beside the folder. */
    PageCheck(Browser browser, Path folder) throws IOException {
        this.browser = browser;
        this.folder = folder;
        pictures = Files.createDirectories(folder.resolveSibling("phone"));
    }

    /** The levels of the game, world by world. */
    static List<Level> levels() throws IOException {
        List<Level> levels = new ArrayList<>();
        for (Path file : LevelShelf.files()) {
            levels.add(new LevelLoader().load(file).level().orElseThrow());
        }
        return levels;
    }

    /** The first level of each world. */
    static List<Level> firsts() throws IOException {
        List<Level> firsts = new ArrayList<>();
        int world = 0;
        List<Level> all = levels();
        for (int i = 0; i < all.size(); i++) {
            if (LevelShelf.world(LevelShelf.files().get(i)) > world) {
                firsts.add(all.get(i));
                world++;
            }
        }
        return firsts;
    }

    /** Plays levels and prints the results; returns whether all is well. */
    boolean isSound(List<Level> levels) throws IOException, InterruptedException {
        try (LocalServer server = new LocalServer(folder, 0);
                Browser.Window window = browser.open()) {
            Phone phone = new Phone(window.port(), server.address(""), pictures);
            boolean isPlayed = isPlayed(phone, levels);
            ReaderCheck reader = new ReaderCheck(phone);
            boolean isRead = reader.isVerdictSaid() && reader.isMenuRead();
            boolean isMade = AsideCheck.isMade(phone.page());
            boolean isEdited = new EditorCheck(phone).isLevelMade();
            phone.leave();
            boolean isQuiet = isQuiet(phone.requests(), phone.complaints(), server);
            Phone lacking = new Phone(window.port(), server.address(""), pictures);
            boolean isBorne = new HardshipCheck(lacking, levels.get(0)).isBorne();
            lacking.leave();
            boolean isOffline = OfflineCheck.isPlayed(window, folder, pictures, levels.get(0));
            return isPlayed && isRead && isMade && isEdited && isQuiet && isBorne && isOffline;
        }
    }

    private static boolean isPlayed(Phone phone, List<Level> levels)
            throws IOException, InterruptedException {
        PhoneCheck check = new PhoneCheck(phone);
        int solved = 0;
        for (Level level : levels) {
            solved += check.isSolved(level) ? 1 : 0;
        }
        System.out.printf("%d of %d levels were solved by touch%n", solved, levels.size());
        return solved == levels.size();
    }

    /** Plays levels by clicks in Firefox, if it is installed; returns whether all were solved. */
    boolean isSoundInFirefox(List<Level> levels) throws IOException, InterruptedException {
        Optional<Firefox> firefox = Firefox.find();
        if (firefox.isEmpty()) {
            System.out.println("There is no Firefox here: nothing is played there.");
            return true;
        }
        try (LocalServer server = new LocalServer(folder, 0);
                Browser.Window window = firefox.get().open()) {
            Page page = new Bidi(window.port());
            MouseCheck check = new MouseCheck(page, server.address(""));
            int solved = 0;
            for (Level level : levels) {
                solved += check.isSolved(level) ? 1 : 0;
            }
            Files.write(pictures.resolve("firefox.png"), page.picture());
            page.close();
            System.out.printf(
                    "%d of %d levels were solved by clicks in %s%n",
                    solved, levels.size(), firefox.get());
            return solved == levels.size() && isQuiet(page.requests(), page.complaints(), server);
        }
    }

    /** Prints output to the console and requests outside; returns whether there were none. */
    private static boolean isQuiet(
            List<String> requests, List<String> complaints, LocalServer server) {
        List<String> outside = requests.stream().filter(asked -> !isInside(asked, server)).toList();
        complaints.forEach(System.out::println);
        outside.forEach(asked -> System.out.println("asked for " + asked));
        return outside.isEmpty() && complaints.isEmpty();
    }

    private static boolean isInside(String asked, LocalServer server) {
        return asked.startsWith(server.address("")) || asked.startsWith("about:");
    }
}
