package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;

import java.util.Arrays;

/** Columns of boxes of 1 kg on the ground that are pushed sideways, compared with Coulomb's law. */
class NewtonSolverTest {

    private static final double H = 1.0 / 240;

    /** Rows yield by 1e-10 of their loads, for up to ten boxes. */
    private static final double GIVEN_WAY = 1e-8;

    private final PackedIsland island = new PackedIsland();
    private final PackedContacts contacts = island.contacts;
    private final ContactOrder order = new ContactOrder(island.motions, contacts);
    private final FlatRows rows = new FlatRows(island.motions, contacts, order);
    private final RowFactor factor = new RowFactor(contacts, rows, order);
    private final NewtonSolver newton =
            new NewtonSolver(island.motions, contacts, order, rows, factor);

    @BeforeEach
    void begin() {
        factor.forget();
    }

    /**
     * Boxes that do not turn, each on the one before, falling at 1 m/s with a third of their loads.
     */
    private void column(int count, double friction) {
        island.begin(count);
        for (int body = 1; body <= count; body++) {
            island.body(body, 1, 0);
            int row = island.contact(body - 1, body, 0.5, 0.5);
            int at = row * PackedContacts.STRIDE;
            contacts.data[at + PackedContacts.FRICTION] = friction;
            contacts.data[at + PackedContacts.MASS_T] = body == 1 ? 1 : 0.5;
            contacts.data[at + PackedContacts.GIVE] = 1e-10;
            island.motions.data[body * Motions.STRIDE + Motions.VY] = -1;
        }
        order.find();
    }

    private boolean solve() {
        rows.layOut(false);
        rows.read(H);
        Arrays.fill(rows.kept, 0, FlatRows.KINDS * contacts.count, 0);
        boolean isSolved = newton.solve(0, 1e-12, Double.POSITIVE_INFINITY);
        rows.write();
        return isSolved;
    }

    private double speedX(int body) {
        return island.motions.data[body * Motions.STRIDE + Motions.VX];
    }

    /**
     * The uppermost of n boxes slides at v: its contact carries one momentum of 1 kg·m/s, with
     * friction of μ times it. The ones below carry 2 … n and hold, as long as μ·1 is no more than
     * their bound.
     */
    @ParameterizedTest
    @CsvSource({"1, 0.3, 2", "2, 0.3, 2", "5, 0.2, -3", "7, 0.5, 1"})
    void whatSlidesIsBrakedByTheLoadThatIsFound(int count, double friction, double speed) {
        column(count, friction);
        island.motions.data[count * Motions.STRIDE + Motions.VX] = speed;
        assertThat(solve()).isTrue();
        for (int row = 0; row < count; row++) {
            double load = island.of(row, PackedContacts.IMPULSE0);
            assertThat(load).isCloseTo(count - row, within(GIVEN_WAY * count));
            // The tangent points to the left.
            double rubs = Math.signum(speed) * friction;
            assertThat(island.of(row, PackedContacts.IMPULSE_T)).isCloseTo(rubs, within(GIVEN_WAY));
        }
        double left = Math.signum(speed) * (Math.abs(speed) - friction);
        assertThat(speedX(count)).isCloseTo(left, within(GIVEN_WAY));
        assertThat(count > 1 ? speedX(1) : 0).isCloseTo(0, within(GIVEN_WAY));
    }

    /**
     * The uppermost of n bodies, with moments of inertia of 1 kg·m², turns: its contact brakes it
     * by the lever times its load of 1 kg·m/s. The ones below hold, for they carry 2 … n.
     */
    @ParameterizedTest
    @CsvSource({"1, 0.3, 2", "2, 0.3, 2", "5, 0.2, -3", "7, 0.5, 1"})
    void whatRollsIsBrakedByTheLoadThatIsFound(int count, double lever, double spin) {
        column(count, 0);
        for (int row = 0; row < count; row++) {
            contacts.points[row] = 1;
            island.set(row, PackedContacts.LEVER_A0, 0);
            island.set(row, PackedContacts.LEVER_B0, 0);
            island.set(row, PackedContacts.ROLLING, lever);
            island.set(row, PackedContacts.WIDTH, 0.7);
            island.motions.data[(row + 1) * Motions.STRIDE + Motions.INVERSE_INERTIA] = 1;
        }
        island.motions.data[count * Motions.STRIDE + Motions.SPIN] = spin;
        order.find();
        assertThat(solve()).isTrue();
        double rolls = -Math.signum(spin) * lever;
        for (int row = 0; row < count; row++) {
            assertThat(island.of(row, PackedContacts.IMPULSE0))
                    .isCloseTo(count - row, within(GIVEN_WAY * count));
            assertThat(island.of(row, PackedContacts.IMPULSE_R))
                    .isCloseTo(rolls, within(GIVEN_WAY));
        }
        assertThat(spin(count)).isCloseTo(spin + rolls, within(GIVEN_WAY));
        assertThat(count > 1 ? spin(1) : 0).isCloseTo(0, within(GIVEN_WAY));
    }

    private double spin(int body) {
        return island.motions.data[body * Motions.STRIDE + Motions.SPIN];
    }

    /** Friction stops the boxes if it can, and a box over a gap falls on through it. */
    @Test
    void whatFrictionCanHoldIsHeldAndGapsStayOpen() {
        column(2, 0.5);
        island.motions.data[Motions.STRIDE + Motions.VX] = 0.7;
        contacts.data[PackedContacts.STRIDE + PackedContacts.GAP0] = 2 * H;
        assertThat(solve()).isTrue();
        assertThat(island.of(1, PackedContacts.IMPULSE0)).isZero();
        assertThat(island.motions.data[2 * Motions.STRIDE + Motions.VY]).isEqualTo(-1);
        assertThat(island.of(0, PackedContacts.IMPULSE0)).isCloseTo(1, within(GIVEN_WAY));
        assertThat(speedX(1)).isCloseTo(0.7 - 0.5, within(GIVEN_WAY));
    }

    /** Two gaps of a wall ask a box for different speeds: no body is moved by a millionfold. */
    @Test
    void rowsThatContradictEachOtherAreLeftAlone() {
        column(1, 0);
        int row = island.contact(0, 1, 0.5, 0.5);
        int at = row * PackedContacts.STRIDE;
        contacts.data[at + PackedContacts.GIVE] = 1e-10;
        contacts.data[at + PackedContacts.MASS_T] = 1;
        contacts.data[at + PackedContacts.NEARING] = 0.3;
        contacts.data[PackedContacts.IMPULSE0] = 1;
        contacts.data[at + PackedContacts.IMPULSE0] = 1;
        order.find();
        assertThat(solve()).isFalse();
        assertThat(island.motions.data[Motions.STRIDE + Motions.VY]).isEqualTo(-1);
        assertThat(island.of(0, PackedContacts.IMPULSE0)).isEqualTo(1);
    }
}
