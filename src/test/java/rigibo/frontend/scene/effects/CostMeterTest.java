package rigibo.frontend.scene.effects;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import rigibo.backend.Pool;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.trial.Trials;

import java.util.ArrayDeque;
import java.util.List;
import java.util.Optional;
import java.util.Queue;

/** Time passes only where a field is asked for its force, so its cost is known to the ns. */
class CostMeterTest {

    private static final long ASKED = 700;

    /** Time on the game's clock that is longer than any pause after a trial. */
    private static final long LATER = 100_000_000_000L;

    private long now;
    private long asked;
    private final Field field =
            new Field(
                    point -> {
                        now += ASKED;
                        asked++;
                    });
    private final Gravity gravity = new Gravity(0, -9.81);
    private final Pool pool = new Pool(Effects.of(gravity, field), Accuracy.GAME);
    private final Queue<Runnable> trials = new ArrayDeque<>();
    private final CostMeter meter = new CostMeter(Trials.on(trials::add, () -> now));

    @BeforeEach
    void fill() {
        pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(0, 100));
    }

    /** Trials that are run as soon as they are asked for, with time to rest between them. */
    private void measure(int count, List<Effect> shown, Optional<Effect> watched) {
        for (int i = 0; i < count; i++) {
            meter.turn(pool, shown, watched);
            trials.forEach(Runnable::run);
            trials.clear();
            meter.turn(pool, shown, watched);
            now += LATER;
        }
    }

    private double nanosOfAStep() {
        Pool copy = Pool.restore(pool.snapshot(), pool.effects());
        asked = 0;
        copy.step(1.0 / 60);
        return ASKED * asked;
    }

    @Test
    void tellsWhatAnEffectCosts() {
        measure(Estimate.FEWEST, List.of(field), Optional.empty());
        assertThat(meter.cost(field).mean()).isPositive().isEqualTo(nanosOfAStep());
        assertThat(meter.cost(field).noise()).isZero();
    }

    @Test
    void tellsWhatAnEffectThatIsNotSimulatedWouldCost() {
        double cost = nanosOfAStep();
        pool.effects(Effects.of(gravity));
        measure(Estimate.FEWEST, List.of(field), Optional.empty());
        assertThat(meter.cost(field).mean()).isEqualTo(cost);
    }

    /** A step of the game takes three times as long as on a copy: so does what the effect costs. */
    @Test
    void tellsWhatItCostsInTheGameAndNotOnACopy() {
        double copy = nanosOfAStep();
        pool.clock(() -> 3 * now);
        pool.step(1.0 / 60);
        measure(Estimate.FEWEST, List.of(field), Optional.empty());
        assertThat(meter.step()).isCloseTo(3 * copy, within(1e-6));
        assertThat(meter.cost(field).mean()).isCloseTo(3 * copy, within(1e-6));
    }

    @Test
    void whatCostsNothingIsSaidToCostNothing() {
        measure(Estimate.FEWEST, List.of(gravity), Optional.empty());
        assertThat(meter.cost(gravity).isKnown()).isTrue();
        assertThat(meter.cost(gravity).mean()).isZero();
    }

    @Test
    void saysNothingBeforeItKnows() {
        measure(Estimate.FEWEST - 1, List.of(field), Optional.empty());
        assertThat(meter.cost(field).isKnown()).isFalse();
        assertThat(new CostWords(new Words("en")).ofLit(meter.cost(field))).isEqualTo("costs …");
        assertThat(new CostWords(new Words("en")).ofUnlit(meter.cost(field)))
                .isEqualTo("would cost … more");
        assertThat(new CostWords(new Words("en")).ofStep(meter.step())).isEqualTo("a step takes …");
    }

    @Test
    void takesTheEffectsInTurnAndEverySecondTimeTheOneThatIsAskedFor() {
        List<Effect> shown = List.of(gravity, field, new Sleep(), new Restitution());
        measure(2 * Estimate.FEWEST, shown, Optional.of(field));
        assertThat(meter.cost(field).isKnown()).isTrue();
        assertThat(meter.cost(gravity).isKnown()).as("half of the other half").isFalse();
        measure(4 * Estimate.FEWEST, shown, Optional.empty());
        assertThat(meter.cost(gravity).isKnown()).isTrue();
        assertThat(meter.cost(new Restitution()).isKnown()).as("it needs contacts").isFalse();
    }

    @Test
    void leavesThePoolAsItIs() {
        long before = pool.stateHash();
        measure(5, List.of(field, gravity), Optional.empty());
        assertThat(pool.stateHash()).isEqualTo(before);
        assertThat(pool.effects()).isEqualTo(Effects.of(gravity, field));
    }

    /** Bodies that come between two snapshots are there in the later one. */
    @Test
    void looksAtTheSceneAgainAfterAWhile() {
        measure(Estimate.FEWEST, List.of(field), Optional.empty());
        double one = meter.cost(field).mean();
        pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(10, 100));
        measure(Estimate.ROUNDS, List.of(field), Optional.empty());
        assertThat(meter.cost(field).mean()).isEqualTo(2 * one);
    }

    @Test
    void neverWaitsForATrial() {
        meter.turn(pool, List.of(field), Optional.empty());
        meter.turn(pool, List.of(field), Optional.empty());
        assertThat(trials).as("one at a time").hasSize(1);
    }

    @Test
    void restsAfterATrial() {
        meter.turn(pool, List.of(field), Optional.empty());
        trials.remove().run();
        meter.turn(pool, List.of(field), Optional.empty());
        assertThat(trials).isEmpty();
        now += LATER;
        meter.turn(pool, List.of(field), Optional.empty());
        assertThat(trials).hasSize(1);
    }

    @Test
    void forgetsWhatItKnewOfOtherEffectsOrAnotherAccuracy() {
        measure(Estimate.FEWEST, List.of(gravity), Optional.empty());
        pool.accuracy(Accuracy.FINE);
        meter.turn(pool, List.of(), Optional.empty());
        assertThat(meter.cost(gravity).isKnown()).isFalse();
        measure(Estimate.FEWEST, List.of(gravity), Optional.empty());
        pool.effects(Effects.of(gravity));
        meter.turn(pool, List.of(), Optional.empty());
        assertThat(meter.cost(gravity).isKnown()).isFalse();
    }

    /** Switching anything wakes everybody: then both pools are woken. */
    @Test
    void tellsWhenSleepersWereWoken() {
        Pool asleep = new Pool(Effects.of(gravity, new Contacts(), new Sleep()), Accuracy.GAME);
        asleep.add(BodyDefinition.fixed(Polygon.box(4, 1)).at(0, -0.5));
        asleep.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 0.5));
        for (int i = 0; i < 120; i++) {
            asleep.step(1.0 / 60);
        }
        assertThat(asleep.bodies().get(1).isAwake()).isFalse();
        meter.turn(asleep, List.of(new Restitution()), Optional.empty());
        trials.remove().run();
        meter.turn(asleep, List.of(), Optional.empty());
        assertThat(meter.hasWoken()).isTrue();
    }
}
