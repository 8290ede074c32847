package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;

import java.util.ArrayList;
import java.util.List;

/** Notices for the player, shown above everything else until read. */
final class NoticePlate {

    private static final double WIDTH = 600;
    private static final double LEFT = (Scene.WIDTH - WIDTH) / 2;
    private static final double PADDING = 24;
    private static final double SIZE = 18;
    private static final double LINE = 26;
    private static final double FOOT = 34;

    private final Director director;

    /** The notices that were read and still hold. */
    private List<String> read = List.of();

    NoticePlate(Director director) {
        this.director = director;
    }

    boolean isShown() {
        List<String> notices = director.notices();
        return !notices.isEmpty() && !notices.equals(read);
    }

    void dismiss() {
        director.forgetNotices();
        read = director.notices();
        director.sounds().press();
    }

    private String foot() {
        return director.words().of("menu.understood");
    }

    /** Tells of the notices, and of the whole window as the button that it is. */
    void describe(Narrator narrator) {
        director.notices().forEach(narrator::says);
        narrator.offers(new Plate(0, 0, Scene.WIDTH, Scene.HEIGHT).button(foot(), true));
    }

    void draw(Canvas canvas) {
        List<String> lines = new ArrayList<>();
        for (String notice : director.notices()) {
            lines.addAll(Lines.of(canvas, notice, SIZE, Canvas.Font.WORDS, WIDTH - 2 * PADDING));
        }
        double pitch = canvas.layout().lettered(LINE);
        double height = 2 * PADDING + pitch * lines.size() + FOOT;
        double top = (Scene.HEIGHT - height) / 2;
        canvas.cover(Color.DUSK_TOP.alpha(0.96));
        canvas.panel(LEFT, top, WIDTH, height, 18, Color.PANEL_LIT);
        canvas.frame(LEFT, top, WIDTH, height, 18, Color.BRASS);
        double y = top + PADDING + pitch / 2;
        for (String line : lines) {
            Print.left(canvas, line, LEFT + PADDING, y, SIZE, Color.TEXT);
            y += pitch;
        }
        Print.centred(canvas, foot(), Scene.WIDTH / 2.0, y + FOOT / 2, SIZE, Color.BRASS);
    }
}
