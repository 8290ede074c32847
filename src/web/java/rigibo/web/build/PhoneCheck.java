package rigibo.web.build;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Edges;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Pinch;

import java.io.IOException;

/**
 * Plays levels by touch on a phone, by their stored solutions: a finger comes down in the exact
 * step that was recorded. Before the last click of a level two fingers enlarge it.
 */
final class PhoneCheck {

    private static final Layout LAYOUT = Layout.inHand(Phone.WIDTH, Phone.HEIGHT, 1, Edges.NONE);

    /** Steps after the verdict until all medals are stamped. */
    private static final int APPLAUSE = 120;

    /** Longest play, steps: half a minute without a click loses every level. */
    private static final int MOST_STEPS = 60 * 60;

    /** Most steps between two looks whether the level is over. */
    private static final int UNTOUCHED = 40;

    /** Distance of two fingers before and after they enlarge a level, px. */
    private static final double NEAR = 60;

    private static final double FAR = 150;

    private final Phone phone;

    PhoneCheck(Phone phone) {
        this.phone = phone;
    }

    /** Opens a level and plays its solution; returns whether the page stored it as solved. */
    boolean isSolved(Level level) throws IOException, InterruptedException {
        phone.open(level.id());
        play(level);
        boolean isKept = phone.stepped().isKept(level.id() + ".best", "");
        System.out.println(level.id() + (isKept ? " was solved" : " was not solved") + " by touch");
        return isKept;
    }

    /** Plays the level of the page by its solution. */
    void play(Level level) throws IOException, InterruptedException {
        Recording run = Recording.of(level, level.solutions().get(0), Accuracy.GAME, MOST_STEPS);
        Playback here = new Playback(level, run.replay());
        // The first picture makes the first step.
        here.step();
        View view = new View(level);
        boolean isDown = false;
        while (here.game().outcome() == Outcome.RUNNING && here.game().steps() < MOST_STEPS) {
            if (here.upcoming().filter(act -> act.step() <= here.game().steps()).isPresent()) {
                if (!isDown) {
                    phone.page().down(spot(LAYOUT, here, view.camera()));
                }
                phone.page().lift(spot(LAYOUT, here, view.camera()));
                isDown = false;
            } else if (ahead(here) <= Stepped.AT_ONCE) {
                if (isLast(here, level) && !view.isEnlarged()) {
                    enlarge(spot(LAYOUT, here, view.camera()), view);
                }
                phone.page().down(spot(LAYOUT, here, view.camera()));
                isDown = true;
            }
            int steps = steps(here);
            here.stepTo(here.game().steps() + steps);
            phone.go(steps);
            if (isDown && here.game().clicks() == 0 || isDown && view.isEnlarged()) {
                phone.picture(level.id() + (view.isEnlarged() ? "-enlarged" : "-choosing"));
            }
        }
        phone.go(APPLAUSE);
        phone.picture(level.id() + "-end");
    }

    private static boolean isLast(Playback here, Level level) {
        return here.game().clicks() == level.solutions().get(0).clicks().size() - 1;
    }

    /** Enlarges the level on the page and here by two fingers, one of them at a point. */
    private void enlarge(Page.Spot at, View view) throws IOException, InterruptedException {
        double up = at.y() > Phone.HEIGHT / 2.0 ? -1 : 1;
        Page.Spot from = at.plus(0, up * NEAR);
        Page.Spot to = at.plus(0, up * FAR);
        phone.pinch(at, from, to);
        view.pinch(
                new Pinch(
                        FAR / NEAR,
                        LAYOUT.logicalX(at.x()),
                        LAYOUT.logicalY((at.y() + to.y()) / 2),
                        0,
                        (to.y() - from.y()) / 2 / LAYOUT.ratio()));
    }

    /** The place on the page of the next target. */
    static Page.Spot spot(Layout layout, Playback here, Camera camera) {
        Target next = here.game().target(here.upcoming().orElseThrow().target()).orElseThrow();
        return new Page.Spot(
                layout.windowX(camera.screenX(next.x())), layout.windowY(camera.screenY(next.y())));
    }

    /** Steps until the next click is due. */
    private static int ahead(Playback here) {
        return here.upcoming().map(act -> act.step() - here.game().steps()).orElse(MOST_STEPS);
    }

    /** Steps until a finger must come down or be lifted. */
    private static int steps(Playback here) {
        int ahead = ahead(here);
        int untilDown = Math.min(UNTOUCHED, ahead - Stepped.AT_ONCE);
        // A due click comes before the first of the following steps.
        return untilDown > 0 ? untilDown : Math.max(1, ahead);
    }
}
