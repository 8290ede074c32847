package rigibo.lab.precision;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** Our {@code GAME} beside other engines at one problem. */
final class Comparison {

    /** The one that is native code behind a Java face. */
    private static final String NATIVE = "gdx";

    private final Asked asked;
    private final Point game;

    private Comparison(Asked asked, Point game) {
        this.asked = asked;
        this.game = game;
    }

    /** Where both have points. */
    static Optional<Comparison> of(Asked asked) {
        return asked.preset("GAME")
                .filter(game -> !asked.peers().isEmpty())
                .map(game -> new Comparison(asked, game));
    }

    Point game() {
        return game;
    }

    /** All of them, as they come and finer. */
    List<Point> others() {
        return asked.peers().stream().flatMap(peer -> asked.of(peer).stream()).toList();
    }

    /** Those that are not less accurate, where errors that count as equal are equal. */
    List<Point> asAccurate() {
        return others().stream()
                .filter(other -> !other.errors().hasFailed())
                .filter(other -> error(other) <= error(game))
                .toList();
    }

    private double error(Point point) {
        return Math.max(point.errors().main(), asked.problem().equalBelow());
    }

    /** Whether every other one errs more, or failed. */
    boolean isMostAccurate() {
        return !game.errors().hasFailed() && asAccurate().isEmpty();
    }

    /** The fastest that is written in Java, by step, of those timed. */
    Optional<Point> fastestJava() {
        return others().stream()
                .filter(other -> !other.engine().startsWith(NATIVE))
                .filter(other -> other.timing().isPresent())
                .min(Comparator.comparingDouble(Comparison::micros));
    }

    /** Time of our step over that of the fastest in Java; empty where one was not timed. */
    Optional<Double> slowdown() {
        return game.timing().isEmpty()
                ? Optional.empty()
                : fastestJava().map(other -> micros(game) / micros(other));
    }

    /** Whether no Java engine's step takes less time, within what the timing can tell. */
    boolean isNoSlower() {
        Optional<Point> fastest = fastestJava();
        return fastest.isEmpty()
                || game.timing().isPresent()
                        && game.timing().get().cpuLow() <= fastest.get().timing().get().cpuHigh();
    }

    private static double micros(Point point) {
        return point.timing().orElseThrow().cpu();
    }
}
