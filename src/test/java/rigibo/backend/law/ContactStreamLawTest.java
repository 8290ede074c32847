package rigibo.backend.law;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.ContactEvent;
import rigibo.backend.ContactEvent.Phase;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Of any two bodies the steps tell BEGIN, PERSIST in every further step, END, and so on, whatever
 * is edited in between, and of nobody any more once all are gone. No push goes untold.
 */
@Execution(ExecutionMode.CONCURRENT)
class ContactStreamLawTest {

    private static final int TRAY = 3;
    private static final int STEPS = 240;
    private static final int STEPS_PER_EDIT = 3;

    /** Contacts are undeclared every so many steps, and for so many. */
    private static final int CONTACTS_GO = 97;

    private static final int STEPS_WITHOUT = 2;

    /** m/s: well above the round-off of passes at speeds of some 10 m/s. */
    private static final double PUSHED = 1e-9;

    /** Rounding of a normal's length, squared. */
    private static final double ROUNDING = 1e-12;

    @ParameterizedTest
    @CsvSource({"DRAFT, 30, 2900", "GAME, 30, 2900", "EXACT, 8, 650"})
    void everyContactBeginsPersistsAndEnds(Preset preset, int scenes, long contacts) {
        Laws.hold(
                Seeds.upTo(scenes),
                seed -> {
                    RandomScene tray = Surroundings.tray(seed, preset.accuracy);
                    // One that falls asleep at once, so that contacts are left as they just began.
                    double seconds = seed % 3 == 0 ? 0.5 : RandomScene.DT;
                    return tray.effects(tray.effects().with(new Sleep(seconds, 0.02)));
                },
                ContactStreamLawTest::streams,
                new Quota(contacts, "contacts begun"));
    }

    /** In space nothing else changes a velocity, so whoever got another one is in a contact. */
    @ParameterizedTest
    @CsvSource({"DRAFT, 300, 3500", "GAME, 300, 3500", "EXACT, 100, 1300"})
    void whoeverIsPushedIsTold(Preset preset, int scenes, long pushes) {
        Laws.hold(
                Seeds.upTo(scenes),
                seed -> Surroundings.meeting(seed, preset.accuracy),
                ContactStreamLawTest::tellsOfPushes,
                new Quota(pushes, "bodies pushed"));
    }

    private static Optional<String> tellsOfPushes(RandomScene scene, Asked asked) {
        Pool pool = scene.pool();
        for (int step = 1; step <= scene.steps(); step++) {
            Map<RigidBody, State> before = new HashMap<>();
            pool.bodies().forEach(body -> before.put(body, State.of(body)));
            pool.step(RandomScene.DT);
            Set<RigidBody> told = new HashSet<>();
            for (ContactEvent event : pool.contactEvents()) {
                if (event.phase() != Phase.END && event.impulse() > 0) {
                    told.addAll(List.of(event.a(), event.b()));
                }
            }
            for (RigidBody body : pool.bodies()) {
                State was = before.get(body);
                double changeX = body.velocityX() - was.velocityX();
                double changeY = body.velocityY() - was.velocityY();
                boolean isPushed = Math.hypot(changeX, changeY) > PUSHED;
                asked.more(isPushed ? 1 : 0);
                if (isPushed && !told.contains(body)) {
                    return Optional.of("step " + step + " pushed, and did not tell of " + body);
                }
            }
        }
        return Optional.empty();
    }

    private static Optional<String> streams(RandomScene scene, Asked asked) {
        Pool pool = scene.steps(0).finished();
        Effects effects = pool.effects();
        RandomEdits edits = new RandomEdits(pool, TRAY, scene.seed());
        Listener listener = new Listener();
        Optional<String> broken = Optional.empty();
        for (int step = 1; step <= STEPS && broken.isEmpty(); step++) {
            if (pool.bodies().size() > TRAY && step % STEPS_PER_EDIT == 0) {
                edits.rough();
            }
            if (step % CONTACTS_GO == 0) {
                pool.effects(Effects.of(new Gravity(0, -9.81), new Rotation()));
            } else if (step % CONTACTS_GO == STEPS_WITHOUT) {
                pool.effects(effects);
            }
            pool.step(RandomScene.DT);
            asked.more(Contacts.begun(pool));
            broken = listener.hear(pool, step);
        }
        return broken.or(() -> removed(pool, listener));
    }

    private static Optional<String> removed(Pool pool, Listener listener) {
        for (RigidBody body : List.copyOf(pool.bodies())) {
            pool.remove(body);
        }
        pool.step(RandomScene.DT);
        Optional<String> broken = listener.hear(pool, STEPS + 1);
        if (broken.isEmpty() && !listener.touching.isEmpty()) {
            return Optional.of("never ended: " + listener.touching.keySet());
        }
        pool.step(RandomScene.DT);
        return broken.or(() -> listener.hear(pool, STEPS + 2));
    }

    /** The pairs that touch, according to the events. */
    private static final class Listener {

        /** The step that last told of two bodies. */
        private final Map<Set<RigidBody>, Integer> touching = new HashMap<>();

        private Optional<String> hear(Pool pool, int step) {
            for (ContactEvent event : pool.contactEvents()) {
                if (!isDue(event, step)) {
                    return Optional.of("step " + step + ": " + event);
                }
            }
            return touching.entrySet().stream()
                    .filter(entry -> entry.getValue() != step)
                    .map(entry -> "step " + step + " tells nothing of " + entry.getKey())
                    .findAny();
        }

        private boolean isDue(ContactEvent event, int step) {
            Set<RigidBody> two = Set.of(event.a(), event.b());
            Integer last = touching.get(two);
            boolean isNext = event.phase() == Phase.BEGIN ? last == null : isOf(last, step - 1);
            double length = event.normalX() * event.normalX() + event.normalY() * event.normalY();
            if (event.phase() == Phase.END) {
                touching.remove(two);
            } else {
                touching.put(two, step);
            }
            boolean isNamedRightly = event.phase() == Phase.END || event.bothAlive();
            return isNext && isNamedRightly && Math.abs(length - 1) < ROUNDING;
        }

        private static boolean isOf(Integer told, int step) {
            return told != null && told == step;
        }
    }
}
