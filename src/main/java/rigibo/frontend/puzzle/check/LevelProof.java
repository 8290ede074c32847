package rigibo.frontend.puzzle.check;

import rigibo.frontend.document.Problem;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.List;
import java.util.OptionalInt;

/**
 * Finds all problems of a level's text, including those that appear only in play; takes seconds.
 */
public final class LevelProof {

    private LevelProof() {}

    /**
     * Reports what {@code levels check --accuracy GAME} finds in a text.
     *
     * @param name what messages call it
     */
    public static List<Problem> problems(String name, String text) {
        LoadedLevel loaded = new LevelLoader().parse(name, text);
        loaded.level()
                .ifPresent(
                        level ->
                                LevelCheck.play(
                                        loaded, level, List.of(Preset.GAME), OptionalInt.empty()));
        return loaded.problems();
    }
}
