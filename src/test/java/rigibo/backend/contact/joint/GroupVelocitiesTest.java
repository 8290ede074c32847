package rigibo.backend.contact.joint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/** Bodies 1 and 3 are hinged to each other, body 2 is free; all of 1 kg and 1 kg·m². */
class GroupVelocitiesTest {

    private final Motions motions = new Motions(true);
    private final NeutralRows rows = new NeutralRows(motions, null);
    private final EquationFactor factor = new EquationFactor(motions, rows);
    private final GroupVelocities velocities = new GroupVelocities(null, motions, rows, factor);

    @BeforeEach
    void addBodies() {
        motions.data = new double[4 * Motions.STRIDE];
        motions.slots = new int[4];
        motions.reach = new double[4];
        motions.count = 4;
        Arrays.fill(motions.reach, 0.5);
        for (int body = 1; body <= 3; body++) {
            motions.data[body * Motions.STRIDE + Motions.INVERSE_MASS] = 1;
            motions.data[body * Motions.STRIDE + Motions.INVERSE_INERTIA] = 1;
            motions.data[body * Motions.STRIDE + Motions.VX] = body;
        }
        for (int axis = 0; axis < 2; axis++) {
            int row = rows.add();
            rows.derive(row, Motions.STRIDE, axis - 1, -axis, 0);
            rows.derive(row, 3 * Motions.STRIDE, 1 - axis, axis, 0);
            rows.finish(row);
        }
        factor.layOut();
        factor.changeAll();
        velocities.begin();
    }

    @Test
    void joinedBodiesAreOneBlockAndAFreeOneIsAnother() {
        int group = velocities.groupOf(1);
        assertThat(velocities.groupOf(3)).isEqualTo(group);
        assertThat(velocities.groupOf(2)).isEqualTo(EquationList.NONE);
        assertThat(velocities.block(Motions.STRIDE))
                .isEqualTo(velocities.block(3 * Motions.STRIDE));
        assertThat(velocities.block(2 * Motions.STRIDE))
                .isNotIn(velocities.block(Motions.STRIDE), velocities.noBlock());
        assertThat(velocities.endOf(group) - velocities.startOf(group)).isEqualTo(6);
        assertThat(velocities.areAnyLarge()).isFalse();
    }

    /** The hinge opens at 3 − 1 m/s along x. */
    @Test
    void rowsSeeTheVelocitiesThatWereTaken() {
        assertThat(velocities.along(0)).isEqualTo(2);
        motions.data[Motions.STRIDE + Motions.VX] = 2;
        assertThat(velocities.along(0)).isEqualTo(2);
        velocities.take();
        assertThat(velocities.along(0)).isEqualTo(1);
        rows.target[0] = 0.25;
        assertThat(velocities.residual(0)).isEqualTo(0.75);
    }

    /** 2 kg·m move bodies of 1 kg by 2 m; a quarter of that is left, or nothing. */
    @Test
    void displacementsOfAGroupAreScaledOrTakenBack() {
        int group = velocities.groupOf(1);
        velocities.rest();
        velocities.keep(group);
        velocities.displace(0, 2);
        assertThat(velocities.along(0)).isCloseTo(4, within(1e-15));
        assertThat(velocities.farthest(group)).isCloseTo(2, within(1e-15));
        velocities.scale(group, 0.25);
        assertThat(velocities.farthest(group)).isCloseTo(0.5, within(1e-15));
        velocities.recall(group);
        assertThat(velocities.farthest(group)).isZero();
    }
}
