package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * A warm step allocates not a byte; told by a Java of its own that has only its first compiler. The
 * optimizing one would hide what it can prove to stay on the stack, and makes the text constants of
 * a method's class on the thread that runs when the method is first compiled.
 */
class AllocationTest {

    /**
     * Columns double when more meet at once than ever before: in a gusty tray that was as late as
     * after 3675 steps.
     */
    private static final int WARM_UP = 5000;

    private static final int STEPS = 1000;

    /** What is run: every scene; prints the bytes that its steps allocated. */
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
        // The question itself may allocate the first time it is asked.
        Allocation.bytes();
        long before = Allocation.bytes();
        long asked = Allocation.bytes() - before;
        before = Allocation.bytes();
        Scenes.run(pool, STEPS);
        return Allocation.bytes() - before - asked;
    }
}
