package rigibo.backend.flight;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.storage.Pairs;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;

/** The order of predicted impacts, compared with a sorted list. */
class ImpactQueueTest {

    private static final int PAIRS = 60;

    private final Pairs pairs = new Pairs(Effects.of());
    private final ImpactQueue queue = new ImpactQueue(pairs);

    /** Pair p has the bodies p mod 7 and 10 + p, so no two pairs have the same bodies. */
    @BeforeEach
    void nameBodies() {
        for (int pair = 0; pair < PAIRS; pair++) {
            pairs.bodyA[pair] = pair % 7;
            pairs.bodyB[pair] = 10 + PAIRS - pair;
        }
        queue.clear(PAIRS);
    }

    private int takeFirst() {
        int first = queue.first();
        queue.remove(first);
        return first;
    }

    /** Times have few values, so that many are equal. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void comesInTheOrderOfTimeThenOfBodies(long seed) {
        Random random = new Random(seed);
        List<Integer> known = new ArrayList<>();
        double[] time = new double[PAIRS];
        Comparator<Integer> order =
                Comparator.<Integer>comparingDouble(pair -> time[pair])
                        .thenComparingInt(pair -> pairs.bodyA[pair])
                        .thenComparingInt(pair -> pairs.bodyB[pair]);
        for (int i = 0; i < 2000; i++) {
            int pair = random.nextInt(PAIRS);
            known.remove((Integer) pair);
            if (random.nextInt(3) == 0) {
                queue.remove(pair);
                assertThat(queue.timeOf(pair)).isInfinite();
            } else {
                time[pair] = random.nextInt(12);
                queue.put(pair, time[pair]);
                known.add(pair);
                assertThat(queue.timeOf(pair)).isEqualTo(time[pair]);
            }
            assertThat(queue.isEmpty()).isEqualTo(known.isEmpty());
            if (!known.isEmpty()) {
                known.sort(order);
                assertThat(queue.first()).as("seed %d, turn %d", seed, i).isEqualTo(known.get(0));
                assertThat(queue.firstTime()).isEqualTo(time[known.get(0)]);
            }
        }
        known.sort(order);
        for (int pair : known) {
            assertThat(takeFirst()).as("seed %d", seed).isEqualTo(pair);
        }
        assertThat(queue.isEmpty()).isTrue();
    }

    @Test
    void aNewTimeTakesThePlaceOfTheOld() {
        queue.put(1, 0.25);
        queue.put(2, 0.5);
        queue.put(1, 0.75);

        assertThat(takeFirst()).isEqualTo(2);
        assertThat(takeFirst()).isEqualTo(1);
        assertThat(queue.isEmpty()).isTrue();
    }

    @Test
    void whatWasClearedIsForgotten() {
        queue.put(3, 0.25);
        queue.put(4, 0.5);
        queue.clear(PAIRS);

        assertThat(queue.isEmpty()).isTrue();
        assertThat(queue.timeOf(3)).isInfinite();
        assertThat(queue.timeOf(4)).isInfinite();
    }

    @Test
    void keepsWhatItKnowsWhenItGrows() {
        queue.put(3, 0.25);
        queue.reserve(2 * PAIRS);
        pairs.bodyA[PAIRS] = 1;
        queue.put(PAIRS, 0.125);
        queue.reserve(PAIRS);

        assertThat(queue.timeOf(2 * PAIRS - 1)).isInfinite();
        assertThat(takeFirst()).isEqualTo(PAIRS);
        assertThat(takeFirst()).isEqualTo(3);
    }
}
