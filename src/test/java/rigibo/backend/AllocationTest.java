package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.lang.management.ManagementFactory;

/** A warm step allocates nothing: in a game the collector must never be the reason for a jolt. */
class AllocationTest {

    private static final int WARM_UP = 1500;
    private static final int STEPS = 1000;
    private static final int MOST_QUESTIONS = 3;

    private static final com.sun.management.ThreadMXBean THREADS =
            (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();

    /**
     * Whatever the engine allocates it allocates again. The virtual machine's optimizing compiler
     * now and then leaves some hundred bytes on a thread whose code it replaces, which neither its
     * interpreter nor its first compiler ever does: so a thousand steps are asked about up to three
     * times.
     */
    @ParameterizedTest
    @EnumSource(Scenes.class)
    void thousandWarmStepsAllocateNothing(Scenes scene) {
        Pool pool = scene.build();
        Scenes.run(pool, WARM_UP);
        long least = Long.MAX_VALUE;
        for (int i = 0; i < MOST_QUESTIONS && least > 0; i++) {
            least = Math.min(least, bytesOfSteps(pool));
        }
        assertThat(least).as("%s, bytes", scene).isZero();
    }

    private static long bytesOfSteps(Pool pool) {
        // The question itself may allocate the first time it is asked.
        bytesAllocated();
        long before = bytesAllocated();
        long asked = bytesAllocated() - before;
        before = bytesAllocated();
        Scenes.run(pool, STEPS);
        return bytesAllocated() - before - asked;
    }

    private static long bytesAllocated() {
        return THREADS.getThreadAllocatedBytes(Thread.currentThread().getId());
    }
}
