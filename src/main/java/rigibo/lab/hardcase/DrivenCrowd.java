package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;
import rigibo.lab.bench.scene.Commotions;
import rigibo.lab.bench.scene.Scene;

import java.util.List;
import java.util.function.IntFunction;
import java.util.function.Predicate;

/**
 * Crowds on a belt, in a shaken box, of thin rods, of towers that are pushed. Truth: no body
 * leaves, overlap stays as small as in a crowd that rains, and all energy comes from the start and
 * the work of the drive.
 *
 * @param scene by its size
 * @param horizon s
 * @param isKept whether nobody has left
 * @param few sizes that are tried as a rule
 * @param all sizes
 */
record DrivenCrowd(
        IntFunction<Scene> scene,
        double horizon,
        Predicate<StagedScene> isKept,
        List<Integer> few,
        List<Integer> all)
        implements Scenes {

    static final DrivenCrowd SHAKEN =
            new DrivenCrowd(
                    Commotions::shaken,
                    5,
                    DrivenCrowd::isInTheBox,
                    List.of(12),
                    List.of(12, 61, 100));

    static final DrivenCrowd RODS =
            new DrivenCrowd(
                    Commotions::rods,
                    8,
                    DrivenCrowd::isAboveTheFloor,
                    List.of(41),
                    List.of(41, 140, 300));

    static final DrivenCrowd TOWERS =
            new DrivenCrowd(
                    storeys -> Commotions.towers(storeys / 4, storeys),
                    8,
                    DrivenCrowd::isAboveTheFloor,
                    List.of(9),
                    List.of(9, 17, 30));

    static final DrivenCrowd BELT =
            new DrivenCrowd(
                    Commotions::belt,
                    10,
                    DrivenCrowd::isBeforeTheWall,
                    List.of(24),
                    List.of(24, 52, 80));

    private static final int FEW_BODIES = 100;

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
            trial.measure("left", isAlwaysKept ? 0 : 1, "crowds", 0);
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

    /** Whether every body is between the middles of the walls: floor, ceiling, left, right. */
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
