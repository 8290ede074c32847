package rigibo.backend.contact.bounce;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedTurns;
import rigibo.backend.contact.row.RowBuilder;
import rigibo.backend.contact.row.StoredIsland;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Rotation;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

/**
 * Discs in a line, which meet within a substep of 0.1 s. After an impact at the time τ a body moves
 * with its new velocity. The substep moves all bodies by h·v, so places must be shifted by τ·(v₀ −
 * v₁). Pair by pair no shift leads into a present body, so only velocities are exact.
 */
class IslandImpactsTest {

    private static final double H = 0.1;
    private static final double ROUND_OFF = 1e-12;

    private final StoredIsland island =
            new StoredIsland(
                    Effects.of(
                            new Contacts(),
                            new Rotation(),
                            new Restitution(),
                            new ContinuousImpacts()));
    private final Motions motions = island.motions;
    private final PackedContacts contacts = island.contacts;
    private final PackedTurns turns = island.turns;
    private final RowBuilder builder = island.builder;
    private final Kick kick = new Kick(island.bodies, motions, null, null, turns);
    private final IslandImpacts impacts =
            new IslandImpacts(island.data, motions, contacts, kick, 1e-4);

    private enum Way {
        JOINTLY,
        APART
    }

    /** A disc of 1 m radius that moves along x. */
    private int disc(double x, double mass, double velocity, double elasticity) {
        return island.body(
                BodyDefinition.dynamic(new Circle(1))
                        .at(x, 0)
                        .velocity(velocity, 0)
                        .mass(mass)
                        .material(new Material(1, 0, elasticity)));
    }

    private int meet(int a, int b) {
        int pair = island.contact(a, b, 0);
        double x = island.bodies.x[a] + 1;
        island.point(pair, x, 0, island.bodies.x[b] - 1 - x);
        return pair;
    }

    private boolean resolve(Way way) {
        builder.build(0, 1);
        island.data.noteHits().clear(island.pairs.room());
        impacts.begin(H, 1e6);
        impacts.startAt(0);
        return resolvePacked(way, 0);
    }

    private boolean resolvePacked(Way way, int substep) {
        kick.remember();
        kick.accelerate(0, H / 2);
        kick.measureGain();
        boolean isAnswered = true;
        if (way == Way.JOINTLY) {
            isAnswered = impacts.resolveJointly(H, substep);
        } else {
            impacts.resolveApart(H, substep);
        }
        motions.drift(H);
        return isAnswered;
    }

    private double velocity(int slot) {
        return motions.data[builder.offset(slot) + Motions.VX];
    }

    private double way(int slot) {
        return motions.data[builder.offset(slot) + Motions.DX];
    }

    /** Newton's law: v′ = −e·v at a wall, from the time gap/v on. */
    @ParameterizedTest
    @CsvSource({
        "JOINTLY, 1, 0.1", "JOINTLY, 0.5, 0.1", "JOINTLY, 0.5, 0",
        "APART, 1, 0.1", "APART, 0.5, 0.1", "APART, 0.5, 0"
    })
    void discComesBackFromAWall(Way way, double elasticity, double gap) {
        int disc = disc(0, 2, 4, elasticity);
        int wall = island.body(BodyDefinition.fixed(new Circle(1)).at(2 + gap, 0));
        int pair = meet(disc, wall);
        assertThat(resolve(way)).isTrue();
        assertThat(velocity(disc)).isCloseTo(-elasticity * 4, within(ROUND_OFF));
        double time = gap / 4;
        double truth = gap - elasticity * 4 * (H - time);
        if (way == Way.JOINTLY) {
            assertThat(way(disc)).isCloseTo(truth, within(ROUND_OFF));
        }
        assertThat(island.pairs.impacts[pair]).isEqualTo(1);
        assertThat(contacts.impacts).isEqualTo(1);
        assertThat(contacts.work.impacts).isEqualTo(1);
    }

    /**
     * Momentum is kept, and the parting speed is e times the closing speed; the impulse is m·Δv.
     */
    @ParameterizedTest
    @CsvSource({"JOINTLY, 3, 1", "JOINTLY, 0.2, 0.4", "APART, 3, 1", "APART, 0.2, 0.4"})
    void twoDiscsFollowNewton(Way way, double mass, double elasticity) {
        int a = disc(0, 2, 5, elasticity);
        int b = disc(2.12, mass, -1, 0);
        meet(a, b);
        resolve(way);
        double common = (2 * 5 - mass) / (2 + mass);
        double va = common - elasticity * mass / (2 + mass) * 6;
        double vb = common + elasticity * 2 / (2 + mass) * 6;
        assertThat(velocity(a)).isCloseTo(va, within(ROUND_OFF));
        assertThat(velocity(b)).isCloseTo(vb, within(ROUND_OFF));
        double time = 0.02;
        if (way == Way.JOINTLY) {
            assertThat(way(a)).isCloseTo(5 * time + va * (H - time), within(ROUND_OFF));
            assertThat(way(b)).isCloseTo(-time + vb * (H - time), within(ROUND_OFF));
        }
        double impulse = contacts.data[PackedContacts.TOTAL];
        double told = island.pairs.impulse[contacts.pair[0]];
        assertThat(impulse + told).isCloseTo(mass * (vb + 1), within(ROUND_OFF));
    }

    /** Equal elastic discs hand their velocities on, each at its time. */
    @ParameterizedTest
    @EnumSource(Way.class)
    void velocityIsHandedAlongALine(Way way) {
        int a = disc(0, 1, 10, 1);
        int b = disc(2.2, 1, 0, 1);
        int c = disc(4.5, 1, 0, 1);
        meet(a, b);
        meet(b, c);
        resolve(way);
        assertThat(velocity(a)).isCloseTo(0, within(ROUND_OFF));
        assertThat(velocity(b)).isCloseTo(0, within(ROUND_OFF));
        assertThat(velocity(c)).isCloseTo(10, within(ROUND_OFF));
        if (way == Way.JOINTLY) {
            assertThat(way(a)).isCloseTo(0.2, within(ROUND_OFF));
            assertThat(way(b)).isCloseTo(0.3, within(ROUND_OFF));
            assertThat(way(c)).isCloseTo(10 * (H - 0.05), within(ROUND_OFF));
        }
        assertThat(contacts.impacts).isEqualTo(2);
    }

    /**
     * With a heavy disc between: 3 kg at 2 m/s are struck by 1 kg at 10 m/s, and then strike 1 kg.
     */
    @Test
    void chainOfUnequalDiscsIsSolvedInTime() {
        int a = disc(0, 1, 10, 1);
        int b = disc(2.2, 3, 0, 1);
        int c = disc(4.3, 1, 0, 1);
        meet(a, b);
        meet(b, c);
        resolve(Way.JOINTLY);
        // (m₁ − m₂)/(m₁ + m₂) = −½ and 2m₁/(m₁ + m₂) = ½ of 10 m/s, then ½ and 3/2 of 5.
        assertThat(velocity(a)).isCloseTo(-5, within(ROUND_OFF));
        assertThat(velocity(b)).isCloseTo(2.5, within(ROUND_OFF));
        assertThat(velocity(c)).isCloseTo(7.5, within(ROUND_OFF));
        double first = 0.02;
        double second = first + 0.1 / 5;
        assertThat(way(a)).isCloseTo(0.2 - 5 * (H - first), within(ROUND_OFF));
        assertThat(way(b)).isCloseTo(0.1 + 2.5 * (H - second), within(ROUND_OFF));
        assertThat(way(c)).isCloseTo(7.5 * (H - second), within(ROUND_OFF));
    }

    /** With an acceleration a: gap = v·τ + a·τ²/2, and −e times the speed there. */
    @ParameterizedTest
    @CsvSource({"JOINTLY, 1", "JOINTLY, 0.5", "APART, 1", "APART, 0.5"})
    void pulledDiscStrikesWithTheSpeedItHasThere(Way way, double elasticity) {
        double pull = 20;
        int disc = disc(0, 2, 3, elasticity);
        int wall = island.body(BodyDefinition.fixed(new Circle(1)).at(2.15, 0));
        meet(disc, wall);
        island.bodies.accelerationX[disc] = pull;
        resolve(way);
        // Pair by pair the time is that of a straight path at the mean velocity.
        double time =
                way == Way.JOINTLY
                        ? (Math.sqrt(9 + 2 * pull * 0.15) - 3) / pull
                        : 0.15 / (3 + pull * H / 2);
        double strikes = 3 + pull * time;
        double after = -elasticity * strikes - pull * (time - H / 2);
        assertThat(velocity(disc)).isCloseTo(after, within(ROUND_OFF));
    }

    /** Too slow for an impact, out of reach in the substep, parting, or not there yet. */
    @ParameterizedTest
    @CsvSource({"4, 0.41, 0", "-4, 0, 0", "1e-10, 0, 0", "4, 0.1, 1"})
    void whatDoesNotStrikeGoesOn(double speed, double gap, int firstSubstep) {
        int disc = disc(0, 2, speed, 1);
        int wall = island.body(BodyDefinition.fixed(new Circle(1)).at(2 + gap, 0));
        int pair = meet(disc, wall);
        for (Way way : Way.values()) {
            builder.build(0, 1);
            contacts.firstSubstep[0] = firstSubstep;
            impacts.begin(H, 1e6);
            resolvePacked(way, 0);
            assertThat(velocity(disc)).isEqualTo(speed);
            assertThat(way(disc)).isCloseTo(H * speed, within(1e-15));
            assertThat(island.pairs.impacts[pair]).isZero();
        }
    }

    /** Without a budget no impact is resolved, and the return value says so. */
    @Test
    void budgetIsKept() {
        int disc = disc(0, 2, 4, 1);
        int wall = island.body(BodyDefinition.fixed(new Circle(1)).at(2.1, 0));
        meet(disc, wall);
        builder.build(0, 1);
        impacts.begin(H, 0);
        assertThat(resolvePacked(Way.JOINTLY, 0)).isFalse();
        assertThat(velocity(disc)).isEqualTo(4);
    }

    /** A box that lands on one corner: J·M⁻¹·Jᵀ·j = (1 + e)·v at that corner. */
    @ParameterizedTest
    @EnumSource(Way.class)
    void cornerTurnsABox(Way way) {
        int box =
                island.body(
                        BodyDefinition.dynamic(Polygon.box(1, 1))
                                .mass(2)
                                .velocity(0, -3)
                                .spin(1)
                                .material(new Material(1, 0, 0.6)));
        int floor = island.body(BodyDefinition.fixed(Polygon.box(9, 1)).at(0, -1));
        int pair = island.contact(box, floor, -Math.PI / 2);
        island.point(pair, 0.5, -0.5, 0);
        island.point(pair, -0.5, -0.5, 0.9);
        resolve(way);
        double inverseInertia = island.bodies.inverseInertia[box];
        double closing = -3 + 0.5 * 1;
        double impulse = -1.6 * closing / (0.5 + 0.25 * inverseInertia);
        int at = builder.offset(box);
        assertThat(motions.data[at + Motions.VY]).isCloseTo(-3 + impulse / 2, within(1e-9));
        assertThat(motions.data[at + Motions.SPIN])
                .isCloseTo(1 + 0.5 * impulse * inverseInertia, within(1e-9));
    }

    /** A disc strikes a chain at rest whose discs touch: momentum and energy are kept. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void touchingRowOfDiscsKeepsMomentumAndEnergy(int waiting) {
        int[] slots = new int[waiting + 1];
        slots[0] = disc(0, 1, 10, 1);
        for (int i = 1; i <= waiting; i++) {
            slots[i] = disc(0.2 + 2 * i, 1, 0, 1);
            meet(slots[i - 1], slots[i]);
        }
        resolve(Way.JOINTLY);
        double momentum = 0;
        double energy = 0;
        double last = Double.NEGATIVE_INFINITY;
        for (int slot : slots) {
            double v = velocity(slot);
            momentum += v;
            energy += v * v;
            assertThat(v).isGreaterThanOrEqualTo(last - ROUND_OFF);
            last = v;
        }
        assertThat(momentum).isCloseTo(10, within(1e-9));
        assertThat(energy).isCloseTo(100, within(1e-7));
    }

    /** In the last kick a rebound of a pair that has not met yet is left to the next step. */
    @ParameterizedTest
    @CsvSource({"4, 0.1, 1", "4, -0.001, -1", "-4, 0.1, -1"})
    void whatWillBounceNextStepIsLeftOpen(double speed, double gap, int firstSubstep) {
        int disc = disc(0, 2, speed, 1);
        int wall = island.body(BodyDefinition.fixed(new Circle(1)).at(2 + gap, 0));
        meet(disc, wall);
        builder.build(0, 1);
        impacts.begin(H, 1e6);
        impacts.leaveOpen(0);
        assertThat(contacts.firstSubstep[0]).isEqualTo(firstSubstep);
    }

    /** A hit is recorded with its time, place and closing speed. */
    @ParameterizedTest
    @EnumSource(Way.class)
    void hitsAreNoted(Way way) {
        int disc = disc(0, 2, 4, 1);
        int wall = island.body(BodyDefinition.fixed(new Circle(1)).at(2.1, 0));
        meet(disc, wall);
        resolve(way);
        assertThat(island.data.hits.count).isEqualTo(1);
        assertThat(island.data.hits.x[0]).isCloseTo(1.1, within(ROUND_OFF));
        assertThat(island.data.hits.y[0]).isCloseTo(0, within(ROUND_OFF));
        assertThat(island.data.hits.time[0]).isCloseTo(0.025, within(ROUND_OFF));
    }
}
