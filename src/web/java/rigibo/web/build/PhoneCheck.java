package rigibo.web.build;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LevelShelf;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Edges;
import rigibo.frontend.scene.Layout;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Plays levels by touch in a browser as large as a phone, by their stored solutions. The page's
 * clock and pictures are the check's: each picture makes one step, so that a finger comes down in
 * the very step that was recorded, however slow the machine is.
 */
final class PhoneCheck {

    private static final int WIDTH = 390;
    private static final int HEIGHT = 844;
    private static final Layout LAYOUT = Layout.inHand(WIDTH, HEIGHT, 1, Edges.NONE);

    /** Steps after the verdict until all medals are stamped. */
    private static final int APPLAUSE = 120;

    /** Steps that are made at once while nothing is touched. */
    private static final int AT_ONCE = 4;

    /** Half a minute without a click loses every level. */
    private static final int MOST_STEPS = 60 * 60;

    /** A clock that stands still between pictures, half a step off the steps' own times. */
    private static final String CLOCK =
            "let now = 1000, next = null; performance.now = () => now; window.requestAnimationFrame"
                + " = made => { next = made; return 1; }; window.isReady = () => next !== null;"
                + " window.begin = () => { now += 1000 / 120; made(); }; const made = () => { const"
                + " call = next; next = null; call(now); }; window.go = steps => { if (steps > 0) {"
                + " now += steps * 1000 / 60; made(); } };";

    private final DevTools page;
    private final String address;
    private final Path pictures;
    private Camera camera = Camera.ofPuzzle();

    private PhoneCheck(DevTools page, String address, Path pictures) {
        this.page = page;
        this.address = address;
        this.pictures = pictures;
    }

    /** Plays the first so many levels; says how it went, and returns whether all is well. */
    static boolean play(Browser browser, Path folder, int levels)
            throws IOException, InterruptedException {
        Path pictures = Files.createDirectories(folder.resolveSibling("phone"));
        try (LocalServer server = new LocalServer(folder, 0);
                Browser.Window window = browser.open();
                DevTools page = new DevTools(window.port())) {
            PhoneCheck check = new PhoneCheck(page, server.address(""), pictures);
            return check.play(LevelShelf.files().subList(0, levels));
        }
    }

    private boolean play(List<Path> files) throws IOException, InterruptedException {
        page.send(
                "Emulation.setDeviceMetricsOverride",
                String.format(
                        "\"width\":%d,\"height\":%d,\"deviceScaleFactor\":1,\"mobile\":true",
                        WIDTH, HEIGHT));
        page.send("Emulation.setTouchEmulationEnabled", "\"enabled\":true");
        page.send(
                "Page.addScriptToEvaluateOnNewDocument",
                "\"source\":\"" + CLOCK.replace("\"", "\\\"") + "\"");
        int solved = 0;
        for (Path file : files) {
            if (isSolved(new LevelLoader().load(file).level().orElseThrow())) {
                solved++;
            }
        }
        ReaderCheck reader = new ReaderCheck(page);
        boolean isRead = reader.isVerdictSaid() && reader.isMenuRead(address);
        boolean isMade = AsideCheck.isMade(page);
        List<String> outside = page.requests().stream().filter(asked -> !isInside(asked)).toList();
        page.complaints().forEach(System.out::println);
        outside.forEach(asked -> System.out.println("asked for " + asked));
        System.out.printf("%d of %d levels were solved by touch%n", solved, files.size());
        return isRead
                && isMade
                && solved == files.size()
                && outside.isEmpty()
                && page.complaints().isEmpty();
    }

    private boolean isInside(String asked) {
        return asked.startsWith(address) || asked.startsWith("about:");
    }

    /** Opens an address, and draws the first picture. */
    static void open(DevTools page, String address) throws IOException, InterruptedException {
        page.send("Page.navigate", "\"url\":\"" + address + "\"");
        await(page, "window.isReady && window.isReady() ? 1 : 0");
        page.value("window.begin()");
    }

    /** Opens a level and plays it as its solution says; whether the page kept it as solved. */
    private boolean isSolved(Level level) throws IOException, InterruptedException {
        // A new query loads the page anew; another hash alone does not.
        open(page, address + "?" + level.id() + "#" + level.id());
        Recording run = Recording.of(level, level.solutions().get(0), Accuracy.GAME, MOST_STEPS);
        Playback here = new Playback(level, run.replay());
        // The picture that begins makes the first step.
        here.step();
        camera = new View(level).camera();
        boolean isDown = false;
        while (here.game().outcome() == Outcome.RUNNING && here.game().steps() < MOST_STEPS) {
            if (here.upcoming().filter(act -> act.step() <= here.game().steps()).isPresent()) {
                if (!isDown) {
                    page.down(x(here), y(here));
                }
                page.lift(x(here), y(here));
                isDown = false;
            } else if (untilNext(here) < AT_ONCE) {
                page.down(x(here), y(here));
                isDown = true;
            }
            int steps = untilNext(here);
            here.stepTo(here.game().steps() + steps);
            page.value("window.go(" + steps + ")");
            if (isDown && here.game().clicks() == 0) {
                picture(level, "choosing");
            }
        }
        for (int steps = 0; steps < APPLAUSE; steps += AT_ONCE) {
            page.value("window.go(" + AT_ONCE + ")");
        }
        picture(level, "end");
        return isKept(level);
    }

    /** Where on the page the next target is now, px. */
    private double x(Playback here) {
        return LAYOUT.windowX(camera.screenX(next(here).x()));
    }

    private double y(Playback here) {
        return LAYOUT.windowY(camera.screenY(next(here).y()));
    }

    private static Target next(Playback here) {
        return here.game().target(here.upcoming().orElseThrow().target()).orElseThrow();
    }

    private static int untilNext(Playback here) {
        // The act that is due is made by the first of the steps that follow.
        return here.upcoming()
                .map(act -> act.step() - here.game().steps())
                .filter(steps -> steps < AT_ONCE)
                .map(steps -> Math.max(1, steps))
                .orElse(AT_ONCE);
    }

    /** The page keeps what the player does within some seconds, by the real clock. */
    private boolean isKept(Level level) throws IOException, InterruptedException {
        String kept =
                "Object.keys(localStorage).join().includes('" + level.id() + ".best') ? 1 : 0";
        for (int tries = 0; tries < 50; tries++) {
            if (page.value(kept).equals("1")) {
                return true;
            }
            Thread.sleep(100);
        }
        System.out.println(level.id() + " was not solved");
        return false;
    }

    private static void await(DevTools page, String script)
            throws IOException, InterruptedException {
        for (int tries = 0; !page.value(script).equals("1"); tries++) {
            if (tries == 600) {
                throw new IOException("the page does not begin: " + page.complaints());
            }
            Thread.sleep(100);
        }
    }

    private void picture(Level level, String state) throws IOException, InterruptedException {
        Files.write(pictures.resolve(level.id() + "-" + state + ".png"), page.picture());
    }
}
