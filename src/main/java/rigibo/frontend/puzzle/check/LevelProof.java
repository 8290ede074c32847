package rigibo.frontend.puzzle.check;

import rigibo.frontend.document.Problem;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.List;

/** All that is wrong with a level's text, played through; takes seconds. */
public final class LevelProof {

    private LevelProof() {}

    /**
     * What {@code levels check --accuracy GAME} tells of a text.
     *
     * @param name what messages call it
     */
    public static List<Problem> problems(String name, String text) {
        LoadedLevel loaded = new LevelLoader().parse(name, text);
        loaded.level().ifPresent(level -> LevelCheck.play(loaded, level, List.of(Preset.GAME)));
        return loaded.problems();
    }
}
