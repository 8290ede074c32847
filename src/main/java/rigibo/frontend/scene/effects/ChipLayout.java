package rigibo.frontend.scene.effects;

import rigibo.backend.effect.Effects;
import rigibo.frontend.scene.Canvas;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Which chips there are and where: first what the scene calls for, then what it offers, in two rows
 * at most. Offers that find no room are left out; what the scene calls for moves together instead.
 */
final class ChipLayout {

    static final int ROWS = 2;

    /** Between rows and between chips, px. */
    static final double GAP = 6;

    /** Beside a chip's word, px. */
    private static final double MARGIN = 10;

    /** The same where there is a crowd. */
    private static final double CROWDED_MARGIN = 2;

    private static final double CROWDED_GAP = 4;

    private final Canvas canvas;
    private final double width;
    private final boolean isCrowded;
    private final List<Chip> chips = new ArrayList<>();
    private final double[] ends = new double[ROWS];
    private int row;

    private ChipLayout(Canvas canvas, double width, boolean isCrowded) {
        this.canvas = canvas;
        this.width = width;
        this.isCrowded = isCrowded;
    }

    /** The chips of a scene in rows of a width in px, the first of them at (0, 0). */
    static List<Chip> of(SceneEffects scene, Canvas canvas, double width) {
        Map<Boolean, List<EffectReason>> shown = shown(scene.calledFor(), scene.reasons());
        List<EffectReason> called = shown.get(true);
        ChipLayout layout = new ChipLayout(canvas, width, false);
        if (!called.stream().allMatch(layout::place)) {
            layout = new ChipLayout(canvas, width, true);
            called.forEach(layout::place);
        }
        shown.get(false).forEach(layout::place);
        return layout.chips;
    }

    /** By whether the scene calls for them. */
    private static Map<Boolean, List<EffectReason>> shown(
            Effects calledFor, List<EffectReason> reasons) {
        return Arrays.stream(KnownEffect.values())
                .map(known -> known.in(calledFor, reasons))
                .flatMap(Optional::stream)
                .collect(
                        Collectors.partitioningBy(
                                reason -> calledFor.declares(reason.effect().getClass())));
    }

    /** Adds a chip behind the last, in a crowd wherever there is room; whether there was. */
    private boolean place(EffectReason reason) {
        double margin = isCrowded ? CROWDED_MARGIN : MARGIN;
        double words = canvas.textWidth(reason.effect().title(), 16, Canvas.Font.WORDS);
        double needed = words + 2 * margin;
        for (int i = isCrowded ? 0 : row; i < ROWS; i++) {
            if (ends[i] + needed <= width) {
                chips.add(new Chip(reason, ends[i], i * (Chip.HEIGHT + GAP), needed));
                ends[i] += needed + (isCrowded ? CROWDED_GAP : GAP);
                row = i;
                return true;
            }
        }
        return false;
    }
}
