package rigibo.web.build;

import rigibo.frontend.puzzle.level.Level;

import java.io.IOException;

/**
 * Opens the page in browsers that lack or refuse a feature. A sentence says so; if only storage is
 * refused, a level is still solved.
 */
final class HardshipCheck {

    private static final String DENIED =
            "Object.defineProperty(window, 'localStorage', { get() { throw new"
                    + " DOMException('denied', 'SecurityError'); } });";

    /** Fills the browser's storage to the last letter. */
    private static final String FULL =
            "localStorage.clear(); let size = 1 << 22, count = 0; while (size > 0) { try {"
                    + " localStorage.setItem('filling' + count++, 'x'.repeat(size)); } catch (full)"
                    + " { size >>= 1; } }";

    private static final String NO_GRAPHICS =
            "const get = HTMLCanvasElement.prototype.getContext;"
                    + " HTMLCanvasElement.prototype.getContext = function(kind, ...more) { return"
                    + " kind === 'webgl2' ? null : get.call(this, kind, ...more); };";

    private static final String NO_WEB_ASSEMBLY = "delete window.WebAssembly;";

    /** The sentence that the page shows in place of the game, when it does. */
    private static final String PROBLEM =
            "new Promise(done => { const look = () => { const told ="
                    + " document.getElementById('problem'); told && !told.hidden ?"
                    + " done(told.textContent) : setTimeout(look, 20); }; look(); })";

    private final Phone phone;
    private final Level level;

    /** The check of a level on a phone. */
    HardshipCheck(Phone phone, Level level) {
        this.phone = phone;
        this.level = level;
    }

    /** Runs the check and prints the result; returns whether all refusals were reported. */
    boolean isBorne() throws IOException, InterruptedException {
        boolean isDenialTold = isPlayedWith(DENIED);
        boolean isFullTold = isPlayedWith(FULL);
        phone.page().value("localStorage.clear()");
        boolean isKeptLater = phone.stepped().isKept(level.id() + ".best", "");
        boolean isGraphicsTold = isToldWith(NO_GRAPHICS, "WebGL 2");
        boolean isAssemblyTold = isToldWith(NO_WEB_ASSEMBLY, "WebAssembly");
        System.out.printf(
                "told: storage denied %s, full %s and kept later %s, no WebGL %s, no WebAssembly"
                        + " %s%n",
                isDenialTold, isFullTold, isKeptLater, isGraphicsTold, isAssemblyTold);
        return isDenialTold && isFullTold && isKeptLater && isGraphicsTold && isAssemblyTold;
    }

    /** Whether a level is solved and the player is told that results are not stored. */
    private boolean isPlayedWith(String script) throws IOException, InterruptedException {
        phone.openWith(script, level.id());
        new PhoneCheck(phone).play(level);
        phone.stepped().keep();
        phone.goUntilTold();
        String said = phone.stepped().said();
        boolean isTold =
                said.contains(phone.words().of("toast.not-kept"))
                        && said.contains(phone.words().of("puzzle.won"));
        if (!isTold) {
            System.out.println("said where nothing is kept: " + said);
        }
        return isTold;
    }

    private boolean isToldWith(String script, String what)
            throws IOException, InterruptedException {
        return phone.problemWith(script, PROBLEM).contains(what);
    }
}
