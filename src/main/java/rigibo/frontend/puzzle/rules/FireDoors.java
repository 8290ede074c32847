package rigibo.frontend.puzzle.rules;

import rigibo.backend.ContactEvent.Phase;
import rigibo.backend.ContactView;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.frontend.puzzle.level.Substance;

import java.util.ArrayList;
import java.util.List;

/**
 * Fire doors: bodies of ember, which melt half a second after a ball has touched them. A door that
 * was frozen in time is a stone and stays.
 */
final class FireDoors {

    private final Pool pool;
    private final List<RigidBody> balls;

    /** Doors that are still there and have not become stones. */
    private final List<Piece> doors = new ArrayList<>();

    private int steps;

    FireDoors(Board board) {
        pool = board.pool();
        balls = board.balls();
        board.pieces().stream().filter(FireDoors::isDoor).forEach(doors::add);
    }

    private static boolean isDoor(Piece piece) {
        return piece.isAlive() && piece.substance() == Substance.EMBER;
    }

    /** Removes doors that have melted, before the next step. */
    void beforeStep(int done) {
        doors.stream()
                .filter(door -> isDoor(door) && hasMelted(door, done))
                .forEach(door -> pool.remove(door.body()));
        doors.removeIf(door -> !isDoor(door));
    }

    private static boolean hasMelted(Piece door, int steps) {
        return door.melt().filter(melt -> melt.isOver(steps)).isPresent();
    }

    /** Starts melting doors that a ball touched in the last step. */
    void afterStep(int done) {
        if (!doors.isEmpty()) {
            steps = done;
            pool.forEachContact(this::observe);
        }
    }

    /**
     * A bounce within the step is a contact that begins, even if the two bodies are apart again.
     */
    private void observe(ContactView contact) {
        if (contact.phase != Phase.END) {
            touch(contact.a, contact.b);
            touch(contact.b, contact.a);
        }
    }

    private void touch(RigidBody ball, RigidBody body) {
        if (balls.contains(ball)) {
            doors.stream()
                    .filter(door -> door.body() == body && door.melt().isEmpty())
                    .forEach(door -> door.melt(new Melt(steps)));
        }
    }

    /** Whether a door is melting, so that bodies will move. */
    boolean areMelting() {
        return doors.stream().anyMatch(door -> isDoor(door) && door.melt().isPresent());
    }
}
