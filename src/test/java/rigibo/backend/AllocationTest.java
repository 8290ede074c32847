package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * A warm step allocates no byte. A separate Java measures that, with its first compiler only. The
 * optimizing compiler would hide objects that it can keep on the stack; it also allocates text
 * constants on the thread that is running when a method is first compiled.
 */
@Execution(ExecutionMode.CONCURRENT)
class AllocationTest {

    /**
     * Columns double when more meet at once than ever before: in a gusty tray that was as late as
     * after 3675 steps.
     */
    private static final int WARM_UP = 5000;

    private static final int STEPS = 1000;

    /** Runs every scene in the other Java and prints the bytes that its steps allocated. */
    public static void main(String[] arguments) {
        for (Scenes scene : Scenes.values()) {
            System.out.println(scene + " " + bytesOfSteps(scene.build()));
        }
    }

    @Test
    void thousandWarmStepsAllocateNothing() throws IOException, InterruptedException {
        List<String> expected = new ArrayList<>();
        for (Scenes scene : Scenes.values()) {
            expected.add(scene + " 0");
        }
        assertThat(
                        ChildJvm.output(
                                ChildJvm.own(),
                                List.of("-XX:TieredStopAtLevel=1"),
                                AllocationTest.class))
                .as("bytes of %d steps, by scene", STEPS)
                .isEqualTo(String.join(System.lineSeparator(), expected));
    }

    private static long bytesOfSteps(Pool pool) {
        Scenes.run(pool, WARM_UP);
        // The measurement itself may allocate the first time.
        Allocation.bytes();
        long before = Allocation.bytes();
        long asked = Allocation.bytes() - before;
        before = Allocation.bytes();
        Scenes.run(pool, STEPS);
        return Allocation.bytes() - before - asked;
    }
}
