package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.ContactEvent.Phase;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Filter;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** A contact that an edit ends is told like any other, and read without allocating. */
class ContactEndsTest {

    private static final BodyDefinition BOX = BodyDefinition.dynamic(Polygon.box(1, 1));

    private static final int VISITS = 200;

    private final Pool pool = Scenes.restless();
    private RigidBody floor;
    private RigidBody box;
    private long seen;
    private final Consumer<ContactView> counting = contact -> seen++;

    @BeforeEach
    void standing() {
        floor = Scenes.addFloor(pool);
        box = pool.add(BOX.at(3, 0.5));
        Scenes.run(pool, 30);
        assertThat(only(pool).phase()).isEqualTo(Phase.PERSIST);
    }

    @Test
    void removalEndsTheContactOnceAndNamesTheRemoved() {
        ContactEvent before = only(pool);
        pool.remove(box);
        assertThat(pool.contactEvents()).as("until the next step").containsExactly(before);
        pool.step(Scenes.DT);
        ContactEvent end = only(pool);
        assertThat(end.phase()).isEqualTo(Phase.END);
        assertThat(List.of(end.a(), end.b())).containsExactlyInAnyOrder(floor, box);
        assertThat(box.isAlive()).isFalse();
        assertThat(end.bothAlive()).isFalse();
        assertThat(end.x()).isEqualTo(before.x());
        assertThat(end.normalY()).isEqualTo(before.normalY());
        assertThat(end.impulse()).isZero();
        requireNothingMore();
    }

    @Test
    void removalOfBothEndsTheContactOnce() {
        pool.remove(box);
        pool.remove(floor);
        requireEnd();
    }

    @Test
    void teleportEndsTheContact() {
        box.moveTo(3, 50, 0);
        requireEnd();
    }

    @Test
    void teleportAndRemovalEndTheContactOnce() {
        box.moveTo(3, 50, 0);
        pool.remove(box);
        requireEnd();
    }

    /** A body that is moved along a floor step by step would else begin to touch in each. */
    @Test
    void contactPersistsWhenItIsThereAgainAfterTheStep() {
        for (int i = 0; i < 5; i++) {
            box.moveTo(3 + 0.1 * i, 0.5, 0);
            assertThat(only(pool).phase()).as("before step %d", i).isEqualTo(Phase.PERSIST);
            pool.step(Scenes.DT);
            assertThat(only(pool).phase()).as("step %d", i).isEqualTo(Phase.PERSIST);
        }
    }

    @Test
    void anotherShapeThatDoesNotReachEndsTheContact() {
        box.shape(new Circle(0.1));
        requireEnd();
    }

    @Test
    void filterThatExcludesEverybodyEndsTheContact() {
        box.filter(Filter.ALL.mask(0));
        requireEnd();
    }

    @Test
    void filterThatStillMeetsTheOtherKeepsTheContact() {
        box.filter(Filter.ALL.category(2));
        pool.step(Scenes.DT);
        assertThat(only(pool).phase()).isEqualTo(Phase.PERSIST);
    }

    @Test
    void disabledBodyLeavesTheContact() {
        box.disable();
        requireEnd();
    }

    @Test
    void bodyThatBecomesStaticLeavesTheContact() {
        box.type(BodyType.STATIC);
        requireEnd();
    }

    @Test
    void bodyThatBecomesKinematicAndDynamicAgainPersists() {
        box.type(BodyType.KINEMATIC);
        box.type(BodyType.DYNAMIC);
        pool.step(Scenes.DT);
        assertThat(only(pool).phase()).isEqualTo(Phase.PERSIST);
    }

    @Test
    void contactsNoLongerDeclaredEnd() {
        pool.effects(Effects.of(new Gravity(0, -9.81), new Rotation()));
        requireEnd();
    }

    /** The slot is used again, and the body in it is another one. */
    @Test
    void anotherBodyInThePlaceOfTheRemovedBegins() {
        int slot = box.slot();
        pool.remove(box);
        RigidBody other = pool.add(BOX.at(3, 0.5));
        assertThat(other.slot()).isEqualTo(slot);
        pool.step(Scenes.DT);
        assertThat(pool.contactEvents())
                .extracting(event -> event.phase() + " " + (event.b() == box || event.a() == box))
                .containsExactlyInAnyOrder("END true", "BEGIN false");
        pool.step(Scenes.DT);
        assertThat(only(pool).phase()).isEqualTo(Phase.PERSIST);
    }

    @Test
    void whatNeverTouchedDoesNotEnd() {
        RigidBody flying = pool.add(BOX.at(-3, 20));
        pool.step(Scenes.DT);
        pool.remove(flying);
        pool.step(Scenes.DT);
        assertThat(only(pool).phase()).isEqualTo(Phase.PERSIST);
    }

    /** An end that the last step told is not told again when the body is removed then. */
    @Test
    void endOfALeavingBodyIsToldOnce() {
        box.velocity(0, 5);
        Scenes.run(pool, 1);
        while (only(pool).phase() != Phase.END) {
            pool.step(Scenes.DT);
        }
        pool.remove(box);
        assertThat(only(pool).phase()).isEqualTo(Phase.END);
        requireNothingMore();
    }

    /** It fell asleep in the step in which it began to touch, and nobody looks at it again. */
    @Test
    void sleeperDoesNotBeginInEveryStep() {
        Pool sleepy =
                new Pool(
                        Effects.of(
                                new Gravity(0, -9.81),
                                new Contacts(),
                                new Rotation(),
                                new Sleep(0.5 * Scenes.DT, 0.1)),
                        Accuracy.GAME);
        Scenes.addFloor(sleepy);
        RigidBody sleeper = sleepy.add(BOX.at(0, 0.5));
        sleepy.step(Scenes.DT);
        assertThat(sleeper.isAwake()).isFalse();
        assertThat(only(sleepy).phase()).isEqualTo(Phase.BEGIN);
        Pool restored = Pool.restore(sleepy.snapshot());
        for (int i = 0; i < 5; i++) {
            sleepy.step(Scenes.DT);
            restored.step(Scenes.DT);
            assertThat(only(sleepy).phase()).as("step %d", i).isEqualTo(Phase.PERSIST);
            assertThat(only(restored).phase()).as("step %d", i).isEqualTo(Phase.PERSIST);
            assertThat(restored.stateHash()).isEqualTo(sleepy.stateHash());
        }
    }

    @Test
    void restoredPoolTellsTheEndsOfWhatItHas() {
        RigidBody other = pool.add(BOX.at(6, 0.5));
        RigidBody third = pool.add(BOX.at(9, 0.5));
        Scenes.run(pool, 2);
        box.moveTo(3, 50, 0);
        pool.remove(other);
        third.moveTo(9.1, 0.5, 0);
        Pool before = Pool.restore(pool.snapshot());
        requireTellsTheSame(before);
        pool.step(Scenes.DT);
        before.step(Scenes.DT);
        assertThat(pool.contactEvents())
                .extracting(ContactEvent::phase)
                .containsExactlyInAnyOrder(Phase.PERSIST, Phase.END, Phase.END);
        requireTellsTheSame(before);
        Pool after = Pool.restore(pool.snapshot());
        requireTellsTheSame(after);
        pool.step(Scenes.DT);
        after.step(Scenes.DT);
        requireTellsTheSame(after);
    }

    private void requireTellsTheSame(Pool restored) {
        assertThat(told(restored)).isEqualTo(told(pool));
        assertThat(restored.stateHash()).isEqualTo(pool.stateHash());
    }

    /** The contacts that both pools can name, by slots. */
    private static List<String> told(Pool pool) {
        List<String> told = new ArrayList<>();
        pool.forEachContact(
                contact -> {
                    if (contact.bothAlive()) {
                        told.add(
                                String.format(
                                        "%d %d %s at %s %s, %s",
                                        contact.a.slot(),
                                        contact.b.slot(),
                                        contact.phase,
                                        contact.x,
                                        contact.y,
                                        contact.impulse));
                    }
                });
        return told;
    }

    @Test
    void visitorSeesWhatTheListTells() {
        pool.add(BOX.at(6, 0.5));
        RigidBody gone = pool.add(BOX.at(9, 0.5));
        Scenes.run(pool, 2);
        pool.remove(gone);
        pool.step(Scenes.DT);
        List<ContactEvent> visited = new ArrayList<>();
        pool.forEachContact(contact -> visited.add(contact.event()));
        assertThat(visited).hasSize(3).isEqualTo(pool.contactEvents());
    }

    @Test
    void visitWithinAVisitLeavesTheOuterViewAlone() {
        pool.add(BOX.at(6, 0.5));
        Scenes.run(pool, 2);
        pool.forEachContact(
                contact -> {
                    ContactEvent before = contact.event();
                    assertThat(pool.contactEvents()).hasSize(2);
                    assertThat(contact.event()).isEqualTo(before);
                });
    }

    @Test
    void poolCannotBeChangedWhileItsContactsAreVisited() {
        List<Runnable> changes =
                List.of(
                        () -> pool.remove(box),
                        () -> pool.add(BOX),
                        () -> box.velocity(0, 1),
                        () -> pool.step(Scenes.DT),
                        () -> pool.effects(Effects.usual()));
        for (Runnable change : changes) {
            assertThatThrownBy(() -> pool.forEachContact(contact -> change.run()))
                    .isInstanceOf(IllegalStateException.class)
                    .hasMessageContaining("while contacts are visited");
        }
        pool.remove(box);
        requireEnd();
    }

    /** A list of a thousand contacts takes 87 kB. */
    @Test
    void visitorAllocatesNothing() {
        for (int i = 0; i < 1000; i++) {
            pool.add(BOX.at(5 + 1.5 * i, 0.5).mass(1));
        }
        floor.shape(Polygon.box(4000, 1));
        Scenes.run(pool, 2);
        pool.remove(box);
        pool.step(Scenes.DT);
        assertThat(Allocation.ofThirdRun(this::visitOften)).isZero();
        assertThat(seen).isEqualTo(3 * VISITS * 1001);
    }

    /** So often that its code is compiled before it is measured: compiling may make constants. */
    private void visitOften() {
        for (int i = 0; i < VISITS; i++) {
            pool.forEachContact(counting);
        }
    }

    private void requireEnd() {
        pool.step(Scenes.DT);
        assertThat(only(pool).phase()).isEqualTo(Phase.END);
        assertThat(only(pool).x()).isCloseTo(3, within(1e-6));
        requireNothingMore();
    }

    private void requireNothingMore() {
        for (int i = 0; i < 3; i++) {
            pool.step(Scenes.DT);
            assertThat(pool.contactEvents()).isEmpty();
        }
    }

    private static ContactEvent only(Pool pool) {
        assertThat(pool.contactEvents()).hasSize(1);
        return pool.contactEvents().get(0);
    }
}
