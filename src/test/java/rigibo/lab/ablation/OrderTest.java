package rigibo.lab.ablation;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Effect;
import rigibo.lab.ablation.Run.Engine;
import rigibo.lab.ablation.probe.LeftOut;
import rigibo.lab.ablation.probe.Share;
import rigibo.lab.ablation.probe.Use;
import rigibo.lab.ablation.probe.Workload;
import rigibo.lab.ablation.probe.Workloads;

import java.util.Arrays;
import java.util.List;

class OrderTest {

    private final Workloads workloads = new Workloads(1);

    @Test
    void pairsAreRunInTurnedOrder() {
        Order order = new Order(workloads, List.of("heap"), 3);
        assertThat(order.runs().stream().limit(6).map(Run::engine))
                .containsExactly(
                        Engine.STRIPPED,
                        Engine.FULL,
                        Engine.FULL,
                        Engine.STRIPPED,
                        Engine.STRIPPED,
                        Engine.FULL);
        assertThat(order.runs()).doesNotHaveDuplicates();
    }

    @Test
    void everyEffectHasAScene() {
        assertThat(workloads.uses().stream().map(Use::name))
                .containsExactlyInAnyOrder(
                        Arrays.stream(Effect.class.getPermittedSubclasses())
                                .map(Class::getSimpleName)
                                .toArray(String[]::new));
        assertThat(workloads.uses().stream().map(use -> use.scene().name()))
                .isSubsetOf(workloads.scenes().stream().map(Workload::name).toList());
    }

    @Test
    void everyRunCanBeFoundByItsWords() {
        List<String> all = workloads.scenes().stream().map(Workload::name).toList();
        for (Run run : new Order(workloads, all, 1).runs()) {
            assertThat(workloads.find(run.workload()).bodies()).as(run.workload()).isNotEmpty();
        }
    }

    @Test
    void sharesCountTheBodiesThatMove() {
        Use rolling = workloads.use("RollingResistance");
        assertThat(rolling.users(Share.NONE)).isZero();
        assertThat(rolling.users(Share.ONE)).isEqualTo(1);
        assertThat(rolling.users(Share.HALF)).isEqualTo(10);
        assertThat(rolling.users(Share.ALL)).isEqualTo(20);
    }

    @Test
    void whatNeedsAnEffectIsLeftOutWithIt() {
        LeftOut scene = LeftOut.of(workloads.scene("wheel"), "Contacts");
        assertThat(scene.companions())
                .containsExactly("Friction", "RollingResistance", "ContinuousImpacts");
        assertThat(scene.remaining().all())
                .extracting(Effect::title)
                .containsExactly("gravity", "rotation", "thrust");
    }
}
