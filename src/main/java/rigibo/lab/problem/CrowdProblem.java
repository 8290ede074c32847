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
 * Hundreds of boxes that rain into a trough, a pyramid that falls together, a pyramid that is
 * struck, ragdolls on stairs. Where the boxes are in the end nobody can say, but they are rigid: no
 * two ever overlap, and all energy is that of the start and of the strikes. The phases differ a
 * little, and since every run is chaotic, the median over them counts.
 */
final class CrowdProblem implements Problem {

    /** The first box of a pyramid's base, after the floor. */
    private static final int FOOT = 1;

    /** Row M1: up to 400 bodies, and above. */
    private static final double OVERLAP_OF_400 = 0.05;

    private static final double OVERLAP_OF_MORE = 0.10;

    /**
     * A run.
     *
     * @param scene as it begins
     * @param strike at the foot each second, N·s; 0 for none
     */
    private record Phase(Scene scene, double strike) {

        Phase(Scene scene) {
            this(scene, 0);
        }
    }

    /** Row J15. */
    private static final double JOINT_ERROR = 1e-3;

    private final String id;
    private final String title;
    private final boolean isOfJoints;
    private final double equalBelow;
    private final double seconds;
    private final List<Line> lines;
    private final List<Phase> phases;

    private CrowdProblem(
            String id, String title, double equalBelow, double seconds, Stream<Phase> phases) {
        this(id, title, equalBelow, seconds, List.of(), phases);
    }

    private CrowdProblem(
            String id,
            String title,
            double equalBelow,
            double seconds,
            List<Line> lines,
            Stream<Phase> phases) {
        this.id = id;
        this.title = title;
        isOfJoints = equalBelow == JOINT_ERROR;
        this.equalBelow = equalBelow;
        this.seconds = seconds;
        this.lines = lines;
        this.phases = phases.toList();
    }

    /** The phases are rains of other seeds. What passes and substeps buy is seen here. */
    static CrowdProblem rain(int boxes) {
        return new CrowdProblem(
                "R14",
                boxes + " boxes that rain into a trough",
                OVERLAP_OF_400,
                7,
                List.of(Line.SUBSTEPS, Line.ITERATIONS),
                LongStream.of(14, 15, 16)
                        .mapToObj(seed -> new Scene(Crowd.EFFECTS, Crowd.BOXES.rain(boxes, seed)))
                        .map(Phase::new));
    }

    /** The phases are gaps between storeys. */
    static CrowdProblem settling(int storeys) {
        return new CrowdProblem(
                "R15",
                "a pyramid of " + storeys + " storeys that falls together",
                OVERLAP_OF_MORE,
                10,
                DoubleStream.of(0.0195, 0.02, 0.0205)
                        .mapToObj(gap -> Commotions.settling(storeys, gap))
                        .map(Phase::new));
    }

    /** The phases are speeds in m/s that a strike would give a box which nothing holds. */
    static CrowdProblem struck(int storeys) {
        Scene scene = Commotions.struck(storeys);
        double mass = scene.bodies().get(FOOT).massProperties().mass();
        return new CrowdProblem(
                "R16",
                "a pyramid of " + storeys + " storeys, struck at its foot each second",
                OVERLAP_OF_MORE,
                10,
                DoubleStream.of(9.7, 10, 10.3).mapToObj(speed -> new Phase(scene, speed * mass)));
    }

    /** The phases are heights from which they fall, m. */
    static CrowdProblem ragdolls(int count) {
        return new CrowdProblem(
                "R20",
                count + " ragdolls that fall down stairs",
                JOINT_ERROR,
                10,
                DoubleStream.of(0, 0.05, 0.1)
                        .mapToObj(higher -> Assemblies.stairs(count, higher))
                        .map(Phase::new));
    }

    @Override
    public String id() {
        return id;
    }

    @Override
    public String title() {
        return title;
    }

    @Override
    public String error() {
        return isOfJoints ? "error of the joints, m" : "deepest overlap / width";
    }

    @Override
    public double equalBelow() {
        return equalBelow;
    }

    /** Few or none: turning every knob takes hours. */
    @Override
    public List<Line> lines() {
        return lines;
    }

    @Override
    public boolean isLong() {
        return true;
    }

    @Override
    public Trial set(Bench bench) {
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
        Errors errors =
                isOfJoints
                        ? Errors.of(median(crowds, CrowdWatch::jointError))
                                .with(
                                        "deepest overlap / width",
                                        median(crowds, CrowdWatch::deepest))
                        : Errors.of(median(crowds, CrowdWatch::deepest));
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
