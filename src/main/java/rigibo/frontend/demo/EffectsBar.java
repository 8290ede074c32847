package rigibo.frontend.demo;

import rigibo.backend.Pool;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Sleep;
import rigibo.backend.effect.Thrust;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;

import java.util.ArrayList;
import java.util.List;

/**
 * The effects as chips at the foot of the window: lit when simulated. A click switches one, which
 * is an experiment, for the scene calls for another set, and is marked as one.
 */
final class EffectsBar {

    private static final double LEFT = 8;
    private static final double PADDING = 10;
    private static final double CHIP = 30;
    private static final double GAP = 6;
    private static final double WORDS = 30;

    private record Chip(Effect effect, String words, double x, double y, double width) {

        private boolean holds(double px, double py) {
            return px >= x && px <= x + width && py >= y && py <= y + CHIP;
        }
    }

    private final Pool pool;
    private final Effects calledFor;
    private List<Chip> chips = List.of();
    private Chip hot;

    /** Why the last click changed nothing; empty otherwise. */
    private String refusal = "";

    EffectsBar(Pool pool) {
        this.pool = pool;
        calledFor = pool.effects();
    }

    /** What each effect is for, in words; the scene's own take the place of these. */
    private List<Chip> known() {
        List<Chip> all = new ArrayList<>();
        add(all, new Gravity(0, -9.81), "everything falls");
        add(all, new Contacts(), "bodies do not pass through each other");
        add(all, new Rotation(), "bodies turn");
        add(all, new Friction(), "surfaces hold each other, by a share of the load");
        add(all, new Restitution(), "what hits bounces, as elastic as it is");
        add(all, new RollingResistance(), "what rolls slows down");
        add(all, new Thrust(), "forces and torques that are asked for act");
        add(all, new ContinuousImpacts(), "impacts come at their own time within the step");
        add(all, new Sleep(), "what rests is not computed until it is disturbed");
        return all;
    }

    private void add(List<Chip> all, Effect usual, String words) {
        Effect own =
                calledFor.all().stream()
                        .filter(effect -> effect.getClass() == usual.getClass())
                        .findFirst()
                        .orElse(usual);
        all.add(new Chip(own, words, 0, 0, 0));
    }

    void draw(Canvas canvas) {
        double bottom = layOut(canvas) + WORDS;
        double top = Scene.HEIGHT - 8 - bottom;
        canvas.panel(LEFT, top, Scene.WIDTH - 2 * LEFT, bottom, 12, Color.PANEL);
        chips = chips.stream().map(c -> at(c, c.x, c.y + top)).toList();
        chips.forEach(chip -> draw(canvas, chip));
        boolean isExperiment = chips.stream().anyMatch(this::isChanged);
        canvas.text(
                words(isExperiment),
                LEFT + PADDING + 4,
                top + bottom - WORDS / 2 - 2,
                16,
                Canvas.Font.WORDS,
                Canvas.Align.LEFT,
                refusal.isEmpty() ? Color.BRASS : Color.BAD);
    }

    private static Chip at(Chip chip, double x, double y) {
        return new Chip(chip.effect, chip.words, x, y, chip.width);
    }

    /** Sets the chips in rows from (LEFT, 0) on; returns the height they need, px. */
    private double layOut(Canvas canvas) {
        double x = LEFT + PADDING;
        double y = PADDING;
        List<Chip> laid = new ArrayList<>();
        for (Chip chip : known()) {
            double width = canvas.textWidth(chip.effect.title(), 16, Canvas.Font.WORDS) + 20;
            if (x + width > Scene.WIDTH - LEFT - PADDING) {
                x = LEFT + PADDING;
                y += CHIP + GAP;
            }
            laid.add(new Chip(chip.effect, chip.words, x, y, width));
            x += width + GAP;
        }
        chips = laid;
        return y + CHIP;
    }

    private void draw(Canvas canvas, Chip chip) {
        boolean isLit = pool.effects().declares(chip.effect.getClass());
        canvas.panel(chip.x, chip.y, chip.width, CHIP, 15, isLit ? Color.BRASS : Color.PANEL_LIT);
        if (isChanged(chip)) {
            canvas.frame(chip.x - 1, chip.y - 1, chip.width + 2, CHIP + 2, 16, Color.BAD);
        }
        canvas.text(
                chip.effect.title(),
                chip.x + chip.width / 2,
                chip.y + CHIP / 2,
                16,
                Canvas.Font.WORDS,
                Canvas.Align.CENTRE,
                isLit ? Color.DUSK_TOP : Color.TEXT_DIM);
    }

    private boolean isChanged(Chip chip) {
        Class<? extends Effect> kind = chip.effect.getClass();
        return pool.effects().declares(kind) != calledFor.declares(kind);
    }

    private String words(boolean isExperiment) {
        if (!refusal.isEmpty()) {
            return refusal;
        }
        if (hot != null) {
            return hot.effect.title() + ": " + hot.words;
        }
        return isExperiment
                ? "an experiment: the framed effects are not as the scene calls for (R restarts)"
                : "simulated is what is lit; click to switch";
    }

    void pointerMoved(double px, double py) {
        hot = chips.stream().filter(chip -> chip.holds(px, py)).findFirst().orElse(null);
    }

    /** The pointer went down; returns whether on a chip. */
    boolean pointerPressed(double px, double py) {
        pointerMoved(px, py);
        refusal = "";
        if (hot != null) {
            flip(hot.effect);
        }
        return hot != null;
    }

    private void flip(Effect effect) {
        try {
            Effects now = pool.effects();
            boolean isLit = now.declares(effect.getClass());
            pool.effects(isLit ? now.without(effect.getClass()) : now.with(effect));
        } catch (IllegalArgumentException needed) {
            refusal = needed.getMessage();
        }
    }
}
