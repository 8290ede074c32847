package rigibo.web.build;

import rigibo.frontend.scene.Words;

import java.io.IOException;

/**
 * Asks a page what it tells a screen reader: what happened, what its buttons are called, and that
 * nothing moves where the system wants little motion.
 */
final class ReaderCheck {

    private final Phone phone;
    private final Words words;

    /** Asks a page in the language that it is in. */
    ReaderCheck(Phone phone) throws IOException, InterruptedException {
        this.phone = phone;
        words = phone.words();
    }

    /** Whether the page, at the end of a level, has said that it is solved. */
    boolean isVerdictSaid() throws IOException, InterruptedException {
        String said = phone.stepped().said();
        System.out.println("said: " + said);
        return said.contains(words.of("puzzle.won"));
    }

    /** Whether the menu's buttons have names and can be pressed, for a player who wants calm. */
    boolean isMenuRead() throws IOException, InterruptedException {
        phone.openCalmly("");
        DevTools page = phone.page();
        phone.goUntilTold();
        String tree = page.send("Accessibility.getFullAXTree", "");
        boolean isNamed =
                tree.contains(name("menu.levels"))
                        && tree.contains(name("menu.statistics"))
                        && tree.contains(name("menu.settings"));
        page.value(control("menu.settings") + ".click()");
        phone.goUntilTold();
        phone.goUntilTold();
        String calm = page.value(control("settings.calm") + ".getAttribute('aria-pressed')");
        String title = phone.stepped().said();
        System.out.println("menu read: " + isNamed + ", calm: " + calm + ", said: " + title);
        return isNamed && calm.equals("true") && title.contains(words.of("menu.settings"));
    }

    /** A name in the browser's tree for screen readers. */
    private String name(String key) {
        return "\"type\":\"computedString\",\"value\":\"" + words.of(key) + "\"";
    }

    private String control(String key) {
        return "document.querySelector('#controls [aria-label=\"" + words.of(key) + "\"]')";
    }
}
