package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.puzzle.hud.Command;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;

import java.util.List;

class SequelTest {

    private final RecordingDirector director = new RecordingDirector();
    private final List<Level> levels = Levels.all();

    private void solve(Level level) {
        director.progress(director.progress().solved(level.id(), level.hash(), 1));
    }

    @Test
    void endlessLevelsFollowTheLastOnceAllAreSolved() {
        Sequel last = Sequel.of(director, levels, levels.size() - 1);
        levels.stream().skip(1).forEach(this::solve);
        assertThat(last.next()).isEmpty();
        solve(levels.get(0));
        assertThat(last.onward()).isEqualTo(Command.ENDLESS);
        Scene next = last.next().orElseThrow().get();
        assertThat(next.title()).isEqualTo("RigiBo – Endless");
        next.closed();
    }

    @Test
    void nothingFollowsTheLastOfOtherLevels() {
        Level level = PlayedLevel.twoBoxes();
        solve(level);
        assertThat(Sequel.of(director, List.of(level), 0).next()).isEmpty();
    }
}
