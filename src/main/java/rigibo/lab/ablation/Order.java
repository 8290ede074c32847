package rigibo.lab.ablation;

import rigibo.backend.effect.Effect;
import rigibo.lab.ablation.Run.Budget;
import rigibo.lab.ablation.Run.Engine;
import rigibo.lab.ablation.probe.Share;
import rigibo.lab.ablation.probe.Use;
import rigibo.lab.ablation.probe.Workload;
import rigibo.lab.ablation.probe.Workloads;

import java.util.ArrayList;
import java.util.List;

/**
 * All runs, in order. They come in pairs whose order alternates, a b b a, so that a drift of the
 * machine affects both.
 */
final class Order {

    /** The number of pairs for a cost; a ratio to one percent needs more. */
    private static final int PAIRS_OF_A_COST = 5;

    private final Workloads workloads;
    private final List<Workload> scenes;
    private final int pairs;
    private final int costPairs;
    private final List<Run> runs = new ArrayList<>();

    /** The runs for some scenes, with a number of pairs for each. */
    Order(Workloads workloads, List<String> names, int pairs) {
        this.workloads = workloads;
        this.pairs = pairs;
        costPairs = Math.min(pairs, PAIRS_OF_A_COST);
        scenes = workloads.scenes().stream().filter(scene -> names.contains(scene.name())).toList();
        scenes.forEach(this::addAblation);
        uses().forEach(this::addUse);
        scenes.forEach(this::addLeftOut);
    }

    List<Run> runs() {
        return runs;
    }

    List<Workload> scenes() {
        return scenes;
    }

    /** The uses of effects whose scene is among the scenes. */
    List<Use> uses() {
        return workloads.uses().stream()
                .filter(use -> scenes.stream().anyMatch(one -> isScene(one, use)))
                .toList();
    }

    private static boolean isScene(Workload scene, Use use) {
        return scene.name().equals(use.scene().name());
    }

    private void addAblation(Workload scene) {
        for (int round = 1; round <= pairs; round++) {
            addPair(
                    new Run(scene.name(), Engine.STRIPPED, round, Budget.LONG),
                    new Run(scene.name(), Engine.FULL, round, Budget.LONG));
        }
    }

    private void addUse(Use use) {
        for (Share share : use.shares()) {
            for (int round = 1; round <= costPairs; round++) {
                addPair(
                        cost(Workloads.using(use.name(), share, false), round),
                        cost(Workloads.using(use.name(), share, true), round));
            }
        }
    }

    private void addLeftOut(Workload scene) {
        for (Effect effect : scene.effects().all()) {
            String name = effect.getClass().getSimpleName();
            for (int round = 1; round <= costPairs; round++) {
                addPair(
                        cost(Workloads.without(scene.name(), name), round),
                        cost(Workloads.beside(scene.name(), name), round));
            }
        }
    }

    private static Run cost(String workload, int round) {
        return new Run(workload, Engine.FULL, round, Budget.SHORT);
    }

    private void addPair(Run first, Run second) {
        boolean isTurned = first.round() % 2 == 0;
        runs.add(isTurned ? second : first);
        runs.add(isTurned ? first : second);
    }
}
