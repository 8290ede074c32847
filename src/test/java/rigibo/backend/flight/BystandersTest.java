package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Restitution;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.impact.Impact;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.setup.Material;
import rigibo.backend.storage.Pairs;

/**
 * The reach of struck bodies, compared with the impact law worked out by hand. The allowance is
 * 0.002 of a width: 0.004 m for discs of radius 1 m. A body beyond it may get as far as twice its
 * speed takes it.
 */
class BystandersTest {

    private static final double TOLERANCE = 1e-4;
    private static final Accuracy GAME = Accuracy.GAME.withImpactTolerance(TOLERANCE);

    /** Gap that counts as contact, m, for bodies 2 m wide. */
    private static final double TOUCHING = 2e-3;

    private static final double ROUND_OFF = 1e-14;

    private Air air = new Air(GAME);
    private Trajectories paths = new Trajectories(air.bodies);
    private Bystanders bystanders = watch();

    private Bystanders watch() {
        return new Bystanders(air.storage.data, air.narrowphase, air.broadphase, paths, GAME);
    }

    /** Starts again in a world without rotation. */
    private void turnNothing() {
        air = new Air(GAME, new Contacts(), new Friction(), new Restitution());
        paths = new Trajectories(air.bodies);
        bystanders = watch();
    }

    private int disc(double x, double y, double vx, double vy) {
        return air.add(Air.body(new Circle(1), 0).at(x, y).velocity(vx, vy));
    }

    private int wall() {
        return air.add(BodyDefinition.fixed(Polygon.box(2, 2)).material(new Material(1, 0, 0)));
    }

    /** The impact of two discs, with the normal (0.6, 0.8) from A to B. */
    private Impact impact(int a, int b, double elasticity) {
        int pair = air.storage.pair(a, b);
        air.pairs.normalX[pair] = 0.6;
        air.pairs.normalY[pair] = 0.8;
        Impact impact = new Impact();
        impact.load(air.bodies, air.pairs, pair);
        impact.elasticity = elasticity;
        impact.addPoint(0.6, 0.8, 0, 0, 1.2, 1.6);
        return impact;
    }

    /** The larger reach of the two bodies; body B belongs to the pile. */
    private double reachOfImpact(int a, int b, Impact impact, double left) {
        return reachOfImpact(a, b, impact, false, left);
    }

    private double reachOfImpact(int a, int b, Impact impact, boolean isPileA, double left) {
        bystanders.measureImpact(a, b, impact, isPileA, left);
        return Math.max(bystanders.reachOfA, bystanders.reachOfB);
    }

    /**
     * Equal discs, one of which comes at speed v. Other bodies may stop it or throw it back, so its
     * reach follows from v. The allowance is 0.004 m.
     */
    @ParameterizedTest(name = "at {0} m/s with e = {1}, in {2} s: {3} m")
    @CsvSource({
        "1, 0.5, 0.5, 1",
        "1, 0, 0.5, 1",
        "2, 1, 0.125, 0.5",
        "0.0081, 0.5, 0.5, 0.0081",
        "0.0079, 0.5, 0.5, 0"
    })
    void theStruckGetsAsFarAsTwiceItsSpeedLeads(
            double speed, double elasticity, double left, double reach) {
        int a = disc(0, 0, 0.6 * speed, 0.8 * speed);
        int b = disc(1.2, 1.6, 0, 0);
        assertThat(reachOfImpact(a, b, impact(a, b, elasticity), left))
                .isEqualTo(reach, within(ROUND_OFF));
        int c = disc(2, 2, -0.6 * speed, -0.8 * speed);
        assertThat(reachOfImpact(b, c, impact(b, c, elasticity), true, left))
                .isEqualTo(reach, within(ROUND_OFF));
    }

    /**
     * The disc moves at 0.6 m/s and turns at 0.5 rad/s, which adds 0.5 m/s at a radius of 1 m, for
     * 0.5 s.
     */
    @Test
    void whatTurnsMayBeStoppedToo() {
        int a = disc(0, 0, 0.36, 0.48);
        air.bodies.spin[a] = -0.5;
        air.bodies.sweepRadius[a] = 1;
        int b = disc(1.2, 1.6, 0, 0);
        assertThat(reachOfImpact(a, b, impact(a, b, 0), 0.5))
                .isEqualTo(2 * (0.6 + 0.5) * 0.5, within(ROUND_OFF));
    }

    @Test
    void whereNothingTurnsOnlyWaysLead() {
        turnNothing();
        int a = disc(0, 0, 0.6, 0.8);
        int b = disc(1.2, 1.6, 0, 0);
        assertThat(reachOfImpact(a, b, impact(a, b, 0), 0.5)).isEqualTo(2 * 0.5, within(ROUND_OFF));
    }

    /**
     * The struck body leaves faster than either came: its speed is 2·v·2m/(3m) for a mass ratio of
     * 2.
     */
    @Test
    void whatIsLighterGoesFaster() {
        int a = disc(0, 0, 0.6, 0.8);
        int b = disc(1.2, 1.6, 0, 0);
        Impact impact = impact(a, b, 1);
        impact.inverseMassB = 2 * impact.inverseMassA;
        assertThat(reachOfImpact(a, b, impact, 0.5))
                .isEqualTo(2 * (4 / 3.0) * 0.5, within(ROUND_OFF));
    }

    /**
     * A body of a pile at 2 m/s meets a wall that comes at 1 m/s, and leaves it at a quarter of the
     * closing speed of 3 m/s: a change of 3.75 m/s. The wall's own path is known.
     */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aWallIsWhereItIsExpected(boolean isFirst) {
        int side = isFirst ? 1 : -1;
        int wall =
                air.add(
                        BodyDefinition.kinematic(Polygon.box(2, 2))
                                .velocity(side * 0.6, side * 0.8)
                                .material(new Material(1, 0, 0)));
        int disc = disc(0, 0, side * -1.2, side * -1.6);
        int a = isFirst ? wall : disc;
        int b = isFirst ? disc : wall;
        assertThat(reachOfImpact(a, b, impact(a, b, 0.25), !isFirst, 0.5))
                .isEqualTo(2 * 3.75 * 0.5, within(ROUND_OFF));
        assertThat(isFirst ? bystanders.reachOfA : bystanders.reachOfB).isZero();
    }

    /** The reaches do not depend on a common velocity (u, v) of the bodies and the floor, m/s. */
    @ParameterizedTest
    @CsvSource({"0, 0", "50, 0", "-7, 300"})
    void whatMovesWithThePileIsNoWay(double u, double v) {
        int a = disc(0, 0, u + 0.6, v + 0.8);
        int b = disc(1.2, 1.6, u, v);
        bystanders.measureImpact(a, b, impact(a, b, 0.5), false, 0.5);
        // Subtracting speeds of 300 m/s leaves thirteen digits. A leaves at ¼ of the closing speed,
        // B at ¾.
        assertThat(bystanders.reachOfA).isEqualTo(2 * 0.5, within(1e-12));
        assertThat(bystanders.reachOfB).isEqualTo(2 * 0.75 * 0.5, within(1e-12));
    }

    /** Without a contact point no velocity changes, but another body may stop it. */
    @Test
    void withoutAPointItMayBeStopped() {
        int a = disc(0, 0, 6, 8);
        int b = disc(1.2, 1.6, 0, 0);
        Impact impact = impact(a, b, 0.5);
        impact.points = 0;
        assertThat(reachOfImpact(a, b, impact, 0.5)).isEqualTo(2 * 10 * 0.5, within(ROUND_OFF));
    }

    /** Adds a pair with a gap along (0.6, 0.8). */
    private int near(int a, int b, double gap) {
        int pair = air.storage.pair(Math.min(a, b), Math.max(a, b));
        air.pairs.normalX[pair] = 0.6;
        air.pairs.normalY[pair] = 0.8;
        air.pairs.points[pair] = 1;
        air.pairs.separation[2 * pair] = gap;
        return pair;
    }

    /** A and B close at 1 m/s and slide past each other at 2 m/s: they close by 0.1 m in 0.1 s. */
    @ParameterizedTest(name = "over {0} m in {1} s: strike is {2}")
    @CsvSource({
        "0.099, 0.1, true",
        "0.101, 0.1, false",
        "-1, 0.0041, true",
        "-1, 0.0039, false",
        "0, 0.5, true"
    })
    void bouncersGetAsFarAsTwiceTheirSpeedLeads(double gap, double dt, boolean strike) {
        int far = near(disc(50, 0, 0, 0), disc(60, 0, 0, 0), 1);
        int a = disc(0, 0, 0.6 + 5, 0.8 + 7);
        int b = disc(2, 2, 2 * 0.8 + 5, -2 * 0.6 + 7);
        int pair = near(a, b, gap);
        double reach = bystanders.reachOfBouncers(pair, dt);

        assertThat(reach).isEqualTo(strike ? 2 * Math.sqrt(5) * dt : 0, within(ROUND_OFF));
        assertThat(bystanders.reachOfBouncers(far, dt)).isZero();
    }

    @Test
    void whatPartsStrikesNothing() {
        int pair = near(disc(0, 0, -0.6, -0.8), disc(2, 2, 0.6, 0.8), 0);
        assertThat(bystanders.reachOfBouncers(pair, 1)).isZero();
    }

    /**
     * A corner √2 m from the centre of a box that turns at 3 rad/s adds 3·√2 m/s of closing speed,
     * in either sense.
     */
    @ParameterizedTest
    @CsvSource({"3, 0", "-3, 0", "0, 3", "2, -1"})
    void turningClosesToo(double spinA, double spinB) {
        int a = air.add(Air.body(Polygon.box(2, 2), 0).spin(spinA));
        int b = air.add(Air.body(Polygon.box(2, 2), 0).at(3, 3).velocity(0.8, -0.6).spin(spinB));
        int pair = near(a, b, 0);
        double turning = (Math.abs(spinA) + Math.abs(spinB)) * Math.sqrt(2);
        assertThat(bystanders.reachOfBouncers(pair, 0.25))
                .isEqualTo(2 * (1 + turning) * 0.25, within(ROUND_OFF));
        air.pairs.separation[2 * pair] = turning * 0.25 * 1.001;
        assertThat(bystanders.reachOfBouncers(pair, 0.25)).isZero();
    }

    /**
     * The velocity of a turning wall is taken at the contact, (3, 4) m from its centre: ω·(−4, 3).
     * Turning adds ω·2 m/s across the other body's width.
     */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void aWallThatTurnsMovesAsItDoesThere(boolean isFirst) {
        near(disc(50, 0, 0, 0), disc(60, 0, 0, 0), 1);
        BodyDefinition driven =
                BodyDefinition.kinematic(Polygon.box(9, 9)).spin(0.5).velocity(1, 2);
        int first = isFirst ? air.add(driven) : disc(5, 6, 0, 0);
        int second = isFirst ? disc(5, 6, 0, 0) : air.add(driven);
        int pair = near(first, second, 0);
        air.pairs.pointX[2 * pair] = 3;
        air.pairs.pointY[2 * pair] = 4;
        // The velocity (1 − 2, 2 + 1.5) = (−1, 3.5) has the component 2.2 along (0.6, 0.8), towards
        // the disc if that is ahead.
        double closing = (isFirst ? 2.2 : -2.2) + 1;
        double reach = bystanders.reachOfBouncers(pair, 0.25);
        assertThat(reach)
                .isEqualTo(
                        closing > 0 ? 2 * (Math.hypot(1, 3.5) + 1) * 0.25 : 0, within(ROUND_OFF));
        air.pairs.separation[2 * pair] = 0.26 * closing;
        assertThat(bystanders.reachOfBouncers(pair, 0.25)).isZero();
    }

    @Test
    void whereNothingTurnsOnlyWaysClose() {
        turnNothing();
        int pair = near(disc(0, 0, 0.6, 0.8), disc(2, 2, 0, 0), 0.2);
        assertThat(bystanders.reachOfBouncers(pair, 0.25)).isEqualTo(0.5, within(ROUND_OFF));
        assertThat(bystanders.reachOfBouncers(pair, 0.19)).isZero();
    }

    /**
     * A disc that will be at x = 6 finds one at x = 12 with a reach of 4.1 m, and does not with 3.9
     * m.
     */
    @ParameterizedTest
    @CsvSource({"4.5, true", "1, false"})
    void looksRoundWhereTheBodyIsByThen(double reach, boolean finds) {
        int flyer = disc(0, 0, 0, 3);
        int other = disc(0, 12, 0, 0);
        air.meet(1e-3);
        paths.begin();
        assertThat(air.pairOf(flyer, other)).isEqualTo(Pairs.NONE);
        bystanders.lookRound(flyer, 2, reach);
        assertThat(air.pairOf(flyer, other) != Pairs.NONE).isEqualTo(finds);
    }

    /**
     * Discs with a gap of 1 m, which the reach and their own motion must close: 2 m/s for the rest
     * of the step, and a thousandth of their width. Bodies that were in a pile from the start are
     * measured at their poses there, others at their present poses, 0.25 m nearer.
     */
    @ParameterizedTest(name = "reach {0} m, in flight {1}, {2}: within is {3}")
    @CsvSource({
        "0.5, false, false, true",
        "0.49, false, false, false",
        "0.25, true, false, true",
        "0.24, true, false, false",
        "0.25, false, true, true",
        "0.24, false, true, false",
        "0.25, true, true, true",
        "0.24, true, true, false",
    })
    void isWithinReachOfWhereItIs(double reach, boolean flies, boolean otherFlies, boolean within) {
        int a = air.add(Air.body(Polygon.box(2, 2), 0).at(7, 9).velocity(2, 0));
        int b = air.add(Air.body(Polygon.box(2, 2), 0).at(10, 9));
        int pair = air.storage.pair(a, b);
        paths.begin();
        air.bodies.piled[a] = !flies;
        air.bodies.piled[b] = !otherFlies;
        boolean isWithin = bystanders.isWithinReach(pair, reach - TOUCHING + 1e-9, 0.125, 0.125);

        assertThat(isWithin).isEqualTo(within);
        assertThat(air.pairs.points[pair] > 0).isEqualTo(within);
        if (within) {
            double gap = flies || otherFlies ? 0.75 : 1;
            assertThat(air.pairs.separation[2 * pair]).isEqualTo(gap, within(ROUND_OFF));
        }
    }

    /** A body that joined the pile within the step is predicted from the place where it joined. */
    @Test
    void whoJoinedWithinTheStepIsWhereItGoesFromThere() {
        int a = disc(0, 0, 2, 0);
        int b = disc(3, 0, 0, 0);
        int pair = air.storage.pair(a, b);
        paths.begin();
        air.bodies.piled[b] = true;
        air.bodies.pileTime[b] = 0;
        paths.advance(a, 0.125);
        paths.land(a, 0.125);
        assertThat(bystanders.isWithinReach(pair, 1, 0.25, 0.125)).isTrue();
        assertThat(air.pairs.separation[2 * pair]).isEqualTo(0.5, within(ROUND_OFF));
    }

    /**
     * Boxes turned by 45° face each other with their corners. They are measured only if their
     * bounding circles are within reach.
     */
    @ParameterizedTest
    @CsvSource({"0.99, true", "1.01, false"})
    void whatIsBeyondEvenByItsCirclesIsNotMeasured(double gap, boolean isMeasured) {
        int a = air.add(Air.body(new Circle(1), 0).at(-3, -4));
        double apart = 3 + gap;
        int b = air.add(Air.body(new Circle(2), 0).at(-3 + 0.6 * apart, -4 + 0.8 * apart));
        int pair = air.storage.pair(a, b);
        paths.begin();
        air.pairs.reach[pair] = 7;
        assertThat(bystanders.isWithinReach(pair, 1 - TOUCHING, 0, 0)).isEqualTo(isMeasured);
        assertThat(Double.isNaN(air.pairs.reach[pair])).isEqualTo(isMeasured);
        // A pair that had points is measured again wherever it is.
        air.pairs.points[pair] = 1;
        assertThat(bystanders.isWithinReach(pair, 1 - TOUCHING, 0, 0)).isEqualTo(isMeasured);
        assertThat(air.pairs.reach[pair]).isNaN();
    }

    /**
     * Of the reach of 1 m the gap takes the part that both motions do not close: 0.5 m less 2
     * m/s·0.125 s. A body struck by an equal one at an elasticity of 0 moves on at half the speed.
     */
    @ParameterizedTest(name = "of {0} m over {1} m: {2} m")
    @CsvSource({
        "1, 0.5, 0.376",
        "1, 0.1, 0.5",
        "1, -5, 0.5",
        "0.2565, 0.5, 0.00425",
        "0.2555, 0.5, 0",
        "0.1, 0.5, 0",
        "0.0079, 0, 0",
        "0.0081, 0, 0.00405"
    })
    void aGapUsesUpTheReach(double reach, double gap, double left) {
        int pushed = disc(2, 2, 0, 0);
        air.pile(pushed);
        int pair = near(disc(0, 0, 1.2, 1.6), pushed, gap);
        assertThat(bystanders.reachLeft(pair, pushed, reach, 0.125))
                .isEqualTo(left, within(ROUND_OFF));
    }

    /**
     * A body of mass m strikes one of mass M, which moves on at (1 + e)·m/(m + M). M is four times
     * m, or a quarter of it.
     */
    @ParameterizedTest(name = "by {0} of its mass with e = {1}: {2}")
    @CsvSource({"4, 0, 0.8", "4, 1, 1.6", "0.25, 0, 0.2", "0.25, 0.5, 0.3"})
    void aStruckBodyTakesItsShareByMass(double ratio, double elasticity, double share) {
        int struck = disc(0, 0, 0, 0);
        int striking = disc(5, 0, 0, 0);
        air.pile(struck);
        air.bodies.inverseMass[striking] = air.bodies.inverseMass[struck] / ratio;
        int pair = near(struck, striking, -1);
        air.pairs.elasticity[pair] = elasticity;
        assertThat(bystanders.reachLeft(pair, struck, 1, 0.125))
                .isEqualTo(share, within(ROUND_OFF));
        int wall = wall();
        assertThat(bystanders.reachLeft(near(struck, wall, -1), wall, 1, 0.125)).isZero();
    }

    /**
     * A flyer of any mass gets the whole rest of the way: it may fall on a body that a floor has
     * stopped. It gets more only if the striking body is far heavier.
     */
    @ParameterizedTest(name = "by {0} of its mass with e = {1}: {2}")
    @CsvSource({"0.25, 0, 1", "1, 0, 1", "4, 0.5, 1.2", "4, 1, 1.6"})
    void aFlyerGoesItsWholeWay(double ratio, double elasticity, double share) {
        int struck = disc(0, 0, 0, 0);
        int striking = disc(5, 0, 0, 0);
        air.bodies.inverseMass[striking] = air.bodies.inverseMass[struck] / ratio;
        int pair = near(struck, striking, -1);
        air.pairs.elasticity[pair] = elasticity;
        assertThat(bystanders.reachLeft(pair, struck, 1, 0.125))
                .isEqualTo(share, within(ROUND_OFF));
    }

    /** Twice the root of 10⁻⁴ is above the bound of 0.002; that of 10⁻⁸ is below it. */
    @ParameterizedTest
    @CsvSource({"EVENTS, 1e-4, 0.002", "EVENTS, 1e-8, 0.0002", "SPLIT, 1e-8, 0.1"})
    void theAllowanceIsByTheAccuracyOfImpacts(ImpactMode mode, double tolerance, double widths) {
        Accuracy accuracy = GAME.withImpacts(mode).withImpactTolerance(tolerance);
        Bystanders asked =
                new Bystanders(air.storage.data, air.narrowphase, air.broadphase, paths, accuracy);

        assertThat(asked.allowance()).isEqualTo(widths, within(1e-15));
    }
}
