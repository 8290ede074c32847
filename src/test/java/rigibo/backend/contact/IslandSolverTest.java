package rigibo.backend.contact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.collision.Narrowphase;
import rigibo.backend.contact.row.StoredIsland;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.ContactSolver;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Bodies;

import java.util.function.UnaryOperator;

/** Islands written by hand into the columns: boxes of 1 m and 1 kg on a floor. */
class IslandSolverTest {

    private static final double DT = 1.0 / 60;
    private static final double G = 9.81;
    private static final Effects EFFECTS =
            Effects.of(new Contacts(), new Rotation(), new Friction(), new Restitution());
    private static final Material ROUGH = new Material(1, 0.5, 0);

    private final StoredIsland island = new StoredIsland(EFFECTS);
    private final Bodies bodies = island.bodies;
    private final int floor = floor(island);

    private enum Way {
        WHOLE(Accuracy.GAME),
        WHOLE_AND_SPLIT(Accuracy.GAME.withImpacts(ImpactMode.SPLIT)),
        BLOCK(Accuracy.GAME.withContactSolver(ContactSolver.BLOCK)),
        SEQUENTIAL(Accuracy.GAME.withContactSolver(ContactSolver.SEQUENTIAL)),
        DRAFT(Accuracy.DRAFT);

        final Accuracy accuracy;

        Way(Accuracy accuracy) {
            this.accuracy = accuracy;
        }
    }

    private static int floor(StoredIsland on) {
        return on.body(BodyDefinition.fixed(Polygon.box(100, 1)).at(0, -0.5).material(ROUGH));
    }

    private static int box(StoredIsland on, double x, double y, UnaryOperator<BodyDefinition> as) {
        BodyDefinition box = BodyDefinition.dynamic(Polygon.box(1, 1)).at(x, y).material(ROUGH);
        int slot = on.body(as.apply(box));
        on.bodies.accelerationY[slot] = -G;
        return slot;
    }

    private int box(double x, double y) {
        return box(island, x, y, box -> box);
    }

    /** Puts B on A, with both corners of B's lower side at a gap. */
    private static int stand(StoredIsland on, int a, int b, double gap) {
        int pair = on.contact(a, b, Math.PI / 2);
        double y = on.bodies.y[b] - 0.5;
        on.point(pair, on.bodies.x[b] - 0.5, y, gap);
        on.point(pair, on.bodies.x[b] + 0.5, y, gap);
        on.pairs.faceOf[pair] = a;
        return pair;
    }

    private static IslandSolver solver(StoredIsland on, Accuracy accuracy) {
        return new IslandSolver(on.data, new Narrowphase(on.data), EFFECTS, accuracy, null, null);
    }

    private void solve(Accuracy accuracy) {
        solver(island, accuracy).solve(0, DT);
    }

    /** The floor carries m·g, the middle of the stack the weight of the box above. */
    @ParameterizedTest
    @EnumSource(Way.class)
    void stackIsCarriedAndStaysInPlace(Way way) {
        int lower = box(0, 0.5);
        int upper = box(0, 1.5);
        int onFloor = stand(island, floor, lower, 0);
        int between = stand(island, lower, upper, 0);
        IslandSolver solver = solver(island, way.accuracy);
        // Passes find loads in a few steps, starting from none.
        for (int step = 0; step < 20; step++) {
            island.pairs.impulse[onFloor] = 0;
            island.pairs.impulse[between] = 0;
            solver.solve(0, DT);
        }
        // Passes may err by a hundredth.
        assertThat(force(onFloor)).isCloseTo(2 * G, within(0.02 * G));
        assertThat(force(between)).isCloseTo(G, within(0.01 * G));
        assertThat(island.pairs.impulse[onFloor]).isCloseTo(2 * G * DT, within(0.02 * G * DT));
        assertThat(island.pairs.impulse[between]).isCloseTo(G * DT, within(0.01 * G * DT));
        for (int slot : new int[] {lower, upper}) {
            assertThat(bodies.x[slot]).isCloseTo(0, within(1e-9));
            assertThat(bodies.y[slot]).isCloseTo(slot == lower ? 0.5 : 1.5, within(1e-5));
            assertThat(bodies.velocityY[slot]).isCloseTo(0, within(1e-4));
        }
        assertThat(island.pairs.touching[onFloor]).isTrue();
        assertThat(island.pairs.resting[between]).isTrue();
    }

    private double force(int pair) {
        return island.pairs.normalForce[2 * pair] + island.pairs.normalForce[2 * pair + 1];
    }

    /** v − μ·g·t, and v·t − μ·g·t²/2, until it stops. */
    @ParameterizedTest
    @EnumSource(Way.class)
    void slidingBoxIsBrakedByFriction(Way way) {
        int box = box(island, 0, 0.5, it -> it.velocity(2, 0));
        int pair = stand(island, floor, box, 0);
        // Passes begin with the loads of the last step, shifted to the front by the friction.
        island.pairs.normalForce[2 * pair] = G / 4;
        island.pairs.normalForce[2 * pair + 1] = 3 * G / 4;
        solve(way.accuracy);
        double v = 2 - 0.5 * G * DT;
        // Passes may err by a hundredth of the change by friction.
        assertThat(bodies.velocityX[box]).isCloseTo(v, within(0.01 * 0.5 * G * DT));
        assertThat(bodies.x[box]).isCloseTo((2 + v) / 2 * DT, within(0.01 * G * DT * DT));
        assertThat(bodies.y[box]).isCloseTo(0.5, within(1e-4));
    }

    /** A box that touches nothing yet falls: y − g·t²/2 by leapfrog, to round-off. */
    @ParameterizedTest
    @EnumSource(Way.class)
    void boxFallsWhileItsGapIsOpen(Way way) {
        int box = box(island, 0, 5.5, it -> it.velocity(1, -2));
        int pair = stand(island, floor, box, 5);
        solve(way.accuracy);
        assertThat(bodies.velocityX[box]).isCloseTo(1, within(1e-14));
        assertThat(bodies.velocityY[box]).isCloseTo(-2 - G * DT, within(1e-13));
        assertThat(bodies.x[box]).isCloseTo(DT, within(1e-14));
        assertThat(bodies.y[box]).isCloseTo(5.5 - 2 * DT - G * DT * DT / 2, within(1e-13));
        assertThat(force(pair)).isZero();
        assertThat(island.pairs.touching[pair]).isFalse();
    }

    /** From 0.02 m at 3 m/s the box arrives after 0.0065 s and leaves with e times its speed. */
    @ParameterizedTest
    @CsvSource({"WHOLE, 0.5", "WHOLE, 1", "BLOCK, 0.5", "BLOCK, 1", "SEQUENTIAL, 1"})
    void boxBouncesWithinTheStep(Way way, double elasticity) {
        Material bouncy = new Material(1, 0, elasticity);
        int box = box(island, 0, 0.52, it -> it.velocity(0, -3).material(bouncy));
        int pair = stand(island, floor, box, 0.02);
        assertThat(island.pairs.elasticity[pair]).isEqualTo(elasticity);
        solve(way.accuracy);
        double hit = (-3 + Math.sqrt(9 + 2 * G * 0.02)) / G;
        double back = elasticity * (3 + G * hit);
        double left = DT - hit;
        // Passes place times within a substep: errors are up to g·h·h/8 in place and g·h/2 in
        // speed.
        double h = DT / 4;
        assertThat(bodies.velocityY[box]).isCloseTo(back - G * left, within(G * h));
        double y = 0.5 + back * left - G * left * left / 2;
        assertThat(bodies.y[box]).isCloseTo(y, within(G * h * h));
        assertThat(island.pairs.impacts[pair]).isPositive();
        assertThat(bodies.spin[box]).isCloseTo(0, within(1e-9));
    }

    /** A body that joins after 0.4 of the step starts there, at the place of its columns. */
    @ParameterizedTest
    @ValueSource(doubles = {0.4, 0.75})
    void islandBeginsWithItsFirstBody(double share) {
        int box = box(island, 0, 5.5, it -> it.velocity(1, -2));
        stand(island, floor, box, 5);
        bodies.pileTime[box] = share * DT;
        solve(Accuracy.GAME);
        double left = (1 - share) * DT;
        assertThat(bodies.velocityY[box]).isCloseTo(-2 - G * left, within(1e-13));
        assertThat(bodies.x[box]).isCloseTo(left, within(1e-14));
        assertThat(bodies.y[box]).isCloseTo(5.5 - 2 * left - G * left * left / 2, within(1e-13));
    }

    /** On a carrier in uniform motion the box rests as on the floor and moves along. */
    @Test
    void movingCarrierTakesItsLoadAlong() {
        int lift =
                island.body(BodyDefinition.kinematic(Polygon.box(9, 1)).at(0, -0.5).velocity(3, 2));
        int box = box(island, 0, 0.5, it -> it.velocity(3, 2));
        int pair = stand(island, lift, box, 0);
        IslandSolver solver = solver(island, Accuracy.GAME);
        solver.solve(0, DT);
        assertThat(bodies.x[box]).isCloseTo(3 * DT, within(1e-9));
        assertThat(bodies.y[box]).isCloseTo(0.5 + 2 * DT, within(1e-6));
        assertThat(bodies.velocityX[box]).isCloseTo(3, within(1e-9));
        assertThat(bodies.velocityY[box]).isCloseTo(2, within(1e-6));
        assertThat(bodies.velocityX[lift]).isEqualTo(3);
        assertThat(force(pair)).isCloseTo(G, within(1e-6));
    }

    /** A moving pile, alone or as the last of three islands on one floor. */
    private static double[] pile(boolean isAmongStrangers, Accuracy accuracy) {
        StoredIsland world = new StoredIsland(EFFECTS);
        int ground = floor(world);
        IslandSolver solver = solver(world, accuracy);
        if (isAmongStrangers) {
            int near = box(world, 1.01, 0.5, it -> it.velocity(-1, 0));
            stand(world, ground, near, 0);
            int onIt = box(world, 1.3, 1.4, it -> it.velocity(0, -3).spin(20));
            stand(world, near, onIt, -0.1);
            world.beginIsland();
            int far = box(world, 40, 0.4, it -> it.mass(1e6).spin(-7));
            stand(world, ground, far, -0.1);
            world.beginIsland();
        }
        int lower = box(world, 0, 0.5, it -> it.velocity(0.7, 0));
        int upper = box(world, 0.3, 1.52, it -> it.velocity(0, -1).spin(0.5));
        int[] pairs = {stand(world, ground, lower, 0), stand(world, lower, upper, 0.02)};
        for (int step = 0; step < 3; step++) {
            for (int i = 0; i < world.data.islands.count; i++) {
                solver.solve(i, DT);
            }
        }
        double[] all = new double[14 + 2 * pairs.length];
        int i = 0;
        for (int slot : new int[] {lower, upper}) {
            all[i++] = world.bodies.x[slot];
            all[i++] = world.bodies.y[slot];
            all[i++] = world.bodies.angle[slot];
            all[i++] = world.bodies.velocityX[slot];
            all[i++] = world.bodies.velocityY[slot];
            all[i++] = world.bodies.spin[slot];
        }
        for (int pair : pairs) {
            all[i++] = world.pairs.normalForce[2 * pair];
            all[i++] = world.pairs.normalForce[2 * pair + 1];
            all[i++] = world.pairs.impulse[pair];
        }
        return all;
    }

    /** The solution depends on nothing outside the island, nor on earlier solutions, to the bit. */
    @ParameterizedTest
    @EnumSource(Way.class)
    void strangersChangeNoBit(Way way) {
        double[] alone = pile(false, way.accuracy);
        assertThat(pile(true, way.accuracy)).isEqualTo(alone);
        assertThat(alone[0]).isBetween(0.005, 0.05);
    }
}
