package rigibo.backend.storage;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.setup.BodyType;

import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.Set;

/** Sorting the pairs gives them other slots, and nothing else. */
class PairOrderTest {

    private static final int BODIES = 80;
    private static final long SEED = 11;

    /** What says who a pair is and where its lists go on: checked by what is found through it. */
    private static final Set<String> LINKS =
            Set.of("bodyA", "bodyB", "next", "previous", "active", "activeStep");

    private final DataStorage data = new DataStorage(everyColumn());
    private final Pairs pairs = data.pairs;

    private static Effects everyColumn() {
        return Effects.of(
                new Contacts(),
                new Rotation(),
                new Friction(),
                new Restitution(),
                new RollingResistance());
    }

    @Test
    void everyColumnGoesWithItsPair() throws IllegalAccessException {
        pairUpAtRandom();
        listActive();
        mark();
        List<List<Integer>> neighbours = neighbours();
        new PairOrder(data).restore();
        assertThat(pairs.slots.freeCount).isZero();
        for (int i = 0; i < pairs.activeCount; i++) {
            assertThat(pairs.active[i]).as("active pairs stand in their order").isEqualTo(i);
        }
        int active = pairs.activeCount;
        for (int pair = 0; pair < active; pair++) {
            pairs.activate(pair);
        }
        assertThat(pairs.activeCount).as("no pair is listed twice").isEqualTo(active);
        assertThat(neighbours()).isEqualTo(neighbours);
        for (int pair : pairs.slots.occupied()) {
            int a = pairs.bodyA[pair];
            int b = pairs.bodyB[pair];
            assertThat(pairs.index.find(a, b)).isEqualTo(pair);
            for (Field column : columns()) {
                requireMark(column, pair, a * BODIES + b);
            }
        }
    }

    @Test
    void whatIsInOrderIsLeftAlone() {
        pairUpAtRandom();
        listActive();
        PairOrder order = new PairOrder(data);
        order.restore();
        double[] before = pairs.normalX;
        order.restore();
        assertThat(pairs.normalX).isSameAs(before);
    }

    /**
     * Every pair of bodies that is near by number, in any order, and a third of them gone again.
     */
    private void pairUpAtRandom() {
        List<int[]> all = new ArrayList<>();
        for (int a = 0; a < BODIES; a++) {
            int slot = data.bodies.take();
            data.bodies.type[slot] = BodyType.DYNAMIC;
            data.bodies.firstPair[slot] = Pairs.NONE;
            for (int b = a + 1; b < BODIES; b++) {
                all.add(new int[] {a, b});
            }
        }
        Collections.shuffle(all, new Random(SEED));
        for (int[] two : all) {
            pairs.add(data.bodies, two[0], two[1]);
        }
        for (int i = 0; i < all.size(); i += 3) {
            pairs.remove(data.bodies, pairs.index.find(all.get(i)[0], all.get(i)[1]));
        }
    }

    /** Most of them, body by body, as a step does. */
    private void listActive() {
        pairs.beginStep();
        for (int a = 0; a < BODIES - 2; a++) {
            for (int p = data.bodies.firstPair[a]; p != Pairs.NONE; p = pairs.nextOf(p, a)) {
                if (pairs.bodyA[p] == a) {
                    pairs.activate(p);
                }
            }
        }
    }

    private void mark() throws IllegalAccessException {
        for (int pair : pairs.slots.occupied()) {
            int mark = pairs.bodyA[pair] * BODIES + pairs.bodyB[pair];
            for (Field column : columns()) {
                for (int i = 0; i < width(column); i++) {
                    set(column.get(pairs), width(column) * pair + i, mark + i);
                }
            }
        }
    }

    private void requireMark(Field column, int pair, int mark) throws IllegalAccessException {
        for (int i = 0; i < width(column); i++) {
            Object found = Array.get(column.get(pairs), width(column) * pair + i);
            Object expected =
                    found instanceof Boolean
                            ? (Object) ((mark + i) % 2 == 0)
                            : found instanceof Double
                                    ? (Object) (double) (mark + i)
                                    : (Object) (mark + i);
            assertThat(found).as(column.getName()).isEqualTo(expected);
        }
    }

    private static void set(Object column, int at, int mark) {
        if (column instanceof boolean[] flags) {
            flags[at] = mark % 2 == 0;
        } else if (column instanceof double[] numbers) {
            numbers[at] = mark;
        } else {
            ((int[]) column)[at] = mark;
        }
    }

    /** Values of a column for each pair. */
    private int width(Field column) throws IllegalAccessException {
        return Array.getLength(column.get(pairs)) / pairs.bodyA.length;
    }

    /** Found by reflection, so that a column that is added later is not forgotten here. */
    private static List<Field> columns() {
        List<Field> columns = new ArrayList<>();
        for (Field field : Pairs.class.getDeclaredFields()) {
            if (field.getType().isArray() && !LINKS.contains(field.getName())) {
                columns.add(field);
            }
        }
        return columns;
    }

    private List<List<Integer>> neighbours() {
        List<List<Integer>> of = new ArrayList<>();
        for (int body = 0; body < BODIES; body++) {
            List<Integer> others = new ArrayList<>();
            for (int p = data.bodies.firstPair[body]; p != Pairs.NONE; p = pairs.nextOf(p, body)) {
                others.add(pairs.other(p, body));
            }
            of.add(others);
        }
        return of;
    }
}
