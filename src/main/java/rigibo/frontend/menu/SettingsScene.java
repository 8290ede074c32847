package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Button;
import rigibo.frontend.scene.widget.Choice;
import rigibo.frontend.scene.widget.Panel;
import rigibo.frontend.scene.widget.Print;
import rigibo.frontend.scene.widget.Slider;
import rigibo.frontend.scene.widget.Toggle;
import rigibo.frontend.scene.widget.Widget;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** The player's settings; every change takes effect at once and is kept. */
public final class SettingsScene implements Scene {

    private static final double PANEL_WIDTH = 560;
    private static final double TOP = 180;

    /** Between rows, px: text of 130 % fills a row. */
    private static final double GAP = 10;

    /** Margin around the panel in a handheld window, and above it for the heading, px. */
    private static final double GAP_IN_HAND = 12;

    private static final double TOP_IN_HAND = 110;

    private static final List<String> LANGUAGES = Settings.LANGUAGES.stream().sorted().toList();

    private final Director director;
    private final Playground playground = new Playground();
    private Panel panel;

    public SettingsScene(Director director) {
        this.director = director;
        panel = new Panel((WIDTH - PANEL_WIDTH) / 2, TOP, PANEL_WIDTH, GAP, widgets());
    }

    private List<Widget> widgets() {
        Words words = director.words();
        return List.of(
                new Choice(
                        words.of("settings.language"),
                        LANGUAGES.stream().map(tag -> new Words(tag).of("language.name")).toList(),
                        () -> LANGUAGES.indexOf(settings().language()),
                        index -> choose(settings().withLanguage(LANGUAGES.get(index)))),
                new Slider(
                        words,
                        "settings.volume",
                        "%.0f %%",
                        0,
                        100,
                        5,
                        () -> 100 * settings().volume(),
                        percent -> choose(settings().withVolume(percent / 100))),
                new Slider(
                        words,
                        "settings.music",
                        "%.0f %%",
                        0,
                        100,
                        5,
                        () -> 100 * settings().music(),
                        percent -> choose(settings().withMusic(percent / 100))),
                new Toggle(
                        words.of("settings.mute"),
                        () -> settings().isMuted(),
                        () -> choose(settings().withMuted(!settings().isMuted()))),
                new Toggle(
                        words.of("settings.calm"),
                        this::isCalm,
                        () -> choose(settings().withMotion(otherMotion()))),
                detail(words),
                text(words),
                new Toggle(
                        words.of("settings.full-screen"),
                        () -> settings().isFullScreen(),
                        () -> choose(settings().withFullScreen(!settings().isFullScreen()))),
                new Button(words.of("settings.keys"), () -> director.show(new KeysScene(director))),
                new Button(words.of("menu.back"), director::showMenu));
    }

    private Choice detail(Words words) {
        List<String> names =
                Arrays.stream(Settings.Detail.values())
                        .map(detail -> detail.name().toLowerCase(Locale.ROOT))
                        .map(name -> words.of("settings.detail." + name))
                        .toList();
        return new Choice(
                words.of("settings.detail"),
                names,
                () -> settings().detail().ordinal(),
                index -> choose(settings().withDetail(Settings.Detail.values()[index])));
    }

    private Choice text(Words words) {
        return new Choice(
                words.of("settings.text"),
                Arrays.stream(Settings.TextSize.values())
                        .map(size -> Math.round(100 * size.share()) + " %")
                        .toList(),
                () -> settings().text().ordinal(),
                index -> choose(settings().withText(Settings.TextSize.values()[index])));
    }

    private Settings settings() {
        return director.settings();
    }

    private boolean isCalm() {
        return settings().motion() == Settings.Motion.REDUCED;
    }

    private Settings.Motion otherMotion() {
        return isCalm() ? Settings.Motion.FULL : Settings.Motion.REDUCED;
    }

    private void choose(Settings chosen) {
        director.settings(chosen);
        panel = panel.with(widgets());
    }

    @Override
    public String title() {
        return "RigiBo – " + director.words().of("menu.settings");
    }

    @Override
    public boolean isForHands() {
        return true;
    }

    @Override
    public void step() {
        playground.step();
    }

    @Override
    public void draw(Canvas canvas) {
        playground.draw(canvas);
        String heading = director.words().of("menu.settings");
        Layout layout = canvas.layout();
        if (layout.isInHand()) {
            double left = layout.seenLeft() + GAP_IN_HAND;
            double top = layout.seenTop() + (layout.isUpright() ? TOP_IN_HAND : GAP_IN_HAND);
            panel.place(left, top, layout.seenRight() - GAP_IN_HAND - left);
        } else {
            panel.place((WIDTH - PANEL_WIDTH) / 2, TOP, PANEL_WIDTH);
        }
        if (!layout.isInHand() || layout.isUpright()) {
            double y = layout.isInHand() ? layout.seenTop() + TOP_IN_HAND / 2 : 120;
            Print.centred(canvas, heading, WIDTH / 2.0, y, 48, Color.BRASS);
        }
        panel.draw(canvas);
    }

    @Override
    public void describe(Narrator narrator) {
        panel.describe(narrator);
    }

    @Override
    public void pointerMoved(double x, double y) {
        playground.pointerMoved(x, y);
        panel.pointerMoved(x, y);
    }

    @Override
    public void pointerPressed(PointerButton button, double x, double y) {
        if (button == PointerButton.LEFT) {
            director.sounds().press();
            panel.pointerPressed(x, y);
        }
    }

    @Override
    public void pointerReleased(PointerButton button, double x, double y) {
        panel.pointerReleased();
    }

    @Override
    public void keyPressed(Key key) {
        panel.keyPressed(key == Key.TAB ? Key.DOWN : key);
    }
}
