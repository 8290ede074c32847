package rigibo.web.build;

import rigibo.frontend.scene.Words;

import java.io.IOException;

/**
 * Checks the page's descriptions for screen readers: the events, the names of buttons, and that
 * there is no motion if the system asks for little.
 */
final class ReaderCheck {

    private final Phone phone;
    private final Words words;

    /** A check in the page's language. */
    ReaderCheck(Phone phone) throws IOException, InterruptedException {
        this.phone = phone;
        words = phone.words();
    }

    /** Whether the page has reported, at the end of a level, that it is solved. */
    boolean isVerdictSaid() throws IOException, InterruptedException {
        String said = phone.stepped().said();
        System.out.println("said: " + said);
        return said.contains(words.of("puzzle.won"));
    }

    /**
     * Whether the menu's buttons have names and can be pressed, for a player who wants little
     * motion.
     */
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

    /** A name in the browser's accessibility tree. */
    private String name(String key) {
        return "\"type\":\"computedString\",\"value\":\"" + words.of(key) + "\"";
    }

    private String control(String key) {
        return "document.querySelector('#controls [aria-label=\"" + words.of(key) + "\"]')";
    }
}
