package rigibo.frontend.editor;

import rigibo.frontend.editor.desk.Desk;
import rigibo.frontend.editor.draft.Point;
import rigibo.frontend.editor.pane.Craft;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Modifier;

/** The editor's commands by key. */
final class Commands {

    private static final double TURN = 1;
    private static final double LARGE_TURN = 15;

    private final Workshop shop;
    private final Desk desk;

    Commands(Workshop shop) {
        this.shop = shop;
        desk = shop.desk();
    }

    void keyPressed(Key key) {
        if (shop.stopSettling()) {
            return;
        }
        if (desk.isHeld(Modifier.CONTROL)) {
            withControl(key);
        } else if (shop.typing().isOn()) {
            shop.typing().keyPressed(key);
        } else if (!shop.tool().keyPressed(key)) {
            alone(key);
        }
    }

    private void withControl(Key key) {
        switch (key) {
            case Z -> {
                if (desk.isHeld(Modifier.SHIFT)) {
                    shop.redo();
                } else {
                    shop.undo();
                }
            }
            case Y -> shop.redo();
            case S -> shop.save();
            case D -> desk.duplicate();
            case N -> shop.beginNew();
            case O -> shop.showFiles();
            case C -> shop.copyCode();
            default -> {}
        }
    }

    private void alone(Key key) {
        switch (key) {
            case T -> shop.startTest();
            case G -> desk.switchGrid();
            case K -> shop.check();
            case S -> shop.settle();
            case DELETE, BACKSPACE -> desk.remove();
            case TAB -> desk.chooseNext(desk.isHeld(Modifier.SHIFT) ? -1 : 1);
            case HOME -> shop.view().home();
            case Q, LEFT_BRACKET -> desk.turn(angle());
            case E, RIGHT_BRACKET -> desk.turn(-angle());
            case LEFT -> desk.move(new Point(-way(), 0));
            case RIGHT -> desk.move(new Point(way(), 0));
            case UP -> desk.move(new Point(0, way()));
            case DOWN -> desk.move(new Point(0, -way()));
            default -> choose(key);
        }
    }

    private double angle() {
        return desk.isHeld(Modifier.SHIFT) ? LARGE_TURN : TURN;
    }

    /** A line of the grid; without one a centimetre. */
    private double way() {
        return Math.max(0.01, desk.grid().pitch());
    }

    private void choose(Key key) {
        Craft.of(key).ifPresent(shop::take);
        int digit = key.ordinal() - Key.DIGIT_1.ordinal();
        if (digit >= 0 && digit < Substance.values().length) {
            desk.substance(Substance.values()[digit]);
        }
    }

    boolean escaped() {
        if (shop.stopSettling()) {
            return true;
        }
        if (shop.typing().isOn()) {
            shop.typing().cancel();
            return true;
        }
        if (shop.list().isPresent()) {
            shop.closeList();
            return true;
        }
        if (shop.tool().cancelled()) {
            return true;
        }
        if (shop.craft() != Craft.SELECT) {
            shop.take(Craft.SELECT);
            return true;
        }
        boolean hasChosen = !desk.chosen().isEmpty();
        desk.choose("");
        return hasChosen;
    }
}
