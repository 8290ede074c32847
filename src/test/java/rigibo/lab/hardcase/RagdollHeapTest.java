package rigibo.lab.hardcase;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.lab.bench.scene.Assemblies;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.Link;

import java.util.List;

/** Ragdolls fall on each other without lying in each other. */
@Execution(ExecutionMode.CONCURRENT)
class RagdollHeapTest {

    /**
     * Widths. A limb that an impact makes spin at 80 rad/s about its hinge turns by a third of a
     * radian in a substep, and its end leaves its tangent by its length of three widths times the
     * square of that, over two: 0.17.
     */
    private static final double AT_ONCE = 0.2;

    /** Widths, in the mean over steps. Where impacts were left unsolved it was 0.1. */
    private static final double USUAL = 0.02;

    /** From the first landing to when the last ragdolls lie. */
    private static final int STEPS = 160;

    @Test
    void noLimbGetsDeepIntoAnother() {
        Scene scene = Assemblies.ragdolls(49);
        Pool pool = new Pool(scene.effects(), Accuracy.GAME);
        List<RigidBody> bodies = scene.bodies().stream().map(pool::add).toList();
        for (Link link : scene.links()) {
            pool.join(link.between(bodies.get(link.a()), bodies.get(link.b())));
        }
        Overlap overlap = new Overlap();
        double sum = 0;
        double deepest = 0;
        for (int i = 0; i < STEPS; i++) {
            pool.step(1 / 60.0);
            double deep = overlap.deepestShare(bodies);
            sum += deep;
            deepest = Math.max(deepest, deep);
        }
        assertThat(deepest).isPositive().isLessThan(AT_ONCE);
        assertThat(sum / STEPS).isLessThan(USUAL);
    }
}
