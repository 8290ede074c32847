package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

/** Islands of many joints: they stay closed, gain no energy, and come to rest. */
@Execution(ExecutionMode.CONCURRENT)
class JointCrowdsTest {

    /** Share of the start's energy that sums over all bodies may lose to rounding. */
    private static final double ROUND_OFF = 1e-9;

    /**
     * Multiplications of a step: of twenty ragdolls each may take 64 eliminations of its rows, of
     * some 12,000 multiplications, in each of 5 kicks.
     */
    private static final double MOST_MULTIPLICATIONS = 1e8;

    /** Rows that passes solve in a step: a million, made twice at most, in 5 kicks for 4. */
    private static final long MOST_SOLVES = 2_500_000;

    private static double worstError(Pool pool) {
        return pool.joints().stream().mapToDouble(Joint::error).max().orElse(0);
    }

    /** Runs so many steps and holds what every step owes; answers the worst error seen, m. */
    private static double run(Pool pool, int steps) {
        double start = JointScenes.energy(pool);
        double worst = 0;
        for (int i = 0; i < steps; i++) {
            StepReport report = pool.step(Scenes.DT);
            assertThat(JointScenes.energy(pool))
                    .as("J after step %d", i)
                    .isLessThanOrEqualTo(start * (1 + ROUND_OFF));
            assertThat(report.multiplications()).isLessThan(MOST_MULTIPLICATIONS);
            assertThat(report.contactSolves()).isLessThan(MOST_SOLVES);
            assertThat(report.quarantined()).isZero();
            worst = Math.max(worst, worstError(pool));
        }
        return worst;
    }

    /** Joints may gape by a millimetre, wherever the bodies fall. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 4, 6, 7, 9, 11})
    void jointsOfRagdollsThatFallHold(int millimetres) {
        Pool pool = fallingRagdolls(millimetres);
        assertThat(run(pool, 180)).isLessThan(1e-3);
        assertThat(pool.bodies()).allSatisfy(body -> assertThat(body.x() + body.y()).isFinite());
    }

    /** Twenty ragdolls in the air, of which some start so many millimetres farther on. */
    private static Pool fallingRagdolls(int millimetres) {
        Pool pool = new Pool(JointScenes.ROUGH_EARTH, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5));
        for (int i = 0; i < 20; i++) {
            double x = 2 * (i % 5) - 4 + 0.3 * (i / 5) + 1e-3 * millimetres * (i % 3);
            JointScenes.addRagdoll(pool, x, 2 + 2.2 * (i / 5));
        }
        return pool;
    }

    /**
     * A net of 30 × 30 discs with hinges between them that hangs by its upper corners. It could
     * only sag by turning neighbours against each other, which would make it narrower, and the
     * corners do not come nearer: it stays.
     */
    @Test
    void stretchedNetStaysWhereItHangs() {
        Pool pool = new Pool(JointScenes.ROUGH_EARTH, Accuracy.GAME);
        int side = 30;
        RigidBody[][] knots = new RigidBody[side][side];
        for (int row = 0; row < side; row++) {
            for (int column = 0; column < side; column++) {
                BodyDefinition knot =
                        row == 0 && column % (side - 1) == 0
                                ? BodyDefinition.fixed(new Circle(0.1))
                                : BodyDefinition.dynamic(new Circle(0.1));
                knots[row][column] = pool.add(knot.at(0.5 * column, 20 - 0.5 * row).group(1));
                RigidBody here = knots[row][column];
                if (column > 0) {
                    RigidBody left = knots[row][column - 1];
                    pool.join(RevoluteJoint.at(left, here, here.x() - 0.25, here.y()));
                }
                if (row > 0) {
                    RigidBody above = knots[row - 1][column];
                    pool.join(RevoluteJoint.at(above, here, here.x(), here.y() + 0.25));
                }
            }
        }
        assertThat(run(pool, 60)).isLessThan(1e-6);
        assertThat(knots[side - 1][side / 2].y()).isCloseTo(20 - 0.5 * (side - 1), within(1e-6));
    }

    /**
     * A straight bridge of planks between two fixed ends, as long as its span, on which discs fall.
     * Nothing pushes it upwards as long as it is straight, and the least way down asks of its
     * hinges for more than any force: an equation that no elimination answers with a sensible
     * number. Whatever it does, nothing drives it, and its hinges gape by no more than a fiftieth
     * of a plank's height, as bodies may overlap: discs that nobody stops in time land some
     * centimetres deep.
     */
    @ParameterizedTest
    @CsvSource({
        "DRAFT, 12", "DRAFT, 20", "DRAFT, 40", "DRAFT, 60",
        "GAME, 12", "GAME, 40", "GAME, 60", "FINE, 20"
    })
    void straightBridgeStaysClosedAndGainsNoEnergy(Preset preset, int planks) {
        Pool pool = new Pool(JointScenes.ROUGH_EARTH, preset.accuracy);
        double left = -0.25 * planks;
        RigidBody before = pool.add(BodyDefinition.fixed(new Circle(0.05)).at(left - 0.05, 8));
        for (int i = 0; i < planks; i++) {
            double x = left + 0.5 * i;
            RigidBody plank = JointScenes.bone(pool, x + 0.25, 8, 0.5, 0.125);
            pool.join(RevoluteJoint.at(before, plank, x, 8));
            before = plank;
        }
        RigidBody last = pool.add(BodyDefinition.fixed(new Circle(0.05)).at(0.05 - left, 8));
        pool.join(RevoluteJoint.at(before, last, -left, 8));
        for (int i = 0; i < planks / 4; i++) {
            double x = left / 2 + 1.01 * i;
            pool.add(BodyDefinition.dynamic(new Circle(0.25)).at(x, 10));
        }
        assertThat(run(pool, 120)).isLessThan(2.5e-3);
    }

    /**
     * A door of three equations (two of its hinge, one of its spring) takes two kicks a step: its
     * spin of 2 rad/s and its spring of 1 Hz are 0.1 rad of a step, where 0.25 may lie in a
     * substep. A factor takes 3 multiplications at most, a solution 12; five solutions are one of
     * either kick, two of Newton's steps and one to take errors back. The six kicks of a composed
     * step would take 90 at least.
     */
    @Test
    void doorOnADampedSpringTakesTwoKicksAStep() {
        Pool pool =
                new Pool(Effects.of(new Contacts(), new Rotation(), new Joints()), Accuracy.GAME);
        RigidBody frame = pool.add(BodyDefinition.fixed(Polygon.box(0.2, 0.2)).at(0, 0));
        RigidBody door =
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(2, 0.2))
                                .at(1.1, 0)
                                .velocity(0, 2.2)
                                .spin(2));
        pool.join(RevoluteJoint.at(frame, door, 0, 0).limits(-2, 2));
        pool.join(DistanceJoint.rod(frame, 0, -1, door, 1.1, 0).spring(1, 0.7));
        for (int i = 0; i < 60; i++) {
            assertThat(pool.step(Scenes.DT).multiplications()).isBetween(1.0, 2 * 3 + 5 * 12.0);
        }
    }

    /**
     * A bridge in space, as long as its span but for hinges that are each off by a hundredth of a
     * millimetre, and so long that it is a crowd. It sags by a millimetre, so that closing its 200
     * hinges along it moves its middle across: by the circle's segment √(L·n·e/2) in all, 0.3 m.
     * Planks go no farther than four times what all hinges are off together.
     */
    @Test
    void closingATautBridgeDoesNotThrowIt() {
        Pool pool = new Pool(JointScenes.SPACE, Accuracy.GAME);
        int planks = 200;
        double plank = 0.5;
        double off = 1e-5;
        double sag = 1e-3;
        RigidBody before = pool.add(BodyDefinition.fixed(new Circle(0.05)).at(0, 0.2));
        for (int i = 0; i < planks; i++) {
            RigidBody next =
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(plank, 0.125))
                                    .at((i + 0.5) * plank, 0));
            pool.join(RevoluteJoint.at(before, next, i * plank, 0));
            before = next;
        }
        RigidBody end = pool.add(BodyDefinition.fixed(new Circle(0.05)).at(planks * plank, 0.2));
        pool.join(RevoluteJoint.at(before, end, planks * plank, 0));
        double[] y = new double[planks + 2];
        for (int i = 1; i <= planks; i++) {
            double share = (i - 0.5) / planks;
            y[i] = -4 * sag * share * (1 - share);
            double slope = -4 * sag * (1 - 2 * share) / (planks * plank);
            RigidBody body = pool.bodies().get(i);
            body.moveTo(body.x() + i * off, y[i], Math.atan(slope));
        }
        end.moveTo(end.x() + (planks + 1) * off, end.y(), 0);
        double bottom = y[planks / 2] - 0.0625;
        pool.add(BodyDefinition.fixed(Polygon.box(0.2, 0.2)).at(50.25, bottom - 0.1));
        pool.step(Scenes.DT);
        double most = 4 * (planks + 1) * off;
        for (int i = 1; i <= planks; i++) {
            assertThat(pool.bodies().get(i).y()).isCloseTo(y[i], within(most));
        }
    }
}
