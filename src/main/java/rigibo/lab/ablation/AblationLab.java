package rigibo.lab.ablation;

import rigibo.backend.effect.Effect;
import rigibo.lab.ablation.Findings.Ablation;
import rigibo.lab.ablation.Findings.Saving;
import rigibo.lab.ablation.Findings.UseCost;
import rigibo.lab.ablation.probe.LeftOut;
import rigibo.lab.ablation.probe.Sample;
import rigibo.lab.ablation.probe.Share;
import rigibo.lab.ablation.probe.Use;
import rigibo.lab.ablation.probe.Workload;
import rigibo.lab.ablation.probe.Workloads;
import rigibo.lab.child.Fields;
import rigibo.lab.child.Kept;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Makes the missing runs and evaluates all of them. */
final class AblationLab {

    private static final String RUNS = "effects-runs.log";

    private final Archives archives;
    private final ProbeJava java;
    private final Order order;
    private final Kept kept;

    AblationLab(Question question) {
        Workloads workloads = new Workloads(question.seed());
        archives = new Archives(question.out().resolve("archives"), workloads);
        java = new ProbeJava(archives, question.seed());
        order = new Order(workloads, question.scenes(), question.runs());
        String key = archives.hash() + "-" + question.seed() + "-" + Runtime.version();
        kept = new Kept(question.out().resolve(RUNS), key);
    }

    /** Describes how processes are run. */
    String method() {
        return java.words();
    }

    /**
     * Makes the missing runs.
     *
     * @param tell is told how far it is
     * @throws IllegalStateException when a run breaks off, with what it said
     */
    void run(Consumer<String> tell) {
        order.scenes().forEach(scene -> archives.strip(scene.name()));
        kept.make(order.runs(), Run::name, run -> Fields.line(java.run(run)), tell);
    }

    /** The findings of all runs. */
    Findings findings() {
        return new Findings(ablations(), uses(), savings());
    }

    private List<Ablation> ablations() {
        return order.scenes().stream().map(this::ablation).toList();
    }

    private Ablation ablation(Workload scene) {
        Pairs pairs =
                new Pairs(
                        samples(scene.name(), Run.Engine.STRIPPED),
                        samples(scene.name(), Run.Engine.FULL));
        int takenOut = archives.takenOut(scene.name()).size();
        return new Ablation(scene.name(), scene.words(), scene.period(), takenOut, pairs);
    }

    private List<UseCost> uses() {
        List<UseCost> costs = new ArrayList<>();
        for (Use use : order.uses()) {
            use.shares().forEach(share -> costs.add(cost(use, share)));
        }
        return costs;
    }

    private UseCost cost(Use use, Share share) {
        Pairs pairs =
                pairs(
                        Workloads.using(use.name(), share, false),
                        Workloads.using(use.name(), share, true));
        return new UseCost(
                use.name(),
                use.scene().name(),
                use.scene().words(),
                use.words(),
                share,
                use.users(share),
                pairs);
    }

    private List<Saving> savings() {
        List<Saving> savings = new ArrayList<>();
        for (Workload scene : order.scenes()) {
            for (Effect effect : scene.effects().all()) {
                savings.add(saving(scene, effect.getClass().getSimpleName()));
            }
        }
        return savings;
    }

    private Saving saving(Workload scene, String effect) {
        return new Saving(
                scene.name(),
                effect,
                LeftOut.of(scene, effect).companions(),
                pairs(
                        Workloads.without(scene.name(), effect),
                        Workloads.beside(scene.name(), effect)));
    }

    private Pairs pairs(String first, String second) {
        return new Pairs(samples(first, Run.Engine.FULL), samples(second, Run.Engine.FULL));
    }

    /** The samples in the order of their rounds. */
    private List<Sample> samples(String workload, Run.Engine engine) {
        return order.runs().stream()
                .filter(run -> run.workload().equals(workload) && run.engine() == engine)
                .map(run -> Fields.parse(Sample.class, kept.of(run.name()).orElseThrow()))
                .toList();
    }
}
