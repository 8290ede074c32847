package rigibo.web.build;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Layout;

import java.io.IOException;

/** Plays levels by mouse in a desktop window, by their stored solutions. */
final class MouseCheck {

    static final int WIDTH = 1280;
    static final int HEIGHT = 800;

    private static final Layout LAYOUT = Layout.of(WIDTH, HEIGHT, 1);

    /** Longest play, steps: half a minute without a click loses every level. */
    private static final int MOST_STEPS = 60 * 60;

    /** Steps from the verdict until the page has stored it. */
    private static final int APPLAUSE = 120;

    private final Page page;
    private final Stepped stepped;
    private final String address;

    /** Plays in a page opened at an address. */
    MouseCheck(Page page, String address) throws IOException, InterruptedException {
        this.page = page;
        this.address = address;
        page.size(WIDTH, HEIGHT);
        stepped = new Stepped(page);
    }

    /** Opens a level and plays its solution; returns whether the page stored it as solved. */
    boolean isSolved(Level level) throws IOException, InterruptedException {
        // Changing only the part after the # would not open a new page.
        page.open("about:blank");
        stepped.open(address + "#" + level.id());
        Recording run = Recording.of(level, level.solutions().get(0), Accuracy.GAME, MOST_STEPS);
        Playback here = new Playback(level, run.replay());
        // The first picture makes the first step.
        here.step();
        Camera camera = new View(level).camera();
        while (here.game().outcome() == Outcome.RUNNING && here.game().steps() < MOST_STEPS) {
            int due = here.upcoming().map(Act::step).orElse(MOST_STEPS);
            int ahead = due - here.game().steps();
            if (ahead <= 0) {
                page.click(PhoneCheck.spot(LAYOUT, here, camera));
            }
            // A due click comes before the first of the following steps.
            int steps = Math.max(1, Math.min(ahead, Stepped.AT_ONCE));
            here.stepTo(here.game().steps() + steps);
            stepped.go(steps);
        }
        stepped.go(APPLAUSE);
        boolean isKept = stepped.isKept(level.id() + ".best", "");
        System.out.println(
                level.id() + (isKept ? " was solved" : " was not solved") + " by clicks");
        return isKept;
    }
}
