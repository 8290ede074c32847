package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Joints;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Waking;

import java.util.ArrayList;
import java.util.List;

/**
 * The spread of disturbances among piles. Discs of radius 1 m and 1 kg lie at rest on a line, with
 * an elasticity of 1; each hands its whole reach to the next.
 */
class DisturbanceTest {

    private static final double DT = 0.5;

    private final Air air = new Air(Accuracy.GAME);
    private final Trajectories paths = new Trajectories(air.bodies);
    private final Bystanders bystanders =
            new Bystanders(air.storage.data, air.narrowphase, air.broadphase, paths, Accuracy.GAME);
    private final List<Integer> joined = new ArrayList<>();
    private final Disturbance disturbance =
            new Disturbance(
                    air.storage.data, paths, bystanders, new Waking(air.storage.data), this::join);

    private void join(int flyer, int pileBody, double time, double dt) {
        paths.land(flyer, time);
        joined.add(flyer);
        // Flight measures its pairs by the predicted motions of both bodies, which meet nothing.
        for (int p = air.bodies.firstPair[flyer]; p != Pairs.NONE; p = air.pairs.nextOf(p, flyer)) {
            air.pairs.points[p] = 0;
        }
    }

    private int flyer(double x) {
        return air.add(Air.disc(x, 0, 1));
    }

    private int piled(double x) {
        int slot = flyer(x);
        air.pile(slot);
        return slot;
    }

    private void begin() {
        air.meet(DT);
        paths.begin();
        disturbance.begin();
    }

    /** Gives a body of a pile a reach (m) from the start of the step. */
    private void disturb(int slot, double reach) {
        disturbance.note(slot, reach);
        disturbance.spread(0, DT);
    }

    /** A reach that grows by less than a twentieth is not searched again. */
    @Test
    void aWayThatIsHardlyLongerIsNoNews() {
        int disturbed = piled(0);
        int beside = flyer(2 + 1.02);
        begin();
        disturb(disturbed, 1);
        disturb(disturbed, 1.04);
        assertThat(joined).isEmpty();
        disturb(disturbed, 1.06);

        assertThat(joined).containsExactly(beside);
    }

    /**
     * A body that joins gets a contact with the disturbed body, whatever their predicted motions.
     */
    @Test
    void whoJoinsIsAContactOfWhatIsDisturbed() {
        int disturbed = piled(0);
        int beside = flyer(2 + 0.9);
        begin();
        disturb(disturbed, 1);

        assertThat(joined).containsExactly(beside);
        int pair = air.pairOf(disturbed, beside);
        assertThat(air.pairs.points[pair]).isPositive();
        assertThat(air.pairs.separation[2 * pair]).isEqualTo(0.9, within(1e-12));
    }

    @Test
    void aLongerWayIsHandedOnAgain() {
        int disturbed = piled(0);
        piled(2);
        int beside = flyer(4 + 1.5);
        begin();
        disturb(disturbed, 1);
        assertThat(joined).isEmpty();
        disturb(disturbed, 2);

        assertThat(joined).containsExactly(beside);
    }

    /** Flyers that come near later join by later disturbances only. */
    @Test
    void aWayIsLookedAlongOnce() {
        int disturbed = piled(0);
        // The search box includes it, though the distance is 1.8 m.
        int beside = air.add(Air.body(new Circle(1), 1).at(2.7, 2.7));
        int farAway = piled(50);
        begin();
        disturb(disturbed, 1);
        assertThat(air.pairOf(disturbed, beside)).isNotEqualTo(Pairs.NONE);
        air.bodies.x[beside] = 0;
        disturb(farAway, 1);

        assertThat(joined).isEmpty();
    }

    /** A disc that touches an undisturbed pile flies on. */
    @Test
    void whatRestsDisturbsNobodyWhateverElseIs() {
        piled(0);
        flyer(2.001);
        int farAway = piled(50);
        begin();
        disturb(farAway, 1);

        assertThat(joined).isEmpty();
    }

    @Test
    void aStepForgetsTheWaysOfTheLast() {
        int disturbed = piled(0);
        int beside = flyer(2 + 3);
        begin();
        disturb(disturbed, 1);
        assertThat(joined).isEmpty();
        air.bodies.x[beside] = 2 + 0.5;
        begin();
        disturb(disturbed, 1);

        assertThat(joined).containsExactly(beside);
    }

    /** A body of another pile is reached beyond the distance that their speeds would close. */
    @Test
    void whatIsReachedOfAPileBecomesAContact() {
        int disturbed = piled(0);
        int other = piled(2 + 0.5);
        begin();
        disturb(disturbed, 1);

        int pair = air.pairOf(disturbed, other);
        assertThat(air.pairs.points[pair]).isEqualTo(1);
        assertThat(air.pairs.separation[2 * pair]).isEqualTo(0.5, within(1e-15));
        assertThat(joined).isEmpty();
    }

    /**
     * Over a gap of ½ m the disturbance reaches a body of another pile, which hands on the
     * remaining ½ m, farther than the first body could get.
     */
    @ParameterizedTest
    @CsvSource({"0.49, true", "0.51, false"})
    void whatIsReachedOfAPileHandsOnWhatIsLeft(double gap, boolean joins) {
        int disturbed = piled(0);
        piled(2 + 0.5);
        int beside = flyer(4 + 0.5 + gap);
        begin();
        disturb(disturbed, 1);

        assertThat(joined.contains(beside)).isEqualTo(joins);
    }

    /**
     * From ¼ s on the reach is 1 m. A disc that flies past at 1 m/s is within it at its present
     * place, or at any place of its way in the ½ s of the step; a thousandth of its width is added.
     */
    @ParameterizedTest
    @CsvSource({"1.501, true", "1.503, false"})
    void whoFliesIsReachedWhereItIsByThen(double gap, boolean joins) {
        int disturbed = piled(0);
        // Diagonally, a search box finds bodies that are farther away than the reach.
        double along = Math.sqrt(0.5);
        double place = (2 + gap) * along;
        int beside =
                air.add(
                        Air.body(new Circle(1), 1)
                                .at(place - 0.25 * along, place + 0.25 * along)
                                .velocity(along, -along));
        begin();
        disturbance.note(disturbed, 1);
        disturbance.spread(0.25, DT);

        assertThat(joined.contains(beside)).isEqualTo(joins);
        assertThat(air.bodies.piled[beside]).isEqualTo(joins);
    }

    /**
     * A joint hands on √(m/(m + M)) of the reach of a disc of m = 1 kg to one of mass M: moving as
     * far in the same time, both have the energy of the first alone.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 1, 4})
    void aJointHandsOnWhatTheEnergyAllows(double mass) {
        double share = Math.sqrt(1 / (1 + mass));
        Air jointed = new Air(Accuracy.GAME, new Contacts(), new Joints());
        int struck = jointed.add(Air.disc(0, 0, 1));
        int mate = jointed.add(Air.disc(50, 0, 1).mass(mass));
        int near = jointed.add(Air.disc(52 + 0.9 * share, 0, 1));
        int far = jointed.add(Air.disc(48 - 1.1 * share, 0, 1));
        jointed.pile(struck);
        jointed.pile(mate);
        jointed.storage.data.joints.add(JointKind.WELD, struck, mate);
        Trajectories courses = new Trajectories(jointed.bodies);
        List<Integer> met = new ArrayList<>();
        Disturbance spreading =
                new Disturbance(
                        jointed.storage.data,
                        courses,
                        new Bystanders(
                                jointed.storage.data,
                                jointed.narrowphase,
                                jointed.broadphase,
                                courses,
                                Accuracy.GAME),
                        new Waking(jointed.storage.data),
                        (flyer, body, time, dt) -> {
                            courses.land(flyer, time);
                            met.add(flyer);
                        });
        jointed.meet(DT);
        courses.begin();
        spreading.begin();
        spreading.note(struck, 1);
        spreading.spread(0, DT);

        assertThat(met).containsExactly(near).doesNotContain(far);
    }
}
