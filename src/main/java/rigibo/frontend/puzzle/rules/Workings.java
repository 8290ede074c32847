package rigibo.frontend.puzzle.rules;

import rigibo.backend.Explosion;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Placement;
import rigibo.backend.setup.Filter;
import rigibo.frontend.puzzle.level.Handling;
import rigibo.frontend.puzzle.level.Verb;

import java.util.ArrayList;
import java.util.List;

/** Performs the actions of clicks and their later consequences, such as fuses that burn down. */
final class Workings {

    private final Pool pool;
    private final List<Piece> pieces;

    /** Bombs with burning fuses, in the order in which they were lit. */
    private final List<Piece> burning = new ArrayList<>();

    private final Sources sources;

    Workings(Pool pool, List<Piece> pieces, Sources sources) {
        this.pool = pool;
        this.pieces = pieces;
        this.sources = sources;
    }

    /** Performs the verb of a clickable target. */
    void act(Target target, int steps) {
        if (target instanceof Piece piece) {
            act(piece, steps);
            refreshSources(piece);
        } else if (target instanceof Link link) {
            if (link.is(Verb.SWITCH)) {
                link.flip();
            } else {
                pool.remove(link.joint());
            }
        }
    }

    /** Updates the effects of the pool after a fan or magnet was switched or deleted. */
    private void refreshSources(Piece piece) {
        if (piece.definition().source().isThere()) {
            pool.effects(sources.in(pool.effects()));
        }
    }

    private void act(Piece piece, int steps) {
        switch (piece.verb().orElseThrow()) {
            case DELETE -> pool.remove(piece.body());
            case SWITCH -> piece.flip();
            case FREEZE -> piece.freeze();
            case LIGHT -> light(piece, steps);
            case CUT, PULL -> throw new IllegalArgumentException("not a joint: " + piece.id());
        }
    }

    private void light(Piece bomb, int steps) {
        bomb.light(new Fuse(steps));
        burning.add(bomb);
    }

    /** Blows up bombs that are due, before the next step. */
    void beforeStep(int steps) {
        burning.removeIf(bomb -> !bomb.isAlive());
        for (Piece bomb : List.copyOf(burning)) {
            if (bomb.fuse().orElseThrow().isBurntDown(steps)) {
                burning.remove(bomb);
                blow(bomb, steps);
            }
        }
    }

    /** Blows a bomb up, which lights the bombs within reach. */
    private void blow(Piece bomb, int steps) {
        Handling.Charge charge = bomb.definition().handling().charge().orElseThrow();
        Explosion blast =
                Explosion.at(bomb.x(), bomb.y())
                        .radius(charge.radius())
                        .falloff(charge.falloff())
                        .impulsePerMetre(charge.impulse());
        List<Piece> reached = bombsWithin(charge.radius() + charge.falloff(), bomb);
        pool.remove(bomb.body());
        pool.explode(blast);
        reached.forEach(next -> light(next, steps));
    }

    /** The bombs not lit yet that have a part within a distance (m) of a bomb's centre. */
    private List<Piece> bombsWithin(double distance, Piece bomb) {
        List<RigidBody> near = new ArrayList<>();
        Placement centre = new Placement(bomb.x(), bomb.y(), 0);
        pool.overlapping(new Circle(distance), centre, Filter.ALL, near::add);
        return pieces.stream()
                .filter(piece -> piece.is(Verb.LIGHT) && piece.isClickable())
                .filter(piece -> near.contains(piece.body()))
                .toList();
    }

    /** Whether a fuse burns, so that bodies will move. */
    boolean isBurning() {
        return !burning.isEmpty();
    }
}
