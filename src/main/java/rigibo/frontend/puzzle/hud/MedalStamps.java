package rigibo.frontend.puzzle.hud;

import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.Words;

import java.util.stream.Stream;

/**
 * The medals of a solved level, stamped one by one from bronze up to the one that was earned. Each
 * has a colour, a number and a shape.
 */
final class MedalStamps {

    /** Time between two stamps. */
    static final int APART = Steps.of(0.25);

    /** Time for which a stamp falls. */
    private static final int FALL = Steps.of(0.15);

    static final double RADIUS = 24;

    private static final String LONG = "puzzle.medal.";
    private static final String SHORT = "puzzle.short.";

    /** Factor of size at which a stamp begins to fall. */
    private static final double HEIGHT = 1.5;

    private final Medal earned;
    private final int par;
    private int turns;

    MedalStamps(Medal earned, int par) {
        this.earned = earned;
        this.par = par;
    }

    /** The medal that was earned, in words. */
    String told(Words words) {
        return told(words, LONG, earned);
    }

    private String kind(Canvas canvas, Words words, PrizePlaces places) {
        boolean haveRoom =
                Stream.of(Medal.values())
                        .map(medal -> told(words, LONG, medal))
                        .allMatch(name -> places.hasRoomFor(canvas, name));
        return haveRoom ? LONG : SHORT;
    }

    private String told(Words words, String kind, Medal medal) {
        return words.of(kind + Command.key(medal), par, par + 1);
    }

    /** After each frame. */
    void turn() {
        turns++;
    }

    /** Draws them at the first places. */
    void draw(Canvas canvas, Words words, PrizePlaces places, Motion motion) {
        Medal[] medals = Medal.values();
        String kind = kind(canvas, words, places);
        for (int i = 0; i < medals.length; i++) {
            Medal medal = medals[medals.length - 1 - i];
            int age = turns - (i + 1) * APART;
            boolean isStamped = medal.compareTo(earned) >= 0 && age >= 0;
            canvas.ring(places.x(i), places.y(i), RADIUS, 2, 1, Color.EDGE);
            if (isStamped) {
                draw(canvas, medal, places.x(i), places.y(i), RADIUS * scale(age, motion));
            }
            Color ink = isStamped ? Color.TEXT : Color.TEXT_DIM;
            places.drawWords(canvas, told(words, kind, medal), i, ink);
        }
    }

    /**
     * Size of a stamp relative to its final one.
     *
     * @param age turns since it began to fall
     */
    static double scale(int age, Motion motion) {
        double above = Math.max(0, 1 - age / (double) FALL);
        return motion == Motion.FULL ? 1 + HEIGHT * above : 1;
    }

    private static void draw(Canvas canvas, Medal medal, double x, double y, double radius) {
        Color metal = medal.color();
        int rank = medal.ordinal() + 1;
        if (medal != Medal.BRONZE) {
            drawRays(canvas, x, y, radius, metal, medal == Medal.GOLD ? 12 : 6);
        }
        canvas.disc(x, y, radius * 0.9, metal);
        canvas.ring(x, y, radius * 0.68, 2, 1, Color.DUSK_TOP.alpha(0.5));
        canvas.text(
                Integer.toString(rank),
                x,
                y,
                22,
                Canvas.Font.NUMBERS,
                Canvas.Align.CENTRE,
                Color.DUSK_TOP);
    }

    /** Better medals have more rays. */
    private static void drawRays(
            Canvas canvas, double x, double y, double radius, Color metal, int rays) {
        for (int ray = 0; ray < rays; ray++) {
            double angle = 2 * Math.PI * ray / rays;
            double tipX = x + 1.25 * radius * Math.sin(angle);
            double tipY = y - 1.25 * radius * Math.cos(angle);
            canvas.line(x, y, tipX, tipY, 5, metal);
        }
    }
}
