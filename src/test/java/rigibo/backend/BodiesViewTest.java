package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.ConcurrentModificationException;
import java.util.Iterator;
import java.util.List;
import java.util.ListIterator;
import java.util.Random;

/** The list of bodies: order, access, what changing the pool does to whoever goes through it. */
class BodiesViewTest {

    private static final BodyDefinition DISC = BodyDefinition.dynamic(new Circle(0.5));
    private static final int COUNT = 6;

    private final Pool pool = new Pool();

    @BeforeEach
    void fill() {
        for (int i = 0; i < COUNT; i++) {
            pool.add(DISC.at(2 * i, 0));
        }
    }

    @Test
    void keepsTheOrderOfAdditionThroughRandomEdits() {
        Random random = new Random(3);
        List<RigidBody> expected = new ArrayList<>(pool.bodies());
        for (int i = 0; i < 5000; i++) {
            if (random.nextInt(100) < 49 && !expected.isEmpty()) {
                pool.remove(expected.remove(random.nextInt(expected.size())));
            } else {
                expected.add(pool.add(DISC));
            }
            int at = random.nextInt(expected.size() + 1);
            if (at < expected.size()) {
                assertThat(pool.bodies().get(at)).as("edit %d", i).isSameAs(expected.get(at));
            }
            if (i % 50 == 0) {
                assertThat(pool.bodies()).as("edit %d", i).isEqualTo(expected);
            }
        }
        assertThat(pool.bodies()).hasSameSizeAs(expected);
    }

    /**
     * Closing up after each of 20,000 removals would move 2·10⁸ bodies. A read moves each at most
     * once.
     */
    @Test
    void removalMovesNoOtherBody() {
        int many = 20_000;
        for (int i = COUNT; i < many; i++) {
            pool.add(DISC.at(2 * i, 0));
        }
        BodyList list = (BodyList) pool.bodies();
        long before = list.moves();
        List<RigidBody> all = List.copyOf(list);
        for (int i = 0; i < many; i += 2) {
            pool.remove(all.get(i));
        }
        assertThat(list.moves() - before).isZero();
        assertThat(list.get(many / 4)).isSameAs(all.get(many / 2 + 1));
        assertThat(list.moves() - before).isLessThanOrEqualTo(many);
    }

    /** Gaps that nobody reads past do not pile up: room stays within twice what is taken. */
    @Test
    void comingAndGoingTakesNoMoreAndMoreTime() {
        BodyList list = (BodyList) pool.bodies();
        int rounds = 10_000;
        for (int i = 0; i < rounds; i++) {
            pool.remove(pool.add(DISC));
        }
        // Of the 16 places at first, at least half are freed each time that all are used up.
        assertThat(list.moves()).isLessThanOrEqualTo(rounds);
        assertThat(list).hasSize(COUNT);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 2, COUNT - 2, COUNT - 1})
    void goingOnAfterARemovalIsRefused(int at) {
        List<RigidBody> seen = new ArrayList<>();
        RigidBody victim = pool.bodies().get(at);
        assertThatThrownBy(
                        () -> {
                            for (RigidBody body : pool.bodies()) {
                                seen.add(body);
                                if (body == victim) {
                                    pool.remove(body);
                                }
                            }
                        })
                .isInstanceOf(ConcurrentModificationException.class)
                .hasMessageContaining("List.copyOf");
        assertThat(seen).hasSize(at + 1);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, COUNT - 2, COUNT - 1})
    void goingOnAfterAnAdditionIsRefused(int at) {
        Iterator<RigidBody> bodies = pool.bodies().iterator();
        for (int i = 0; i <= at; i++) {
            bodies.next();
        }
        pool.add(DISC);
        assertThat(bodies.hasNext()).isTrue();
        assertThatThrownBy(bodies::next).isInstanceOf(ConcurrentModificationException.class);
    }

    @Test
    void streamAndForEachThatRemoveAreRefusedAtOnce() {
        assertThatThrownBy(() -> pool.bodies().stream().forEach(pool::remove))
                .isInstanceOf(ConcurrentModificationException.class);
        assertThat(pool.bodies()).hasSize(COUNT - 1);
        assertThatThrownBy(() -> pool.bodies().forEach(pool::remove))
                .isInstanceOf(ConcurrentModificationException.class);
        assertThat(pool.bodies()).hasSize(COUNT - 2);
    }

    @Test
    void goingBackwardsIsRefusedLikewise() {
        ListIterator<RigidBody> bodies = pool.bodies().listIterator(COUNT);
        bodies.previous();
        pool.remove(pool.bodies().get(0));
        assertThat(bodies.hasPrevious()).isTrue();
        assertThatThrownBy(bodies::previous).isInstanceOf(ConcurrentModificationException.class);
    }

    @Test
    void removingThroughACopyReachesEveryBody() {
        for (RigidBody body : List.copyOf(pool.bodies())) {
            pool.remove(body);
        }
        assertThat(pool.bodies()).isEmpty();
    }

    @Test
    void stoppingAfterARemovalIsAllowed() {
        for (RigidBody body : pool.bodies()) {
            pool.remove(body);
            break;
        }
        assertThat(pool.bodies()).hasSize(COUNT - 1);
    }

    @Test
    void listItselfCannotBeChanged() {
        List<RigidBody> bodies = pool.bodies();
        RigidBody body = bodies.get(0);
        assertThatThrownBy(() -> bodies.add(body))
                .isInstanceOf(UnsupportedOperationException.class);
        assertThatThrownBy(() -> bodies.remove(body))
                .isInstanceOf(UnsupportedOperationException.class);
        assertThatThrownBy(bodies::clear).isInstanceOf(UnsupportedOperationException.class);
        assertThat(bodies).hasSize(COUNT);
    }
}
