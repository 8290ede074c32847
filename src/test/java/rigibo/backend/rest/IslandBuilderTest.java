package rigibo.backend.rest;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Contacts;
import rigibo.backend.setup.BodyType;
import rigibo.backend.storage.Islands;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.TreeMap;

/** Islands against groups that are found by spreading the lowest slot until nothing changes. */
class IslandBuilderTest {

    private final Pile pile = new Pile(new Contacts());
    private final Islands islands = pile.data.islands;

    private int piled() {
        int slot = pile.body(BodyType.DYNAMIC);
        pile.bodies.piled[slot] = true;
        return slot;
    }

    private void build() {
        pile.accept();
        new IslandBuilder(pile.data).build();
    }

    /** The bodies of every island, in their order. */
    private List<List<Integer>> groups() {
        return slices(islands.bodies, islands.bodyStart);
    }

    private List<List<Integer>> contacts() {
        return slices(islands.pairs, islands.pairStart);
    }

    private List<List<Integer>> slices(int[] all, int[] start) {
        List<List<Integer>> slices = new ArrayList<>();
        for (int i = 0; i < islands.count; i++) {
            slices.add(Arrays.stream(all, start[i], start[i + 1]).boxed().toList());
        }
        return slices;
    }

    @Test
    void twoStacksOnOneFloorAreTwoIslands() {
        int floor = pile.body(BodyType.STATIC);
        int left = piled();
        int right = piled();
        int leftTop = piled();
        int first = pile.contact(floor, left, 2);
        int second = pile.contact(floor, right, 2);
        int third = pile.contact(left, leftTop, 1);
        build();

        assertThat(groups()).containsExactly(List.of(left, leftTop), List.of(right));
        assertThat(contacts()).containsExactly(List.of(first, third), List.of(second));
    }

    @Test
    void whatIsDrivenJoinsNothing() {
        int left = piled();
        int lift = pile.body(BodyType.KINEMATIC);
        int right = piled();
        pile.bodies.velocityY[lift] = 1;
        int first = pile.contact(left, lift, 1);
        int second = pile.contact(lift, right, 1);
        build();

        assertThat(groups()).containsExactly(List.of(left), List.of(right));
        assertThat(contacts()).containsExactly(List.of(first), List.of(second));
    }

    /** A body in flight takes its contacts out of the pile, though it touches. */
    @Test
    void whatIsInFlightJoinsNothing() {
        int left = piled();
        int flyer = pile.body(BodyType.DYNAMIC);
        int right = piled();
        int floor = pile.body(BodyType.STATIC);
        pile.contact(left, flyer, 2);
        pile.contact(flyer, right, 2);
        pile.contact(flyer, floor, 2);
        build();

        assertThat(groups()).containsExactly(List.of(left), List.of(right));
        assertThat(contacts()).containsExactly(List.of(), List.of());
    }

    /** Marked as piled when it fell asleep, perhaps. */
    @Test
    void sleepersJoinNothing() {
        int left = piled();
        int sleeper = piled();
        int right = piled();
        pile.bodies.awake[sleeper] = false;
        pile.contact(left, sleeper, 2);
        pile.contact(sleeper, right, 2);
        build();

        assertThat(groups()).containsExactly(List.of(left), List.of(right));
        assertThat(contacts()).containsExactly(List.of(), List.of());
    }

    /** What an earlier step looked at is still written behind the lists of this one. */
    @Test
    void whatIsOverJoinsNothing() {
        int left = piled();
        int right = piled();
        int third = piled();
        pile.contact(left, right, 2);
        build();
        assertThat(groups()).containsExactly(List.of(left, right), List.of(third));
        pile.pairs.beginStep();
        pile.bodies.awake[third] = false;
        build();

        assertThat(groups()).containsExactly(List.of(left), List.of(right));
        assertThat(contacts()).containsExactly(List.of(), List.of());
    }

    @Test
    void pairsWithoutPointsJoinNothing() {
        int left = piled();
        int right = piled();
        pile.contact(left, right, 0);
        build();

        assertThat(groups()).containsExactly(List.of(left), List.of(right));
        assertThat(contacts()).containsExactly(List.of(), List.of());
    }

    @Test
    void withoutAPileThereAreNoIslands() {
        pile.contact(pile.body(BodyType.DYNAMIC), pile.body(BodyType.STATIC), 2);
        build();

        assertThat(islands.count).isZero();
    }

    /** One builder serves every step, and keeps nothing of the islands of the step before. */
    @Test
    void islandsAreBuiltAnewEveryStep() {
        int left = piled();
        int right = piled();
        int contact = pile.contact(left, right, 1);
        IslandBuilder builder = new IslandBuilder(pile.data);
        pile.accept();
        builder.build();
        assertThat(groups()).containsExactly(List.of(left, right));
        pile.pairs.points[contact] = 0;
        builder.build();
        assertThat(groups()).containsExactly(List.of(left), List.of(right));
        pile.bodies.piled[left] = false;
        builder.build();
        assertThat(groups()).containsExactly(List.of(right));
    }

    /** Whatever the graph: more bodies and islands than any first capacity, in some of them. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15})
    void islandsAreTheConnectedGroups(int seed) {
        Random random = new Random(seed);
        int count = 1 + random.nextInt(120);
        for (int i = 0; i < count; i++) {
            int slot = pile.body(BodyType.values()[Math.max(0, random.nextInt(8) - 5)]);
            pile.bodies.velocityX[slot] = random.nextInt(2);
            pile.bodies.piled[slot] = random.nextInt(8) > 0;
            pile.bodies.awake[slot] = random.nextInt(8) > 0;
        }
        joinAtRandom(random, count, random.nextInt(2 * count));
        build();

        TreeMap<Integer, List<Integer>> groups = expectedGroups();
        assertThat(groups()).as("seed %s", seed).isEqualTo(new ArrayList<>(groups.values()));
        assertThat(contacts()).as("seed %s", seed).isEqualTo(expectedContacts(groups()));
    }

    private void joinAtRandom(Random random, int count, int contacts) {
        for (int i = 0; i < contacts; i++) {
            int a = random.nextInt(count);
            int b = random.nextInt(count);
            boolean canMeet = a != b && (pile.bodies.isDynamic(a) || pile.bodies.isDynamic(b));
            if (canMeet && pile.pairs.index.find(Math.min(a, b), Math.max(a, b)) < 0) {
                pile.contact(a, b, random.nextInt(3));
            }
        }
    }

    private boolean isPiled(int slot) {
        return pile.bodies.isDynamic(slot) && pile.bodies.awake[slot] && pile.bodies.piled[slot];
    }

    private boolean isOfAPile(int pair) {
        int a = pile.pairs.bodyA[pair];
        int b = pile.pairs.bodyB[pair];
        return pile.pairs.points[pair] > 0
                && (isPiled(a) || !pile.bodies.isDynamic(a))
                && (isPiled(b) || !pile.bodies.isDynamic(b));
    }

    /** By the lowest slot of each group, which is also how islands are numbered. */
    private TreeMap<Integer, List<Integer>> expectedGroups() {
        int[] lowest = new int[pile.bodies.slots.high];
        Arrays.setAll(lowest, slot -> slot);
        for (int round = 0; round < lowest.length; round++) {
            for (int pair = 0; pair < pile.pairs.slots.high; pair++) {
                int a = pile.pairs.bodyA[pair];
                int b = pile.pairs.bodyB[pair];
                if (isOfAPile(pair) && isPiled(a) && isPiled(b)) {
                    lowest[a] = lowest[b] = Math.min(lowest[a], lowest[b]);
                }
            }
        }
        TreeMap<Integer, List<Integer>> groups = new TreeMap<>();
        for (int slot = 0; slot < lowest.length; slot++) {
            if (isPiled(slot)) {
                groups.computeIfAbsent(lowest[slot], leader -> new ArrayList<>()).add(slot);
            }
        }
        return groups;
    }

    private List<List<Integer>> expectedContacts(List<List<Integer>> groups) {
        List<List<Integer>> contacts = new ArrayList<>();
        for (List<Integer> group : groups) {
            List<Integer> here = new ArrayList<>();
            for (int pair = 0; pair < pile.pairs.slots.high; pair++) {
                boolean isHere =
                        group.contains(pile.pairs.bodyA[pair])
                                || group.contains(pile.pairs.bodyB[pair]);
                if (isHere && isOfAPile(pair)) {
                    here.add(pair);
                }
            }
            contacts.add(here);
        }
        return contacts;
    }

    /** A chain whose links come in any order: bodies and numbers are the same. */
    @Test
    void theOrderOfPairsDoesNotMatter() {
        for (int i = 0; i < 60; i++) {
            piled();
        }
        List<Integer> links = new ArrayList<>();
        for (int i = 0; i < 57; i++) {
            links.add(pile.contact(i, i + 3, 1));
        }
        build();
        List<List<Integer>> before = groups();
        assertThat(before).hasSize(3);
        Collections.shuffle(links, new Random(1));
        pile.pairs.beginStep();
        links.forEach(pile.pairs::activate);
        build();

        assertThat(groups()).isEqualTo(before);
    }
}
