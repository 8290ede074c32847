package rigibo.frontend.puzzle.hud;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.puzzle.show.Refusal;
import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.WholePlate;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** All panels around the play: the bar, the keys, the drawers, and the panel at the end. */
public final class Panels {

    /** Greatest number of commands in a handheld window. */
    private static final int MOST_IN_HAND = 8;

    private final Session session;
    private final View view;
    private final Words words;
    private final Hud hud;
    private final KeyStrip keys = new KeyStrip();
    private final EffectsDrawer effects;
    private final HintPlate hint;
    private final Offers offers;
    private final List<Command> exits;
    private final WholePlate whole;
    private final ButtonRow pause;
    private final ButtonRow stop = Hud.buttons(List.of(Command.STOP));
    private Drawer open = Drawer.NONE;

    private Layout layout = Layout.ALONE;

    private Optional<EndPanel> end = Optional.empty();

    /** Panels of which one may be open, between the bar and the play or beside it. */
    public enum Drawer {
        NONE,
        EFFECTS,
        HINT
    }

    public Panels(
            Level level,
            Session session,
            View view,
            Words words,
            Lesson lesson,
            List<Command> exits) {
        this.session = session;
        this.exits = exits;
        offers = new Offers(session, exits);
        List<Command> inPause = new ArrayList<>(List.of(Command.RESUME, Command.RESTART));
        inPause.addAll(exits);
        pause = Hud.buttons(inPause);
        this.view = view;
        this.words = words;
        hud = new Hud(level, lesson);
        whole = new WholePlate(words);
        effects = new EffectsDrawer(new LevelEffects(level, session, words));
        hint = new HintPlate(level.hint().in(words.locale()), !level.solutions().isEmpty());
    }

    /** Opens a drawer, or closes it if it is open. */
    public void toggle(Drawer drawer) {
        open = open == drawer ? Drawer.NONE : drawer;
        fit();
    }

    private void fit() {
        view.fitBelow(foot());
        end.ifPresent(this::place);
    }

    /** Upper edge of the play, px; a drawer that opens beside the play takes nothing from it. */
    private double foot() {
        if (layout.isInHand() && layout.isUpright() && open == Drawer.HINT) {
            return hint.foot(View.BAR_FOOT);
        }
        if (isBeside()) {
            return View.BAR_FOOT;
        }
        return switch (open) {
            case NONE -> View.BAR_FOOT;
            case EFFECTS -> EffectsDrawer.foot(layout);
            case HINT -> HintPlate.FOOT;
        };
    }

    /** Whether the window has room for drawers beside the play. */
    private boolean isBeside() {
        return layout.columns() == 2 || layout.isInHand();
    }

    /**
     * Sets the layout of the window before the play is drawn, since the play may be larger beside
     * panels.
     */
    public void layOut(Layout shown) {
        double before = foot();
        boolean isTurned = shown.isInHand() != layout.isInHand();
        layout = shown;
        if (foot() != before || isTurned) {
            fit();
        }
    }

    private void place(EndPanel panel) {
        if (layout.isInHand() && layout.isUpright()) {
            HandPlaces places = HandPlaces.of(layout, MOST_IN_HAND);
            panel.place(new Span(places.bar().bottom(), places.keys().first().y()), visible());
        } else {
            panel.place(new Span(foot(), View.KEYS_TOP), visible());
        }
    }

    /** Heights of the balls on the screen, and of the platform. */
    private List<Span> visible() {
        PuzzleGame game = session.game();
        return Stream.concat(game.balls().stream(), Stream.of(game.platform()))
                .map(body -> Span.of(body, view.camera()))
                .filter(span -> span.bottom() > foot() && span.top() < View.KEYS_TOP)
                .toList();
    }

    public void shut() {
        open = Drawer.NONE;
        view.fitBelow(foot());
    }

    public boolean isOpen(Drawer drawer) {
        return open == drawer;
    }

    /** Shows the outcome of a game, as long as that game is on the screen. */
    public void end(PuzzleGame game, Optional<Command> next, boolean hasStar) {
        Optional<StarStamp> star =
                game.level()
                        .star()
                        .map(one -> new StarStamp(one.text().in(words.locale()), game, hasStar));
        end = Optional.of(new EndPanel(game, next, exits.get(0), star));
        end.ifPresent(this::place);
    }

    /** Sets the share of real time at which the world runs; the bar reports a late one. */
    public void paced(double share) {
        hud.paced(share);
    }

    /** After each frame. */
    public void turn() {
        end().ifPresent(EndPanel::turn);
    }

    private Optional<EndPanel> end() {
        return end.filter(panel -> panel.isOf(session.game()));
    }

    /** The buttons that keys select at present, if any. */
    private Optional<ButtonRow> buttons() {
        if (layout.isInHand()) {
            return end().map(EndPanel::buttons);
        }
        if (session.isShowing()) {
            return Optional.of(stop);
        }
        return session.isPaused() ? Optional.of(pause) : end().map(EndPanel::buttons);
    }

    /** Whether keys select buttons at present. */
    public boolean hasButtons() {
        return buttons().isPresent();
    }

    /** Selects the first button, if there are any. */
    public void begin() {
        buttons().ifPresent(ButtonRow::begin);
    }

    /** Selects the next button (+1) or the previous one (−1), if there are any. */
    public void move(int by) {
        buttons().ifPresent(row -> row.move(by));
    }

    /** Clears the selection. */
    public void letGo() {
        buttons().ifPresent(ButtonRow::letGo);
    }

    /** The command of the selected button. */
    public Optional<Command> chosen() {
        return buttons().flatMap(ButtonRow::chosen);
    }

    /**
     * Draws all panels.
     *
     * @param offered commands that are available at present only, in their order
     */
    public void draw(Canvas canvas, Refusal refusal, Set<Command> offered, Motion motion) {
        whole.hide();
        if (view.isEnlarged()) {
            whole.draw(canvas, View.KEYS_TOP);
        }
        if (layout.isInHand()) {
            drawInHand(canvas, refusal, offered, motion);
            return;
        }
        if (session.isShowing()) {
            canvas.frame(3, 3, Scene.WIDTH - 6, Scene.HEIGHT - 6, 12, Color.BRASS);
            hud.drawShow(canvas, words, session, stop, motion);
        } else if (session.isPaused()) {
            hud.drawPaused(canvas, words, session, refusal, pause, motion);
        } else {
            hud.draw(canvas, words, session, refusal, motion);
        }
        drawDrawer(canvas);
        session.verdict().ifPresent(said -> VerdictPlate.draw(canvas, words, said, foot()));
        keys.draw(canvas, words, offers.onADesk(offered), offers.lit(open));
        end().ifPresent(panel -> panel.draw(canvas, words, motion));
        hud.drawHelp(canvas, words);
    }

    private void drawInHand(Canvas canvas, Refusal refusal, Set<Command> offered, Motion motion) {
        List<Command> commands = offers.inAHand(offered);
        HandPlaces places = HandPlaces.of(layout, commands.size());
        hud.drawInHand(canvas, places.bar(), words, session, refusal, motion);
        if (open == Drawer.HINT) {
            hint.drawInHand(canvas, words, places.hint());
        }
        session.verdict().ifPresent(said -> VerdictPlate.draw(canvas, words, said, foot()));
        keys.drawInHand(canvas, words, commands, offers.lit(open), places.keys());
        end().ifPresent(panel -> panel.draw(canvas, words, motion));
        hud.drawHelp(canvas, words);
    }

    /** Describes all buttons and the events of the game to a screen reader. */
    public void describe(Narrator narrator, Refusal refusal) {
        if (end().isEmpty()) {
            buttons().ifPresent(row -> row.describe(narrator, words));
        }
        end().ifPresent(panel -> panel.describe(narrator, words));
        if (open == Drawer.HINT) {
            hint.describe(narrator, words);
        }
        keys.describe(narrator, words);
        whole.describe(narrator);
        hud.describe(narrator, words, session, refusal);
        session.verdict().ifPresent(said -> narrator.says(said.in(words)));
    }

    private void drawDrawer(Canvas canvas) {
        switch (open) {
            case NONE -> {}
            case EFFECTS -> {
                if (isBeside()) {
                    effects.drawBeside(canvas);
                } else {
                    effects.draw(canvas);
                }
            }
            case HINT -> {
                if (isBeside()) {
                    hint.drawBeside(canvas, words);
                } else {
                    hint.draw(canvas, words);
                }
            }
        }
    }

    /** The command of the button at a point. */
    public Optional<Command> at(double x, double y) {
        Optional<Command> command = buttons().flatMap(row -> row.point(x, y));
        if (command.isEmpty() && open == Drawer.HINT && hint.isOnSolution(x, y)) {
            return Optional.of(Command.SOLUTION);
        }
        return command.or(() -> keys.at(x, y)).or(() -> whole(x, y));
    }

    /** The panel at the end of a try covers the corner of the play. */
    private Optional<Command> whole(double x, double y) {
        boolean isThere = whole.contains(x, y) && !end().filter(p -> p.contains(x, y)).isPresent();
        return isThere ? Optional.of(Command.WHOLE) : Optional.empty();
    }

    /** Whether a point lies on a panel, so that a click there does not reach the play. */
    public boolean cover(double x, double y) {
        if (layout.isInHand()) {
            return hud.contains(x, y)
                    || open == Drawer.HINT && hint.contains(x, y)
                    || keys.at(x, y).isPresent()
                    || end().filter(p -> p.contains(x, y)).isPresent();
        }
        return y < foot()
                || isOnDrawer(x, y)
                || KeyStrip.contains(y)
                || end().filter(p -> p.contains(x, y)).isPresent();
    }

    private boolean isOnDrawer(double x, double y) {
        return switch (open) {
            case NONE -> false;
            case EFFECTS -> effects.contains(x, y);
            case HINT -> hint.contains(x, y);
        };
    }

    /** Handles a click on a panel outside its buttons. */
    public void press(double x, double y) {
        if (open == Drawer.EFFECTS) {
            effects.pointerPressed(x, y);
        }
    }

    public void pointerMoved(double x, double y) {
        buttons().ifPresent(row -> row.point(x, y));
        hud.pointerMoved(x, y);
        keys.pointerMoved(x, y);
        effects.pointerMoved(x, y);
    }

    /** Called after each frame that was drawn. */
    public void drawn() {
        if (open == Drawer.EFFECTS) {
            effects.drawn();
        }
    }

    public void close() {
        effects.close();
    }

    public boolean isOver() {
        return session.game().outcome() != Outcome.RUNNING;
    }
}
