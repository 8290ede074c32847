package rigibo.backend.contact.solve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.PackedIsland;

import java.util.SplittableRandom;
import java.util.stream.IntStream;

/** Sets of rows factored within their envelope, compared with Gauss's elimination of all rows. */
class RowFactorTest {

    /** Highest friction of sliding contacts. */
    private static final double SLIDES = 0.3;

    /**
     * That on hubs, where most of a row's response is the compliance that keeps sets from being
     * singular: with more friction some pivot would be less than it and count as redundant.
     */
    private static final double SLIDES_ON_HUBS = 0.1;

    private final PackedIsland island = new PackedIsland();
    private final ContactOrder order = new ContactOrder(island.motions, island.contacts);
    private final FlatRows rows = new FlatRows(island.motions, island.contacts, order);
    private final RowFactor factor = new RowFactor(island.contacts, rows, order);

    /** Bodies in a chain with some more contacts, with random normals and levers. */
    private void heap(SplittableRandom random, int bodies) {
        bodies(random, bodies);
        link(random, bodies);
        lay();
    }

    private void bodies(SplittableRandom random, int bodies) {
        island.begin(bodies);
        for (int body = 1; body <= bodies; body++) {
            island.body(body, random.nextDouble(0.5, 2), random.nextDouble(0.5, 2));
        }
    }

    private void link(SplittableRandom random, int bodies) {
        for (int body = 1; body <= bodies; body++) {
            contact(random, body - 1, body);
            int other = random.nextInt(bodies + 1);
            if (other != body && random.nextInt(3) == 0) {
                contact(random, Math.min(other, body), Math.max(other, body));
            }
        }
    }

    private void lay() {
        order.find();
        rows.layOut(false);
        // Soft enough that no set is singular; points are, too.
        all().filter(k -> k % FlatRows.KINDS == FlatRows.ROLL).forEach(k -> rows.give[k] = 0.1);
        factor.forget();
    }

    private void contact(SplittableRandom random, int a, int b) {
        int row = island.contact(a, b, random.nextDouble(0.1, 1), random.nextDouble(0.1, 1));
        double angle = random.nextDouble(-3, 3);
        int at = row * PackedContacts.STRIDE;
        double[] d = island.contacts.data;
        d[at + PackedContacts.NX] = Math.cos(angle);
        d[at + PackedContacts.NY] = Math.sin(angle);
        d[at + PackedContacts.LEVER_TA] = random.nextDouble(-1, 1);
        d[at + PackedContacts.LEVER_TB] = random.nextDouble(-1, 1);
        d[at + PackedContacts.MASS_T] = 1;
        d[at + PackedContacts.WIDTH] = random.nextDouble(0.5, 2);
        d[at + PackedContacts.ROLLING] = random.nextBoolean() ? 0.1 : 0;
        d[at + PackedContacts.GIVE] = 0.1;
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whatIsFactoredSolvesItsMatrix(boolean slides) {
        SplittableRandom random = new SplittableRandom(slides ? 1 : 2);
        for (int i = 0; i < 300; i++) {
            heap(random, 1 + random.nextInt(12));
            assertThat(order.hubCount).isZero();
            assertSolves(random, anySet(random, slides ? SLIDES : 0));
        }
    }

    /**
     * Many bodies on one or two that lie on the ground and on each other; some of the many lie on
     * both, and some beside each other. The velocities of the two are unknowns.
     */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whatLiesOnHubsSolvesItsMatrix(boolean slides) {
        SplittableRandom random = new SplittableRandom(slides ? 4 : 5);
        int[] asked = new int[3];
        for (int i = 0; i < 300; i++) {
            int bodies = 20 + random.nextInt(10);
            int hubs = 1 + random.nextInt(2);
            bodies(random, bodies);
            contact(random, 0, 1);
            contact(random, 0, 1 + random.nextInt(hubs));
            for (int body = 2; body <= bodies; body++) {
                contact(random, body <= hubs ? 1 : 1 + random.nextInt(hubs), body);
                if (body > hubs + 1 && random.nextInt(4) == 0) {
                    contact(random, random.nextBoolean() ? body - 1 : hubs, body);
                }
            }
            lay();
            asked[order.hubCount]++;
            for (int again = 0; again < 3; again++) {
                assertSolves(random, anySet(random, slides ? SLIDES_ON_HUBS : 0));
            }
        }
        assertThat(asked[1]).isGreaterThan(80);
        assertThat(asked[2]).isGreaterThan(80);
    }

    /** One body that carries n others: 3 unknowns of its own in place of n² couplings. */
    @Test
    void workOnAHubGrowsAsItsContactsDo() {
        SplittableRandom random = new SplittableRandom(6);
        double[] work = new double[3];
        for (int i = 0; i < work.length; i++) {
            int bodies = 10 << i;
            bodies(random, bodies);
            contact(random, 0, 1);
            for (int body = 2; body <= bodies; body++) {
                contact(random, 1, body);
            }
            lay();
            assertThat(order.hubCount).isOne();
            factor.clearWork();
            assertSolves(random, anySet(random, 0));
            work[i] = factor.work();
        }
        assertThat(work[1]).isLessThan(2.5 * work[0]);
        assertThat(work[2]).isLessThan(2.5 * work[1]);
    }

    /** A long pile of equal bodies has no hub, though each has many contacts. */
    @Test
    void aBandHasNoHubs() {
        SplittableRandom random = new SplittableRandom(7);
        bodies(random, 40);
        for (int body = 1; body <= 40; body++) {
            for (int below = Math.max(0, body - 5); below < body; below++) {
                contact(random, below, body);
            }
        }
        lay();
        assertThat(order.hubCount).isZero();
        assertSolves(random, anySet(random, 0));
    }

    private int[] anySet(SplittableRandom random, double friction) {
        boolean slides = friction > 0;
        rows.followNone();
        all().filter(k -> slides && !FlatRows.isPoint(k) && random.nextBoolean())
                .forEach(k -> rows.follow(k, random.nextDouble(-friction, friction)));
        return all().filter(k -> FlatRows.isPoint(k) || !slides)
                .filter(k -> random.nextInt(4) > 0)
                .toArray();
    }

    /** The rows of all contacts; that of rolling is none where there is no resistance to it. */
    private IntStream all() {
        return IntStream.range(0, FlatRows.KINDS * island.contacts.count)
                .filter(k -> k % FlatRows.KINDS != FlatRows.ROLL || rows.share(k) > 0);
    }

    /** A set with the beginning of the last one is factored again only after it. */
    @Test
    void whatFollowsOnAnotherSetSolvesItsOwn() {
        SplittableRandom random = new SplittableRandom(3);
        heap(random, 10);
        int late = FlatRows.KINDS * (island.contacts.count - 2);
        assertSolves(random, all().toArray());
        factor.clearWork();
        assertSolves(random, all().filter(k -> k != late).toArray());
        double some = factor.work();
        factor.clearWork();
        assertSolves(random, all().skip(1).toArray());
        assertThat(some).isLessThan(factor.work() / 2);
        factor.clearWork();
        assertSolves(random, all().skip(1).toArray());
        assertThat(factor.work()).isZero();
    }

    private void assertSolves(SplittableRandom random, int[] set) {
        double[] asked = new double[set.length];
        for (int i = 0; i < set.length; i++) {
            asked[i] = random.nextDouble(-1, 1);
        }
        factor.factorize(set, set.length);
        double[] found = asked.clone();
        factor.solve(found);
        for (int i = 0; i < set.length; i++) {
            double sum = rows.give[set[i]] * found[i];
            double scale = 1;
            for (int j = 0; j < set.length; j++) {
                double term = answerTo(set[i], set[j]) * found[j];
                sum += term;
                scale += Math.abs(term);
            }
            // Some 40 rows, each of which loses a few digits of the sum of all terms.
            assertThat(sum).isCloseTo(asked[i], within(1e-10 * scale));
        }
    }

    /** Speed of a row by a unit impulse of another one with its friction, through all bodies. */
    private double answerTo(int i, int j) {
        double sum = rows.answerTo(i, j);
        for (int hub = 0; hub < order.hubCount; hub++) {
            for (int axis = 0; axis < FlatRows.AXES; axis++) {
                sum += rows.ofHub(i, order.hubs[hub], axis) * rows.toHub(j, order.hubs[hub], axis);
            }
        }
        return sum;
    }
}
