package rigibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rigibo.backend.Pool;
import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.replay.Recordings;
import rigibo.frontend.puzzle.replay.ReplayShelf;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;

class ReplayCommandTest {

    @TempDir Path folder;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int replay(String... files) {
        String[] typed = new String[files.length + 1];
        typed[0] = "replay";
        System.arraycopy(files, 0, typed, 1, files.length);
        return Main.run(new PrintWriter(out), new PrintWriter(err), typed);
    }

    private Path kept() throws IOException {
        Recording played = Recordings.sound();
        ReplayShelf shelf = new ReplayShelf(folder, played.level());
        shelf.keep(played);
        return shelf.best();
    }

    private String level() throws IOException {
        return Files.writeString(folder.resolve("drop.json"), LevelTexts.SOUND).toString();
    }

    @Test
    void aKeptRunIsTheSame() throws IOException {
        String file = kept().toString();
        assertThat(replay("--level", level(), file)).isZero();
        assertThat(out.toString()).startsWith(file + ": the same to the last bit: ");
    }

    @Test
    void aReplayOfAnotherLevelFailsAndTheOthersAreStillChecked() throws IOException {
        String file = kept().toString();
        assertThat(replay(folder.resolve("none.replay.json").toString(), file)).isEqualTo(1);
        assertThat(err.toString())
                .contains("there is no such file", "belongs to the level \"drop\"");
    }

    @Test
    void aReplayOfAnotherRevisionIsToldAndNotPlayed() throws IOException {
        Path file = kept();
        String revision = "\"revision\" : " + Pool.REVISION;
        String text = Files.readString(file);
        assertThat(text).contains(revision);
        Files.writeString(file, text.replace(revision, "\"revision\" : 99"));
        assertThat(replay("--level", level(), file.toString())).isEqualTo(1);
        assertThat(err.toString()).contains("was played in revision 99 of the simulation");
        assertThat(out.toString()).isEmpty();
    }

    @Test
    void aDivergenceFails() throws IOException {
        Path file = kept();
        Files.writeString(file, Files.readString(file).replace("\"step\" : 60", "\"step\" : 61"));
        assertThat(replay("--level", level(), file.toString())).isEqualTo(1);
        assertThat(out.toString()).contains("went apart between step 60 and step 90");
    }
}
