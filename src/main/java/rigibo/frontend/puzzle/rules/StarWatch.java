package rigibo.frontend.puzzle.rules;

import rigibo.backend.ContactEvent.Phase;
import rigibo.backend.ContactView;
import rigibo.backend.RigidBody;
import rigibo.frontend.puzzle.level.Feat;
import rigibo.frontend.puzzle.level.Steps;

import java.util.List;

/** Watches a game for the feat of its level's star. Reads the pool and changes nothing. */
final class StarWatch {

    private final Feat feat;
    private final Board board;
    private boolean hasTouched;
    private boolean hasSpilt;

    StarWatch(Feat feat, Board board) {
        this.feat = feat;
        this.board = board;
    }

    /** Must be called after each step up to the end, before fallen bodies are removed. */
    void observe() {
        if (feat instanceof Feat.Inside) {
            hasSpilt |= board.pieces().stream().anyMatch(board::hasFallen);
        } else if (isOfTouches() && !hasTouched) {
            board.pool().forEachContact(this::observe);
        }
    }

    private boolean isOfTouches() {
        return feat instanceof Feat.AvoidBody
                || feat instanceof Feat.AvoidMaterial
                || feat instanceof Feat.Touch;
    }

    /**
     * A bounce within the step is a contact that begins, even if the two bodies are apart again.
     */
    private void observe(ContactView contact) {
        if (contact.phase != Phase.END) {
            hasTouched |= isTouch(contact.a, contact.b) || isTouch(contact.b, contact.a);
        }
    }

    private boolean isTouch(RigidBody ball, RigidBody other) {
        return board.balls().contains(ball) && board.piece(other).filter(this::isMeant).isPresent();
    }

    private boolean isMeant(Piece piece) {
        if (feat instanceof Feat.AvoidMaterial avoid) {
            return piece.substance() == avoid.material();
        }
        String meant =
                feat instanceof Feat.Touch touch ? touch.body() : ((Feat.AvoidBody) feat).body();
        return piece.id().equals(meant);
    }

    /**
     * Whether a game that has just been won has earned the star.
     *
     * @param acts its clicks
     * @param steps since its start
     */
    boolean isEarned(List<Act> acts, int steps) {
        if (feat instanceof Feat.Clicks clicks) {
            return acts.size() == clicks.count();
        }
        if (feat instanceof Feat.Quick quick) {
            return steps <= Steps.of(quick.seconds());
        }
        if (feat instanceof Feat.Keep keep) {
            return board.piece(keep.body()).filter(this::isLeft).isPresent();
        }
        if (feat instanceof Feat.Clear) {
            return board.pieces().stream()
                    .filter(piece -> piece.definition().deletable())
                    .noneMatch(this::isLeft);
        }
        if (feat instanceof Feat.Inside) {
            return !hasSpilt;
        }
        if (feat instanceof Feat.First first) {
            return !acts.isEmpty() && acts.get(0).target().equals(first.target());
        }
        return hasTouched == feat instanceof Feat.Touch;
    }

    private boolean isLeft(Piece piece) {
        return piece.isAlive() && !board.hasFallen(piece);
    }
}
