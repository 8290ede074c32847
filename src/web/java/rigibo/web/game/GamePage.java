package rigibo.web.game;

import org.teavm.jso.JSBody;
import org.teavm.jso.browser.Window;

import rigibo.frontend.demo.Demos;
import rigibo.frontend.display.PageDisplay;
import rigibo.frontend.gallery.Gallery;
import rigibo.frontend.laboratory.Laboratory;
import rigibo.frontend.menu.LevelsScene;
import rigibo.frontend.menu.MenuScene;
import rigibo.frontend.puzzle.Levels;
import rigibo.frontend.puzzle.PlayerFiles;
import rigibo.frontend.save.Places;
import rigibo.frontend.save.SavedPlayer;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/** Starts the game in a page. */
public final class GamePage {

    /** Where the game finds its files, as it finds them on a disk. */
    private static final Path HOME = Path.of("/game");

    private static final Path PLAYER = Path.of("/player");

    private GamePage() {}

    public static void main(String[] arguments) throws IOException {
        System.setProperty("rigibo.home", HOME.toString());
        Brought.unpackTo(HOME);
        List<PageDisplay> display = new ArrayList<>();
        Keeping keeping = new Keeping(PLAYER, () -> display.forEach(PageDisplay::notKept));
        SavedPlayer player = new SavedPlayer(Places.in(PLAYER), language());
        display.add(new PageDisplay(GamePage::menu, GamePage::levels, player));
        display.get(0).opensCodesBy(PlayerFiles::pasted);
        display.get(0).run(asked());
        keeping.begin();
    }

    /** What there is in the page; the editor is not in it yet. */
    private static List<SceneEntry> entries() {
        List<SceneEntry> entries = new ArrayList<>(Levels.entries());
        entries.addAll(Demos.entries());
        entries.add(Gallery.entry());
        entries.add(Laboratory.entry());
        return entries;
    }

    /** The scene that the page's link names, such as {@code #flood}. */
    private static Optional<Function<Director, Scene>> asked() {
        String name = Window.current().getLocation().getHash().replace("#", "");
        return Stream.concat(entries().stream(), Gallery.exhibits().stream())
                .filter(entry -> entry.name().equals(name))
                .findFirst()
                .map(SceneEntry::open);
    }

    private static Scene menu(Director director) {
        return new MenuScene(director, entries());
    }

    /** Levels that are made by chance take seconds to make, in which a page would stand still. */
    private static Scene levels(Director director) {
        return new LevelsScene(director, entries(), List.of());
    }

    @JSBody(script = "return navigator.language.substring(0, 2);")
    private static native String language();
}
