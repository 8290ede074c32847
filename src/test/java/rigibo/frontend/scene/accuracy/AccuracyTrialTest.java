package rigibo.frontend.scene.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

import java.util.Optional;

/** Time passes only where a field is asked for its force. */
class AccuracyTrialTest {

    private long now;
    private long longest;
    private final Effects effects = Effects.of(new Field(point -> now++));
    private final Pool pool = new Pool(effects, Accuracy.GAME);

    private AccuracyTrial.Result result(Accuracy accuracy) {
        return result(accuracy, Long.MAX_VALUE);
    }

    private AccuracyTrial.Result result(Accuracy accuracy, long mostPiece) {
        pool.add(BodyDefinition.dynamic(new Circle(0.5)));
        AccuracyTrial trial =
                new AccuracyTrial(pool.snapshot(), effects, accuracy, () -> now, mostPiece);
        Optional<AccuracyTrial.Result> found = Optional.empty();
        while (found.isEmpty()) {
            long begin = now;
            found = trial.goOn();
            longest = Math.max(longest, now - begin);
        }
        return found.get();
    }

    @Test
    void tellsWhatItTookAndHowFarItIsFromExact() {
        AccuracyTrial.Result result = result(Accuracy.DRAFT);
        assertThat(result.isWhole()).isTrue();
        assertThat(result.nanos()).isEqualTo(now);
        assertThat(result.price()).as("DRAFT beside DRAFT").isEqualTo(1);
        assertThat(result.error()).as("nothing pulls").isZero();
    }

    @Test
    void doesAStepOfOneCopyAtATime() {
        result(Accuracy.GAME);
        pool.accuracy(Accuracy.EXACT);
        long begin = now;
        pool.step(1.0 / 60);
        assertThat(longest).isPositive().isEqualTo(now - begin);
    }

    /** A single round: of EXACT, a step is made and no more. */
    @Test
    void endsWithTheRoundInWhichAPieceTakesTooLong() {
        AccuracyTrial.Result result = result(Accuracy.DRAFT, 1);
        assertThat(result.steps()).isEqualTo(1);
        assertThat(result.isWhole()).isFalse();
        assertThat(result.price()).as("DRAFT beside DRAFT").isEqualTo(1);
        assertThat(result.longest()).isEqualTo(longest).isGreaterThan(1);
    }
}
