package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.RevoluteJoint;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.Accuracy;

/** A box on a hinge after a kick, against the impulse that stops it and the circle it turns on. */
class WholeSolverTest {

    private static final double H = 1.0 / 240;

    /** A few roundings of speeds of 1 m/s and impulses of 1 N·s. */
    private static final double ROUND_OFF = 1e-12;

    private final JointedIsland island = new JointedIsland();
    private final NeutralRows rows = island.rows;
    private final JointPlaces places = island.jointRows.places;
    private final RowElimination elimination = new RowElimination(island.motions, rows);
    private final ContactRows contactRows =
            new ContactRows(island.motions, island.contacts, rows, island.states);
    private final RowSolver solver =
            new RowSolver(island.motions, rows, elimination, Accuracy.EXACT);
    private final JointBudget budget =
            new JointBudget(island.data, rows, elimination, Accuracy.EXACT);
    private final WholeSolver whole = whole();

    private WholeSolver whole() {
        NeutralRows ahead = new NeutralRows(island.motions, null);
        JointRows rowsAhead =
                new JointRows(
                        island.data,
                        ahead,
                        island.packed,
                        island.poses,
                        island.states,
                        island.lines);
        double tolerance = Accuracy.EXACT.impactTolerance();
        HeldPlaces held =
                new HeldPlaces(
                        island.motions,
                        rows,
                        places,
                        ahead,
                        rowsAhead,
                        island.poses,
                        solver,
                        elimination,
                        tolerance);
        JointSubsteps needed =
                new JointSubsteps(
                        island.data,
                        island.motions,
                        rows,
                        places,
                        island.packed,
                        contactRows,
                        budget,
                        Accuracy.EXACT);
        return new WholeSolver(
                island.motions,
                rows,
                island.packed,
                contactRows,
                elimination,
                solver,
                held,
                null,
                null,
                budget,
                needed,
                tolerance);
    }

    private void kick(double x, double y, double speedX, double speedY) {
        island.pool.join(RevoluteJoint.at(island.ground, island.a, x, y));
        island.pack(1, H);
        island.poses.take(0);
        rows.clear();
        island.jointRows.write(H, H);
        budget.begin(false, 1);
        whole.beginIsland();
        island.motions.data[Motions.STRIDE + Motions.VX] = speedX;
        island.motions.data[Motions.STRIDE + Motions.VY] = speedY;
    }

    @Test
    void aBoxHungAtItsCentreStops() {
        kick(0.3, 0.2, 0.5, -1);
        whole.solve(H, 1, 1, 0, 1);
        double mass = 1 / island.motions.data[Motions.STRIDE + Motions.INVERSE_MASS];
        assertThat(rows.impulse[0]).isCloseTo(-0.5 * mass, within(ROUND_OFF * mass));
        assertThat(rows.impulse[1]).isCloseTo(mass, within(ROUND_OFF * mass));
        assertThat(rows.speed(0)).isCloseTo(0, within(ROUND_OFF));
        assertThat(rows.speed(1)).isCloseTo(0, within(ROUND_OFF));
    }

    /** A metre below its hinge and kicked across by 3 m/s, it turns by some 0.01 rad in a drift. */
    @Test
    void aPendulumIsOnItsCircleAtTheEndOfADrift() {
        kick(0.3, 1.2, 3, 0);
        whole.solve(H, 1, 3, 0, 1);
        island.poses.take(H);
        places.measureAnew();
        double allowed =
                JointPlaces.MISSED * Accuracy.EXACT.impactTolerance() * places.size(0)
                        + places.roundOff();
        assertThat(places.of(0)).isCloseTo(0, within(allowed));
        assertThat(places.of(1)).isCloseTo(0, within(allowed));
        assertThat(Math.abs(island.motions.data[Motions.STRIDE + Motions.SPIN]))
                .isBetween(2.0, 3.0);
    }

    /** After the last kick only speeds count: the hinge stands still, the box turns by v·r·m/I. */
    @Test
    void aPendulumMovesAcrossItsArmAtTheEnd() {
        kick(0.3, 1.2, 3, 0);
        whole.solveAtRest(1, 3, 0, 1);
        double mass = 1 / island.motions.data[Motions.STRIDE + Motions.INVERSE_MASS];
        double inertia = 1 / island.motions.data[Motions.STRIDE + Motions.INVERSE_INERTIA];
        double spin = 3 * mass / (mass + inertia);
        assertThat(island.motions.data[Motions.STRIDE + Motions.SPIN])
                .isCloseTo(spin, within(ROUND_OFF));
        assertThat(island.motions.data[Motions.STRIDE + Motions.VX])
                .isCloseTo(spin, within(ROUND_OFF));
    }
}
