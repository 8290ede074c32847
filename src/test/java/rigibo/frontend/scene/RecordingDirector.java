package rigibo.frontend.scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Keeps what was asked of it. */
public final class RecordingDirector implements Director {

    /** The scenes that were to be shown, in their order. */
    public final List<Scene> shown = new ArrayList<>();

    /** The sounds that were asked for. */
    public final RecordingSounds sounds = new RecordingSounds();

    /** The texts put on the clipboard. */
    public final List<String> copied = new ArrayList<>();

    /** The messages shown for a moment. */
    public final List<String> said = new ArrayList<>();

    /** The other requests: menu, levels, quit, paste. */
    public final List<String> asked = new ArrayList<>();

    /** Where solved runs are kept. */
    public Optional<Path> replays = Optional.empty();

    /** Where what the player measures is kept. */
    public Optional<Path> measurements = Optional.empty();

    /** Pictures that were to be saved. */
    public final List<Path> pictures = new ArrayList<>();

    /** Where levels that the player makes are kept. */
    public Optional<Path> levels = Optional.empty();

    /** Whether files are handed over, and those that were, by their names. */
    public boolean handsOver;

    public final Map<String, String> handed = new HashMap<>();

    /** Whether what is shown has an address. */
    public boolean hasAddress;

    private final Player player;

    /** For a player who speaks English. */
    public RecordingDirector() {
        this("en");
    }

    /** For a player who speaks a language. */
    public RecordingDirector(String language) {
        player = new Guest(Settings.initial(language));
    }

    @Override
    public void show(Scene scene) {
        shown.add(scene);
    }

    @Override
    public void showMenu() {
        asked.add("menu");
    }

    @Override
    public void showLevels() {
        asked.add("levels");
    }

    @Override
    public void quit() {
        asked.add("quit");
    }

    @Override
    public void say(String words) {
        said.add(words);
    }

    @Override
    public Optional<Path> measurements() {
        return measurements;
    }

    @Override
    public void savePicture(Path file) {
        pictures.add(file);
    }

    @Override
    public void copy(String text) {
        copied.add(text);
    }

    @Override
    public boolean handsOver() {
        return handsOver;
    }

    @Override
    public void handOver(String name, String text) {
        handed.put(name, text);
    }

    @Override
    public boolean hasAddress() {
        return hasAddress;
    }

    @Override
    public void share() {
        asked.add("share");
    }

    @Override
    public void paste() {
        asked.add("paste");
    }

    @Override
    public Player player() {
        return player;
    }

    @Override
    public void settings(Settings changed) {
        player.settings(changed);
    }

    @Override
    public Words words() {
        return new Words(settings());
    }

    @Override
    public Optional<Path> levels() {
        return levels;
    }

    @Override
    public Optional<Path> replays() {
        return replays;
    }

    @Override
    public Sounds sounds() {
        return sounds;
    }
}
