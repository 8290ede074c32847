package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.lang.management.ManagementFactory;

/** A warm step allocates nothing: in a game the collector must never be the reason for a jolt. */
class AllocationTest {

    private static final int WARM_UP = 1500;
    private static final int STEPS = 1000;

    private static final com.sun.management.ThreadMXBean THREADS =
            (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();

    @ParameterizedTest
    @EnumSource(Scenes.class)
    void thousandWarmStepsAllocateNothing(Scenes scene) {
        Pool pool = scene.build();
        Scenes.run(pool, WARM_UP);
        // The question itself may allocate the first time it is asked.
        bytesAllocated();
        long before = bytesAllocated();
        long asked = bytesAllocated() - before;
        before = bytesAllocated();
        Scenes.run(pool, STEPS);
        assertThat(bytesAllocated() - before - asked).as("%s, bytes", scene).isZero();
    }

    private static long bytesAllocated() {
        return THREADS.getThreadAllocatedBytes(Thread.currentThread().getId());
    }
}
