package rigibo.frontend.demo;

import rigibo.frontend.scene.Layout;

import java.util.EnumSet;
import java.util.Set;

/**
 * Which plates of a demo are open. Where they lie over the scene, all begin folded, so that the
 * scene can be seen. In one column beside it, one plate is open. In two columns all are open, with
 * one of those at the side. In a handheld window at most one is open.
 */
final class Folds {

    private final Set<Fold> open = EnumSet.noneOf(Fold.class);
    private int columns;
    private boolean isInHand;

    /**
     * Takes how many columns of plates stand beside the scene; begins anew if that has changed.
     *
     * @param most columns, 0 to 2, whatever room the window has
     */
    void fit(Layout layout, int most) {
        boolean isHeld = layout.isInHand();
        int now = isHeld ? 0 : Math.min(most, layout.columns());
        if (now != columns || isHeld != isInHand) {
            columns = now;
            isInHand = isHeld;
            boolean wasHaunted = open.contains(Fold.GHOST);
            open.clear();
            open.addAll(first());
            if (wasHaunted) {
                open(Fold.GHOST);
            }
        }
    }

    /** How many columns of plates stand beside the scene. */
    int columns() {
        return columns;
    }

    private Set<Fold> first() {
        return switch (columns) {
            case 0 -> EnumSet.noneOf(Fold.class);
            case 1 -> EnumSet.of(Fold.CONTROLS);
            default -> EnumSet.of(Fold.CONTROLS, Fold.EFFECTS, Fold.FRAME);
        };
    }

    boolean isOpen(Fold fold) {
        return open.contains(fold);
    }

    /** Whether a plate has a tab: controls and effects have room of their own in two columns. */
    boolean hasTab(Fold fold) {
        return fold.isForHands() ? isInHand : columns < 2 || fold.isAtTheSide();
    }

    /** Whether a plate that opens takes the place of any other. */
    boolean isOneAtATime() {
        return columns == 1 || isInHand;
    }

    /** Opens a plate in place of those that would be in its way. */
    void open(Fold fold) {
        open.removeIf(other -> isOneAtATime() || fold.isAtTheSide() && other.isAtTheSide());
        open.add(fold);
    }

    /** Folds a plate; beside the scene the plate that was open at first takes its place. */
    private void close(Fold fold) {
        open.remove(fold);
        if (columns == 1 && open.isEmpty() || columns == 2 && open.size() < first().size()) {
            first().forEach(this::open);
        }
    }

    void toggle(Fold fold) {
        if (isOpen(fold)) {
            close(fold);
        } else {
            open(fold);
        }
    }

    /** Folds the ghost, if it is open. */
    void layTheGhost() {
        if (isOpen(Fold.GHOST)) {
            close(Fold.GHOST);
        }
    }
}
