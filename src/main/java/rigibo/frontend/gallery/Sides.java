package rigibo.frontend.gallery;

import rigibo.backend.StepReport;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.accuracy.StageProfile;
import rigibo.frontend.scene.ghost.Ghost;
import rigibo.frontend.scene.ghost.GhostPlate;
import rigibo.frontend.scene.widget.Plate;

import java.util.Optional;

/** The plates beside an exhibit; in a wide window the source is open from the beginning. */
final class Sides {

    private final SourcePlate source;
    private final StageProfile frame;
    private final GhostPlate ghost;
    private Optional<Side> open = Optional.empty();

    /** Whether no plate was opened or folded yet. */
    private boolean isUntouched = true;

    private Plate place = Plate.NONE;

    Sides(Found found, Words words) {
        source = new SourcePlate(found, words);
        frame = new StageProfile(words);
        ghost = new GhostPlate(words);
    }

    /** Takes whether there is room for a text beside the scene. */
    void fit(boolean isWide) {
        if (isUntouched) {
            open = isWide && has(Side.SOURCE) ? Optional.of(Side.SOURCE) : Optional.empty();
        }
    }

    /** Whether there is anything to show. */
    boolean has(Side side) {
        return side != Side.SOURCE || source.isThere();
    }

    boolean isOpen(Side side) {
        return open.filter(side::equals).isPresent();
    }

    /** Opens a plate in place of any other, if there is anything on it, or folds it. */
    void toggle(Side side) {
        open = isOpen(side) || !has(side) ? Optional.empty() : Optional.of(side);
        isUntouched = false;
    }

    /** Holds no point until it is drawn again. */
    void hide() {
        place = Plate.NONE;
    }

    boolean isAnyOpen() {
        return open.isPresent();
    }

    void fold() {
        open = Optional.empty();
        isUntouched = false;
    }

    /** A step was made. */
    void step(StepReport report) {
        frame.step(report);
    }

    /** A frame took so long to draw, ns. */
    void drawn(long nanos) {
        frame.drawing(nanos);
    }

    /** Draws the open plate in a room, px, as high as it needs. */
    void draw(Canvas canvas, Plate room, Optional<Ghost> haunting) {
        if (isOpen(Side.SOURCE)) {
            place = room;
            source.draw(canvas, room);
        } else if (isOpen(Side.FRAME)) {
            place = new Plate(room.x(), room.y(), room.width(), StageProfile.HEIGHT);
            frame.draw(canvas, room.x(), room.y(), room.width());
        } else if (isOpen(Side.GHOST) && haunting.isPresent()) {
            place = new Plate(room.x(), room.y(), room.width(), GhostPlate.HEIGHT);
            ghost.draw(canvas, haunting.get(), room.x(), room.y(), room.width());
        }
    }

    /** Whether a point of the canvas on which it was drawn, px, is on the open plate. */
    boolean contains(double x, double y) {
        return place.contains(x, y);
    }

    /** Moves on by a number of pages of the source, if it is open. */
    void turn(int on) {
        if (isOpen(Side.SOURCE)) {
            source.turn(on);
        }
    }
}
