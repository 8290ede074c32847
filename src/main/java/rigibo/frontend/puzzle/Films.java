package rigibo.frontend.puzzle;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Scene;

import java.util.function.Function;

/** Scenes that play by themselves, without input. */
public final class Films {

    /** Longest film: no solution takes longer. */
    private static final int MOST_STEPS = Steps.of(120);

    private Films() {}

    /**
     * Shows how a level of the game can be solved.
     *
     * @throws IllegalArgumentException when there is no such level, or no solution of it
     */
    public static Function<Director, Scene> of(String level) {
        return Levels.all().stream()
                .filter(one -> one.id().equals(level))
                .findFirst()
                .map(Films::of)
                .orElseThrow(() -> new IllegalArgumentException(unknown(level)));
    }

    private static String unknown(String level) {
        String ids = String.join(", ", Levels.all().stream().map(Level::id).toList());
        return "There is no level '" + level + "'; there are: " + ids;
    }

    static Function<Director, Scene> of(Level level) {
        if (level.solutions().isEmpty()) {
            throw new IllegalArgumentException(level.id() + " has no solution to be shown");
        }
        return of(Recording.of(level, level.solutions().get(0), Accuracy.GAME, MOST_STEPS));
    }

    static Function<Director, Scene> of(Recording recording) {
        return director -> new ReplayScene(director, recording, ReplayScene.Audience.FILM);
    }
}
