package rigibo.lab.ablation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import rigibo.backend.Pool;
import rigibo.lab.ablation.Run.Budget;
import rigibo.lab.ablation.Run.Engine;
import rigibo.lab.ablation.probe.Sample;
import rigibo.lab.ablation.probe.Workloads;
import rigibo.lab.child.ClassFiles;

import java.nio.file.Path;
import java.util.List;

/** An engine without the classes of what a scene does not declare runs it, to the same bits. */
class StrippedEngineTest {

    private static final long SEED = 3;

    @TempDir private Path directory;
    private ProbeJava java;

    @BeforeEach
    void strip() {
        Archives archives = new Archives(directory, new Workloads(SEED));
        archives.strip("flyers");
        java = new ProbeJava(archives, SEED);
    }

    private static Run flyers(Engine engine) {
        return new Run("flyers", engine, 1, Budget.SHORT);
    }

    @Test
    void flyersEndInTheSameBits() {
        Sample full = java.run(flyers(Engine.FULL));
        Sample stripped = java.run(flyers(Engine.STRIPPED));
        assertThat(stripped.stateHash()).isEqualTo(full.stateHash());
        assertThat(stripped.work()).isEqualTo(full.work());
    }

    @Test
    void runThatNeedsWhatWasTakenOutBreaksOffAndSaysWhy() {
        ClassFiles.of(Pool.class)
                .without(List.of("rigibo/backend/force/GravityKernel.class"))
                .write(directory.resolve("engine-for-flyers.jar"));
        assertThatThrownBy(() -> java.run(flyers(Engine.STRIPPED)))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("'flyers'")
                .hasMessageContaining("NoClassDefFoundError")
                .hasMessageContaining("GravityKernel");
    }
}
