package rigibo.frontend.puzzle.rules;

import rigibo.backend.Explosion;
import rigibo.backend.Pool;
import rigibo.frontend.puzzle.level.Handling;
import rigibo.frontend.puzzle.level.Verb;

import java.util.ArrayList;
import java.util.List;

/** Does what clicks ask for, and what follows from them later: fuses that burn down. */
final class Workings {

    private final Pool pool;

    /** Bombs whose fuses burn, in the order in which they were lit. */
    private final List<Piece> burning = new ArrayList<>();

    private final Sources sources;

    Workings(Pool pool, Sources sources) {
        this.pool = pool;
        this.sources = sources;
    }

    /** Does to a target that can be clicked what its verb says. */
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

    /** A fan or magnet that was switched or deleted changes the effects of the pool. */
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
            case LIGHT -> {
                piece.light(new Fuse(steps));
                burning.add(piece);
            }
            case CUT, PULL -> throw new IllegalArgumentException("not a joint: " + piece.id());
        }
    }

    /** Blows up what is due, before the next step. */
    void beforeStep(int steps) {
        burning.removeIf(bomb -> !bomb.isAlive());
        for (Piece bomb : List.copyOf(burning)) {
            if (bomb.fuse().orElseThrow().isBurntDown(steps)) {
                burning.remove(bomb);
                blow(bomb);
            }
        }
    }

    private void blow(Piece bomb) {
        Handling.Charge charge = bomb.definition().handling().charge().orElseThrow();
        Explosion blast =
                Explosion.at(bomb.x(), bomb.y())
                        .radius(charge.radius())
                        .falloff(charge.falloff())
                        .impulsePerMetre(charge.impulse());
        pool.remove(bomb.body());
        pool.explode(blast);
    }

    /** Whether a fuse burns, so that something is going to move. */
    boolean isBurning() {
        return !burning.isEmpty();
    }
}
