package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.puzzle.record.Tally;
import rigibo.frontend.puzzle.replay.Proof;
import rigibo.frontend.puzzle.replay.ReplayShelf;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.RecordingDirector;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

class KeptReplayTest {

    @TempDir Path folder;

    private final Level level = LevelTexts.sound();
    private final RecordingDirector director = new RecordingDirector();

    private static PuzzleGame won(PuzzleGame game) {
        game.act("box");
        while (game.outcome() == Outcome.RUNNING) {
            game.step();
        }
        return game;
    }

    @Test
    void aSolvedRunIsKeptAndPlaysBackTheSame() {
        director.replays = Optional.of(folder);
        new Tally(director, level).ended(won(new PuzzleGame(level, Accuracy.GAME)));
        assertThat(new ReplayShelf(folder, level).watchable())
                .hasValueSatisfying(kept -> assertThat(Proof.of(kept).isSame()).isTrue());
    }

    @Test
    void aRunOfAnotherRevisionIsToldInPlaceOfBeingPlayed() throws IOException {
        director.replays = Optional.of(folder);
        assertThat(Replays.best(director, level)).isEmpty();
        new Tally(director, level).ended(won(new PuzzleGame(level, Accuracy.GAME)));
        assertThat(Replays.best(director, level)).containsInstanceOf(ReplayScene.class);
        ReplayShelf shelf = new ReplayShelf(folder, level);
        for (Path file : List.of(shelf.best(), shelf.last())) {
            String text = Files.readString(file);
            Files.writeString(file, text.replace("\"format\" : 2", "\"format\" : 1"));
        }
        assertThat(Replays.best(director, level)).containsInstanceOf(ProblemsScene.class);
    }

    @Test
    void anExperimentIsNotKept() {
        director.replays = Optional.of(folder);
        PuzzleGame game = new PuzzleGame(level, Accuracy.GAME);
        Effects own = level.world().effects();
        game.experiment(own);
        new Tally(director, level).ended(won(game));
        assertThat(new ReplayShelf(folder, level).watchable()).isEmpty();
    }

    @Test
    void whereNothingCanBeWrittenThePlayerIsTold() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "no folder");
        director.replays = Optional.of(file);
        new Tally(director, level).ended(won(new PuzzleGame(level, Accuracy.GAME)));
        assertThat(director.notices())
                .singleElement()
                .asString()
                .startsWith("The replay of drop could not be kept: ");
    }
}
