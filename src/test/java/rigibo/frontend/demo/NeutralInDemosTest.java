package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.Pool;
import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Buoyancy;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.effect.Thrust;
import rigibo.frontend.scene.Words;

import java.util.List;
import java.util.function.Function;

/**
 * An effect that no demo calls for changes nothing in any of them while its parameters are neutral.
 */
@Execution(ExecutionMode.CONCURRENT)
class NeutralInDemosTest {

    private static final double STEP = 1.0 / 60;
    private static final int STEPS = 600;

    /** No body of a demo has drag; no demo reaches so deep. */
    private static final List<Effect> NEUTRAL =
            List.of(
                    new Drag(),
                    new AirDrag(0, 1),
                    new SurfaceSpeed(),
                    new Thrust(),
                    new CentralForce(1, 2, 0, -2),
                    new Buoyancy(-1e4, 1000, 5),
                    new Field(at -> at.push(0, 0)));

    /** Nothing sleeps where a function of the caller's is declared: it may change with time. */
    private static boolean isForeign(Effect effect, Effects called) {
        boolean keepsAwake = effect.holdsFunction() && called.declares(Sleep.class);
        boolean lacksFriction = effect instanceof SurfaceSpeed && !called.declares(Friction.class);
        return !called.declares(effect.getClass()) && !keepsAwake && !lacksFriction;
    }

    /** The crate's floor runs for whoever switches that on. */
    private static boolean isStated(Effect effect, Demo demo) {
        return effect instanceof SurfaceSpeed && demo instanceof CrateDemo;
    }

    @ParameterizedTest
    @MethodSource("rigibo.frontend.demo.EveryDemo#all")
    void neutralEffectsLeaveTheHashOfADemo(Function<Words, Demo> demo) {
        Effects called = demo.apply(new Words("en")).effects();
        long plain = run(demo.apply(new Words("en")), called).stateHash();
        for (Effect effect : NEUTRAL) {
            if (isForeign(effect, called) && !isStated(effect, demo.apply(new Words("en")))) {
                assertThat(run(demo.apply(new Words("en")), called.with(effect)).stateHash())
                        .as("%s in %s", effect.title(), demo.apply(new Words("en")).name())
                        .isEqualTo(plain);
            }
        }
    }

    private static Pool run(Demo demo, Effects effects) {
        Workbench bench = EveryDemo.built(demo);
        Pool pool = bench.pool();
        pool.effects(effects);
        for (int step = 1; step <= STEPS; step++) {
            demo.beforeStep(bench);
            pool.step(STEP);
            demo.afterStep(bench);
        }
        return pool;
    }
}
