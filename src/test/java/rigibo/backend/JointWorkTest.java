package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

/** The work of joined bodies whose impulses are not unique; it is counted, not timed. */
@Execution(ExecutionMode.CONCURRENT)
class JointWorkTest {

    /**
     * A bridge as long as its span under discs: no force holds it straight, so that its tension has
     * no bounds and it trembles faster than any kick follows. Its two equations for each of 41
     * hinges and four rows for each of 10 discs have an envelope some six wide, of which a factor
     * and a solution take 25 multiplications each: 3,000 an elimination. Two kicks a step, three
     * where discs roll fast, of three eliminations each are 27,000.
     */
    @Test
    void straightBridgeUnderALoadStaysClosedWithFewKicks() {
        Pool pool = straightBridge();
        for (int i = 0; i < 10; i++) {
            pool.add(BodyDefinition.dynamic(new Circle(0.25)).at(1.01 * i - 5, 2));
        }
        // A hundredth of a plank's height.
        assertThat(workPerStep(pool, 300, 60, 1.25e-3)).isLessThan(27_000);
    }

    /**
     * Before anything touches the bridge it cannot move. Two kicks a step with three eliminations
     * each take 18,000 multiplications. It took 390,000 to follow what its joints are off by.
     */
    @Test
    void straightBridgeThatNothingTouchesIsStill() {
        Pool pool = straightBridge();
        assertThat(workPerStep(pool, 60, 15, 1e-4)).isLessThan(18_000);
        assertThat(pool.bodies())
                .allSatisfy(plank -> assertThat(Math.abs(plank.velocityY())).isLessThan(0.01));
    }

    /**
     * Multiplications a step of so many steps, but for the first ones; joints are never off by as
     * much as that, m.
     */
    private static double workPerStep(Pool pool, int steps, int leftOut, double error) {
        double work = 0;
        for (int i = 0; i < steps; i++) {
            StepReport report = pool.step(Scenes.DT);
            work += i < leftOut ? 0 : report.multiplications();
            assertThat(worstError(pool)).as("m after step %d", i).isLessThan(error);
        }
        return work / (steps - leftOut);
    }

    private static double worstError(Pool pool) {
        return pool.joints().stream().mapToDouble(Joint::error).max().orElseThrow();
    }

    /** Forty planks between two ends. */
    private static Pool straightBridge() {
        Pool pool = new Pool(JointScenes.ROUGH_EARTH, Accuracy.GAME);
        RigidBody before = pool.add(BodyDefinition.fixed(new Circle(0.05)).at(-10.05, 0));
        for (int i = 0; i < 40; i++) {
            double x = 0.5 * i - 10;
            RigidBody plank =
                    pool.add(BodyDefinition.dynamic(Polygon.box(0.5, 0.125)).at(x + 0.25, 0));
            pool.join(RevoluteJoint.at(before, plank, x, 0));
            before = plank;
        }
        RigidBody last = pool.add(BodyDefinition.fixed(new Circle(0.05)).at(10.05, 0));
        pool.join(RevoluteJoint.at(before, last, 10, 0));
        return pool;
    }

    /**
     * Ragdolls on each other, whose brakes hold them like single pieces, lie on more points than
     * statics tells the loads of. All rows of two of them take 15,000 multiplications to eliminate;
     * five kicks a step of eight eliminations each are 600,000. Sets of rows that followed each
     * other without an end took 2.6 million.
     */
    @ParameterizedTest
    @CsvSource({"2, 600000", "3, 900000"})
    void heapOfRagdollsTakesFewEliminations(int count, double most) {
        Pool pool = heapOfRagdolls(count, 0);
        int steps = 900;
        double work = 0;
        for (int i = 0; i < steps; i++) {
            work += pool.step(Scenes.DT).multiplications();
        }
        assertThat(work / steps).isLessThan(most);
    }

    /**
     * The second doll a few millimetres aside. Braked dolls that come to stand rock on their feet,
     * a handbreadth apart under a metre of height: a landing takes a few hundredths of the motion,
     * and that takes more than half a minute. Heaps that crept by some 20 µm/s never came to rest.
     */
    @ParameterizedTest
    @CsvSource({"2, 0", "2, 1", "2, 5", "2, 6", "2, 8", "2, 11", "3, 0"})
    void heapOfRagdollsComesToRestWhereverItFalls(int count, int millimetres) {
        Pool pool = heapOfRagdolls(count, millimetres * 1e-3);
        int steps = 0;
        while (steps < 3600 && pool.bodies().stream().anyMatch(RigidBody::isAwake)) {
            pool.step(Scenes.DT);
            steps++;
        }
        assertThat(pool.bodies()).noneMatch(RigidBody::isAwake);
    }

    private static Pool heapOfRagdolls(int count, double aside) {
        Pool pool = new Pool(JointScenes.ROUGH_EARTH, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5));
        for (int i = 0; i < count; i++) {
            double x = 0.3 * (i % 3) + (i == 1 ? aside : 0);
            JointScenes.addRagdoll(pool, x, 2 + 2.2 * i);
        }
        return pool;
    }

    /** More limits in an island than any before it had: boxes in a row, hinged to each other. */
    @Test
    void rowOfManyLimitsRests() {
        Pool pool = new Pool(JointScenes.ROUGH_EARTH, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5));
        RigidBody before = null;
        for (int i = 0; i < 30; i++) {
            RigidBody box =
                    pool.add(BodyDefinition.dynamic(Polygon.box(0.5, 0.5)).at(0.5 * i - 7, 0.25));
            if (before != null) {
                pool.join(RevoluteJoint.at(before, box, 0.5 * i - 7.25, 0.25).limits(-0.8, 0.8));
            }
            before = box;
        }
        for (int i = 0; i < 180; i++) {
            pool.step(Scenes.DT);
        }
        assertThat(pool.bodies()).noneMatch(RigidBody::isAwake);
    }

    /**
     * A track of forty links round three driven wheels: between hinges, wheels and ground friction
     * has no unique answer, and sets of rows follow each other without an end. An island of a game
     * is worth 4 million multiplications a step. The last elimination may exceed that: L·U of 200
     * rows in an envelope of up to 60 takes n·w² = 0.7 million, and so does what is solved in
     * passes in the rest of the step. It took 32 million, 0.1 s. The track still drives its load.
     */
    @Test
    void trackRoundDrivenWheelsKeepsToItsBudget() {
        Pool pool = new Pool(JointScenes.ROUGH_EARTH, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(60, 1)).at(20, -0.5));
        RigidBody hull = trackedVehicle(pool, 40);
        for (int i = 0; i < 240; i++) {
            assertThat(pool.step(Scenes.DT).multiplications()).as("step %d", i).isLessThan(5.4e6);
            assertThat(worstError(pool)).as("m after step %d", i).isLessThan(1e-3);
        }
        // Wheels of 0.4 m at 6 rad/s, a second of which the motors accelerate.
        assertThat(hull.x()).isBetween(0.4 * 6 * 2.0, 0.5 * 6 * 4.0);
        assertThat(Math.abs(hull.angle())).isLessThan(0.1);
    }

    /** A hull on three driven wheels with a track of so many links around them. */
    private static RigidBody trackedVehicle(Pool pool, int links) {
        double radius = 0.4;
        double length = 1.1;
        double height = 0.65;
        RigidBody hull =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(2, 0.3))
                                .at(0, height)
                                .mass(50)
                                .group(-1));
        for (int i = -1; i <= 1; i++) {
            RigidBody wheel =
                    pool.add(
                            BodyDefinition.dynamic(new Circle(radius))
                                    .at(i * length, height)
                                    .mass(5)
                                    .group(-1));
            pool.join(RevoluteJoint.at(hull, wheel, i * length, height).motor(-6, 80));
        }
        double round = radius + 0.1;
        double each = (4 * length + 2 * Math.PI * round) / links;
        double[] x = new double[links + 1];
        double[] y = new double[links + 1];
        for (int i = 0; i <= links; i++) {
            double way = i % links * each;
            boolean isBack = way >= 2 * length + Math.PI * round;
            double along = isBack ? way - 2 * length - Math.PI * round : way;
            double angle = Math.max(0, (along - 2 * length) / round);
            double sign = isBack ? -1 : 1;
            x[i] = sign * (Math.min(along, 2 * length) - length + round * Math.sin(angle));
            y[i] = height + sign * round * Math.cos(angle);
        }
        RigidBody[] track = new RigidBody[links];
        for (int i = 0; i < links; i++) {
            double dx = x[i + 1] - x[i];
            double dy = y[i + 1] - y[i];
            track[i] =
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(0.8 * Math.hypot(dx, dy), 0.1))
                                    .at((x[i] + x[i + 1]) / 2, (y[i] + y[i + 1]) / 2)
                                    .angle(Math.atan2(dy, dx))
                                    .mass(0.8)
                                    .group(-2));
        }
        for (int i = 0; i < links; i++) {
            RigidBody next = track[(i + 1) % links];
            pool.join(RevoluteJoint.at(track[i], next, x[i + 1], y[i + 1]));
        }
        return hull;
    }
}
