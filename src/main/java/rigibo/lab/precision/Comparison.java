package rigibo.lab.precision;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** Compares our {@code GAME} with other engines at one problem. */
final class Comparison {

    /** How the names of engines in native code begin. */
    private static final List<String> NATIVE = List.of("gdx", "Box2D", "Rapier");

    private final Asked asked;
    private final Point game;

    private Comparison(Asked asked, Point game) {
        this.asked = asked;
        this.game = game;
    }

    /** The comparison for a problem, if both sides have points. */
    static Optional<Comparison> of(Asked asked) {
        return asked.game()
                .filter(game -> !asked.peers().isEmpty())
                .map(game -> new Comparison(asked, game));
    }

    Point game() {
        return game;
    }

    /** All points of other engines, at default and finer settings. */
    List<Point> others() {
        return asked.peers().stream().flatMap(peer -> asked.of(peer).stream()).toList();
    }

    /**
     * The points of other engines that are at least as accurate; errors within the problem's
     * tolerance count as equal.
     */
    List<Point> asAccurate() {
        return others().stream()
                .filter(other -> !other.errors().hasFailed())
                .filter(other -> error(other) <= error(game))
                .toList();
    }

    private double error(Point point) {
        return Math.max(point.errors().main(), asked.problem().equalBelow());
    }

    /** Whether all others have larger errors or failed. */
    boolean isMostAccurate() {
        return !game.errors().hasFailed() && asAccurate().isEmpty();
    }

    /** The engine in Java with the fastest step, among those timed. */
    Optional<Point> fastestJava() {
        return others().stream()
                .filter(other -> NATIVE.stream().noneMatch(other.engine()::startsWith))
                .filter(other -> other.timing().isPresent())
                .min(Comparator.comparingDouble(Comparison::micros));
    }

    /** Our step's time over that of the fastest engine in Java; empty if one was not timed. */
    Optional<Double> slowdown() {
        return game.timing().isEmpty()
                ? Optional.empty()
                : fastestJava().map(other -> micros(game) / micros(other));
    }

    /** Whether no engine in Java has a faster step, within the accuracy of the timing. */
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
