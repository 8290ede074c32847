package rigibo.frontend.puzzle.rules;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelBody;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.puzzle.level.Verb;

import java.util.ArrayList;
import java.util.List;

/**
 * Keeps games of a level in their middle. Each can be gone on with as often as needed, to the bits
 * that it would have come to by itself.
 */
public final class Bookmarks {

    private final Level level;

    /** Handles of the level's bodies, none of them alive, for those that are gone in a game. */
    private final List<RigidBody> gone;

    /**
     * Bookmarks in games of a level.
     *
     * @throws IllegalArgumentException when the level does not {@link #fit}
     */
    public Bookmarks(Level level) {
        if (!fit(level)) {
            throw new IllegalArgumentException("clicks do more than delete in " + level.id());
        }
        this.level = level;
        Board board = Board.of(level, Accuracy.GAME);
        gone = board.pieces().stream().map(Piece::body).toList();
        gone.forEach(board.pool()::remove);
    }

    /**
     * Whether games of a level can be kept: clicks delete, and nothing else but the bodies' motion
     * changes it. Joints, fuses, doors of ember, rides and stars have a memory of their own.
     */
    public static boolean fit(Level level) {
        return level.star().isEmpty()
                && level.joints().isEmpty()
                && level.bodies().stream().allMatch(Bookmarks::isPlain);
    }

    private static boolean isPlain(LevelBody body) {
        return body.path().isEmpty()
                && !body.source().isThere()
                && body.substance() != Substance.EMBER
                && body.verb().stream().allMatch(Verb.DELETE::equals);
    }

    /**
     * A game between two steps.
     *
     * @param pool its bodies, as a snapshot
     * @param places of the level's bodies in the order of the pool; -1 for those that are gone
     * @param memory of the rules
     */
    private record Kept(byte[] pool, int[] places, Memory memory) {}

    /** A place in a game, from which it goes on. */
    public final class Bookmark {

        private final Kept kept;

        private Bookmark(Kept kept) {
            this.kept = kept;
        }

        /** A game of its own that goes on from here. */
        public PuzzleGame game() {
            Pool pool = Pool.restore(kept.pool, level.world().effects());
            return new PuzzleGame(level, board(pool, kept.places), kept.memory.copy());
        }
    }

    /** Keeps a game that is neither won nor lost, as it stands. */
    public Bookmark at(PuzzleGame game) {
        List<RigidBody> bodies = game.pool().bodies();
        int[] places = game.pieces().stream().mapToInt(it -> bodies.indexOf(it.body())).toArray();
        return new Bookmark(new Kept(game.pool().snapshot(), places, game.memory()));
    }

    /** The platform comes first in a pool, and the balls last. */
    private Board board(Pool pool, int[] places) {
        List<RigidBody> bodies = pool.bodies();
        List<Piece> pieces = new ArrayList<>();
        for (int i = 0; i < places.length; i++) {
            RigidBody body = places[i] < 0 ? gone.get(i) : bodies.get(places[i]);
            pieces.add(new Piece(level.bodies().get(i), body));
        }
        List<RigidBody> balls =
                List.copyOf(bodies.subList(bodies.size() - level.balls().size(), bodies.size()));
        Sources none = new Sources(List.of());
        return new Board(level.world(), pool, bodies.get(0), pieces, List.of(), balls, none);
    }
}
