package rigibo.backend.law;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The laws of motion know neither numbers nor strangers. */
@Execution(ExecutionMode.CONCURRENT)
class OrderLawTest {

    private static final Seeds SEEDS = Seeds.upTo(300);

    /** m beyond everything that happens in a scene. */
    private static final double ELSEWHERE = 1000;

    /**
     * More impacts would multiply the round-off beyond the limit, as in {@link SymmetryLawTest}.
     */
    private static final int FEW = 4;

    /** m or rad: which of a pair is A changes the sign of what is rounded and the sums' order. */
    private static final double LIMIT = 1e-11;

    @ParameterizedTest
    @EnumSource(
            value = Preset.class,
            names = {"FINE", "EXACT"})
    void orderOfBodiesDoesNotMatterInFlight(Preset preset) {
        Laws.hold(
                SEEDS,
                seed -> Surroundings.meeting(seed, preset.accuracy),
                OrderLawTest::sameInAnyOrder,
                new Quota(450, "impacts"));
    }

    /** Neither do bodies that others never meet, to the last bit, piles included. */
    @ParameterizedTest
    @EnumSource(Preset.class)
    void strangersNeverMatter(Preset preset) {
        Laws.hold(
                SEEDS,
                seed -> Surroundings.tray(seed, preset.accuracy),
                OrderLawTest::sameAmongStrangers,
                new Quota(14_000, "loaded contacts in piles"));
    }

    static Optional<String> sameInAnyOrder(RandomScene scene, Asked asked) {
        List<BodyDefinition> shuffled = new ArrayList<>(scene.bodies());
        new Draw(scene.seed()).shuffle(shuffled);
        Pool pool = scene.pool();
        Pool other = scene.bodies(shuffled).pool();
        double off = 0;
        int impacts = 0;
        for (int i = 0; i < scene.steps(); i++) {
            int now = pool.step(RandomScene.DT).impacts();
            impacts += now;
            other.step(RandomScene.DT);
            if (impacts > FEW || pool.report().rows() + other.report().rows() > 0) {
                break;
            }
            asked.more(now);
            for (int k = 0; k < shuffled.size(); k++) {
                RigidBody expected = pool.bodies().get(scene.bodies().indexOf(shuffled.get(k)));
                off = Math.max(off, State.of(expected).off(State.of(other.bodies().get(k))));
            }
        }
        return asked.atMost(LIMIT, off, "in another order off by m");
    }

    static Optional<String> sameAmongStrangers(RandomScene scene, Asked asked) {
        List<BodyDefinition> strangers = new ArrayList<>();
        Surroundings.tray(scene.seed() + SEEDS.all().size(), scene.accuracy())
                .bodies()
                .forEach(body -> strangers.add(body.at(body.x() + ELSEWHERE, body.y())));
        List<BodyDefinition> crowd = new ArrayList<>(strangers);
        crowd.addAll(scene.bodies());
        List<Link> links = new ArrayList<>();
        if (!scene.links().isEmpty()) {
            links.addAll(Links.on(scene.bodies(strangers)).links());
        }
        links.addAll(scene.links());
        Pool pool = scene.pool();
        Pool other = scene.bodies(crowd).links(links).pool();
        int different = 0;
        for (int i = 0; i < scene.steps(); i++) {
            pool.step(RandomScene.DT);
            other.step(RandomScene.DT);
            asked.more(Contacts.loadedInPiles(pool));
        }
        for (int i = 0; i < scene.bodies().size(); i++) {
            State expected = State.of(pool.bodies().get(i));
            State found = State.of(other.bodies().get(strangers.size() + i));
            different += expected.isSame(found) ? 0 : 1;
        }
        return asked.atMost(0, different, "bodies that strangers matter to:");
    }
}
