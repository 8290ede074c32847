package rigibo.frontend.puzzle.check;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LoadedLevel;
import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.Deletion;

import java.util.Optional;

/**
 * What only playing shows. E151 a stored solution does not win, as stated or a little aside; E152
 * one click wins where par is more; E160 the level moves by itself.
 */
final class LevelCheck {

    private final Accuracy accuracy;
    private int trials;
    private int wins;

    LevelCheck(Accuracy accuracy) {
        this.accuracy = accuracy;
    }

    /** Plays a level that loads; what is wrong is added to its problems. */
    void play(LoadedLevel loaded, Level level) {
        RestCheck.check(loaded, level, accuracy);
        for (int i = 0; i < level.solutions().size(); i++) {
            solution(loaded, level, i);
        }
        if (level.limits().par() > 1) {
            singleClicks(loaded, level);
        }
    }

    /** What was played, in words; nothing for a level that does not load. */
    String summary(Optional<Level> played) {
        return played.map(
                        level ->
                                ", "
                                        + level.solutions().size()
                                        + " solutions win "
                                        + wins
                                        + " of "
                                        + trials
                                        + " games with bodies up to 10 mm aside, "
                                        + SingleClicks.count(level)
                                        + " single clicks tried")
                .orElse("");
    }

    private void solution(LoadedLevel loaded, Level level, int i) {
        String pointer = "/solutions/" + i;
        SolutionTrials played = SolutionTrials.of(level, level.solutions().get(i), accuracy);
        trials += played.jittered().size();
        wins += played.wins();
        if (!played.stated().isWon()) {
            loaded.error(pointer, "E151 does not win: " + played.stated());
        }
        int seed = played.firstLostSeed();
        if (seed >= 0) {
            loaded.error(
                    pointer,
                    "E151 wins only "
                            + played.wins()
                            + " of "
                            + played.jittered().size()
                            + " with everything up to 10 mm aside; with seed "
                            + seed
                            + ": "
                            + played.jittered().get(seed));
        }
    }

    private void singleClicks(LoadedLevel loaded, Level level) {
        Optional<Deletion> winner = SingleClicks.winner(level, accuracy);
        winner.ifPresent(
                click ->
                        loaded.error(
                                "/rules/par",
                                "E152 par is "
                                        + level.limits().par()
                                        + ", but one click on \""
                                        + click.body()
                                        + "\" at "
                                        + Steps.seconds(click.step())
                                        + " s wins"));
    }
}
