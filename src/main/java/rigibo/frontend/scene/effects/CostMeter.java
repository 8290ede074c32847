package rigibo.frontend.scene.effects;

import rigibo.backend.Pool;
import rigibo.backend.StepReport;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.backend.setup.StepStage;
import rigibo.frontend.scene.trial.Subject;
import rigibo.frontend.scene.trial.Trials;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;

/**
 * Measures what each effect of a running scene costs, one trial after another on copies of its
 * pool. The game's thread only takes a snapshot at intervals and checks whether a trial is done; it
 * never waits. Everything except the trials runs on the game's thread, so nothing needs a lock.
 */
public final class CostMeter {

    /**
     * Snapshots take at most this part of the game's time, as 1 in n: while somebody looks, and
     * while nobody does.
     */
    private static final long WATCHED_SHARE = 200;

    private static final long UNWATCHED_SHARE = 2000;

    /**
     * Pause after a trial, as a multiple of its own time: while somebody looks, and while nobody
     * does.
     */
    private static final long SHORT_REST = 2;

    private static final long LONG_REST = 8;

    /**
     * But no shorter, ns: trials of a few ms have time; and no longer, or slow scenes learn late.
     */
    private static final long SHORTEST_REST = 60_000_000;

    private static final long LONGEST_REST = 3_000_000_000L;

    /** Turns over which the game's own step is smoothed. */
    private static final double SMOOTHING = 30;

    private final Trials trials;
    private final Map<Class<? extends Effect>, Estimate> costs = new HashMap<>();
    private double step;
    private Subject subject;
    private long trialDue;
    private CompletableFuture<CostTrial.Result> trial;
    private Effect tried;
    private boolean isWatched;
    private boolean hasWoken;
    private int turn;
    private int next;

    /** A meter whose trials run there. */
    public CostMeter(Trials trials) {
        this.trials = trials;
    }

    /** Takes in the last measurement and starts the next one. To be called between steps. */
    void turn(Pool pool, List<Effect> shown, Optional<Effect> asked) {
        Subject now = Subject.of(pool);
        if (!now.equals(subject)) {
            forget(now);
        }
        isWatched = asked.isPresent();
        observe(pool.report());
        collect();
        if (trial == null && now() >= trialDue && !shown.isEmpty()) {
            choose(shown, asked).ifPresent(this::start);
        }
    }

    private void forget(Subject now) {
        subject = now;
        costs.clear();
        step = 0;
        trial = null;
    }

    private void observe(StepReport report) {
        long nanos = 0;
        for (StepStage stage : StepStage.values()) {
            nanos += report.nanos(stage);
        }
        step = step == 0 ? nanos : step + (nanos - step) / SMOOTHING;
    }

    private void collect() {
        if (trial == null || !trial.isDone()) {
            return;
        }
        CostTrial.Result result = trial.join();
        boolean isLit = subject.effects().declares(tried.getClass());
        double cost = (isLit ? -1 : 1) * inTheGame(result);
        costs.computeIfAbsent(tried.getClass(), kind -> new Estimate()).add(cost);
        if (!(tried instanceof Sleep)) {
            // Switching sleep leaves the sleepers as they are; every other trial wakes them.
            hasWoken = result.hasWoken();
        }
        long rest = (isWatched ? SHORT_REST : LONG_REST) * result.nanos();
        trialDue = now() + Math.max(SHORTEST_REST, Math.min(LONGEST_REST, rest));
        trial = null;
    }

    /**
     * The difference as the game would feel it, ns. In the game a step takes longer than on a copy,
     * since drawing empties the caches between two steps: with 600 discs 1.5 ms instead of 0.4 ms.
     * A difference is scaled up likewise, as far as it is no longer than a step; anything beyond is
     * work, not waiting for memory. If sleepers were woken, the two steps did different work and
     * nothing is scaled.
     */
    private double inTheGame(CostTrial.Result result) {
        double copy = result.step();
        boolean isSame = step > 0 && copy > 0 && !result.hasWoken();
        double stretch = isSame ? step / copy : 1;
        double within = Math.max(-copy, Math.min(copy, result.difference()));
        return stretch * within + (result.difference() - within);
    }

    /** Every other trial is of the effect that the player looks at; the others take turns. */
    private Optional<Effect> choose(List<Effect> shown, Optional<Effect> asked) {
        turn++;
        if (turn % 2 == 0 && asked.isPresent() && canSwitch(asked.get())) {
            return asked;
        }
        for (int i = 0; i < shown.size(); i++) {
            next = (next + 1) % shown.size();
            if (canSwitch(shown.get(next))) {
                return Optional.of(shown.get(next));
            }
        }
        return Optional.empty();
    }

    private boolean canSwitch(Effect effect) {
        return Switching.of(subject.effects(), effect).effects().isPresent();
    }

    private void start(Effect effect) {
        tried = effect;
        long share = isWatched ? WATCHED_SHARE : UNWATCHED_SHARE;
        byte[] snapshot = trials.snapshot(subject, share);
        Effects switched = Switching.of(subject.effects(), effect).effects().orElseThrow();
        trial = trials.start(new CostTrial(snapshot, subject.effects(), switched, trials.clock()));
    }

    private long now() {
        return trials.clock().getAsLong();
    }

    /** Additional time of a step that a simulated effect costs, or another effect would cost. */
    Estimate cost(Effect effect) {
        return costs.getOrDefault(effect.getClass(), new Estimate());
    }

    /** Time of a step of the game, ns; 0 while unknown. */
    double step() {
        return step;
    }

    /** Whether something sleeps and is woken on the copies that are measured. */
    boolean hasWoken() {
        return hasWoken;
    }
}
