package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;
import rigibo.lab.bench.scene.Commotions;
import rigibo.lab.bench.scene.Scene;

import java.util.List;
import java.util.function.IntFunction;
import java.util.function.Predicate;

/**
 * Crowds under a belt, in a shaken box, of thin rods, of towers that are pushed. Truth: nobody
 * leaves, bodies overlap no deeper than in a crowd that rains, and all energy is that of the start
 * and the work of what is driven.
 */
final class DrivenCrowd implements HardCase {

    private static final int FEW_BODIES = 100;

    private final String name;
    private final IntFunction<Scene> scene;
    private final double horizon;
    private final Predicate<StagedScene> isKept;
    private final List<Integer> few;
    private final List<Integer> all;

    private DrivenCrowd(
            String name,
            IntFunction<Scene> scene,
            double horizon,
            Predicate<StagedScene> isKept,
            List<Integer> few,
            List<Integer> all) {
        this.name = name;
        this.scene = scene;
        this.horizon = horizon;
        this.isKept = isKept;
        this.few = few;
        this.all = all;
    }

    /** Of towers, of a box that is shaken and of rods. */
    static List<HardCase> held() {
        return List.of(
                new DrivenCrowd(
                        "shaken",
                        Commotions::shaken,
                        5,
                        DrivenCrowd::isInTheBox,
                        List.of(12),
                        List.of(12, 61, 100)),
                new DrivenCrowd(
                        "rods",
                        Commotions::rods,
                        8,
                        DrivenCrowd::isAboveTheFloor,
                        List.of(41),
                        List.of(41, 140, 300)),
                new DrivenCrowd(
                        "towers",
                        storeys -> Commotions.towers(storeys / 4, storeys),
                        8,
                        DrivenCrowd::isAboveTheFloor,
                        List.of(9),
                        List.of(9, 17, 30)));
    }

    /** Of a belt, in which bodies sink in. */
    static List<HardCase> open() {
        return List.of(
                new DrivenCrowd(
                        "belt",
                        Commotions::belt,
                        10,
                        DrivenCrowd::isBeforeTheWall,
                        List.of(24),
                        List.of(24, 52, 80)));
    }

    @Override
    public String row() {
        return "M13/" + name;
    }

    @Override
    public String title() {
        return "nobody leaves a crowd that is driven (" + name + "), and no energy comes in unseen";
    }

    @Override
    public String finding() {
        return name.equals("belt") || name.equals("rods")
                ? "What lands on what others press sinks in where passes leave off at DRAFT; a rod"
                        + " is thin, so that the same depth is more of its width."
                : "";
    }

    @Override
    public void run(Trial trial) {
        for (int size : trial.sampling().of(few, all)) {
            trial.variant("of " + size);
            StagedScene stage = new StagedScene(trial, scene.apply(size));
            RigidBody first = stage.bodies().get(0);
            if (first.type() == BodyType.KINEMATIC) {
                CarrierWork work = new CarrierWork(stage.pool(), first);
                stage.pool().countWork(work::ofStep);
            }
            boolean isAlwaysKept = true;
            while (stage.pool().time() < horizon) {
                stage.step();
                isAlwaysKept &= isKept.test(stage);
            }
            double most = stage.dynamic().size() <= FEW_BODIES ? 0.02 : 0.05;
            Limits limits = new Limits(0.5, most, most);
            trial.measure("deepest overlap", stage.pool().deepestShare(), "width", limits);
            trial.measure("left", isAlwaysKept ? 0 : 1, "crowds", Limits.same(0));
        }
    }

    private static boolean isAboveTheFloor(StagedScene stage) {
        return stage.dynamic().stream().allMatch(body -> body.y() > 0);
    }

    private static boolean isBeforeTheWall(StagedScene stage) {
        RigidBody wall = stage.bodies().get(1);
        return isAboveTheFloor(stage)
                && stage.dynamic().stream().allMatch(body -> body.x() < wall.x());
    }

    /** Between the middles of its walls: floor, ceiling, left, right. */
    private static boolean isInTheBox(StagedScene stage) {
        List<RigidBody> walls = stage.bodies();
        return stage.dynamic().stream()
                .allMatch(
                        body ->
                                body.y() > walls.get(0).y()
                                        && body.y() < walls.get(1).y()
                                        && body.x() > walls.get(2).x()
                                        && body.x() < walls.get(3).x());
    }
}
