package rigibo.frontend.display;

import org.teavm.jso.JSBody;
import org.teavm.jso.JSFunctor;
import org.teavm.jso.JSObject;
import org.teavm.jso.browser.Window;

import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Player;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Sounds;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.sound.Speaker;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;

/**
 * Shows scenes in a page, one after the other, by the loop of {@code Display}: input, the steps
 * that are due, a picture. The browser calls it for each picture of the screen, but not while the
 * page is hidden.
 */
public final class PageDisplay implements Director {

    /** Folder of the files that were dropped on the page. */
    private static final Path DROPPED = Path.of("/dropped");

    private final Function<Director, Scene> menu;
    private final Function<Director, Scene> levels;
    private final Player player;
    private final FrameClock clock = new FrameClock(System::nanoTime, nanos -> {});
    private final Curtain curtain = new Curtain();
    private final Toast toast = new Toast();
    private final Speaker speaker = new Speaker();
    private final PageSurface surface = new PageSurface();
    private final PageInput input = new PageInput(surface, this);
    private final Address address = new Address();
    private final Mirror mirror = new Mirror(surface.canvas(), input);
    private BiFunction<Director, String, Optional<Scene>> decoder =
            (director, text) -> Optional.empty();
    private BiFunction<Director, List<Path>, Scene> opener;
    private Function<String, Optional<Function<Director, Scene>>> linker = text -> Optional.empty();
    private Words words;
    private Scene scene;
    private Scene wanted;

    /** Number of pictures for which the curtain has been falling before the next scene. */
    private int fallen;

    /** A display for a player, who can go back to the menu or to the list of levels. */
    public PageDisplay(
            Function<Director, Scene> menu, Function<Director, Scene> levels, Player player) {
        this.menu = menu;
        this.levels = levels;
        this.player = player;
        words = new Words(player.settings());
        speaker.settings(player.settings());
        speaker.plugIn();
    }

    /** Sets the function that makes a scene of a pasted code; it returns none for other texts. */
    public void opensCodesBy(BiFunction<Director, String, Optional<Scene>> decoding) {
        decoder = decoding;
    }

    /** Sets the function that makes a scene of files that are dropped on the page. */
    public void opensFilesBy(BiFunction<Director, List<Path>, Scene> opening) {
        opener = opening;
    }

    /** Sets the function that makes a scene of the text of a link; none if it leads nowhere. */
    public void opensLinksBy(Function<String, Optional<Function<Director, Scene>>> linking) {
        linker = linking;
    }

    /** Opens the scene of the page's address, and runs as long as the page is open. */
    public void run() {
        open(linked());
        address.onEntered(() -> show(linked()));
        tellPace(clock::pace);
        Window.requestAnimationFrame(this::picture);
    }

    /** The scene of the page's address; the menu if there is none. */
    private Scene linked() {
        String text = address.text();
        Optional<Function<Director, Scene>> found = linker.apply(text);
        if (found.isEmpty() && !text.isEmpty()) {
            say(words.of("link.nowhere"));
        }
        return found.orElse(menu).apply(this);
    }

    private void picture(double millis) {
        Window.requestAnimationFrame(this::picture);
        if (clock.beginsTurn()) {
            turn();
        }
    }

    private void turn() {
        if (wanted != null && isCovered()) {
            open(wanted);
            wanted = null;
        }
        if (wanted == null) {
            input.turn();
        }
        do {
            if (wanted == null) {
                scene.step();
                speaker.turn();
            }
        } while (clock.isAnotherDueOf(FrameClock.MOST_STEPS));
        double dark = wanted == null ? curtain.rise() : Curtain.fallen(fallen);
        scene.drawn(surface.draw(scene, settings(), toast, dark));
        scene.paced(clock.pace());
        if (wanted == null) {
            mirror.drawn(scene, surface.layout(), beside());
            address.turn(scene.link());
        }
    }

    /** The controls of the page beside the scene. */
    private List<Control> beside() {
        Plate back = surface.wayBack();
        return back == Plate.NONE ? List.of() : List.of(back.button(words.of("menu.back"), false));
    }

    /** Lets the curtain fall; returns whether the scene is covered. */
    private boolean isCovered() {
        fallen++;
        return settings().motion() != Settings.Motion.FULL || fallen > Curtain.FRAMES;
    }

    private void open(Scene next) {
        if (scene != null) {
            scene.closed();
        }
        scene = next;
        input.shows(scene);
        surface.begin(scene, settings());
        if (settings().motion() == Settings.Motion.FULL) {
            curtain.drop();
        }
        clock.restart();
        title(scene.title());
        language(settings().language());
        mirror.begins(scene.title());
        address.show(scene.link());
    }

    /** Whether another scene was chosen already, so that input no longer means this one. */
    boolean isLeaving() {
        return wanted != null;
    }

    /** Whether typed keys are text. */
    boolean isTyping() {
        return scene.isTyping();
    }

    @Override
    public void show(Scene next) {
        wanted = next;
        fallen = 0;
    }

    @Override
    public void showMenu() {
        show(menu.apply(this));
    }

    @Override
    public void showLevels() {
        show(levels.apply(this));
    }

    /** Does nothing: a page cannot close itself. */
    @Override
    public void quit() {}

    @Override
    public boolean canQuit() {
        return false;
    }

    @Override
    public Player player() {
        return player;
    }

    /** None: players cannot find a file in the browser's storage. */
    @Override
    public Optional<Path> measurements() {
        return Optional.empty();
    }

    @Override
    public void settings(Settings changed) {
        if (changed.isFullScreen() != settings().isFullScreen()) {
            fill(changed.isFullScreen());
        }
        player.settings(changed);
        speaker.settings(changed);
        words = new Words(changed);
        language(changed.language());
    }

    void toggleFullScreen() {
        settings(settings().withFullScreen(!settings().isFullScreen()));
    }

    void toggleMute() {
        settings(settings().withMuted(!settings().isMuted()));
        say(words.of(settings().isMuted() ? "toast.muted" : "toast.sounding"));
    }

    @Override
    public Words words() {
        return words;
    }

    @Override
    public Sounds sounds() {
        return speaker;
    }

    @Override
    public void say(String told) {
        toast.say(told);
        mirror.tell(told);
    }

    /**
     * Tells that the browser keeps no more of the player's results: briefly now, at length in the
     * menu.
     */
    public void notKept() {
        tell(words.of("save.page"));
        say(words.of("toast.not-kept"));
    }

    @Override
    public void copy(String text) {
        copy(text, words.of("toast.copied", text.length()));
    }

    private void copy(String text, String done) {
        Clipboard.write(text, isCopied -> say(isCopied ? done : words.of("toast.not-copied")));
    }

    @Override
    public boolean hasAddress() {
        return true;
    }

    /** Shares by the system's own dialog if there is one, otherwise by the clipboard. */
    @Override
    public void share() {
        address.show(scene.link());
        if (!address.offer(scene.title())) {
            copy(Address.whole(), words.of("toast.link"));
        }
    }

    /** True: files of the page are in the browser's storage. */
    @Override
    public boolean handsOver() {
        return true;
    }

    @Override
    public void handOver(String name, String text) {
        download(name, text);
    }

    @Override
    public void paste() {
        Clipboard.read(this::pasted);
    }

    void pasted(String text) {
        if (!scene.pasted(text)) {
            decoder.apply(this, text)
                    .ifPresentOrElse(this::show, () -> say(words.of("toast.no-code")));
        }
    }

    /** Opens a file that was dropped on the page. */
    void dropped(String name, String text) {
        try {
            Path file = DROPPED.resolve(name);
            Files.createDirectories(DROPPED);
            Files.writeString(file, text);
            show(opener.apply(this, List.of(file)));
        } catch (IOException full) {
            throw new UncheckedIOException(full);
        }
    }

    @JSBody(
            params = {"name", "text"},
            script =
                    "var link = document.createElement('a'); link.download = name; link.href ="
                            + " URL.createObjectURL(new Blob([text])); link.click();"
                            + " setTimeout(function() { URL.revokeObjectURL(link.href); }, 1000);")
    private static native void download(String name, String text);

    @JSBody(params = "title", script = "document.title = title;")
    private static native void title(String title);

    /** Sets the language by which screen readers pronounce the texts. */
    @JSBody(params = "tag", script = "document.documentElement.lang = tag;")
    private static native void language(String tag);

    /** Reports the share of real time at which the world runs, to measurements of the page. */
    @JSFunctor
    interface Pace extends JSObject {
        double share();
    }

    @JSBody(params = "pace", script = "window.rigiboPace = pace;")
    private static native void tellPace(Pace pace);

    @JSBody(
            params = "wanted",
            script =
                    "if (wanted) { document.documentElement.requestFullscreen(); } else if"
                            + " (document.fullscreenElement) { document.exitFullscreen(); }")
    private static native void fill(boolean wanted);
}
