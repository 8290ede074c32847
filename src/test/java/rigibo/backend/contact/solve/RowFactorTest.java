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

/** Sets of rows that are factored within their envelope, against Gauss's elimination of all. */
class RowFactorTest {

    private final PackedIsland island = new PackedIsland();
    private final ContactOrder order = new ContactOrder(island.motions, island.contacts);
    private final FlatRows rows = new FlatRows(island.motions, island.contacts, order);
    private final RowFactor factor = new RowFactor(island.contacts, rows, order);

    /** Bodies in a chain with some more contacts, along normals and with levers at random. */
    private void heap(SplittableRandom random, int bodies) {
        island.begin(bodies);
        for (int body = 1; body <= bodies; body++) {
            island.body(body, random.nextDouble(0.5, 2), random.nextDouble(0.5, 2));
        }
        for (int body = 1; body <= bodies; body++) {
            contact(random, body - 1, body);
            int other = random.nextInt(bodies + 1);
            if (other != body && random.nextInt(3) == 0) {
                contact(random, Math.min(other, body), Math.max(other, body));
            }
        }
        order.find();
        rows.layOut();
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
        // As soft as that no set is singular.
        d[at + PackedContacts.GIVE] = 0.1;
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whatIsFactoredSolvesItsMatrix(boolean slides) {
        SplittableRandom random = new SplittableRandom(slides ? 1 : 2);
        for (int i = 0; i < 300; i++) {
            heap(random, 1 + random.nextInt(12));
            for (int place = 0; place < island.contacts.count; place++) {
                boolean isSliding = slides && random.nextBoolean();
                rows.sliding[place] = isSliding ? random.nextDouble(-0.3, 0.3) : 0;
            }
            int[] set =
                    IntStream.range(0, FlatRows.KINDS * island.contacts.count)
                            .filter(k -> k % FlatRows.KINDS != FlatRows.TANGENT || !slides)
                            .filter(k -> random.nextInt(4) > 0)
                            .toArray();
            assertSolves(random, set);
        }
    }

    /** A set that begins as the one before is factored anew only from there on. */
    @Test
    void whatFollowsOnAnotherSetSolvesItsOwn() {
        SplittableRandom random = new SplittableRandom(3);
        heap(random, 10);
        int count = FlatRows.KINDS * island.contacts.count;
        assertSolves(random, IntStream.range(0, count).toArray());
        factor.clearWork();
        assertSolves(random, IntStream.range(0, count).filter(k -> k != count - 4).toArray());
        double some = factor.work();
        factor.clearWork();
        assertSolves(random, IntStream.range(1, count).toArray());
        assertThat(some).isLessThan(factor.work() / 2);
        factor.clearWork();
        assertSolves(random, IntStream.range(1, count).toArray());
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
                double term = rows.answerTo(set[i], set[j]) * found[j];
                sum += term;
                scale += Math.abs(term);
            }
            // Some 40 rows: each of them loses a few digits of the sum of all terms.
            assertThat(sum).isCloseTo(asked[i], within(1e-10 * scale));
        }
    }
}
