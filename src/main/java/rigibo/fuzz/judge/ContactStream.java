package rigibo.fuzz.judge;

import static rigibo.fuzz.judge.LawBroken.unless;

import rigibo.backend.ContactEvent;
import rigibo.backend.ContactEvent.Phase;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;

import java.util.HashSet;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Checks that the steps report BEGIN, then PERSIST in every further step, then END for any two
 * bodies, whatever is done in between. Bodies are identified by their names, which a restored pool
 * keeps.
 */
final class ContactStream {

    private static final String LAW = "contacts begin, persist and end";
    private static final String FORM = "contact events are well formed";

    /** The tolerance of a unit vector's square. */
    private static final double ROUND_OFF = 1e-9;

    /** The pairs that touched in the step before. */
    private Set<String> touching = new HashSet<>();

    void after(Pool pool) {
        Set<String> now = new HashSet<>();
        Set<String> told = new HashSet<>();
        for (ContactEvent event : pool.contactEvents()) {
            requireWellFormed(pool, event);
            String pair = pair(event);
            unless(told.add(pair), LAW, "twice in a step: %s", event);
            unless(touching.contains(pair) == (event.phase() != Phase.BEGIN), LAW, "%s", event);
            if (event.phase() != Phase.END) {
                now.add(pair);
            }
        }
        touching.removeAll(told);
        unless(touching.isEmpty(), LAW, "not told whether they touch still: %s", touching);
        touching = now;
    }

    /**
     * A restored pool has no handle on bodies that were removed before, so it cannot report the end
     * of their contacts.
     */
    void restored(Pool pool) {
        Set<String> names = pool.bodies().stream().map(RigidBody::name).collect(Collectors.toSet());
        touching.removeIf(
                pair ->
                        !Stream.of(pair.split("-"))
                                .allMatch(one -> names.contains(one.split("/")[0])));
    }

    private static String pair(ContactEvent event) {
        String a = event.a().name() + "/" + event.partA();
        String b = event.b().name() + "/" + event.partB();
        return a.compareTo(b) < 0 ? a + "-" + b : b + "-" + a;
    }

    private static void requireWellFormed(Pool pool, ContactEvent event) {
        boolean isEnd = event.phase() == Phase.END;
        unless(event.a() != event.b(), FORM, "%s is of one body", event);
        unless(event.bothAlive() || isEnd, FORM, "%s is of a removed body", event);
        double square = event.normalX() * event.normalX() + event.normalY() * event.normalY();
        unless(Math.abs(square - 1) <= ROUND_OFF, FORM, "the normal of %s", event);
        unless(Double.isFinite(event.x()) && Double.isFinite(event.y()), FORM, "%s", event);
        boolean pushes = event.impulse() >= 0 && event.impulse() < Double.POSITIVE_INFINITY;
        unless(pushes, FORM, "the impulse of %s", event);
        if (event.bothAlive()) {
            boolean touch = pool.touching(event.a(), event.b());
            unless(touch == pool.touching(event.b(), event.a()), FORM, "one way: %s", event);
            unless(!touch || !isEnd || !areWhole(event), FORM, "touch and have ended: %s", event);
        }
    }

    /** Whether no other parts of the two bodies, and no former outlines, can still touch. */
    private static boolean areWhole(ContactEvent event) {
        return event.a().shape().parts() + event.b().shape().parts() == 2
                && event.partA() + event.partB() == 0;
    }
}
