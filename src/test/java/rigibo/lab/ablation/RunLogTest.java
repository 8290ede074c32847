package rigibo.lab.ablation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rigibo.lab.ablation.Run.Budget;
import rigibo.lab.ablation.Run.Engine;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

class RunLogTest {

    private static final Run RUN = new Run("crate without Sleep", Engine.FULL, 2, Budget.SHORT);

    @TempDir private Path directory;

    private RunLog open(String key) {
        return new RunLog(directory.resolve("runs.csv"), key);
    }

    @Test
    void whatWasRunIsNotRunAgain() {
        open("key").add(RUN, Fake.sample(12.5, 64));
        RunLog again = open("key");
        assertThat(again.has(RUN)).isTrue();
        assertThat(again.of(RUN)).isEqualTo(Fake.sample(12.5, 64));
        assertThat(again.has(new Run(RUN.workload(), Engine.FULL, 3, Budget.SHORT))).isFalse();
    }

    @Test
    void runOfAnotherEngineDoesNotCount() {
        open("key").add(RUN, Fake.sample(12.5, 64));
        RunLog other = open("other");
        assertThat(other.has(RUN)).isFalse();
        assertThatThrownBy(() -> other.of(RUN)).hasMessageContaining("crate without Sleep");
    }

    @Test
    void lineThatWasCutShortIsMadeAgain() throws IOException {
        Path file = directory.resolve("runs.csv");
        open("key").add(RUN, Fake.sample(12.5, 64));
        String text = Files.readString(file);
        Files.writeString(file, text.substring(0, text.length() - 2));
        RunLog again = open("key");
        assertThat(again.has(RUN)).isFalse();
        again.add(RUN, Fake.sample(13, 64));
        assertThat(open("key").of(RUN).nanosPerStep()).isEqualTo(13);
    }
}
