package rigibo.frontend.puzzle.check;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.puzzle.level.Problem;

import java.util.List;

/** All that is wrong with a level's text, played through; takes seconds. */
public final class LevelProof {

    private LevelProof() {}

    /**
     * What {@code levels check} tells of a text.
     *
     * @param name what messages call it
     */
    public static List<Problem> problems(String name, String text) {
        LoadedLevel loaded = new LevelLoader().parse(name, text);
        loaded.level().ifPresent(level -> new LevelCheck(Accuracy.GAME).play(loaded, level));
        return loaded.problems();
    }
}
