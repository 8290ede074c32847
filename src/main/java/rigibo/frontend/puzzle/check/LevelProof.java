package rigibo.frontend.puzzle.check;

import rigibo.frontend.document.Problem;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.scene.accuracy.Preset;

import java.util.List;
import java.util.OptionalInt;
import java.util.function.LongConsumer;

/** Finds all problems of a level's text, including those that only play shows; takes seconds. */
public final class LevelProof {

    private LevelProof() {}

    /**
     * Reports the findings of {@code levels check --accuracy GAME} on a text.
     *
     * @param name of the text in messages
     * @param told receives the number of games played so far, after each, on any thread
     */
    public static List<Problem> problems(String name, String text, LongConsumer told) {
        LoadedLevel loaded = new LevelLoader().parse(name, text);
        loaded.level()
                .ifPresent(
                        level ->
                                LevelCheck.play(
                                        loaded,
                                        level,
                                        List.of(Preset.GAME),
                                        OptionalInt.empty(),
                                        told));
        return loaded.problems();
    }
}
