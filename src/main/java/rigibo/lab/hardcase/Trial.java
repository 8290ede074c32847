package rigibo.lab.hardcase;

import rigibo.backend.StepReport;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Earth;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;

/** One run of a case at one preset: makes its pools and keeps the worst of every figure. */
public final class Trial {

    /** Acceleration of the Earth's gravity, m/s². */
    static final double GRAVITY = Earth.GRAVITY;

    /** The game's step, s. */
    static final double DT = 1.0 / 60;

    /** L: the overlap allowed at rest, m, for bodies of one metre. */
    static final double TOLERATED_OVERLAP = 1e-3;

    /** The largest overlap allowed at any time, as a share of the smaller body's width. */
    private static final double MOST_OVERLAP = 0.02;

    /** The error of momentum that is allowed, as a share of the sum of all momenta. */
    private static final double MOST_MOMENTUM_LOST = 1e-9;

    /** The round-off allowed for energies that become motion and back, as a share. */
    private static final double MOST_ENERGY_BEYOND = 1e-9;

    /** A prime factor, so that the order of hashes matters. */
    private static final long HASH_FACTOR = 0x100000001b3L;

    /** The number of workers in the second run of a case. */
    static final int SEVERAL = 3;

    private final Preset preset;
    private final Preset limitedFrom;
    private final Sampling sampling;
    private final UnaryOperator<BodyDefinition> made;
    private final int workers;
    private final Map<String, Measure> measures = new LinkedHashMap<>();
    private final Map<String, Measure> invariants = new LinkedHashMap<>();
    private CaseWork work = CaseWork.NONE;
    private String variant = "";
    private long hash;

    /**
     * A run at a preset, by a number of workers. The case's own figures have limits from {@code
     * limitedFrom} on, and {@code made} may replace its bodies.
     */
    Trial(
            Preset preset,
            Preset limitedFrom,
            Sampling sampling,
            UnaryOperator<BodyDefinition> made,
            int workers) {
        this.made = made;
        this.workers = workers;
        this.preset = preset;
        this.limitedFrom = limitedFrom;
        this.sampling = sampling;
    }

    Preset preset() {
        return preset;
    }

    int workers() {
        return workers;
    }

    /** The choice among the variants of a case. */
    Sampling sampling() {
        return sampling;
    }

    /** The body that replaces one of the case's. */
    BodyDefinition made(BodyDefinition body) {
        return made.apply(body);
    }

    /** Names the present variant in reports of figures that fail. */
    void variant(String words) {
        variant = words;
    }

    /** A watched pool at this trial's preset. */
    WatchedPool pool(Effects effects) {
        return new WatchedPool(this, variant, effects);
    }

    /** A pool with gravity and without sleep: a scene that rests only asleep does not rest. */
    WatchedPool earth() {
        return pool(Earth.effects());
    }

    /** A pool with gravity and a floor at y = 0 of a friction and elasticity. */
    WatchedPool ground(double friction, double elasticity) {
        WatchedPool pool = earth();
        pool.add(Earth.floor(friction, elasticity));
        return pool;
    }

    /** A pool without gravity. */
    WatchedPool space() {
        return pool(Earth.space());
    }

    /** A pool with joints and gravity. */
    WatchedPool jointedEarth() {
        return pool(Earth.effects().with(new Joints()));
    }

    /** A pool with joints and without gravity. */
    WatchedPool jointedSpace() {
        return pool(Earth.space().with(new Joints()));
    }

    /** Records a figure with a limit for EXACT and one for the other presets that have limits. */
    void measure(String name, double figure, String unit, double exact, double game) {
        measure(name, figure, unit, Limits.of(game, exact));
    }

    /** Records a figure with limits by preset. */
    void measure(String name, double figure, String unit, Limits limits) {
        boolean isReported = preset.compareTo(limitedFrom) < 0;
        double held = isReported ? Double.POSITIVE_INFINITY : limits.of(preset);
        keep(measures, name, figure, unit, held, variant);
    }

    /** Records a figure with one limit for all presets that have limits. */
    void measure(String name, double figure, String unit, double limit) {
        measure(name, figure, unit, limit, limit);
    }

    /** Records the relative error of a value, with a limit for EXACT and one for other presets. */
    void relativeError(
            String name, double value, double truth, String unit, double exact, double game) {
        relativeError(name, value, truth, unit, Limits.of(game, exact));
    }

    /** Records the relative error of a value, with limits by preset. */
    void relativeError(String name, double value, double truth, String unit, Limits limits) {
        measure(name, Math.abs(value / truth - 1), unit, limits);
    }

    /** Records the relative error of a value, with one limit for all presets. */
    void relativeError(String name, double value, double truth, String unit, double limit) {
        relativeError(name, value, truth, unit, limit, limit);
    }

    /** Records a figure without a limit. */
    void report(String name, double figure, String unit) {
        measure(name, figure, unit, Double.POSITIVE_INFINITY);
    }

    /** Records whether a statement holds, as it must at all presets that have limits. */
    void require(String statement, boolean holds) {
        measure(statement, holds ? 0 : 1, "broken", 0);
    }

    /** Records whether a statement holds, as it must at every preset, DRAFT included. */
    void requireAlways(String statement, boolean holds) {
        keep(invariants, statement, holds ? 0 : 1, "broken", 0, variant);
    }

    void energyGain(double share, String where) {
        double limit = preset == Preset.EXACT ? 1e-6 : 1e-3;
        keep(invariants, "energy gained in a step", share, "of E0", limit, where);
    }

    void energyBeyondStart(double share, String where) {
        String unit = "of what could be released";
        keep(invariants, "energy beyond the start", share, unit, MOST_ENERGY_BEYOND, where);
    }

    void overlap(double share, String where) {
        keep(invariants, "overlap", share, "width", MOST_OVERLAP, where);
    }

    void momentumError(double share, String where) {
        keep(invariants, "momentum lost", share, "of all", MOST_MOMENTUM_LOST, where);
    }

    void notFinite(int bodies, String where) {
        keep(invariants, "bodies that are not finite", bodies, "bodies", 0, where);
    }

    void fold(long stateHash) {
        hash = hash * HASH_FACTOR + stateHash;
    }

    /** A hash of all states so far and of their order. */
    long hash() {
        return hash;
    }

    void compare(Trial again) {
        String difference = Long.toHexString(hash) + " and " + Long.toHexString(again.hash);
        boolean isEqual = hash == again.hash;
        keep(
                invariants,
                "hashes of two runs that differ",
                isEqual ? 0 : 1,
                "hashes",
                0,
                isEqual ? "" : difference);
    }

    List<Measure> measures() {
        List<Measure> all = new ArrayList<>(measures.values());
        all.addAll(invariants.values());
        return all;
    }

    /** Adds a step to the work of the case. */
    void count(StepReport step) {
        work = work.plus(step);
    }

    CaseWork work() {
        return work;
    }

    private static void keep(
            Map<String, Measure> kept,
            String name,
            double figure,
            String unit,
            double limit,
            String where) {
        kept.merge(name, new Measure(name, figure, limit, unit, where), Measure::worse);
    }
}
