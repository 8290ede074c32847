package rigibo.frontend.scene.effects;

import rigibo.backend.effect.Effects;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Words;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Selects and places the chips, in a few rows at most: first the effects that the scene needs, then
 * those that it offers. Offers without room are left out; chips of needed effects are moved closer
 * together instead.
 */
final class ChipLayout {

    /** Between rows and between chips, px. */
    static final double GAP = 6;

    /** Space at either side of a chip's word, px. */
    private static final double MARGIN = 10;

    /** Margin, then gap, where chips are moved closer together, px. */
    private static final double CROWDED_MARGIN = 1;

    private static final double CROWDED_GAP = 2;

    private final Words words;
    private final Canvas canvas;
    private final double width;
    private final boolean isCrowded;
    private final List<Chip> chips = new ArrayList<>();
    private final double[] ends;
    private int row;

    private ChipLayout(Words words, Canvas canvas, double width, int rows, boolean isCrowded) {
        this.words = words;
        this.canvas = canvas;
        this.width = width;
        this.isCrowded = isCrowded;
        ends = new double[rows];
    }

    /** The chips of a scene in rows of a width in px, the first of them at (0, 0). */
    static List<Chip> of(SceneEffects scene, Canvas canvas, double width, int rows) {
        Map<Boolean, List<EffectReason>> shown = shown(scene);
        List<EffectReason> called = shown.get(true);
        ChipLayout layout = new ChipLayout(scene.words(), canvas, width, rows, false);
        if (!called.stream().allMatch(layout::place)) {
            layout = new ChipLayout(scene.words(), canvas, width, rows, true);
            called.forEach(layout::place);
        }
        shown.get(false).forEach(layout::place);
        return layout.chips;
    }

    /** How many rows chips take. */
    static int rows(List<Chip> chips) {
        return (int) chips.stream().mapToDouble(Chip::y).distinct().count();
    }

    /** By whether the scene calls for them. */
    private static Map<Boolean, List<EffectReason>> shown(SceneEffects scene) {
        Effects calledFor = scene.calledFor();
        List<EffectReason> reasons = scene.reasons();
        return KnownEffect.all().stream()
                .map(known -> known.in(calledFor, reasons, scene.words()))
                .flatMap(Optional::stream)
                .collect(
                        Collectors.partitioningBy(
                                reason -> calledFor.declares(reason.effect().getClass())));
    }

    /** Adds a chip behind the last, in a crowd wherever there is room; whether there was. */
    private boolean place(EffectReason reason) {
        double margin = isCrowded ? CROWDED_MARGIN : MARGIN;
        String title = words.of("effect." + reason.effect().title());
        double needed = canvas.textWidth(title, 16, Canvas.Font.WORDS) + 2 * margin;
        for (int i = isCrowded ? 0 : row; i < ends.length; i++) {
            if (ends[i] + needed <= width) {
                double height = Chip.height(canvas.layout());
                double y = i * (height + GAP);
                chips.add(new Chip(reason, title, ends[i], y, needed, height));
                ends[i] += needed + (isCrowded ? CROWDED_GAP : GAP);
                row = i;
                return true;
            }
        }
        return false;
    }
}
