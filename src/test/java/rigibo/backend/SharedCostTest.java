package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;

/**
 * Sharing costs nothing in a pool that is not shared; in one that is, it changes no bit and makes
 * no garbage.
 */
@Execution(ExecutionMode.CONCURRENT)
class SharedCostTest {

    /** Columns of pairs double when more meet than ever before, which is over by then. */
    private static final int WARM_UP = 2000;

    private static final int STEPS = 500;

    private static final List<Scenes> MEASURED =
            List.of(Scenes.STACK, Scenes.SLEEPERS, Scenes.JOINTED, Scenes.KINDS);

    /** Pictures that a reader holds while steps go on, the oldest given back in each. */
    private static final int HELD = 3;

    /** Runs the measured scenes, with shared pools or without. */
    public static void main(String[] arguments) {
        for (Scenes scene : MEASURED) {
            Pool pool = scene.build();
            if (arguments[0].equals("shared")) {
                System.out.println(scene + " " + bytesOfSteps(pool, pool.shared()));
            } else {
                Scenes.run(pool, 60);
            }
        }
    }

    private static long bytesOfSteps(Pool pool, SharedView view) {
        Deque<Picture> held = new ArrayDeque<>();
        for (int i = 0; i < HELD; i++) {
            held.add(view.read());
        }
        long bytes = 0;
        for (int i = 0; i < WARM_UP + STEPS; i++) {
            held.remove().close();
            held.add(view.read());
            long before = Allocation.bytes();
            pool.step(Scenes.DT);
            long after = Allocation.bytes();
            bytes += i < WARM_UP ? 0 : after - before;
        }
        return bytes;
    }

    @Test
    void warmStepsThatAreSharedAllocateNothing() throws IOException, InterruptedException {
        String told =
                ChildJvm.output(
                        ChildJvm.own(),
                        List.of("-XX:TieredStopAtLevel=1"),
                        SharedCostTest.class,
                        "shared");
        assertThat(told.lines())
                .as("bytes of %d steps, by scene", STEPS)
                .containsExactlyElementsOf(MEASURED.stream().map(scene -> scene + " 0").toList());
    }

    @Test
    void whereNobodySharesTheCodeIsNotLoaded() throws IOException, InterruptedException {
        String told =
                ChildJvm.output(
                        ChildJvm.own(),
                        List.of("-Xlog:class+load=info:stdout:none"),
                        SharedCostTest.class,
                        "alone");
        assertThat(told).contains("rigibo.backend.Pool ");
        assertThat(told)
                .doesNotContain("rigibo.backend.SharedView")
                .doesNotContain("rigibo.backend.CopiedState")
                .doesNotContain("rigibo.backend.team.Exchange")
                .doesNotContain("rigibo.backend.broadphase.CopiedFixtures")
                .doesNotContain("rigibo.backend.storage.QueriedColumns");
    }

    @ParameterizedTest
    @EnumSource(Scenes.class)
    void stepsHaveTheSameBits(Scenes scene) {
        Pool alone = scene.build();
        Pool shared = scene.build();
        SharedView view = shared.shared();
        for (int step = 0; step < 60; step++) {
            StepReport expected = alone.step(Scenes.DT);
            try (Picture picture = view.read()) {
                StepReport found = shared.step(Scenes.DT);
                picture.rayCast(-9, 3, 9, 2);
                assertThat(found.multiplications()).isEqualTo(expected.multiplications());
                assertThat(shared.stateHash()).as("step %d", step).isEqualTo(alone.stateHash());
            }
        }
        assertThat(shared.snapshot()).isEqualTo(alone.snapshot());
        assertThat(shared.bitsPerBody()).isEqualTo(alone.bitsPerBody());
    }
}
