package rigibo.backend.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Quarantine;

import java.util.Arrays;

/** The work of a step on every moving body, with and without rotation. */
class StepBodiesTest {

    private static final double DT = 0.25;

    /** m/s and rad/s: anything slower is bounded. */
    private static final double FASTEST = Quarantine.FASTEST;

    /** A fixed, a driven, an awake, a sleeping and another awake body, as a step lists them. */
    private static final class Five {

        final DataStorage data;
        final Bodies bodies;
        final StepBodies listed;
        final int driven;
        final int first;
        final int sleeper;
        final int second;

        Five(Effect... effects) {
            data = new DataStorage(Effects.of(effects));
            bodies = data.bodies;
            listed = new StepBodies(data);
            body(BodyType.STATIC, false);
            driven = body(BodyType.KINEMATIC, false);
            first = body(BodyType.DYNAMIC, true);
            sleeper = body(BodyType.DYNAMIC, false);
            second = body(BodyType.DYNAMIC, true);
            bodies.velocityX[driven] = 2;
            bodies.velocityY[driven] = -4;
        }

        private int body(BodyType type, boolean isAwake) {
            int slot = bodies.take();
            bodies.type[slot] = type;
            bodies.awake[slot] = isAwake;
            bodies.x[slot] = slot;
            bodies.y[slot] = -slot;
            bodies.angle[slot] = 0.5;
            bodies.aim(slot);
            return slot;
        }

        /** Accepts, moves the first body away, and does to it what is to be found. */
        int[] quarantinedAfter(Runnable change) {
            listed.accept(DT);
            bodies.x[first] += 10;
            bodies.y[first] += 20;
            bodies.angle[first] += 1;
            bodies.aim(first);
            change.run();
            listed.quarantine(DT);
            return Arrays.copyOf(data.counters.quarantined, data.counters.quarantinedCount);
        }
    }

    private final Five five = new Five(new Contacts(), new Rotation());
    private final Five plain = new Five();

    @Test
    void acceptsWhatIsAwakeOrDrivenInTheOrderOfSlots() {
        five.listed.accept(DT);
        assertThat(Arrays.copyOf(five.data.roster.awake, five.data.roster.awakeCount))
                .containsExactly(five.driven, five.first, five.second);
    }

    /** A list that nothing has changed is not made anew: sleepers cost nothing. */
    @Test
    void acceptsAnewOnlyWhenSomethingChanged() {
        five.listed.accept(DT);
        five.bodies.awake[five.sleeper] = true;
        five.listed.accept(DT);
        assertThat(five.data.roster.awakeCount).isEqualTo(3);
        five.data.roster.isStale = true;
        five.listed.accept(DT);
        assertThat(five.data.roster.awakeCount).isEqualTo(4);
    }

    @Test
    void remembersWhereEachBegins() {
        five.listed.accept(DT);
        for (int slot : new int[] {five.driven, five.first, five.second}) {
            assertThat(five.bodies.startX[slot]).isEqualTo(slot);
            assertThat(five.bodies.startY[slot]).isEqualTo(-slot);
            assertThat(five.bodies.startAngle[slot]).isEqualTo(0.5);
        }
        plain.listed.accept(DT);
        assertThat(plain.bodies.startX[plain.second]).isEqualTo(plain.second);
        assertThat(plain.bodies.startY[plain.second]).isEqualTo(-plain.second);
    }

    @Test
    void takesAllForFlyersButSleepers() {
        five.listed.accept(DT);
        for (int slot : new int[] {five.first, five.sleeper, five.second}) {
            five.bodies.piled[slot] = true;
            five.bodies.pileTime[slot] = 0.1;
        }
        five.listed.scatter(DT);
        for (int slot : new int[] {five.first, five.second}) {
            assertThat(five.bodies.piled[slot]).isFalse();
            assertThat(five.bodies.pileTime[slot]).isZero();
        }
        assertThat(five.bodies.piled[five.sleeper]).isTrue();
    }

    /** A sleeper's tell who leans on whom: they stay. */
    @Test
    void beginsWithNoAccelerationButOfSleepers() {
        for (Five each : new Five[] {five, plain}) {
            each.bodies.integratePaths(true);
            each.listed.accept(DT);
            Arrays.fill(each.bodies.accelerationX, 1);
            Arrays.fill(each.bodies.accelerationY, 2);
            Arrays.fill(each.bodies.pullX, 3);
            each.listed.clearAccelerations(DT);
            for (int slot : new int[] {each.driven, each.first, each.second}) {
                assertThat(each.bodies.accelerationX[slot]).isZero();
                assertThat(each.bodies.accelerationY[slot]).isZero();
                assertThat(each.bodies.pullX[slot]).isZero();
            }
            assertThat(each.bodies.accelerationX[each.sleeper]).isEqualTo(1);
        }
    }

    @Test
    void beginsWithNoAngularAcceleration() {
        five.listed.accept(DT);
        Arrays.fill(five.bodies.angularAcceleration, 3);
        five.listed.clearAccelerations(DT);
        assertThat(five.bodies.angularAcceleration[five.first]).isZero();
        assertThat(five.bodies.angularAcceleration[five.second]).isZero();
        assertThat(five.bodies.angularAcceleration[five.sleeper]).isEqualTo(3);
    }

    /** 2 and −4 m/s for ¼ s. */
    @Test
    void movesWhatIsDrivenAsTold() {
        for (Five each : new Five[] {five, plain}) {
            each.bodies.velocityX[each.first] = 7;
            each.listed.accept(DT);
            each.listed.moveDriven(DT);
            assertThat(each.bodies.x[each.driven]).isEqualTo(each.driven + 0.5);
            assertThat(each.bodies.y[each.driven]).isEqualTo(-each.driven - 1);
            assertThat(each.bodies.x[each.first]).isEqualTo(each.first);
            assertThat(each.bodies.y[each.first]).isEqualTo(-each.first);
        }
    }

    /** 2 rad/s for ¼ s, with its cosine and sine. */
    @Test
    void turnsWhatIsDrivenAsTold() {
        five.bodies.spin[five.driven] = 2;
        five.bodies.spin[five.first] = 2;
        five.listed.accept(DT);
        five.listed.moveDriven(DT);
        assertThat(five.bodies.angle[five.driven]).isEqualTo(1);
        assertThat(five.bodies.cos[five.driven]).isEqualTo(Math.cos(1), within(1e-15));
        assertThat(five.bodies.sin[five.driven]).isEqualTo(Math.sin(1), within(1e-15));
        assertThat(five.bodies.angle[five.first]).isEqualTo(0.5);
    }

    @Test
    void whatIsBoundedGoesOn() {
        double fast = 0.9 * FASTEST;
        for (Five each : new Five[] {five, plain}) {
            assertThat(
                            each.quarantinedAfter(
                                    () -> {
                                        each.bodies.velocityX[each.first] = -fast;
                                        each.bodies.velocityY[each.first] = fast;
                                        each.bodies.x[each.second] = -Double.MAX_VALUE;
                                        each.bodies.accelerationX[each.second] = fast / DT;
                                        each.bodies.accelerationY[each.second] = -fast / DT;
                                    }))
                    .isEmpty();
            assertThat(each.bodies.velocityX[each.first]).isEqualTo(-fast);
            assertThat(each.bodies.x[each.first]).isEqualTo(each.first + 10);
        }
    }

    private static void requireAtRestAtItsStart(Five five) {
        Bodies bodies = five.bodies;
        int slot = five.first;
        assertThat(bodies.x[slot]).isEqualTo(slot);
        assertThat(bodies.y[slot]).isEqualTo(-slot);
        assertThat(bodies.velocityX[slot]).isZero();
        assertThat(bodies.velocityY[slot]).isZero();
        assertThat(bodies.accelerationX[slot]).isZero();
        assertThat(bodies.accelerationY[slot]).isZero();
    }

    private void requireQuarantine(String column, double value) {
        for (Five each : new Five[] {five, plain}) {
            assertThat(each.quarantinedAfter(() -> column(each.bodies, column)[each.first] = value))
                    .as("%s is %s", column, value)
                    .containsExactly(each.first);
            requireAtRestAtItsStart(each);
        }
        assertThat(five.bodies.angle[five.first]).isEqualTo(0.5);
        assertThat(five.bodies.cos[five.first]).isEqualTo(Math.cos(0.5), within(1e-15));
    }

    private static double[] column(Bodies bodies, String name) {
        return switch (name) {
            case "x" -> bodies.x;
            case "y" -> bodies.y;
            case "velocityX" -> bodies.velocityX;
            case "velocityY" -> bodies.velocityY;
            case "accelerationX" -> bodies.accelerationX;
            case "accelerationY" -> bodies.accelerationY;
            default -> throw new IllegalArgumentException(name);
        };
    }

    @ParameterizedTest
    @ValueSource(strings = {"x", "y", "velocityX", "velocityY", "accelerationX", "accelerationY"})
    void whatIsNoNumberGoesBackToItsStart(String column) {
        requireQuarantine(column, Double.NaN);
    }

    @ParameterizedTest
    @ValueSource(strings = {"x", "y", "velocityX", "velocityY", "accelerationX", "accelerationY"})
    void whatIsInfiniteGoesBackToItsStart(String column) {
        requireQuarantine(column, Double.NEGATIVE_INFINITY);
    }

    /** A step of ¼ s at an acceleration adds a quarter of it; either sign. */
    @ParameterizedTest
    @CsvSource({"velocityX, 1", "velocityY, -1", "accelerationX, -4.01", "accelerationY, 4.01"})
    void whatIsTooFastGoesBackToItsStart(String column, double times) {
        requireQuarantine(column, times * FASTEST);
    }

    /** 0.6 + 0.6 of what is allowed, the one now and the other by the end of the step. */
    @ParameterizedTest
    @ValueSource(ints = {1, -1})
    void velocityAndWhatTheStepAddsCountTogether(int sign) {
        assertThat(
                        plain.quarantinedAfter(
                                () -> {
                                    plain.bodies.velocityX[plain.first] = sign * 0.6 * FASTEST;
                                    plain.bodies.accelerationX[plain.first] = 2.4 * FASTEST;
                                    plain.bodies.velocityY[plain.second] = sign * 0.6 * FASTEST;
                                    plain.bodies.accelerationY[plain.second] = 2.4 * FASTEST;
                                }))
                .containsExactly(plain.first, plain.second);
    }

    /** Spin and acceleration in shares of what is allowed; a step of ¼ s adds a quarter. */
    @ParameterizedTest
    @CsvSource({
        "NaN, 0, 0.5",
        "0, NaN, 0.5",
        "0, 0, NaN",
        "0, 0, Infinity",
        "0, 0, -Infinity",
        "1, 0, 0.5",
        "-1, 0, 0.5",
        "0, 4, 0.5",
        "0, -4, 0.5",
        "0.6, 2.4, 0.5",
        "-0.6, 2.4, 0.5"
    })
    void whatTurnsBeyondAllBoundsGoesBackToItsStart(double spin, double turn, double angle) {
        int slot = five.first;
        assertThat(
                        five.quarantinedAfter(
                                () -> {
                                    five.bodies.spin[slot] = spin * FASTEST;
                                    five.bodies.angularAcceleration[slot] = turn * FASTEST;
                                    five.bodies.angle[slot] = angle;
                                }))
                .containsExactly(slot);
        requireAtRestAtItsStart(five);
        assertThat(five.bodies.spin[slot]).isZero();
        assertThat(five.bodies.angularAcceleration[slot]).isZero();
        assertThat(five.bodies.angle[slot]).isEqualTo(0.5);
        assertThat(five.bodies.sin[slot]).isEqualTo(Math.sin(0.5), within(1e-15));
    }

    @Test
    void whatTurnsWithinBoundsGoesOn() {
        assertThat(
                        five.quarantinedAfter(
                                () -> {
                                    five.bodies.spin[five.first] = -0.9 * FASTEST;
                                    five.bodies.angularAcceleration[five.second] = 3.6 * FASTEST;
                                    five.bodies.angle[five.second] = -1e300;
                                }))
                .isEmpty();
        assertThat(five.bodies.spin[five.first]).isEqualTo(-0.9 * FASTEST);
    }

    /** In the order of their slots, whether it is moving or turning that has gone wrong. */
    @Test
    void everyBodyIsNamedOnceInTheOrderOfSlots() {
        int[] found =
                five.quarantinedAfter(
                        () -> {
                            five.bodies.velocityX[five.driven] = Double.NaN;
                            five.bodies.spin[five.first] = Double.NaN;
                            five.bodies.velocityX[five.first] = Double.NaN;
                            five.bodies.velocityX[five.second] = Double.NaN;
                        });
        assertThat(found).containsExactly(five.driven, five.first, five.second);
    }
}
