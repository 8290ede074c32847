package rigibo.web.game;

import org.teavm.jso.JSBody;

import rigibo.frontend.catalog.Catalog;
import rigibo.frontend.display.PageDisplay;
import rigibo.frontend.editor.Proving;
import rigibo.frontend.puzzle.endless.Making;
import rigibo.frontend.save.Places;
import rigibo.frontend.save.SavedPlayer;
import rigibo.frontend.scene.Settings;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Starts the game in a page or, if there are arguments, an errand beside it. */
public final class GamePage {

    /** Folder in which the game finds its files, as on a disk. */
    private static final Path HOME = Path.of("/game");

    private static final Path PLAYER = Path.of("/player");

    private GamePage() {}

    public static void main(String[] arguments) throws IOException {
        if (arguments.length > 0) {
            run(Arrays.asList(arguments));
            return;
        }
        System.setProperty("rigibo.home", HOME.toString());
        Brought.unpackTo(HOME);
        List<PageDisplay> display = new ArrayList<>();
        Keeping keeping = new Keeping(PLAYER, () -> display.forEach(PageDisplay::notKept));
        SavedPlayer player = new SavedPlayer(Places.in(PLAYER), initial());
        display.add(new PageDisplay(Catalog::menu, Catalog::levels, player));
        display.get(0).opensCodesBy(Catalog::pasted);
        display.get(0).opensFilesBy(Catalog::dropped);
        display.get(0).opensLinksBy(Catalog::linked);
        display.get(0).run();
        keeping.begin();
    }

    /** Does an errand beside the page. */
    private static void run(List<String> errand) {
        List<String> words = errand.subList(1, errand.size());
        switch (errand.get(0)) {
            case Making.ERRAND -> Making.make(words);
            case Proving.ERRAND -> Proving.prove(words.get(0));
            default -> throw new IllegalArgumentException("there is no errand " + errand.get(0));
        }
    }

    /** The settings of a new player, as far as the browser knows them. */
    private static Settings initial() {
        Settings initial = Settings.initial(language());
        return isCalm() ? initial.withMotion(Settings.Motion.REDUCED) : initial;
    }

    /** Whether the player's system asks for little motion. */
    @JSBody(script = "return matchMedia('(prefers-reduced-motion: reduce)').matches;")
    private static native boolean isCalm();

    @JSBody(script = "return navigator.language.substring(0, 2);")
    private static native String language();
}
