package rigibo.lab.child;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;

/** Results that were kept are found again. */
class KeptTest {

    @TempDir private Path directory;

    private Path file() {
        return directory.resolve("deeper").resolve("found.log");
    }

    @Test
    void keepsWhatWasFound() {
        new Kept(file(), "key").add("R1 | GAME", "1.5\t2");

        assertThat(new Kept(file(), "key").of("R1 | GAME")).contains("1.5\t2");
        assertThat(new Kept(file(), "key").of("R1 | FINE")).isEmpty();
    }

    @Test
    void anotherKeyDoesNotCountAndIsKept() {
        new Kept(file(), "old").add("R1", "1");

        assertThat(new Kept(file(), "new").of("R1")).isEmpty();
        assertThat(new Kept(file(), "old").of("R1")).contains("1");
    }

    @Test
    void aLineCutShortIsMadeAgain() throws IOException {
        new Kept(file(), "key").add("R1", "1");
        Files.writeString(file(), "key\tR2\t1.2", StandardOpenOption.APPEND);

        Kept kept = new Kept(file(), "key");
        assertThat(kept.of("R2")).isEmpty();
        kept.add("R2", "1.25");
        assertThat(new Kept(file(), "key").of("R2")).contains("1.25");
        assertThat(new Kept(file(), "key").of("R1")).contains("1");
    }

    @Test
    void onlyWhatIsMissingIsMade() {
        Kept kept = new Kept(file(), "key");
        kept.add("run 2", "kept");
        List<String> told = new ArrayList<>();
        kept.make(List.of(1, 2, 3), run -> "run " + run, run -> "made " + run, told::add);

        assertThat(told).first().isEqualTo("2 runs to make");
        assertThat(kept.of("run 1")).contains("made 1");
        assertThat(kept.of("run 2")).contains("kept");
        assertThat(new Kept(file(), "key").of("run 3")).contains("made 3");
    }
}
