package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Joints;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.Thrust;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.JointFrame;
import rigibo.backend.setup.JointMotor;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.Material;
import rigibo.backend.setup.SolveMethod;

import java.util.ArrayList;
import java.util.List;

/**
 * Joined bodies that have come to rest stay to the last bit, without being solved and without
 * sleep, and go on as soon as anything changes.
 */
class JointsAtRestTest {

    private static final double G = 9.81;
    private static final double DT = 1.0 / 60;
    private static final Effects EARTH =
            Effects.of(
                    new Contacts(),
                    new Rotation(),
                    new Friction(),
                    new Joints(),
                    new Thrust(),
                    new Gravity(0, -G));

    /** Assemblies that lose their energy, by a brake, a spring's damping, or an inelastic limit. */
    private enum Assembly {
        /** A bar that falls on its limit. */
        DOOR {
            @Override
            void build(Pool pool) {
                RigidBody bar = bar(pool, 0.5, 0);
                pool.join(RevoluteJoint.at(hook(pool, 0, 0), bar, 0, 0).limits(-0.7, 9));
            }
        },
        /** A bar on a damped spring. */
        SPRUNG {
            @Override
            void build(Pool pool) {
                RigidBody bar = bar(pool, 0.5, 0);
                pool.join(RevoluteJoint.at(hook(pool, 0, 0), bar, 0, 0).spring(3, 0.9));
            }
        },
        /** A cantilever of ten bars, each held by a brake that carries what hangs on it. */
        BRAKED {
            @Override
            void build(Pool pool) {
                RigidBody before = hook(pool, 0, 0);
                for (int k = 0; k < 10; k++) {
                    RigidBody bar = bar(pool, k + 0.5, 0);
                    pool.join(RevoluteJoint.at(before, bar, k, 0).motor(0, 1e6));
                    before = bar;
                }
            }
        },
        /** Planks that sag between two hooks, rub in their hinges, and carry a box. */
        BRIDGE {
            @Override
            void build(Pool pool) {
                int planks = 12;
                double step = 0.49;
                RigidBody before = hook(pool, 0, 0);
                JointFrame end = new JointFrame(0, 0, 0);
                for (int k = 0; k <= planks; k++) {
                    boolean isLast = k == planks;
                    RigidBody plank =
                            isLast
                                    ? hook(pool, step * planks, 0)
                                    : pool.add(
                                            BodyDefinition.dynamic(Polygon.box(0.5, 0.1))
                                                    .at((k + 0.5) * step, 0)
                                                    .group(1));
                    JointFrame begin = isLast ? new JointFrame(0, 0, 0) : left();
                    JointSettings brake = JointSettings.NONE.motor(new JointMotor(0, 2000));
                    pool.join(new RevoluteJoint(before, plank, end, begin, brake));
                    end = new JointFrame(0.25, 0, 0);
                    before = plank;
                }
                pool.add(BodyDefinition.dynamic(Polygon.box(0.4, 0.4)).at(step * planks / 2, 0.3));
            }

            private JointFrame left() {
                return new JointFrame(-0.25, 0, 0);
            }
        },
        /** A car on springs, parked on a slope of 0.2 rad by the brakes of its wheels. */
        CAR {
            @Override
            void build(Pool pool) {
                double slope = 0.2;
                pool.add(BodyDefinition.fixed(Polygon.box(60, 1)).angle(slope));
                double cos = Math.cos(slope);
                double sin = Math.sin(slope);
                BodyDefinition box = BodyDefinition.dynamic(Polygon.box(2, 0.4));
                RigidBody chassis = pool.add(box.at(-1.3 * sin, 1.3 * cos).angle(slope).group(1));
                for (int side = -1; side <= 1; side += 2) {
                    double x = chassis.worldX(0.7 * side, -0.4);
                    double y = chassis.worldY(0.7 * side, -0.4);
                    RigidBody wheel =
                            pool.add(
                                    BodyDefinition.dynamic(new Circle(0.3))
                                            .at(x, y)
                                            .group(1)
                                            .material(new Material(500, 0.9, 0)));
                    pool.join(
                            WheelJoint.at(chassis, wheel, x, y, slope + Math.PI / 2)
                                    .spring(4, 0.7)
                                    .motor(0, 1e5));
                }
            }
        };

        abstract void build(Pool pool);

        Pool pool(Effects effects, Accuracy accuracy) {
            Pool pool = new Pool(effects, accuracy);
            build(pool);
            return pool;
        }
    }

    private static RigidBody hook(Pool pool, double x, double y) {
        return pool.add(BodyDefinition.fixed(new Circle(0.02)).at(x, y));
    }

    private static RigidBody bar(Pool pool, double x, double y) {
        return pool.add(BodyDefinition.dynamic(Polygon.box(1, 0.1)).at(x, y).group(1));
    }

    private static void run(Pool pool, double seconds) {
        for (int i = 0; i < Math.round(seconds / DT); i++) {
            pool.step(DT);
        }
    }

    private static List<Double> state(Pool pool) {
        List<Double> state = new ArrayList<>();
        for (RigidBody body : pool.bodies()) {
            state.addAll(List.of(body.x(), body.y(), body.angle()));
            state.addAll(List.of(body.velocityX(), body.velocityY(), body.angularVelocity()));
        }
        for (Joint joint : pool.joints()) {
            state.addAll(List.of(joint.reactionForceX(), joint.reactionForceY()));
            state.add(joint.reactionTorque());
        }
        return state;
    }

    private static boolean isAtRest(Pool pool) {
        StepReport report = pool.report();
        return report.islands(SolveMethod.AT_REST) > 0
                && report.islands(SolveMethod.ELIMINATION) == 0
                && report.islands(SolveMethod.PASSES) == 0;
    }

    private static Pool rested(Assembly assembly) {
        Pool pool = assembly.pool(EARTH, Accuracy.GAME);
        run(pool, 10);
        assertThat(isAtRest(pool)).as("%s is at rest", assembly).isTrue();
        return pool;
    }

    private static double lowest(Pool pool) {
        return pool.bodies().stream().mapToDouble(RigidBody::y).min().orElseThrow();
    }

    @ParameterizedTest
    @EnumSource(Assembly.class)
    void stayToTheLastBitWithoutSleep(Assembly assembly) {
        for (Accuracy accuracy : List.of(Accuracy.GAME, Accuracy.EXACT)) {
            Pool pool = assembly.pool(EARTH, accuracy);
            run(pool, 10);
            List<Double> before = state(pool);
            for (int i = 0; i < 100; i++) {
                pool.step(DT);
                assertThat(isAtRest(pool)).as("%s step %d", accuracy, i).isTrue();
                assertThat(state(pool)).isEqualTo(before);
            }
            assertThat(pool.kineticEnergy()).isZero();
        }
    }

    @ParameterizedTest
    @EnumSource(Assembly.class)
    void goOnFromASnapshotToTheSameBits(Assembly assembly) {
        Pool pool = rested(assembly);
        Pool again = Pool.restore(pool.snapshot());
        run(pool, 0.5);
        run(again, 0.5);
        assertThat(again.stateHash()).isEqualTo(pool.stateHash());
    }

    @ParameterizedTest
    @EnumSource(Assembly.class)
    void fallAsSoonAsTheirJointsAreRemoved(Assembly assembly) {
        Pool pool = rested(assembly);
        double before = pool.potentialEnergy();
        List.copyOf(pool.joints()).forEach(pool::remove);
        run(pool, 0.5);
        assertThat(pool.potentialEnergy()).isLessThan(before);
        assertThat(isAtRest(pool)).isFalse();
    }

    @ParameterizedTest
    @EnumSource(Assembly.class)
    void fallAsleepWhereSleepIsDeclared(Assembly assembly) {
        Pool pool = assembly.pool(EARTH.with(new Sleep()), Accuracy.GAME);
        run(pool, 12);
        assertThat(pool.bodies())
                .filteredOn(body -> body.type() == BodyType.DYNAMIC)
                .noneMatch(RigidBody::isAwake);
    }

    @Test
    void aBarOnItsLimitFallsOnWhenTheLimitIsLowered() {
        Pool pool = rested(Assembly.DOOR);
        Joint hinge = pool.joints().get(0);
        hinge.limits(-1.2, 9);
        run(pool, 3);
        assertThat(hinge.angle()).isCloseTo(-1.2, within(1e-4));
        assertThat(isAtRest(pool)).isTrue();
    }

    /** The limit is 0.7 rad below: from there a motor of twice the torque needed lifts the bar. */
    @Test
    void aBarIsLiftedWhenItsMotorIsSwitchedOn() {
        Pool pool = rested(Assembly.DOOR);
        Joint hinge = pool.joints().get(0);
        hinge.motor(1, 2 * hinge.b().mass() * G * 0.5);
        run(pool, 1);
        assertThat(hinge.speed()).isCloseTo(1, within(1e-3));
    }

    /** A motor that presses its bar on a limit does not move it, however fast it would like to. */
    @Test
    void aMotorThatIsStalledRests() {
        Pool pool = rested(Assembly.DOOR);
        Joint hinge = pool.joints().get(0);
        hinge.motor(-2, 10);
        run(pool, 1);
        assertThat(hinge.angle()).isCloseTo(-0.7, within(1e-4));
        assertThat(isAtRest(pool)).isTrue();
        hinge.motor(2, 1e5);
        run(pool, 0.5);
        assertThat(hinge.speed()).isCloseTo(2, within(1e-3));
    }

    @Test
    void aBridgeIsShakenByWhatLandsOnIt() {
        Pool pool = rested(Assembly.BRIDGE);
        double before = lowest(pool);
        pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(1.5, 2));
        run(pool, 1.5);
        assertThat(lowest(pool)).isNotEqualTo(before);
    }

    /** The hook carries the weight of a bar at rest on a limit, in every step. */
    @Test
    void theReactionIsToldOfWhatRests() {
        Pool pool = rested(Assembly.DOOR);
        Joint hinge = pool.joints().get(0);
        double weight = hinge.b().mass() * G;
        for (int i = 0; i < 10; i++) {
            pool.step(DT);
            assertThat(hinge.reactionForceY()).isCloseTo(weight, within(1e-6 * weight));
            assertThat(hinge.reactionForceX()).isCloseTo(0, within(1e-6 * weight));
        }
    }

    /** At rest its load is the bar's weight: lowered below that, what it stands breaks it. */
    @Test
    void aJointThatRestsBreaksWhenItMayCarryLess() {
        Pool pool = rested(Assembly.DOOR);
        Joint hinge = pool.joints().get(0);
        hinge.breaking(0.99 * hinge.b().mass() * G, Double.POSITIVE_INFINITY);
        pool.step(DT);
        assertThat(hinge.isAlive()).isFalse();
        assertThat(pool.brokenJoints()).hasSize(1);
    }

    /**
     * A force of a millionth of what holds it moves a bead that nothing holds along its rail: v =
     * F·t/m.
     */
    @Test
    void aWeakPushMovesABeadOnItsRail() {
        Pool pool = new Pool(EARTH, Accuracy.GAME);
        RigidBody bead = pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(0, 0));
        pool.join(PrismaticJoint.along(hook(pool, 0, 0), bead, 0, 0, 0));
        run(pool, 1);
        assertThat(isAtRest(pool)).isTrue();
        double force = 1e-6 * bead.mass() * G;
        for (int i = 0; i < 60; i++) {
            bead.applyForce(force, 0, bead.x(), bead.y());
            pool.step(DT);
        }
        assertThat(bead.velocityX()).isCloseTo(1e-6 * G, within(1e-8 * G));
    }
}
