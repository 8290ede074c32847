package rigibo.lab.problem;

import rigibo.lab.bench.scene.Assemblies;
import rigibo.lab.bench.scene.Commotions;
import rigibo.lab.bench.scene.Crowd;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.Line;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/**
 * Hundreds of boxes that rain into a trough, a pyramid that settles, a pyramid that is struck,
 * ragdolls on stairs. Final places have no known truth, but bodies are rigid: no two ever overlap,
 * and all energy comes from the start and the strikes. The phases differ a little, and since every
 * run is chaotic, their median counts.
 */
final class CrowdProblem {

    /** The first box of a pyramid's base, after the floor. */
    private static final int FOOT = 1;

    /** The limit of row M1 for up to 400 bodies, and for more. */
    private static final double OVERLAP_OF_400 = 0.05;

    private static final double OVERLAP_OF_MORE = 0.10;

    /**
     * A run.
     *
     * @param scene at the start
     * @param strike at the foot each second, N·s; 0 for none
     */
    private record Phase(Scene scene, double strike) {

        Phase(Scene scene) {
            this(scene, 0);
        }
    }

    /** The limit of row J15, m. */
    private static final double JOINT_ERROR = 1e-3;

    private static final String OVERLAP = "deepest overlap / width";
    private static final String JOINTS = "error of the joints, m";

    private final double seconds;
    private final String error;
    private final List<Phase> phases;

    private CrowdProblem(double seconds, String error, Stream<Phase> phases) {
        this.seconds = seconds;
        this.error = error;
        this.phases = phases.toList();
    }

    /** Few knobs or none, since sweeping all of them takes hours. */
    private Problem problem(String id, String title, double equalBelow, Line... lines) {
        return new Problem(id, title, error, equalBelow, List.of(lines), this::set).ofMinutes();
    }

    /** The phases are rains of other seeds. It shows the gain by passes and substeps. */
    static Problem rain(int boxes) {
        Stream<Phase> rains =
                LongStream.of(14, 15, 16)
                        .mapToObj(seed -> new Scene(Crowd.EFFECTS, Crowd.BOXES.rain(boxes, seed)))
                        .map(Phase::new);
        String title = boxes + " boxes that rain into a trough";
        return new CrowdProblem(7, OVERLAP, rains)
                .problem("R14", title, OVERLAP_OF_400, Line.SUBSTEPS, Line.ITERATIONS);
    }

    /** The phases are gaps between storeys. */
    static Problem settling(int storeys) {
        Stream<Phase> gaps =
                DoubleStream.of(0.0195, 0.02, 0.0205)
                        .mapToObj(gap -> new Phase(Commotions.settling(storeys, gap)));
        String title = "a pyramid of " + storeys + " storeys that falls together";
        return new CrowdProblem(10, OVERLAP, gaps).problem("R15", title, OVERLAP_OF_MORE);
    }

    /** The phases are speeds in m/s that a strike would give a free box. */
    static Problem struck(int storeys) {
        Scene scene = Commotions.struck(storeys);
        double mass = scene.bodies().get(FOOT).massProperties().mass();
        Stream<Phase> strikes =
                DoubleStream.of(9.7, 10, 10.3).mapToObj(speed -> new Phase(scene, speed * mass));
        String title = "a pyramid of " + storeys + " storeys, struck at its foot each second";
        return new CrowdProblem(10, OVERLAP, strikes).problem("R16", title, OVERLAP_OF_MORE);
    }

    /** The phases are heights from which they fall, m. */
    static Problem ragdolls(int count) {
        Stream<Phase> heights =
                DoubleStream.of(0, 0.05, 0.1)
                        .mapToObj(higher -> new Phase(Assemblies.stairs(count, higher)));
        String title = count + " ragdolls that fall down stairs";
        return new CrowdProblem(10, JOINTS, heights).problem("R20", title, JOINT_ERROR);
    }

    private Trial set(Bench bench) {
        List<CrowdWatch> crowds =
                phases.stream().map(phase -> new CrowdWatch(bench, phase.scene())).toList();
        return () -> run(bench, crowds);
    }

    private Errors run(Bench bench, List<CrowdWatch> crowds) {
        int every = bench.stepsIn(1);
        for (int i = 0; i < crowds.size(); i++) {
            double strike = phases.get(i).strike();
            for (int step = 0; step < bench.stepsIn(seconds); step++) {
                if (strike > 0 && step > 0 && step % every == 0) {
                    crowds.get(i).strike(FOOT, strike);
                }
                crowds.get(i).step();
            }
            if (crowds.get(i).isLost()) {
                return Errors.failed("something fell through the floor in phase " + i);
            }
        }
        double deepest = median(crowds, CrowdWatch::deepest);
        Errors errors =
                error.equals(JOINTS)
                        ? Errors.of(median(crowds, CrowdWatch::jointError)).with(OVERLAP, deepest)
                        : Errors.of(deepest);
        return errors.with("energy gained / start", median(crowds, CrowdWatch::gain))
                .with("speed left, m/s", median(crowds, CrowdWatch::fastest))
                .with("sinking of the last body, m", median(crowds, CrowdWatch::sinkingOfLast));
    }

    private static double median(List<CrowdWatch> crowds, ToDoubleFunction<CrowdWatch> of) {
        double[] sorted = crowds.stream().mapToDouble(of).toArray();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }
}
